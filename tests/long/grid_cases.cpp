/// Every case in two and three dimensions with a reference comes nearer to it on a finer grid.
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/catch.hpp"
#include "verification/cases/case.hpp"

using namespace g27;

namespace {

CaseResult run(Case const& chosen, int cells, Predictor predictor) {
  CaseOptions options;
  options.cells = cells, options.predictor = predictor;
  return chosen.run(options);
}

}  // namespace

TEST_CASE("twice the cells, less error in every case with a reference", "[cases][grid]") {
  for (Case const& c : all_cases()) {
    if (c.dimensions < 2 || c.solid || !c.has_reference) continue;
    int const coarse = c.dimensions == 2 ? 32 : 12;
    for (Predictor const predictor : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
      // beyond first order the density of gas without pressure is noise of some per cent, which refinement hardly helps
      if (c.name.substr(0, 3) == "noh" && predictor != Predictor::godunov) continue;
      CaseResult const a = run(c, coarse, predictor), b = run(c, 2 * coarse, predictor);
      INFO(c.name << " scheme " << a.scheme << ": " << a.errors.at("density").l1 << ", " << b.errors.at("density").l1);
      // neither grid resolves the density waves behind Shu and Osher's shock
      if (c.name.substr(0, 9) != "shu-osher") CHECK(b.errors.at("density").l1 < 0.95 * a.errors.at("density").l1);
      CHECK(b.errors.at("pressure").l1 < 0.95 * std::fmax(a.errors.at("pressure").l1, 1e-13));
    }
  }
}
