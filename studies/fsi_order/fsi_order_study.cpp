/// Orders of the motion of interfaces on smooth problems: a contact of gas and solid on a line, against its exact
/// motion, and an elastic sphere under a pressure pulse in three dimensions, against itself on three grids. Angles of
/// the fronts in a solid under a superseismic load.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/order_schemes.hpp"
#include "studies/orders/order_tables.hpp"
#include "verification/measure/gci.hpp"

namespace g27 {
namespace {

std::vector<OrderRow> line_rows() {
  std::vector<OrderRow> rows;
  for (OrderScheme const& s : order_schemes) {
    OrderRow row{"line", "fsi-piston-1d", "ideal", "lagrangian", s.name, {}, {50, 100, 200, 400}};
    row.options.predictor = s.predictor, row.options.monotonicity = s.monotonicity;
    row.units = {{"interface_position", 1.0}, {"interface_velocity", 1.0}};
    rows.push_back(row);
  }
  return rows;
}

/// Across the box; the radius has 3.6, 5.4, 8.1 and 12.6. In multiples of four: the surfaces are similar then, an
/// icosahedron with 4, 6, 9 and 14 parts of an edge.
constexpr std::array sphere_cells{16, 24, 36, 56};

/// Value at t of a history, by the cubic through the four points around it.
double at(std::vector<double> const& time, std::vector<double> const& value, double t) {
  std::size_t const n = time.size();
  std::size_t const above = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  std::size_t const first = std::min(above < 2 ? 0 : above - 2, n - 4);
  double sum = 0;
  for (std::size_t i = first; i < first + 4; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + 4; ++j) {
      if (j != i) weight *= (t - time[j]) / (time[i] - time[j]);
    }
    sum += weight * value[i];
  }
  return sum;
}

/// Mean over time of the difference of two histories, over the largest value of the second.
double difference(CaseResult const& a, CaseResult const& b, std::string const& what) {
  constexpr int samples = 200;
  auto const &time_a = a.profile.at("time"), &time_b = b.profile.at("time"), &last = b.profile.at(what);
  double sum = 0, largest = 0;
  for (double v : last) largest = std::max(largest, std::fabs(v));
  for (int k = 1; k <= samples; ++k) {
    double const t = time_b.back() * k / samples;
    sum += std::fabs(at(time_a, a.profile.at(what), t) - at(time_b, last, t));
  }
  return sum / (samples * largest);
}

struct SphereScheme {
  std::string name;
  Predictor predictor;
  Switch monotonicity;
};

Table sphere(StudyContext const& context, Hdf5Writer& histories, std::vector<Finding>& findings) {
  Table table{.name = "sphere",
              .title = "elastic sphere under a pulse: mean difference in time to the next finer grid, over the largest",
              .columns = {{"scheme", "1"},
                          {"quantity", "1"},
                          {"16_to_24", "1"},
                          {"24_to_36", "1"},
                          {"36_to_56", "1"},
                          {"order_before", "1"},
                          {"order", "1"},
                          {"fine_wall", "s"}},
              .rows = {},
              .facts = {}};
  std::vector<SphereScheme> const schemes{{"godunov", Predictor::godunov, Switch::off},
                                          {"linear, graded", Predictor::linear, Switch::graded}};
  Case const problem = find_by_name(all_cases(), "elastic-sphere-pulse", "fsi-order");
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    std::vector<CaseResult> runs;
    for (std::size_t k = 0; k < sphere_cells.size(); ++k) {
      CaseOptions options;
      options.cells = sphere_cells[k], options.predictor = schemes[s].predictor;
      options.monotonicity = schemes[s].monotonicity;
      options.threads = threads_or_all(0);
      double const before = static_cast<double>(s * sphere_cells.size() + k);
      std::string const what = fmt::format("sphere, {}, {} cells", schemes[s].name, sphere_cells[k]);
      options.progress = [&](double done) { context.progress((before + done) / 8, what); };
      runs.push_back(problem.run(options));
      for (char const* quantity : {"time", "momentum", "position", "velocity", "volume"}) {
        histories.write(fmt::format("/{}/{}/{}", schemes[s].name, sphere_cells[k], quantity),
                        runs.back().profile.at(quantity), "1");
      }
    }
    bool const first = schemes[s].predictor == Predictor::godunov;
    for (std::string const quantity : {"momentum", "position", "velocity"}) {
      std::array<double, 3> gap{};
      for (std::size_t k = 0; k < gap.size(); ++k) gap[k] = difference(runs[k], runs[k + 1], quantity);
      // of values whose differences are these
      auto const order_of = [&](std::size_t k) {
        auto const ratio = [&](std::size_t n) { return double(sphere_cells[n + 1]) / sphere_cells[n]; };
        return grid_convergence(0.0, gap[k + 1], gap[k + 1] + gap[k], ratio(k + 1), ratio(k), 2.0).order;
      };
      double const order = order_of(1);
      table.rows.push_back({schemes[s].name, quantity, gap[0], gap[1], gap[2], order_of(0), order, runs.back().wall_s});
      findings.push_back({fmt::format("sphere, {}: order of the body's {} {}", schemes[s].name, quantity,
                                      first ? "below 1.1" : "1.8 to 2.8"),
                          fmt::format("{:.2f} ({:.2g}, {:.2g})", order, gap[1], gap[2]),
                          first ? order < 1.1 : order > 1.8 && order < 2.8});
    }
  }
  return table;
}

Table superseismic(std::vector<Finding>& findings) {
  static std::vector<std::string> const angles{"p_wave_angle", "s_wave_angle", "interface_angle"};
  std::vector<int> const cells{64, 96, 144, 216};
  Table table{
      .name = "superseismic",
      .title = "pressure along an elastic half-space, 1.25 times as fast as P waves: errors of angles, relative",
      .columns = {{"scheme", "1"}, {"quantity", "1"}},
      .rows = {},
      .facts = {}};
  for (int n : cells) table.columns.push_back({fmt::format("error_{}", n), "1"});
  table.columns.push_back({"order", "1"});
  Case const problem = find_by_name(all_cases(), "superseismic-load-2d", "fsi-order");
  for (auto const& [name, predictor] : {std::pair{"godunov", Predictor::godunov},
                                        {"linear, graded", Predictor::linear},
                                        {"parabolic, on", Predictor::parabolic}}) {
    std::map<std::string, std::vector<double>> errors;
    std::vector<double> h;
    for (int n : cells) {
      CaseOptions options;
      options.cells = n, options.predictor = predictor, options.monotonicity = Switch::graded;
      CaseResult const r = problem.run(options);
      h.push_back(1.0 / n);
      for (std::string const& a : angles) errors[a].push_back(std::fabs(r.facts.at(a + "_error")));
    }
    double worst = 0;
    for (std::string const& a : angles) {
      std::vector<Value> row{std::string(name), a};
      for (double e : errors[a]) row.emplace_back(e);
      row.emplace_back(fit_order(h, errors[a]).order);
      table.rows.push_back(row);
      worst = std::max(worst, errors[a].back());
    }
    findings.push_back(
        {fmt::format("superseismic, {}, 216 cells: angles of both fronts and of the surface within 1 %", name),
         fmt::format("{:.2g}, {:.2g}, {:.2g}", errors[angles[0]].back(), errors[angles[1]].back(),
                     errors[angles[2]].back()),
         worst <= 0.01});
  }
  return table;
}

StudyReport run(StudyContext const& context) {
  std::vector<Finding> findings;
  Hdf5Writer histories;
  Table const fronts = superseismic(findings);
  std::vector<RowResult> const results = measure_orders(line_rows(), context);
  auto const claim = [&](std::string const& text, std::string const& scheme, double low, double high) {
    findings.push_back(order_claim(results, text, low, high, [&](auto& r, auto&) { return r.scheme == scheme; }));
  };
  claim("line, linear, off: L1 order of the contact's position and velocity 1.9 to 2.1", "linear, off", 1.9, 2.1);
  claim("line, linear, graded: 1.8 to 2.2", "linear, graded", 1.8, 2.2);
  claim("line, parabolic, on: 1.8 to 3.2", "parabolic, on", 1.8, 3.2);
  claim("line, Godunov: below 1.1", "godunov", 0.5, 1.1);
  Table const bodies = sphere(context, histories, findings);
  histories.save(context.out / "histories.h5");
  return {{order_table(results), error_table(results), fronts, bodies}, findings};
}

}  // namespace

Study fsi_order_study() {
  return {"fsi-order", "interfaces of gas and solids move with second order on smooth problems, Godunov's with first",
          run};
}

}  // namespace g27
