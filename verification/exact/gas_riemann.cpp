#include "verification/exact/gas_riemann.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

/// Density that no single shock reaches.
double compression_limit(ExactEos const& eos, double rho) {
  if (auto const* ideal = std::get_if<IdealLaw>(&eos)) return rho * (ideal->gamma + 1) / (ideal->gamma - 1);
  if (auto const* stiff = std::get_if<StiffenedLaw>(&eos)) return rho * (stiff->gamma + 1) / (stiff->gamma - 1);
  if (auto const* jwl = std::get_if<JwlLaw>(&eos)) return rho * (2 + jwl->omega) / jwl->omega;
  auto const& solid = std::get<MieGruneisenLaw>(eos);
  double const volume = 1 / rho - 2 / (solid.Gamma0 * solid.rho0), least = (1 - 1 / solid.s) / solid.rho0;
  return 1 / std::max({volume, least, 1e-9 / solid.rho0});
}

/// |u* - u| across the wave to pressure p: positive for a shock, negative for a rarefaction.
double velocity_jump(Isentrope const& isentrope, GasState<> const& s, double p) {
  if (p > s.p) return std::sqrt((p - s.p) * (1 / s.rho - 1 / shock_density(isentrope.eos(), s, p)));
  if (p <= isentrope.lowest_pressure()) return isentrope.vacuum_invariant();
  return isentrope.invariant(isentrope.density(p));
}

GasConserved<> conserved_of(ExactEos const& eos, GasState<> const& s) {
  // no matter left: what remains of rho e is the limit on the isentrope
  if (s.rho == 0) return {0, 0, -s.p};
  return {s.rho, s.rho * s.u, s.rho * (energy(eos, s.rho, s.p) + s.u * s.u / 2)};
}

}  // namespace

double shock_density(ExactEos const& eos, GasState<> const& s, double p) {
  double const e = energy(eos, s.rho, s.p);
  auto hugoniot = [&](double rho) { return energy(eos, rho, p) - e - (p + s.p) / 2 * (1 / s.rho - 1 / rho); };
  double const limit = compression_limit(eos, s.rho);
  if (hugoniot(s.rho) <= 0) return s.rho;  // weaker than round-off
  // Close in on the limit from below, where the Hugoniot function may be singular.
  for (double gap = 0.5; gap > 1e-15; gap /= 16) {
    double const rho = limit - (limit - s.rho) * gap;
    if (hugoniot(rho) < 0) return find_root(hugoniot, s.rho, rho);
  }
  throw NumericsError("no shock reaches the pressure " + std::to_string(p));
}

GasRiemann::GasRiemann(ExactEos const& eos_l, GasState<> const& left, ExactEos const& eos_r, GasState<> const& right)
    : side_{{.isentrope = Isentrope(eos_l, left.rho, left.p), .state = left},
            {.isentrope = Isentrope(eos_r, right.rho, right.p), .state = mirror(right)}} {
  auto const& [l, r] = side_;
  double const closing = l.state.u + r.state.u;  // speed at which the two states approach each other
  auto excess = [&](double p) {
    return velocity_jump(l.isentrope, l.state, p) + velocity_jump(r.isentrope, r.state, p) - closing;
  };
  double const lowest = std::max(l.isentrope.lowest_pressure(), r.isentrope.lowest_pressure());
  vacuum_ = excess(lowest) >= 0;
  if (vacuum_) {
    p_star_ = lowest;
  } else {
    // One side may be in tension below what the other can bear.
    double hi = std::max(l.state.p, r.state.p), lo = std::max(std::min(l.state.p, r.state.p), lowest);
    if (lo == lowest) lo = hi;
    for (double step = hi - lowest; excess(hi) < 0; step *= 2) {
      lo = hi;
      hi += step;
    }
    while (excess(lo) > 0) {
      hi = lo;
      lo = lowest + (lo - lowest) / 1024;
    }
    // The logarithm resolves star pressures far below those of both sides.
    auto of_log = [&](double y) { return excess(lowest + std::exp(y)); };
    // Widened by round-off, for a jump that is no more than that.
    p_star_ = lo == hi
                  ? lo
                  : lowest + std::exp(find_root(of_log, std::log(lo - lowest) - 1e-13, std::log(hi - lowest) + 1e-13));
  }
  finish(0, p_star_);
  finish(1, p_star_);
  if (!vacuum_) {
    // Both sides give the contact speed; they differ by the round-off of the root.
    double const u = (side_[0].u_star + side_[1].u_star) / 2;
    side_[0].u_star = side_[1].u_star = u;
  }
}

void GasRiemann::finish(int k, double p) {
  Side& side = side_[k];
  GasState<> const& s = side.state;
  double const c = side.isentrope.sound_speed(s.rho), jump = velocity_jump(side.isentrope, s, p);
  side.shock = p > s.p;
  double u_star = s.u - jump, head, tail;
  if (side.shock) {
    side.rho_star = shock_density(side.isentrope.eos(), s, p);
    // The mean of the characteristic speeds errs by the square of the strength, the jump condition by round-off over
    // the strength.
    bool const weak = p - s.p < 3e-6 * s.rho * c * c;
    double const v = 1 / s.rho;
    head = tail = weak ? (s.u - c + u_star - sound_speed(side.isentrope.eos(), side.rho_star, p)) / 2
                       : s.u - v * std::sqrt((p - s.p) / (v - 1 / side.rho_star));
  } else if (p <= side.isentrope.lowest_pressure()) {
    side.rho_star = 0;
    head = s.u - c;
    tail = u_star;
  } else {
    side.rho_star = side.isentrope.density(p);
    head = s.u - c;
    tail = u_star - side.isentrope.sound_speed(side.rho_star);
  }
  double const sign = k == 0 ? 1 : -1;
  side.u_star = sign * u_star;
  side.head = sign * head;
  side.tail = sign * tail;
}

std::string GasRiemann::pattern() const { return wave_l() + (vacuum_ ? "-vacuum-" : "-contact-") + wave_r(); }

std::vector<double> GasRiemann::speeds() const {
  auto const& [l, r] = side_;
  std::vector<double> out{l.head};
  if (!l.shock) out.push_back(l.tail);
  if (!vacuum_) out.push_back(u_star());
  // a fan that reaches zero density ends at the vacuum: its tail is the front
  if (vacuum_ && l.rho_star > 0) out.push_back(l.u_star);
  if (vacuum_ && r.rho_star > 0) out.push_back(r.u_star);
  if (!r.shock) out.push_back(r.tail);
  out.push_back(r.head);
  return out;
}

GasState<> GasRiemann::in_fan(int k, double xi) const {
  Side const& side = side_[k];
  Isentrope const& isentrope = side.isentrope;
  double const ray = k == 0 ? xi : -xi;
  // u - c along the fan grows from the head to the tail as the density falls
  auto speed = [&](double rho) { return side.state.u - isentrope.invariant(rho) - isentrope.sound_speed(rho) - ray; };
  double lo = std::log(side.rho_star), hi = std::log(side.state.rho);
  if (side.rho_star == 0) {
    lo = hi;
    for (double step = 1; speed(std::exp(lo)) <= 0 && lo > -600; step *= 2) lo -= step;
  }
  double rho = std::exp(lo);
  if (speed(rho) <= 0) return {rho, side.u_star, p_star_};
  if (speed(side.state.rho) >= 0)
    rho = side.state.rho;
  else
    rho = std::exp(find_root([&](double y) { return speed(std::exp(y)); }, lo, hi));
  double const u = side.state.u - isentrope.invariant(rho);
  return {rho, k == 0 ? u : -u, isentrope.pressure(rho)};
}

GasRiemann::Ray GasRiemann::ray(double xi) const {
  auto const& [l, r] = side_;
  ExactEos const *eos_l = &l.isentrope.eos(), *eos_r = &r.isentrope.eos();
  if (xi <= l.head) return {0, l.state, eos_l};
  if (xi >= r.head) return {6, mirror(r.state), eos_r};
  if (xi < l.tail) return {1, in_fan(0, xi), eos_l};
  if (xi > r.tail) return {5, in_fan(1, xi), eos_r};
  if (xi < l.u_star) return {2, {l.rho_star, l.u_star, p_star_}, eos_l};
  if (xi > r.u_star || !vacuum_) return {4, {r.rho_star, r.u_star, p_star_}, eos_r};
  return {3, {0, xi, p_star_}, eos_l};
}

GasState<> GasRiemann::at(double xi) const { return ray(xi).state; }

GasConserved<> GasRiemann::conserved(double xi) const {
  Ray const r = ray(xi);
  return conserved_of(*r.eos, r.state);
}

GasConserved<> GasRiemann::antiderivative(Ray const& r, double xi) const {
  GasConserved<> const c = conserved_of(*r.eos, r.state);
  double const u = r.state.u, p = r.state.p;
  return {c.mass * (xi - u), c.momentum * (xi - u) - p, c.energy * (xi - u) - p * u};
}

GasConserved<> GasRiemann::average(double x0, double x1, double t) const {
  if (t <= 0) {
    GasConserved<> const l = conserved_of(side_[0].isentrope.eos(), side_[0].state),
                         r = conserved_of(side_[1].isentrope.eos(), mirror(side_[1].state));
    double const w = std::clamp(-x0 / (x1 - x0), 0.0, 1.0);
    return {w * l.mass + (1 - w) * r.mass, w * l.momentum + (1 - w) * r.momentum, w * l.energy + (1 - w) * r.energy};
  }
  double const xi0 = x0 / t, xi1 = x1 / t;
  Ray const a = ray(xi0), b = ray(xi1);
  bool const constant = a.region == b.region && a.region != 1 && a.region != 5;
  if (constant) return conserved_of(*a.eos, a.state);
  GasConserved<> const w0 = antiderivative(a, xi0), w1 = antiderivative(b, xi1);
  double const h = xi1 - xi0;
  return {(w1.mass - w0.mass) / h, (w1.momentum - w0.momentum) / h, (w1.energy - w0.energy) / h};
}

}  // namespace g27
