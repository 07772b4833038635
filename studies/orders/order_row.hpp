#pragma once
/// One row of an order study: a case, a law, a mesh and a scheme on a family of grids, and the orders it shows.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/cases/case.hpp"
#include "verification/measure/order.hpp"

namespace g27 {

struct OrderRow {
  std::string group;                       ///< what the row is there for
  std::string problem, eos, mesh, scheme;  ///< `scheme` as the table shows it
  CaseOptions options;                     ///< predictor, switch, ablations
  std::vector<int> cells;
  /// Variables and what their errors are divided by; empty: density, velocity, pressure of the gas `eos`.
  std::vector<std::pair<std::string, double>> units{};
};

/// Errors are relative: to the medium's density, its sound speed and its bulk modulus, or to the row's own units.
struct VariableOrder {
  enum class State {
    fitted,
    round_off,  ///< constant in the exact solution and kept to round-off: no order to fit
    failed      ///< the scheme stopped, or the error outgrew the solution
  };
  std::string variable;
  State state = State::fitted;
  std::vector<double> h;      ///< of the grids that ran, over the length of the line
  std::vector<Norms> errors;  ///< [grids]
  OrderFit l1, l2, linf;      ///< where `fitted`
};

struct RowResult {
  OrderRow row;
  std::vector<VariableOrder> variables;  ///< in the order of the units
  std::string failure;                   ///< why a run stopped, if one did
};

/// Runs the row on its grids.
RowResult measure_order(OrderRow const& row);

/// Leaves out the variables that a problem does not move: those whose error on the finest grid is less than 2 % of its
/// largest one. They carry products of errors, and round-off: an S wave moves density and pressure by the square of its
/// amplitude.
void keep_moving(RowResult& r);

}  // namespace g27
