#include "verification/exact/isentrope.hpp"

#include <limits>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double pressure_on(IdealLaw const& law, double rho0, double p0, double rho) {
  return p0 * std::pow(rho / rho0, law.gamma);
}
double pressure_on(StiffenedLaw const& law, double rho0, double p0, double rho) {
  return (p0 + law.p_inf) * std::pow(rho / rho0, law.gamma) - law.p_inf;
}
double pressure_on(JwlLaw const& law, double rho0, double p0, double rho) {
  return law.thermal(rho0, p0) * std::pow(rho / rho0, 1 + law.omega) - law.thermal(rho, 0.0);
}
/// One side of rho = law.rho0, where the reference changes.
double pressure_on_branch(MieGruneisenLaw const& law, double rho0, double p0, double rho) {
  double const eta0 = 1 - law.rho0 / rho0, eta1 = 1 - law.rho0 / rho;
  double const growth = std::exp(law.Gamma0 * (eta1 - eta0));
  // expanded, the reference is itself an isentrope
  if (std::min(eta0, eta1) < 0) return law.reference(eta1).p + (p0 - law.reference(eta0).p) * growth;
  auto forcing = [&](double eta) {
    auto const r = law.reference(eta);
    return std::exp(law.Gamma0 * (eta1 - eta)) * (r.p_slope - law.Gamma0 * r.e_slope);
  };
  double const size = law.rho0 * law.c0 * law.c0 * std::fabs(eta1 - eta0);
  return p0 * growth + integrate(forcing, eta0, eta1, 2e-14, size);
}
double pressure_on(MieGruneisenLaw const& law, double rho0, double p0, double rho) {
  if ((rho0 - law.rho0) * (rho - law.rho0) >= 0) return pressure_on_branch(law, rho0, p0, rho);
  return pressure_on_branch(law, law.rho0, pressure_on_branch(law, rho0, p0, law.rho0), rho);
}

/// Bulk modulus on the isentrope.
template <class Law>
double modulus_on(Law const& law, double rho0, double p0, double rho) {
  return law.bulk_modulus(rho, pressure_on(law, rho0, p0, rho));
}
double modulus_on(MieGruneisenLaw const& law, double rho0, double p0, double rho) {
  if (rho >= law.rho0) return law.bulk_modulus(rho, pressure_on(law, rho0, p0, rho));
  // Expanded, p - p_ref is far below the round-off of p: take it from where the two isentropes part.
  double const from = std::min(rho0, law.rho0), p_from = pressure_on(law, rho0, p0, from);
  double const thermal = std::max(p_from - law.reference(1 - law.rho0 / from).p, 0.0);
  double const growth = std::exp(law.Gamma0 * law.rho0 * (1 / from - 1 / rho));
  return law.rho0 / rho * (law.reference(1 - law.rho0 / rho).p_slope + law.Gamma0 * thermal * growth);
}

/// Below this density the isentropes are p - lowest = const rho^gamma to double precision.
struct PowerLaw {
  double below, gamma, lowest;
};
PowerLaw power_law(IdealLaw const& law) { return {infinity, law.gamma, 0}; }
PowerLaw power_law(StiffenedLaw const& law) { return {infinity, law.gamma, -law.p_inf}; }
PowerLaw power_law(JwlLaw const& law) {
  // exp(-R v) and R v exp(-R v) against the thermal part: at R v = 100 they are 1e-43 of A
  return {law.rho0 * std::min(law.R1, law.R2) / 100, 1 + law.omega, 0};
}
PowerLaw power_law(MieGruneisenLaw const& law) { return {0, 1, -law.rho0 * law.c0 * law.c0 / (4 * law.s)}; }

}  // namespace

Isentrope::Isentrope(ExactEos eos, double rho, double p) : eos_(std::move(eos)), rho_(rho), p_(p) {
  bool admissible = rho > 0 && g27::sound_speed(eos_, rho, p) > 0;
  // below the cold curve a JWL gas becomes unstable as it expands
  if (auto const* jwl = std::get_if<JwlLaw>(&eos_)) admissible = admissible && jwl->thermal(rho, p) > 0;
  if (!admissible)
    throw NumericsError("state outside the equation of state: density " + std::to_string(rho) + ", pressure " +
                        std::to_string(p));
}

double Isentrope::pressure(double rho) const {
  return std::visit([&](auto const& law) { return pressure_on(law, rho_, p_, rho); }, eos_);
}

double Isentrope::sound_speed(double rho) const {
  return std::visit([&](auto const& law) { return std::sqrt(modulus_on(law, rho_, p_, rho) / rho); }, eos_);
}

/// The integral of c/rho from 0 to rho inside the power law: 2 c/(gamma - 1).
double Isentrope::below(double rho) const {
  double const gamma = std::visit([](auto const& law) { return power_law(law).gamma; }, eos_);
  return 2 * sound_speed(rho) / (gamma - 1);
}

double Isentrope::invariant(double rho) const {
  double const limit = std::visit([](auto const& law) { return power_law(law).below; }, eos_);
  if (rho <= limit && rho_ <= limit) return below(rho) - below(rho_);
  if (rho < limit) return below(rho) - below(limit) + invariant(limit);
  if (rho_ < limit) return Isentrope(eos_, limit, pressure(limit)).invariant(rho) + below(limit) - below(rho_);
  auto c = [&](double log_rho) { return sound_speed(std::exp(log_rho)); };
  double const kink = std::holds_alternative<MieGruneisenLaw>(eos_) ? std::get<MieGruneisenLaw>(eos_).rho0 : rho_;
  double const from = std::log(rho_), to = std::log(rho), middle = std::log(kink);
  if ((kink - rho_) * (kink - rho) < 0) return integrate(c, from, middle) + integrate(c, middle, to);
  return integrate(c, from, to);
}

namespace {

/// The density at which the increasing function f(rho) is zero, searched from `start` by factors.
double increasing_root(ScalarFunction const& f, double start) {
  double lo = start, hi = start, factor = 1.1;
  if (f(start) > 0) {
    while (f(lo) > 0) {
      if (lo < 1e-290) throw NumericsError("no such state on the isentrope: it ends in a vacuum");
      hi = lo;
      lo /= factor;
      factor = std::min(factor * factor, 1e10);
    }
  } else {
    while (f(hi) < 0) {
      if (hi > 1e6 * start) throw NumericsError("no such state on the isentrope");
      lo = hi;
      hi *= factor;
    }
  }
  if (lo == hi) return lo;
  // widened by round-off: a root may sit on an end, and exp(ln rho) is not rho
  return std::exp(find_root([&](double y) { return f(std::exp(y)); }, std::log(lo) - 1e-13, std::log(hi) + 1e-13));
}

}  // namespace

double Isentrope::density(double p) const {
  if (auto const* ideal = std::get_if<IdealLaw>(&eos_)) return rho_ * std::pow(p / p_, 1 / ideal->gamma);
  if (auto const* stiff = std::get_if<StiffenedLaw>(&eos_))
    return rho_ * std::pow((p + stiff->p_inf) / (p_ + stiff->p_inf), 1 / stiff->gamma);
  if (p == p_) return rho_;
  return increasing_root([&](double rho) { return pressure(rho) - p; }, rho_);
}

double Isentrope::density_of_invariant(double w) const {
  PowerLaw const power = std::visit([](auto const& law) { return power_law(law); }, eos_);
  // In the power law c grows with rho^((gamma - 1)/2): closed form.
  double const limit = std::min(power.below, rho_);
  if (limit > 0) {
    double const base = limit < rho_ ? invariant(limit) : 0, c = sound_speed(limit);
    double const ratio = 1 + (power.gamma - 1) * (w - base) / (2 * c);
    if (ratio < 0) throw NumericsError("no such state on the isentrope: it ends in a vacuum");
    if (ratio <= 1 || power.below == infinity) return limit * std::pow(ratio, 2 / (power.gamma - 1));
  }
  if (w == 0) return rho_;
  return increasing_root([&](double rho) { return invariant(rho) - w; }, rho_);
}

double Isentrope::lowest_pressure() const {
  return std::visit([](auto const& law) { return power_law(law).lowest; }, eos_);
}

double Isentrope::vacuum_invariant() const {
  if (auto const* solid = std::get_if<MieGruneisenLaw>(&eos_)) {
    // c/rho falls at least as exp(Gamma0 eta/2): beyond Gamma0 eta = -80 nothing is left
    double const rho = solid->rho0 / (1 + 80 / solid->Gamma0);
    return invariant(std::min(rho, rho_));
  }
  double const limit = std::visit([](auto const& law) { return power_law(law).below; }, eos_);
  double const rho = std::min(limit, rho_);
  return invariant(rho) - below(rho);
}

std::vector<IsentropePoint> integrate_isentrope(ExactEos const& eos, double rho, double p,
                                                std::vector<double> const& densities) {
  double const c0 = sound_speed(eos, rho, p), unit = c0 * c0;
  // y = (e/c0^2, invariant/c0) over ln rho; densities relative to the start keep ln exact there
  auto slope = [&](double x, double const* y, double* out) {
    double const r = rho * std::exp(x), p_here = pressure(eos, r, y[0] * unit);
    out[0] = p_here / (r * unit);
    out[1] = sound_speed(eos, r, p_here) / c0;
  };
  std::vector<double> nodes{0};
  for (double const density : densities) nodes.push_back(std::log(density / rho));
  auto const y = solve_ode(slope, {energy(eos, rho, p) / unit, 0}, nodes);
  std::vector<IsentropePoint> out;
  for (std::size_t i = 0; i < densities.size(); ++i) {
    double const p_here = pressure(eos, densities[i], y[i + 1][0] * unit);
    out.push_back({densities[i], p_here, sound_speed(eos, densities[i], p_here), y[i + 1][1] * c0});
  }
  return out;
}

}  // namespace g27
