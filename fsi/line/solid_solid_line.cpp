#include "fsi/line/solid_solid_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace g27 {

namespace {

constexpr int most_retries = 12;

SolidLineSetup joined(SolidLineSetup left, SolidLineSetup const& right) {
  using Kind = SolidBoundary::Kind;
  if (left.faces.empty() || right.faces.empty()) throw std::invalid_argument("both solids need faces");
  if (left.symmetry != right.symmetry) throw std::invalid_argument("both solids need one symmetry");
  if (left.faces.back() != right.faces.front())
    throw std::invalid_argument("the right solid must begin where the left one ends");
  if (left.right.kind != Kind::contact || right.left.kind != Kind::contact)
    throw std::invalid_argument("both boundaries where the solids meet must be contacts");
  if (left.left.kind == Kind::contact || right.right.kind == Kind::contact)
    throw std::invalid_argument("the outer ends of two bonded solids cannot be contacts");
  if (left.material.mu == 0 && right.material.mu == 0)
    throw std::invalid_argument("two fluids cannot be bonded: one of them needs a shear modulus above 0");
  return left;
}

}  // namespace

SolidSolidLine::SolidSolidLine(SolidLineSetup left, SolidLineSetup right)
    : left_(joined(std::move(left), right)), right_(std::move(right)) {}

StepReport SolidSolidLine::step(double t_end) {
  double shrink = 1.0;
  StepReport report;
  for (int tried = 0; tried <= most_retries; ++tried, shrink *= 0.5) {
    retried_ += tried > 0 ? 1 : 0;
    double const dt = std::min(left_.next_dt(t_end, shrink), right_.next_dt(t_end, shrink));
    report = {.status = StepStatus::time_step_vanished, .cell = 0, .dt = dt};
    if (!(dt > 0) || !(time() + dt > time())) return report;
    BondedContact const found =
        bonded_contact(left_.bonded_side(LineEnd::right, dt), right_.bonded_side(LineEnd::left, dt));
    report = left_.attempt(dt, {.right = found});
    if (report.status != StepStatus::ok) continue;
    report = right_.attempt(dt, {.left = found});
    if (report.status != StepStatus::ok) {
      report.cell += left_.cells();
      continue;
    }
    left_.accept(), right_.accept();
    contact_ = found;
    return report;
  }
  return report;
}

}  // namespace g27
