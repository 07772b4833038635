#include "verification/exact/gas_solid.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {

GasSolid::GasSolid(ExactEos const& eos, GasState<> const& gas, SolidMaterial const& material, SolidPoint const& solid,
                   SolidModel model)
    : eos_(eos), state_(gas), material_(material), ahead_(solid), model_(model) {
  double const sigma = solid.p - solid.S[0];
  a_ = AxialWaves(material, solid, sigma, Direction::right).sound_speed();
  double const lowest = Isentrope(eos, gas.rho, gas.p).lowest_pressure();
  // grows with the stress: the gas pushes less the faster the surface runs away from it
  auto excess = [&](double P) { return P - against_wall(surface_velocity(P)).p_star(); };
  vacuum_ = against_wall(surface_velocity(lowest)).vacuum();
  p_star_ = lowest;
  if (!vacuum_) {
    double const unit = std::max(gas.p, sigma) - lowest;
    double hi = lowest + unit, lo = hi;
    while (excess(hi) < 0) hi = lowest + 4 * ((lo = hi) - lowest);
    while (excess(lo) > 0) lo = lowest + ((hi = lo) - lowest) / 64;
    auto of_log = [&](double y) { return excess(lowest + std::exp(y)); };
    p_star_ = lo == hi ? lo : lowest + std::exp(find_root(of_log, std::log(lo - lowest), std::log(hi - lowest)));
  }
  u_star_ = surface_velocity(p_star_);
  gas_.emplace(against_wall(u_star_));
  if (model == SolidModel::waves) waves_.emplace(material, solid, p_star_, Direction::right);
}

double GasSolid::surface_velocity(double P) const {
  if (model_ == SolidModel::linear) return ahead_.u[0] + (P - (ahead_.p - ahead_.S[0])) / (ahead_.rho * a_);
  return AxialWaves(material_, ahead_, P, Direction::right).behind().u[0];
}

GasRiemann GasSolid::against_wall(double u) const {
  return {eos_, state_, eos_, GasState<>{state_.rho, 2 * u - state_.u, state_.p}};
}

SolidPoint GasSolid::solid_star() const {
  if (waves_) return waves_->behind();
  // u_x = -du/a for waves that run to the right: compression by the velocity of the push
  double const strain = -(u_star_ - ahead_.u[0]) / a_;
  double const gradient[3][3] = {{strain, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  SolidPoint const change = elastic_rate(material_, ahead_, gradient);
  SolidPoint out = ahead_;
  out.rho += change.rho, out.u[0] = u_star_, out.p += change.p, out.e += change.e;
  for (std::size_t c = 0; c < 6; ++c) out.S[c] += change.S[c];
  return out;
}

SolidPoint GasSolid::solid_at(double xi) const {
  if (waves_) return waves_->at(xi);
  return xi < ahead_.u[0] + a_ ? solid_star() : ahead_;
}

std::vector<double> GasSolid::solid_speeds() const {
  return waves_ ? waves_->speeds() : std::vector<double>{ahead_.u[0] + a_};
}

std::string GasSolid::solid_pattern() const { return waves_ ? waves_->pattern() : "linear wave"; }

double GasSolid::residual() const {
  double const p = gas_->p_star();
  double const gap = std::fabs(p - p_star_) / std::max({std::fabs(p), std::fabs(ahead_.p - ahead_.S[0]), state_.p});
  return waves_ ? std::max(gap, waves_->residual()) : gap;
}

}  // namespace g27
