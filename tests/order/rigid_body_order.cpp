/// Motion of a rigid body that gas drives: errors of both schemes and how they fall.
#include <cmath>

#include "studies/driver/lookup.hpp"
#include "tests/catch.hpp"
#include "verification/cases/case.hpp"

using namespace g27;

TEST_CASE("a rigid slab follows the exact piston", "[order]") {
  Case const piston = find_by_name(all_cases(), "rigid-piston", "test");
  struct Error {
    double velocity, position;
  };
  auto const error = [&](Predictor predictor, int cells) {
    CaseOptions options;
    options.cells = cells, options.predictor = predictor, options.threads = 2;
    CaseResult const r = piston.run(options);
    // the round-off of one sum a step, and no moment
    CHECK(std::fabs(r.facts.at("momentum_less_impulse")) < 1e-15);
    CHECK(r.facts.at("turned") < 1e-12);
    return Error{r.errors.at("velocity").l1, r.errors.at("position").linf};
  };
  auto const order = [](double coarse, double fine) { return 0.5 * std::log2(coarse / fine); };
  // Four times the cells. Godunov: 1.8, since what both sides lack cancels in part. Linear: its errors are 5e-5 of the
  // slab's velocity and less, 17 and 4 times below Godunov's, and change sign on coarse grids; what is left, .7, is of
  // the cells that take the states of cores.
  Error const first[2]{error(Predictor::godunov, 20), error(Predictor::godunov, 80)};
  Error const second[2]{error(Predictor::linear, 30), error(Predictor::linear, 120)};
  for (double const o : {order(first[0].velocity, first[1].velocity), order(first[0].position, first[1].position)}) {
    CAPTURE(o);
    CHECK(o > 1.5);
    CHECK(o < 2.1);
  }
  for (double const o :
       {order(second[0].velocity, second[1].velocity), order(second[0].position, second[1].position)}) {
    CAPTURE(o);
    CHECK(o > 0.5);
    CHECK(o < 2.2);
  }
  CHECK(second[0].velocity < first[1].velocity);
  CHECK(second[0].position < first[1].position);
}
