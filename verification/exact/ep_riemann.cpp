#include "verification/exact/ep_riemann.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

/// Lower end of the stresses a material can take: a fluid's pressure where its sound speed ends.
double lowest_stress(SolidMaterial const& m) {
  if (m.mu > 0) return -1e300;
  if (auto const* law = std::get_if<StiffenedLaw>(&m.law)) return -law->p_inf;
  return std::holds_alternative<IdealLaw>(m.law) || std::holds_alternative<JwlLaw>(m.law) ? 0 : -1e300;
}

double contact_stress(SolidMaterial const& material_l, SolidPoint const& l, SolidMaterial const& material_r,
                      SolidPoint const& r) {
  auto excess = [&](double sigma) {
    return AxialWaves(material_l, l, sigma, Direction::left).behind().u[0] -
           AxialWaves(material_r, r, sigma, Direction::right).behind().u[0];
  };
  double const sigma_l = l.p - l.S[0], sigma_r = r.p - r.S[0];
  double const z_l = l.rho * AxialWaves(material_l, l, sigma_l, Direction::left).sound_speed(),
               z_r = r.rho * AxialWaves(material_r, r, sigma_r, Direction::right).sound_speed();
  double const acoustic = (z_r * sigma_l + z_l * sigma_r + z_l * z_r * (l.u[0] - r.u[0])) / (z_l + z_r);
  double const lowest = std::max(lowest_stress(material_l), lowest_stress(material_r));
  double const step = std::fabs(acoustic - sigma_l) + std::fabs(acoustic - sigma_r);
  double const start = acoustic > lowest ? acoustic : lowest + (std::min(sigma_l, sigma_r) - lowest) / 2;
  if (step == 0 && start == acoustic) return acoustic;
  double lo = start, hi = start;
  for (double by = step; excess(hi) > 0; by *= 2) hi = (lo = hi) + by / 4;
  // fans of a fluid end where its sound speed does
  NumericsError const opens("the contact opens: no stress that both laws can bear holds the sides together");
  auto pulled_apart = [&](double sigma) {
    if (sigma - lowest < 1e-9 * (std::max(sigma_l, sigma_r) - lowest)) throw opens;
    try {
      return excess(sigma) < 0;
    } catch (NumericsError const&) {
      throw opens;
    }
  };
  for (double by = step; pulled_apart(lo); by *= 2) {
    double const next = lo - by / 4;
    hi = lo;
    lo = next > lowest ? next : lowest + (lo - lowest) / 4;
  }
  return lo == hi ? lo : find_root(excess, lo, hi);
}

}  // namespace

EpRiemann::EpRiemann(SolidMaterial const& material_l, SolidPoint const& left, SolidMaterial const& material_r,
                     SolidPoint const& right)
    : initial_l_(left),
      initial_r_(right),
      sigma_star_(contact_stress(material_l, left, material_r, right)),
      left_(material_l, left, sigma_star_, Direction::left),
      right_(material_r, right, sigma_star_, Direction::right),
      u_star_((left_.behind().u[0] + right_.behind().u[0]) / 2) {}

std::vector<double> EpRiemann::speeds() const {
  std::vector<double> out = left_.speeds();
  out.push_back(u_star_);
  for (double const s : right_.speeds()) out.push_back(s);
  return out;
}

SolidPoint EpRiemann::at(double xi) const { return xi < u_star_ ? left_.at(xi) : right_.at(xi); }

SolidDensities EpRiemann::average(double x0, double x1, double t) const {
  std::vector<double> breaks;
  for (double const s : speeds()) breaks.push_back(t > 0 ? s * t : 0);
  return solid_average([&](double x) { return t > 0 ? at(x / t) : x < 0 ? initial_l_ : initial_r_; }, x0, x1, breaks);
}

double EpRiemann::residual() const {
  double const gap =
      std::fabs(left_.behind().u[0] - right_.behind().u[0]) / std::max(left_.sound_speed(), right_.sound_speed());
  return std::max({gap, left_.residual(), right_.residual()});
}

}  // namespace g27
