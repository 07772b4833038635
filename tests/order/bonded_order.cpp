/// Order of waves that cross the bonded face of two solids, and the exact states of an impact in which both yield.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/cases/case.hpp"

using namespace g27;

namespace {

Case const& problem(std::string const& name) {
  static std::vector<Case> const cases = all_cases();
  for (Case const& c : cases) {
    if (c.name == name) return c;
  }
  FAIL("no case " << name);
  return cases.front();
}

/// Orders of the L1 errors between 96 and 192 cells a side.
std::map<std::string, double> orders(std::string const& pair, double family, double stress, Predictor predictor) {
  std::map<std::string, double> coarse, out;
  for (int n : {96, 192}) {
    CaseOptions options;
    options.cells = n, options.eos = pair, options.predictor = predictor, options.monotonicity = Switch::off;
    options.values = {{"family", family}, {"stress", stress}};
    for (auto const& [variable, error] : problem("bimaterial-1d").run(options).errors) {
      if (n == 96)
        coarse[variable] = error.l1;
      else
        out[variable] = std::log2(coarse[variable] / error.l1);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("waves cross a bonded face with the order of the scheme, on both sides and at the face", "[order]") {
  for (std::string const pair : {"steel-aluminium", "aluminium-steel"}) {
    for (auto const& [family, stress] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.05}}) {
      std::string const axis = family == 0 ? "x" : "z";
      for (auto const& [predictor, low, high] :
           {std::tuple{Predictor::godunov, 0.8, 1.02},
            {Predictor::linear, 1.9, 2.1},
            // traces from one side are of second order at the face, in two cells of all: 2 to 3
            {Predictor::parabolic, 2.2, 3.1}}) {
        auto const order = orders(pair, family, stress, predictor);
        for (std::string const v : {"left_velocity_", "right_velocity_", "contact_velocity_", "contact_traction_"}) {
          INFO(pair << " family " << family << " stress " << stress << " scheme " << static_cast<int>(predictor) << " "
                    << v + axis);
          CHECK(order.at(v + axis) > low);
          CHECK(order.at(v + axis) < high);
        }
      }
    }
  }
}

TEST_CASE("a bonded impact in which both solids yield leaves the exact states", "[order]") {
  for (Predictor p : {Predictor::linear, Predictor::parabolic}) {
    CaseOptions options;
    options.cells = 200, options.predictor = p;
    CaseResult const r = problem("bonded-impact").run(options);
    // plateaus between shocks of few cells: the error falls with the square of the width, 1e-6 with 800 cells
    CHECK(std::fabs(r.facts.at("contact_stress_error")) < 1e-4);
    CHECK(std::fabs(r.facts.at("contact_velocity_error")) < 1e-4);
    CHECK(std::fabs(r.ledger.momentum.residual()) < 1e-14);
    CHECK(std::fabs(r.ledger.energy.residual()) < 1e-14);
  }
}
