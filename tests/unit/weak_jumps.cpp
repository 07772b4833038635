/// The acoustic star state saves time; without it the same scheme must run, through the exact solver on every face.
#include "tests/catch.hpp"
#include "verification/cases/case.hpp"

using namespace g27;

namespace {

double density_error(Case const& wave, Predictor predictor, bool linear_star, GasCounters& counters) {
  CaseOptions options;
  options.cells = 80, options.predictor = predictor, options.linear_star = linear_star;
  CaseResult const r = wave.run(options);
  counters = r.counters;
  return r.errors.at("density").l1;
}

}  // namespace

TEST_CASE("smooth waves do not depend on who solves the weak Riemann problems", "[scheme]") {
  for (Case const& wave : all_cases()) {
    if (wave.name != "acoustic-1d" && wave.name != "entropy-1d") continue;
    for (Predictor predictor : {Predictor::linear, Predictor::parabolic, Predictor::muscl}) {
      GasCounters with{}, without{};
      double const shortcut = density_error(wave, predictor, true, with);
      double const solved = density_error(wave, predictor, false, without);
      INFO(wave.name << ", predictor " << static_cast<int>(predictor) << ": " << shortcut << ", " << solved);
      CHECK(with.linear_star > with.faces / 2);
      CHECK(without.linear_star == 0);
      // the two agree to second order in the jump over a face, far below the error of the scheme
      CHECK(solved == Approx(shortcut).epsilon(0.02));
    }
  }
}
