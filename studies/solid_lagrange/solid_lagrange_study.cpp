/// Solids on cells that move with the material: two plates against a finer run, a collapsing shell against the exact
/// radius at which it stops.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <numeric>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"
#include "verification/measure/gci.hpp"

namespace g27 {
namespace {

struct Scheme {
  std::string name;
  Predictor predictor;
  double formal_order;
  std::vector<double> bounds;  ///< of the plates' error at the cell numbers below [mm km/s]; empty: none
};
/// The bounds are .100 .051 .028 .0136 and .057 .029 .0152 .0067, and half a unit of their last digit.
std::vector<Scheme> const schemes{{"godunov", Predictor::godunov, 1, {}},
                                  {"linear", Predictor::linear, 2, {0.1005, 0.0515, 0.0285, 0.01365}},
                                  {"parabolic", Predictor::parabolic, 2, {0.0575, 0.0295, 0.01525, 0.00675}}};
std::vector<int> const plate_cells{500, 1000, 2000, 4000}, shell_cells{50, 100, 200, 400};
constexpr int reference_cells = 16000;

struct Run {
  std::string problem;
  std::size_t scheme;  ///< place in `schemes`
  int cells;
  CaseResult result{};
};

/// Runs all of them, longest first, on the machine's cores.
void run_all(std::vector<Run>& runs, StudyContext const& context) {
  std::vector<Case> const cases = all_cases();
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return runs[i].cells > runs[j].cells; });
  std::atomic<std::size_t> next{0};
  std::vector<std::future<void>> workers;
  auto const work = [&] {
    for (std::size_t k = next++; k < order.size(); k = next++) {
      Run& r = runs[order[k]];
      CaseOptions options;
      options.cells = r.cells, options.predictor = schemes[r.scheme].predictor;
      r.result = find_by_name(cases, r.problem, "solid-lagrange").run(options);
    }
  };
  if (context.progress) context.progress(0, fmt::format("{} runs", runs.size()));
  for (int k = 0; k < threads_or_all(0); ++k) workers.push_back(std::async(std::launch::async, work));
  for (auto& w : workers) w.get();
}

CaseResult const& result_of_run(std::vector<Run> const& runs, std::string const& problem, std::size_t scheme,
                                int cells) {
  auto const is = [&](Run const& r) { return r.problem == problem && r.scheme == scheme && r.cells == cells; };
  return std::find_if(runs.begin(), runs.end(), is)->result;
}

/// Integral of |u - u_fine| over x [m^2/s], u_fine the mean over the mass of each cell: cells that move with the
/// material, of equal masses at the start, keep what they hold, and fine ones add up to a coarse one.
double gap(CaseResult const& coarse, CaseResult const& fine) {
  std::size_t const n = coarse.u.size(), ratio = fine.u.size() / n;
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double mean = 0, width = 0;  // widths of equal masses are as 1/rho
    for (std::size_t k = i * ratio; k < (i + 1) * ratio; ++k) {
      mean += fine.u[k] / static_cast<double>(ratio), width += 1 / fine.rho[k];
    }
    sum += width * std::fabs(coarse.u[i] - mean), total += width;
  }
  return sum / total * (fine.facts.at("right_surface") - fine.facts.at("left_surface"));
}

void write_profile(Hdf5Writer& out, std::string const& group, CaseResult const& r) {
  std::vector<double> stress;
  for (std::size_t i = 0; i < r.x.size(); ++i) stress.push_back(r.p[i] - r.profile.at("sxx")[i]);
  out.write(group + "/x", r.x, "m");
  out.write(group + "/velocity", r.u, "m/s");
  out.write(group + "/stress", stress, "Pa");
}

Table plates(std::vector<Run> const& runs, Hdf5Writer& profiles, std::vector<Finding>& findings) {
  Table table{.name = "plates",
              .title =
                  "aluminium at 800 m/s onto aluminium, 5 us: L1 error of the velocity against the parabolic scheme "
                  "with 16000 cells",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"velocity_l1", "mm km/s"},
                          {"order", "1"},
                          {"bound", "mm km/s"},
                          {"release_velocity_error", "1"},
                          {"release_stress_error", "1"}},
              .rows = {},
              .facts = {}};
  CaseResult const& reference = result_of_run(runs, "wilkins-plate", schemes.size() - 1, reference_cells);
  table.facts.emplace_back("unaccounted energy of the reference", reference.ledger.energy.residual());
  write_profile(profiles, "/plates/reference", reference);
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    Scheme const& s = schemes[i];
    double before = 0, worst = 0;
    for (std::size_t k = 0; k < plate_cells.size(); ++k) {
      CaseResult const& r = result_of_run(runs, "wilkins-plate", i, plate_cells[k]);
      double const error = gap(r, reference);  // m^2/s = mm km/s
      double const bound = s.bounds.empty() ? std::numeric_limits<double>::quiet_NaN() : s.bounds[k];
      double const order = before > 0 ? std::log2(before / error) : std::numeric_limits<double>::quiet_NaN();
      table.rows.push_back({s.name, long{plate_cells[k]}, error, order, bound, r.facts.at("release_velocity_error"),
                            r.facts.at("release_stress_error")});
      if (!s.bounds.empty()) worst = std::max(worst, error / bound);
      before = error;
      if (k + 1 == plate_cells.size()) {
        double const found = r.facts.at("release_velocity_error");
        findings.push_back(
            {fmt::format("plates, {}, 4000 cells: velocity behind the elastic release within 0.1 %", s.name),
             fmt::format("{:.2g}", found), std::fabs(found) <= 1e-3});
      }
      if (plate_cells[k] == 1000) write_profile(profiles, "/plates/" + s.name, r);
    }
    if (s.bounds.empty()) continue;
    auto const& b = s.bounds;
    findings.push_back(
        {fmt::format("plates, {}: errors at most {}, {}, {}, {} mm km/s", s.name, b[0], b[1], b[2], b[3]),
         fmt::format("largest ratio to these {:.3g}", worst), worst <= 1});
  }
  return table;
}

Table shell(std::vector<Run> const& runs, Hdf5Writer& out, std::vector<Finding>& findings) {
  Table table{.name = "shell",
              .title = "shell of beryllium thrown inwards: radius at which its inner wall stops",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"stop_radius", "m"},
                          {"over_exact", "1"},
                          {"stop_time", "s"},
                          {"kinetic_share", "1"},
                          {"plastic_share", "1"},
                          {"unaccounted_energy", "1"}},
              .rows = {},
              .facts = {}};
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    Scheme const& s = schemes[i];
    std::vector<double> radius, cells;
    double exact = 0;
    for (int n : shell_cells) {
      CaseResult const& r = result_of_run(runs, "be-shell", i, n);
      auto const& f = r.facts;
      radius.push_back(f.at("stop_radius")), cells.push_back(n), exact = f.at("exact_stop_radius");
      table.rows.push_back({s.name, long{n}, f.at("stop_radius"), f.at("stop_radius_error"), f.at("stop_time"),
                            f.at("kinetic_share"), f.at("plastic_work_share"), r.ledger.energy.residual()});
    }
    out.write("/shell/" + s.name + "/cells", cells, "1");
    out.write("/shell/" + s.name + "/stop_radius", radius, "m");
    out.write("/shell/" + s.name + "/exact", std::vector<double>{exact}, "m");
    GridConvergence const g = grid_convergence(radius[3], radius[2], radius[1], 2, 2, s.formal_order);
    table.facts.emplace_back(s.name + ": observed order on the finest three grids", g.order);
    table.facts.emplace_back(s.name + ": Richardson's value, m", g.richardson);
    table.facts.emplace_back(s.name + ": band of the grid convergence index, m", g.band);
    table.facts.emplace_back(s.name + ": Richardson's value over the exact radius of incompressible material, minus 1",
                             g.richardson / exact - 1);
    if (s.predictor == Predictor::godunov) continue;
    double worst = 0;
    for (double r : radius) worst = std::max(worst, std::fabs(r / exact - 1));
    findings.push_back({fmt::format("shell, {}: stops within 2 % of {:.4g} cm on every grid", s.name, 100 * exact),
                        fmt::format("{:.3g} % at most, {:.3g} % with 400 cells", 100 * worst,
                                    100 * std::fabs(radius.back() / exact - 1)),
                        worst <= 0.02});
  }
  return table;
}

StudyReport run(StudyContext const& context) {
  Hdf5Writer profiles;
  StudyReport report;
  std::vector<Run> runs{{"wilkins-plate", schemes.size() - 1, reference_cells}};
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    for (int n : plate_cells) runs.push_back({"wilkins-plate", i, n});
    for (int n : shell_cells) runs.push_back({"be-shell", i, n});
  }
  run_all(runs, context);
  report.tables.push_back(plates(runs, profiles, report.findings));
  report.tables.push_back(shell(runs, profiles, report.findings));
  profiles.save(context.out / "profiles.h5");
  return report;
}

}  // namespace

Study solid_lagrange_study() {
  return {"solid-lagrange",
          "solids on cells that move with the material: plates converge, a shell stops where it should", run};
}

}  // namespace g27
