/// Observed orders of the gas schemes in three dimensions on smooth problems.
#include "studies/orders/order_schemes.hpp"
#include "studies/orders/order_tables.hpp"

namespace g27 {
namespace {

/// Fine enough for the asymptotic range; sources (mms) are evaluated in every cell and step, hence few cells.
std::vector<int> grids(std::string const& problem, Predictor predictor, Switch monotonicity) {
  if (problem == "mms-3d") {
    if (predictor != Predictor::linear) return {16, 20, 24, 32};
    // the switch lets go of the crests from 40 cells on
    return monotonicity == Switch::off ? std::vector{24, 32, 40, 48} : std::vector{40, 44, 48, 56};
  }
  if (predictor == Predictor::godunov) return {64, 80, 96, 128};
  return {32, 40, 48, 64};
}

std::vector<OrderRow> all_rows() {
  std::vector<OrderRow> rows;
  auto const add = [&](std::string const& problem, std::string const& eos, std::string const& mesh) {
    for (OrderScheme const& s : order_schemes) {
      OrderRow row{"laws", problem, eos, mesh, s.name, {}, grids(problem, s.predictor, s.monotonicity)};
      row.options.predictor = s.predictor, row.options.monotonicity = s.monotonicity;
      rows.push_back(row);
    }
  };
  for (char const* eos : {"ideal", "jwl"}) {
    for (char const* problem : {"acoustic-3d", "mms-3d"}) add(problem, eos, "fixed");
  }
  return rows;
}

/// Velocity and pressure of a density wave are constant: what errors they have come from round-off.
bool varies(OrderRow const& r, VariableOrder const& v) {
  return r.problem.rfind("entropy", 0) != 0 || v.variable == "density";
}

StudyReport run(StudyContext const& context) {
  std::vector<RowResult> const results = measure_orders(all_rows(), context);
  std::vector<Finding> findings;
  auto const claim = [&](std::string const& text, std::string const& scheme, double low, double high) {
    findings.push_back(
        order_claim(results, text, low, high, [&](auto& r, auto& v) { return r.scheme == scheme && varies(r, v); }));
  };
  claim("linear, switch off, every variable: L1 order 1.95 to 2.2", "linear, off", 1.95, 2.2);
  claim("linear, graded switch, every variable: L1 order 1.85 to 2.6", "linear, graded", 1.85, 2.6);
  claim("parabolic, bounds off, every variable: L1 order 1.95 to 3.2", "parabolic, off", 1.95, 3.2);
  // above where refinement also frees crests from the bounds
  claim("parabolic, bounds on, every variable: L1 order 1.85 to 3.8", "parabolic, on", 1.85, 3.8);
  claim("Godunov, every variable: L1 order 0.75 to 1.1", "godunov", 0.75, 1.1);
  return {{order_table(results), error_table(results)}, findings};
}

}  // namespace

Study order_3d_study() {
  return {"order-3d", "in three dimensions the gas schemes are of second order, Godunov's of first, for every law",
          run};
}

}  // namespace g27
