/// Observed orders of the solid schemes on smooth problems in one, two and three dimensions, in every variable.
#include <functional>
#include <map>

#include "studies/orders/order_schemes.hpp"
#include "studies/orders/order_tables.hpp"
#include "verification/cases/solid_problem.hpp"

namespace g27 {
namespace {

struct Problem {
  std::string group, name;
  double amplitude;                ///< over the speed of P waves
  std::vector<int> cells, coarse;  ///< of the linear and Godunov's schemes; of the parabolic one
  std::vector<std::string> media{"steel"};
  std::map<std::string, double> set{};  ///< parameters of the case
};

std::vector<Problem> problems() {
  std::vector<int> const line{80, 112, 160, 224, 320}, short_line{32, 48, 64, 96, 128};
  std::vector<int> const plane{48, 64, 96, 128}, space{40, 50, 60, 80}, sources{24, 32, 48, 64},
      sources_3d{32, 36, 40, 48}, sources_coarse{16, 20, 24, 32};
  std::vector<int> const step{160, 224, 320, 448};
  return {{"waves", "solid-p-1d", 1e-3, line, short_line, {"steel", "aluminium"}},
          {"waves", "solid-s-1d", 1e-3, line, short_line, {"steel", "aluminium"}},
          {"coupled S", "solid-coupled-1d", 0.02, line, short_line, {"steel", "aluminium"}},
          {"coupled P", "solid-coupled-2d", 0.02, plane, plane, {"steel"}, {{"family", 0}}},
          {"coupled S", "solid-coupled-2d", 0.02, plane, plane, {"steel"}, {{"family", 1}}},
          {"coupled P", "solid-coupled-3d", 0.02, space, space, {"steel"}, {{"family", 0}}},
          {"coupled S", "solid-coupled-3d", 0.02, space, space, {"steel"}, {{"family", 1}}},
          {"manufactured", "solid-mms-1d", 0.02, line, short_line, {"steel", "aluminium"}},
          {"manufactured", "solid-mms-2d", 0.02, sources, sources},
          {"manufactured", "solid-mms-3d", 0.02, sources_3d, sources_coarse},
          {"boundaries", "solid-fixed-1d", 1e-7, line, line},
          {"boundaries", "solid-traction-1d", 1e-7, line, line},
          {"boundaries", "solid-wall-1d", 1e-7, line, line},
          {"plastic", "solid-uniaxial-1d", 0.01, step, step},
          {"plastic", "solid-uniaxial-2d", 0.01, plane, plane},
          {"plastic", "solid-uniaxial-3d", 0.01, space, space},
          {"plastic", "solid-sheared-1d", 0.01, step, step},
          {"plastic", "solid-sheared-2d", 0.01, plane, plane},
          {"plastic", "solid-sheared-3d", 0.01, space, space}};
}

std::vector<OrderRow> all_rows() {
  std::vector<OrderRow> rows;
  for (Problem const& p : problems()) {
    for (std::string const& medium : p.media) {
      SolidMedium const m = solid_medium(medium);
      double const u = p.amplitude * m.sound, stress = m.rho0 * m.sound * u;
      for (OrderScheme const& s : order_schemes) {
        OrderRow row{
            p.group, p.name, medium, "fixed", s.name, {}, s.predictor == Predictor::parabolic ? p.coarse : p.cells};
        row.options.predictor = s.predictor, row.options.monotonicity = s.monotonicity;
        row.options.values = p.set;
        for (std::string const& v : solid_variables()) {
          double const unit = v == "density" ? m.rho0 * p.amplitude : v.substr(0, 8) == "velocity" ? u : stress;
          row.units.emplace_back(v, unit);
        }
        rows.push_back(row);
      }
    }
  }
  return rows;
}

StudyReport run(StudyContext const& context) {
  std::vector<RowResult> results = measure_orders(all_rows(), context);
  for (RowResult& r : results) keep_moving(r);
  std::vector<Finding> findings;
  auto const claim = [&](std::string const& text, std::string const& scheme, double low, double high,
                         std::function<bool(OrderRow const&)> const& chosen) {
    findings.push_back(
        order_claim(results, text, low, high, [&](auto& r, auto&) { return r.scheme == scheme && chosen(r); }));
  };
  auto const elastic = [](OrderRow const& r) { return r.group != "plastic" && r.group != "boundaries"; };
  auto const group = [](std::string const& name) { return [=](OrderRow const& r) { return r.group == name; }; };
  claim("linear, switch off, elastic, 1D to 3D, every variable: L1 order 2.00 +- 0.1", "linear, off", 1.9, 2.1,
        elastic);
  claim("linear, graded switch, elastic, 1D to 3D, every variable: L1 order at least 1.8", "linear, graded", 1.8, 3,
        elastic);
  // what a side reflects is of third order in some variables
  claim("linear, switch off, boundaries: L1 order at least 1.8", "linear, off", 1.8, 3.5, group("boundaries"));
  claim("linear, switch off, plastic loading, uniaxial and not proportional, 1D to 3D: L1 order at least 1.8",
        "linear, off", 1.8, 3, group("plastic"));
  claim("linear, graded switch, plastic loading: L1 order at least 1.8", "linear, graded", 1.8, 3, group("plastic"));
  claim("parabolic, bounds on, plastic loading: L1 order at least 1.8", "parabolic, on", 1.8, 4, group("plastic"));
  claim("parabolic, bounds on, P and S waves in 1D: L1 order at least 2.8", "parabolic, on", 2.8, 3.5, group("waves"));
  claim("parabolic, bounds on, elastic, 1D to 3D: L1 order at least 1.8", "parabolic, on", 1.8, 4, elastic);
  claim("Godunov, every problem and variable: L1 order 0.7 to 1.1", "godunov", 0.7, 1.1,
        [](OrderRow const&) { return true; });
  return {{order_table(results), error_table(results)}, findings};
}

}  // namespace

Study order_solid_study() {
  return {"order-solid",
          "the solid schemes are of second order in every variable, elastic and plastic, Godunov's of first", run};
}

}  // namespace g27
