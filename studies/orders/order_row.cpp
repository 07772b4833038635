#include "studies/orders/order_row.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "studies/driver/machine_threads.hpp"
#include "verification/cases/media.hpp"

namespace g27 {
namespace {

constexpr double round_off = 1e-12;   ///< hundreds of steps of a few 1e-16 each
constexpr double least_share = 0.02;  ///< of the largest error, below which a variable does not move
constexpr double blown_up = 1.0;      ///< an error as large as the medium's own density, sound speed or bulk modulus

Case find_case(std::string const& name) {
  for (Case& c : all_cases()) {
    if (c.name == name) return std::move(c);
  }
  throw std::invalid_argument("no case '" + name + "'");
}

OrderFit fit(VariableOrder const& v, double Norms::*norm) {
  std::vector<double> errors;
  for (Norms const& e : v.errors) errors.push_back(e.*norm);
  return fit_order(v.h, errors);
}

void judge(VariableOrder& v, bool stopped) {
  double largest = 0;
  for (Norms const& e : v.errors) {
    if (!(e.linf <= largest)) largest = e.linf;  // a NaN stays
  }
  if (stopped || !(largest <= blown_up)) {
    v.state = VariableOrder::State::failed;
  } else if (largest <= round_off) {
    v.state = VariableOrder::State::round_off;
  } else {
    v.l1 = fit(v, &Norms::l1), v.l2 = fit(v, &Norms::l2), v.linf = fit(v, &Norms::linf);
  }
}

}  // namespace

RowResult measure_order(OrderRow const& row) {
  Case const problem = find_case(row.problem);
  auto units = row.units;
  if (units.empty()) {
    Medium const m = medium(row.eos);
    units = {{"density", m.base.rho}, {"velocity", m.sound}, {"pressure", m.base.rho * m.sound * m.sound}};
  }
  RowResult result{.row = row, .variables = {}, .failure = {}};
  for (auto const& [variable, unit] : units) result.variables.emplace_back().variable = variable;

  for (int const cells : row.cells) {
    CaseOptions options = row.options;
    options.cells = cells, options.eos = row.eos, options.mesh = row.mesh;
    if (problem.dimensions > 1) options.threads = threads_or_all(0);
    try {
      CaseResult const run = problem.run(options);
      for (std::size_t k = 0; k < units.size(); ++k) {
        VariableOrder& v = result.variables[k];
        Norms const& e = run.errors.at(v.variable);
        double const unit = units[k].second;
        v.h.push_back(1.0 / cells);
        v.errors.push_back({e.l1 / unit, e.l2 / unit, e.linf / unit});
      }
    } catch (std::runtime_error const& stop) {
      result.failure = std::to_string(cells) + " cells: " + stop.what();
    }
  }
  for (VariableOrder& v : result.variables) judge(v, !result.failure.empty());
  return result;
}

void keep_moving(RowResult& r) {
  if (!r.failure.empty()) return;
  auto const finest = [](VariableOrder const& v) { return v.errors.empty() ? 0.0 : v.errors.back().l1; };
  double largest = 0;
  for (VariableOrder const& v : r.variables) largest = std::max(largest, finest(v));
  std::erase_if(r.variables,
                [&](VariableOrder const& v) { return v.errors.empty() || !(finest(v) >= least_share * largest); });
}

}  // namespace g27
