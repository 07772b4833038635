#include "studies/orders/order_tables.hpp"

#include <stdexcept>

namespace g27 {
namespace {

using State = VariableOrder::State;

std::string name_of(State state) {
  return state == State::fitted ? "fitted" : state == State::round_off ? "round-off" : "failed";
}

}  // namespace

Table order_table(std::vector<RowResult> const& results) {
  Table table{.name = "orders",
              .title = "observed order, least squares over the grids, with its 95 % confidence interval",
              .columns = {{"group", "1"},
                          {"case", "1"},
                          {"law", "1"},
                          {"mesh", "1"},
                          {"scheme", "1"},
                          {"variable", "1"},
                          {"state", "1"},
                          {"coarsest_cells", "1"},
                          {"finest_cells", "1"},
                          {"l1_order", "1"},
                          {"l1_interval", "1"},
                          {"l2_order", "1"},
                          {"l2_interval", "1"},
                          {"linf_order", "1"},
                          {"linf_interval", "1"},
                          {"finest_l1_error", "1"}},
              .rows = {},
              .facts = {}};
  for (RowResult const& r : results) {
    for (VariableOrder const& v : r.variables) {
      OrderRow const& row = r.row;
      double const nan = std::numeric_limits<double>::quiet_NaN();
      auto const shown = [&](double x) { return v.state == State::fitted ? x : nan; };
      table.rows.push_back({row.group, row.problem, row.eos, row.mesh, row.scheme, v.variable, name_of(v.state),
                            long{row.cells.front()}, long{row.cells.back()}, shown(v.l1.order), shown(v.l1.half_width),
                            shown(v.l2.order), shown(v.l2.half_width), shown(v.linf.order), shown(v.linf.half_width),
                            v.errors.empty() ? nan : v.errors.back().l1});
    }
  }
  return table;
}

Table error_table(std::vector<RowResult> const& results) {
  Table table{.name = "errors",
              .title = "errors over the medium's density, sound speed and bulk modulus",
              .columns = {{"group", "1"},
                          {"case", "1"},
                          {"law", "1"},
                          {"mesh", "1"},
                          {"scheme", "1"},
                          {"variable", "1"},
                          {"h", "m"},
                          {"l1", "1"},
                          {"l2", "1"},
                          {"linf", "1"}},
              .rows = {},
              .facts = {}};
  for (RowResult const& r : results) {
    for (VariableOrder const& v : r.variables) {
      for (std::size_t i = 0; i < v.h.size(); ++i) {
        table.rows.push_back({r.row.group, r.row.problem, r.row.eos, r.row.mesh, r.row.scheme, v.variable, v.h[i],
                              v.errors[i].l1, v.errors[i].l2, v.errors[i].linf});
      }
    }
  }
  return table;
}

Spread spread(std::vector<RowResult> const& results, Chosen const& chosen) {
  Spread s;
  for (RowResult const& r : results) {
    for (VariableOrder const& v : r.variables) {
      if (!chosen(r.row, v)) continue;
      std::string const where = fmt::format("{} {} {} {}", r.row.problem, r.row.eos, r.row.mesh, v.variable);
      if (v.state == State::failed) s.failure = r.failure.empty() ? where : r.failure;
      if (v.state == State::round_off) ++s.exact;
      if (v.state != State::fitted) continue;
      ++s.fitted;
      if (v.l1.order < s.least) s.least = v.l1.order, s.at_least = where;
      if (v.l1.order > s.largest) s.largest = v.l1.order, s.at_largest = where;
    }
  }
  return s;
}

Finding order_claim(std::vector<RowResult> const& results, std::string const& text, double low, double high,
                    Chosen const& chosen) {
  Spread const s = spread(results, chosen);
  return {text, s.text(), s.within(low, high)};
}

std::vector<RowResult> measure_orders(std::vector<OrderRow> const& rows, StudyContext const& context) {
  std::vector<RowResult> results;
  for (OrderRow const& row : rows) {  // before hours of work
    if (row.cells.size() < 4) throw std::invalid_argument("an order of " + row.problem + " needs four grids");
  }
  for (OrderRow const& row : rows) {
    if (context.progress) {
      context.progress(static_cast<double>(results.size()) / static_cast<double>(rows.size()),
                       row.problem + " " + row.eos + " " + row.mesh + " " + row.scheme);
    }
    results.push_back(measure_order(row));
  }
  return results;
}

}  // namespace g27
