#include "fsi/line/gas_solid_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "riemann/contact/fixed_point.hpp"

namespace g27 {

namespace {

constexpr int most_retries = 12;

/// The end at which the two meet.
LineEnd gas_end(GasLineSetup const& gas, SolidLineSetup const& solid) {
  if (gas.faces.empty() || solid.faces.empty()) throw std::invalid_argument("gas and solid need faces");
  if (gas.symmetry != solid.symmetry) throw std::invalid_argument("gas and solid need one symmetry");
  bool const left = gas.faces.back() == solid.faces.front(), right = solid.faces.back() == gas.faces.front();
  if (!left && !right) throw std::invalid_argument("the gas must end where the solid begins, or the other way round");
  bool const contacts = (left ? gas.right : gas.left).kind == GasBoundary::Kind::contact &&
                        (left ? solid.left : solid.right).kind == SolidBoundary::Kind::contact;
  if (!contacts) throw std::invalid_argument("both boundaries where gas and solid meet must be contacts");
  return left ? LineEnd::right : LineEnd::left;
}

}  // namespace

GasSolidLine::GasSolidLine(GasLineSetup gas, SolidLineSetup solid, ContactSolver solver)
    : solver_(solver),
      gas_end_(gas_end(gas, solid)),
      solid_end_(gas_end_ == LineEnd::right ? LineEnd::left : LineEnd::right),
      gas_(std::move(gas)),
      solid_(std::move(solid)) {}

double GasSolidLine::position() const noexcept {
  return solid_end_ == LineEnd::left ? solid_.faces().front() : solid_.faces().back();
}

GasSolidLine::Solved GasSolidLine::solve(double dt) {
  // along the normal from the gas into the solid
  double const n = gas_end_ == LineEnd::right ? 1.0 : -1.0;
  GasState<> gas = gas_.trace(gas_end_, dt);
  gas.u *= n;
  SolidTrace const solid = solid_.trace(solid_end_, dt);
  GasSolidContact const r = std::visit(
      [&](auto const& eos) {
        if (solver_ == ContactSolver::newton) return gas_solid_contact(eos, gas, solid);
        std::size_t const edge = solid_end_ == LineEnd::left ? 0 : solid_.cells() - 1;
        return fixed_point_contact(eos, gas, solid, n * solid_.primitive(edge).u[0]);
      },
      gas_.setup().eos);
  return {.contact = {.p = r.contact.p, .u = n * r.contact.u},
          .converged = r.converged,
          .vacuum = r.vacuum,
          .yielding = r.contact.p > solid.yield_pressure,
          .iterations = r.iterations};
}

StepReport GasSolidLine::step(double t_end) {
  double shrink = 1.0;
  StepReport report;
  for (int tried = 0; tried <= most_retries; ++tried, shrink *= 0.5) {
    counters_.retried += tried > 0 ? 1 : 0;
    double const dt = std::min(gas_.next_dt(t_end, shrink), solid_.next_dt(t_end, shrink));
    report = {.status = StepStatus::time_step_vanished, .cell = 0, .dt = dt};
    if (!(dt > 0) || !(time() + dt > time())) return report;
    report.status = StepStatus::inadmissible_state;
    Solved const found = solve(dt);
    if (!found.converged) {
      report.cell = gas_end_ == LineEnd::right ? gas_.cells() - 1 : 0;
      continue;
    }
    report = gas_.attempt(dt, {.left = found.contact, .right = found.contact});
    if (report.status != StepStatus::ok) continue;
    report = solid_.attempt(dt, {.left = found.contact, .right = found.contact});
    if (report.status != StepStatus::ok) {
      report.cell += gas_.cells();
      continue;
    }
    gas_.accept(), solid_.accept();
    contact_ = found.contact;
    counters_.steps += 1, counters_.iterations += static_cast<std::uint64_t>(found.iterations);
    counters_.vacua += found.vacuum ? 1 : 0, counters_.yielding += found.yielding ? 1 : 0;
    return report;
  }
  return report;
}

}  // namespace g27
