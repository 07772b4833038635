/// Shocks of solids against exact solutions: the elastic-plastic piston, the flying plate, and elastic steps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

struct Scheme {
  std::string name;
  Predictor predictor;
};
std::vector<Scheme> const schemes{
    {"godunov", Predictor::godunov}, {"linear", Predictor::linear}, {"parabolic", Predictor::parabolic}};

CaseResult run_case(std::string const& name, Scheme const& s, int cells, std::map<std::string, double> values = {}) {
  CaseOptions options;
  options.cells = cells, options.predictor = s.predictor, options.monotonicity = Switch::graded;
  options.values = std::move(values);
  return find_by_name(all_cases(), name, "solid-riemann").run(options);
}

void write_profiles(Hdf5Writer& out, std::string const& problem, std::string const& scheme, CaseResult const& r) {
  std::string const group = "/" + problem + "/" + scheme + "/";
  out.write(group + "x", r.x, "m");
  for (auto const& [variable, unit] : {std::pair{"velocity_x", "m/s"}, std::pair{"velocity_y", "m/s"},
                                       std::pair{"pressure", "Pa"}, std::pair{"sxx", "Pa"}}) {
    out.write(group + variable, r.profile.at(variable), unit);
    if (r.profile_ref.contains(variable)) out.write(group + "reference_" + variable, r.profile_ref.at(variable), unit);
  }
}

Table piston(Hdf5Writer& profiles, std::vector<Finding>& findings) {
  static std::vector<std::string> const facts{"elastic_stress_error", "elastic_speed_error", "plastic_stress_error",
                                              "plastic_speed_error", "stress_overshoot"};
  Table table{.name = "piston",
              .title = "steel at 50 m/s against a wall: plateau stresses and wave speeds, relative to the exact ones",
              .columns = {{"scheme", "1"}, {"cells", "1"}},
              .rows = {},
              .facts = {}};
  for (std::string const& f : facts) table.columns.push_back({f, "1"});
  for (Scheme const& s : schemes) {
    for (int cells : {200, 400, 800, 1600}) {
      CaseResult const r = run_case("piston-ep", s, cells);
      std::vector<Value> row{s.name, long{cells}};
      for (std::string const& f : facts) row.emplace_back(r.facts.at(f));
      table.rows.push_back(row);
      if (cells != 800) continue;
      write_profiles(profiles, "piston", s.name, r);
      if (s.predictor == Predictor::godunov) continue;
      auto const claim = [&](std::string const& text, double limit, std::string const& a, std::string const& b) {
        double const worst = std::fmax(std::fabs(r.facts.at(a)), std::fabs(r.facts.at(b)));
        findings.push_back({fmt::format("piston, {}, 800 cells: {}", s.name, text),
                            fmt::format("{:.2g} and {:.2g}", r.facts.at(a), r.facts.at(b)), worst <= limit});
      };
      claim("plateau stresses within 0.1 %", 1e-3, facts[0], facts[2]);
      claim("wave speeds within 0.3 %", 3e-3, facts[1], facts[3]);
      claim("overshoot of stress at most 1e-3", 1e-3, facts[4], facts[4]);
    }
  }
  return table;
}

Table plate(Hdf5Writer& profiles, std::vector<Finding>& findings) {
  Table table{.name = "plate",
              .title = "flying plate: L1 errors and overshoot over the range of the exact solution",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"velocity_l1", "m/s"},
                          {"sxx_l1", "Pa"},
                          {"velocity_overshoot", "1"},
                          {"pressure_overshoot", "1"}},
              .rows = {},
              .facts = {}};
  std::map<std::string, std::vector<double>> errors;
  for (Scheme const& s : schemes) {
    for (int cells : {250, 500, 1000, 2000}) {
      CaseResult const r = run_case("flying-plate", s, cells);
      errors[s.name].push_back(r.errors.at("velocity_x").l1);
      table.rows.push_back({s.name, long{cells}, r.errors.at("velocity_x").l1, r.errors.at("sxx").l1,
                            r.overshoot.at("velocity_x"), r.overshoot.at("pressure")});
      if (cells == 1000) write_profiles(profiles, "plate", s.name, r);
    }
    auto const& e = errors[s.name];
    // Godunov's shocks and contacts spread with the square root of the grid in part
    double const most = s.predictor == Predictor::godunov ? 0.8 : 0.65;
    bool falls = true;
    for (std::size_t i = 1; i < e.size(); ++i) falls = falls && e[i] < most * e[i - 1];
    findings.push_back(
        {fmt::format("plate, {}: the velocity's error falls to less than {} at every doubling", s.name, most),
         fmt::format("{:.3g}, {:.3g}, {:.3g}, {:.3g} m/s", e[0], e[1], e[2], e[3]), falls});
  }
  return table;
}

Table steps(Hdf5Writer& profiles, std::vector<Finding>& findings) {
  Table table{.name = "steps",
              .title = "elastic steps: overshoot of the velocities along and across the normal, over the step",
              .columns = {{"case", "1"},
                          {"step", "1"},
                          {"prestress", "1"},
                          {"scheme", "1"},
                          {"velocity_l1", "m/s"},
                          {"overshoot_normal", "1"},
                          {"overshoot_shear", "1"}},
              .rows = {},
              .facts = {}};
  struct Kind {
    std::string name;
    double normal, shear, stress;
  };
  std::vector<Kind> const kinds{
      {"normal", 1, 0, 0}, {"shear", 0, 1, 0}, {"combined", 1, 1, 0}, {"combined", 1, 1, 0.05}};
  for (int dimensions : {1, 2}) {
    std::string const problem = fmt::format("solid-step-{}d", dimensions);
    for (Scheme const& s : schemes) {
      double worst = 0;
      std::string where;
      for (Kind const& k : kinds) {
        CaseResult const r = run_case(problem, s, dimensions == 1 ? 200 : 128,
                                      {{"normal", k.normal}, {"shear", k.shear}, {"stress", k.stress}});
        double const normal = r.facts.at("overshoot_normal"), shear = r.facts.at("overshoot_shear");
        table.rows.push_back({problem, k.name, k.stress, s.name, r.errors.at("velocity").l1, normal, shear});
        if (std::fmax(normal, shear) >= worst) {
          worst = std::fmax(normal, shear), where = fmt::format("{}, pre-stress {}", k.name, k.stress);
        }
        if (dimensions == 1) write_profiles(profiles, k.name + (k.stress > 0 ? "-stressed" : ""), s.name, r);
      }
      double const limit = dimensions == 1 ? 1e-3 : 0.03;
      findings.push_back({fmt::format("{}, {}: no velocity more than {} of the step beyond the exact ones",
                                      dimensions == 1 ? "steps along the grid" : "oblique steps", s.name, limit),
                          fmt::format("{:.2g} ({})", worst, where), worst <= limit});
    }
  }
  return table;
}

StudyReport run(StudyContext const& context) {
  Hdf5Writer profiles;
  StudyReport report;
  auto const note = [&](double done, char const* what) {
    if (context.progress) context.progress(done, what);
  };
  note(0, "piston");
  report.tables.push_back(piston(profiles, report.findings));
  note(0.3, "flying plate");
  report.tables.push_back(plate(profiles, report.findings));
  note(0.6, "steps");
  report.tables.push_back(steps(profiles, report.findings));
  profiles.save(context.out / "profiles.h5");
  return report;
}

}  // namespace

Study solid_riemann_study() {
  return {"solid-riemann", "shocks of solids have the exact states and speeds, and no overshoot", run};
}

}  // namespace g27
