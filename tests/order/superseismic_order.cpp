/// Fronts in an elastic half-space under a load that outruns them, against the exact self-similar solution.
#include <cmath>

#include "tests/catch.hpp"
#include "verification/cases/case.hpp"

using namespace g27;

namespace {

CaseResult run(Predictor predictor, int cells) {
  for (Case const& c : all_cases()) {
    if (c.name != "superseismic-load-2d") continue;
    CaseOptions options;
    options.cells = cells, options.predictor = predictor;
    return c.run(options);
  }
  throw std::runtime_error("the case is gone");
}

}  // namespace

TEST_CASE("the angles of P and S front and of the surface under a superseismic load are the exact ones", "[order]") {
  CaseResult const coarse = run(Predictor::linear, 64), fine = run(Predictor::linear, 144);
  CaseResult const first = run(Predictor::godunov, 144);
  for (std::string const angle : {"p_wave_angle", "s_wave_angle", "interface_angle"}) {
    INFO(angle);
    // half of a per cent: fronts a few cells wide, a line through 36 rows of them
    CHECK(std::fabs(fine.facts.at(angle + "_error")) < 5e-3);
    // Godunov's fronts are wide, and smear into each other
    CHECK(std::fabs(first.facts.at(angle + "_error")) < 0.02);
    CHECK(std::fabs(first.facts.at(angle + "_error")) > std::fabs(fine.facts.at(angle + "_error")));
  }
  // discontinuities that a scheme of order p spreads over h^(p/(p+1)): 2/3 for the second order
  double const order = std::log(coarse.errors.at("velocity").l1 / fine.errors.at("velocity").l1) / std::log(144.0 / 64);
  CHECK(order > 0.5);
  CHECK(order < 0.75);
}
