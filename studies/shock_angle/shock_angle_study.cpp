/// Shock tubes across the grid at 0, 45 and an irrational angle.
#include <fmt/format.h>

#include <array>
#include <map>

#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

struct Scheme {
  char const* name;
  Predictor predictor;
  RiemannSolver riemann;
};
constexpr std::array schemes{Scheme{"godunov", Predictor::godunov, RiemannSolver::fast},
                             Scheme{"linear", Predictor::linear, RiemannSolver::fast},
                             Scheme{"parabolic", Predictor::parabolic, RiemannSolver::fast},
                             Scheme{"muscl-hllc", Predictor::muscl, RiemannSolver::hllc}};

struct Tube {
  char const *problem, *angle, *name;
};
constexpr std::array tubes{Tube{"sod", "0", "sod-2d"},
                           Tube{"sod", "45", "sod-angle-45"},
                           Tube{"sod", "irrational", "sod-angle-irrational"},
                           Tube{"shu-osher", "0", "shu-osher-2d"},
                           Tube{"shu-osher", "45", "shu-osher-angle-45"},
                           Tube{"shu-osher", "irrational", "shu-osher-angle-irrational"}};

StudyReport run(StudyContext const& context) {
  Table table{.name = "errors",
              .title = "L1 error of density, overshoot beyond the exact range over the jump",
              .columns = {{"problem", "1"},
                          {"angle", "1"},
                          {"scheme", "1"},
                          {"cells", "1"},
                          {"density_l1", "kg/m^3"},
                          {"over_godunov", "1"},
                          {"overshoot", "1"}},
              .rows = {},
              .facts = {}};
  std::map<std::string, double> finest;
  bool better = true, sharper = true;
  double worst_linear = 0, worst_overshoot = 0;
  std::string at_linear, at_overshoot;
  int done = 0;
  for (Tube const& t : tubes) {
    Case const problem = find_by_name(all_cases(), t.name, "shock-angle");
    for (int cells : {100, 200}) {
      double godunov = 0;
      for (Scheme const& s : schemes) {
        if (context.progress) context.progress(done++ / 48.0, fmt::format("{} {} {} cells", t.name, s.name, cells));
        CaseOptions o;
        o.cells = cells, o.predictor = s.predictor, o.riemann = s.riemann;
        CaseResult const r = problem.run(o);
        double const error = r.errors.at("density").l1;
        auto const found = r.overshoot.find("density");
        double const overshoot = found == r.overshoot.end() ? 0.0 : found->second;
        if (s.predictor == Predictor::godunov) godunov = error;
        table.rows.push_back({std::string(t.problem), std::string(t.angle), std::string(s.name),
                              static_cast<long>(cells), error, error / godunov, overshoot});
        if (cells == 200) finest[fmt::format("{} {} {}", t.problem, t.angle, s.name)] = error;
        if (s.predictor == Predictor::linear && error / godunov > worst_linear)
          worst_linear = error / godunov, at_linear = fmt::format("{} {} {}", t.problem, t.angle, cells);
        bool const ours = s.predictor == Predictor::linear || s.predictor == Predictor::parabolic;
        better = better && (!ours || error < godunov);
        if (ours && overshoot > worst_overshoot)
          worst_overshoot = overshoot, at_overshoot = fmt::format("{} {} {} {}", t.problem, t.angle, s.name, cells);
      }
    }
  }
  std::string pairs;
  for (char const* problem : {"sod", "shu-osher"}) {
    for (char const* angle : {"0", "45", "irrational"}) {
      double const ratio = finest[fmt::format("{} {} parabolic", problem, angle)] /
                           finest[fmt::format("{} {} muscl-hllc", problem, angle)];
      sharper = sharper && ratio < 1.0;
      pairs += fmt::format("{} {}: {:.2f}; ", problem, angle, ratio);
    }
  }
  return {{table},
          {{"at every angle the modified schemes' error is below Godunov's",
            fmt::format("linear over Godunov {:.2f} at worst ({})", worst_linear, at_linear), better},
           {"the parabolic scheme's error is below MUSCL-HLLC's at every angle, 200 cells", pairs, sharper},
           {"overshoot of density <= 3 % of the jump at every angle",
            fmt::format("{:.2g} at worst ({})", worst_overshoot, at_overshoot), worst_overshoot <= 0.03}}};
}

}  // namespace

Study shock_angle_study() {
  return {"shock-angle", "shocks at any angle to the grid are captured as well as along it", run};
}

}  // namespace g27
