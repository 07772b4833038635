#pragma once
/// Exact Riemann solver of the ideal and of the stiffened gas, one problem a lane (Toro, Riemann Solvers, 3rd ed., ch.
/// 4).
///
/// The stiffened gas is an ideal gas in P = p + p_inf. The wave curves f_K(P) = |u* - u_K| are closed, F = f_L + f_R +
/// u_R - u_L is concave in P and convex in P^z, z = (gamma - 1)/(2 gamma), so one-sided steps in a power of P converge
/// from anywhere; near the root Halley's step (third order) ends the iteration. A lane's result never depends on its
/// mates: masks choose, and any() only skips work that no lane needs.
#include <array>

#include "riemann/base/lane_math.hpp"
#include "riemann/eos/ideal_gas.hpp"
#include "riemann/eos/stiffened_gas.hpp"
#include "riemann/gas/face_solution.hpp"

namespace g27 {

namespace ideal {

/// What the formulas ask of gamma.
struct Exponents {
  double gamma, z, a;           // z = (gamma - 1)/(2 gamma), a = 2/(gamma - 1)
  std::array<double, 12> weak;  // (1 + x)^z - 1 = sum weak[k] x^(k+1)
};
G27_INLINE Exponents exponents(double gamma) noexcept {
  Exponents e{gamma, (gamma - 1.0) / (2.0 * gamma), 2.0 / (gamma - 1.0), {}};
  double c = e.z;
  for (int k = 0; k < 12; ++k) {
    e.weak[static_cast<std::size_t>(k)] = c;
    c *= (e.z - (k + 1)) / (k + 2.0);
  }
  return e;
}
/// For |x| below this the series is used: its first neglected term is 1e-15 of the sound speed.
inline constexpr double weak_limit = 0.1;

template <Lane V>
G27_INLINE V weak_power(Exponents const& e, V x) noexcept {
  auto const c = [&](std::size_t k) G27_INLINE_LAMBDA { return V(e.weak[k]); };
  V const x2 = x * x, x4 = x2 * x2;
  V const s0 = (c(0) + c(1) * x) + x2 * (c(2) + c(3) * x);
  V const s1 = (c(4) + c(5) * x) + x2 * (c(6) + c(7) * x);
  V const s2 = (c(8) + c(9) * x) + x2 * (c(10) + c(11) * x);
  return x * (s0 + x4 * (s1 + x4 * s2));
}

template <Lane V>
struct Side {
  V rho, u, P, c, Z;  // Z = rho c
  V inv_P;
};

/// f and its derivatives: slope = P f', bend = P^2 f''.
template <Lane V>
struct Curve {
  V f, slope, bend;
};

/// Both wave curves at P (Toro 4.6-4.7, 4.37-4.38).
template <Lane V>
G27_INLINE void wave_curves(Exponents const& e, Side<V> const& l, Side<V> const& r, V P, Mask<V> wanted, Curve<V>& cl,
                            Curve<V>& cr) noexcept {
  V const g1 = 0.5 * (e.gamma + 1.0), g2 = 0.5 * (e.gamma - 1.0);
  // mass flux through a shock: Q^2 = rho ((gamma + 1) P + (gamma - 1) P_K)/2
  V const q_l = sqrt(l.rho * (g1 * P + g2 * l.P)), q_r = sqrt(r.rho * (g1 * P + g2 * r.P));
  V const inv = 1.0 / (q_l * q_r);
  auto const curve = [&](Side<V> const& k, V inv_q) G27_INLINE_LAMBDA {
    V const dp = P - k.P;
    V const x = dp * k.inv_P;
    V const m = g1 * k.rho * inv_q * inv_q;
    V const h = dp * m;
    V power = weak_power(e, x);
    auto const far = x < V(-weak_limit);
    if (any(far && wanted)) power = select(far, pow(P * k.inv_P, V(e.z)) - 1.0, power);
    auto const shock = dp > V(0.0);
    V const fan_slope = k.c * (1.0 / e.gamma) * (1.0 + power);
    V const P_q = P * inv_q;
    return Curve<V>{select(shock, dp * inv_q, e.a * k.c * power), select(shock, P_q * (1.0 - 0.5 * h), fan_slope),
                    select(shock, P_q * P * m * (0.75 * h - 1.0), (e.z - 1.0) * fan_slope)};
  };
  cl = curve(l, inv * q_r);
  cr = curve(r, inv * q_l);
}

/// First guess: acoustic with the quadratic term where the jump is moderate, else a bound to step from.
template <Lane V>
G27_INLINE V first_guess(Exponents const& e, Side<V> const& l, Side<V> const& r) noexcept {
  V const inv = 1.0 / (l.Z + r.Z);
  V const P = (r.Z * l.P + l.Z * r.P + l.Z * r.Z * (l.u - r.u)) * inv;
  V const x_l = P - l.P, x_r = P - r.P;
  V const y_l = x_l * l.inv_P, y_r = x_r * r.inv_P;
  V const quadratic = P + (0.25 * (e.gamma + 1.0) / e.gamma) * inv * (r.Z * x_l * y_l + l.Z * x_r * y_r);
  auto const moderate = abs(y_l) < V(0.5) && abs(y_r) < V(0.5);
  V const low = min(l.P, r.P), high = max(l.P, r.P);
  return select(moderate, quadratic, select(P < low, low, high));
}

template <Lane V>
struct Star {
  V P, f_l, f_r;
  Mask<V> converged;
};

template <Lane V>
Star<V> star(Exponents const& e, Side<V> const& l, Side<V> const& r, Mask<V> active) noexcept {
  constexpr int limit = 60;       // a pressure ratio of 1e10 takes 6
  constexpr double close = 1e-4;  // a Halley step of this relative length leaves an error of 1e-13
  constexpr double halley = 0.1;  // steps shorter than this may be Halley's
  V const du = r.u - l.u;
  V P = first_guess(e, l, r);
  Star<V> s{P, V(0.0), V(0.0), !active};
  for (int i = 0; i < limit; ++i) {
    Curve<V> cl, cr;
    wave_curves(e, l, r, P, !s.converged, cl, cr);
    V const F = cl.f + cr.f + du, G = cl.slope + cr.slope, H = cl.bend + cr.bend;
    V const step = -F * G / (G * G - 0.5 * F * H);
    V const next = P * (1.0 + step);
    auto const fresh = !s.converged;
    s.P = select(fresh, next, s.P);
    s.f_l = select(fresh, cl.f + step * (cl.slope + 0.5 * step * cl.bend), s.f_l);
    s.f_r = select(fresh, cr.f + step * (cr.slope + 0.5 * step * cr.bend), s.f_r);
    s.converged = s.converged || abs(F) < close * G;
    if (all(s.converged)) break;
    V after = next;
    auto const far = !(abs(F) < halley * G);
    if (any(far && !s.converged)) {
      // Left of the root F is concave in sqrt(P), right of it convex in P^z (linear for two rarefactions): Newton's
      // step in that variable stays on its side.
      V const newton = -F / G;
      V const root = 1.0 + 0.5 * newton, base = max(1.0 + e.z * newton, 1e-300);
      after = select(far, P * select(F < V(0.0), root * root, pow(base, V(1.0 / e.z))), next);
    }
    P = after;
  }
  return s;
}

/// State at x/t = 0 on one side of the contact, in the frame where that side is the left one (Toro 4.5).
/// P_s, u_s: star region; f = u_K - u_s.
template <Lane V>
G27_INLINE GasState<V> sample_side(Exponents const& e, Side<V> const& k, V P_s, V u_s, V f, Mask<V> wanted) noexcept {
  V const gamma = V(e.gamma);
  V const up = (gamma + 1.0) * P_s + (gamma - 1.0) * k.P, down = (gamma - 1.0) * P_s + (gamma + 1.0) * k.P;
  auto const shock = P_s > k.P;
  V const c_s = k.c + (0.5 * (e.gamma - 1.0)) * f;
  V const rho_s = select(shock, k.rho * up, gamma * P_s) / select(shock, down, c_s * c_s);
  // the wave's first front runs to the right: face still in the undisturbed state
  auto const ahead = k.u >= V(0.0) && k.rho * k.u * k.u >= select(shock, 0.5 * up, gamma * k.P);
  GasState<V> s{select(ahead, k.rho, rho_s), select(ahead, k.u, u_s), select(ahead, k.P, P_s)};
  auto const fan = !shock && !ahead && u_s > c_s;
  if (any(fan && wanted)) {
    V const c = (2.0 / (e.gamma + 1.0)) * k.c + ((e.gamma - 1.0) / (e.gamma + 1.0)) * k.u;
    V const rho = k.rho * pow(max(c / k.c, 1e-300), V(e.a));
    s = {select(fan, rho, s.rho), select(fan, c, s.u), select(fan, rho * c * c * (1.0 / e.gamma), s.p)};
  }
  return s;
}

/// Two rarefactions that leave a vacuum between them (Toro 4.6). a_l, a_r: speeds of the fronts.
template <Lane V>
FaceSolution<V> vacuum_face(Exponents const& e, Side<V> const& l, Side<V> const& r, Mask<V> wanted) noexcept {
  V const front_l = l.u + e.a * l.c, front_r = r.u - e.a * r.c;
  auto const left = front_l > V(0.0), right = front_r < V(0.0);
  Side<V> const k{select(left, l.rho, r.rho),
                  select(left, l.u, -r.u),
                  select(left, l.P, r.P),
                  select(left, l.c, r.c),
                  V(0.0),
                  V(0.0)};
  // A star region of no density, moving with the front: the face is ahead of the fan or in it.
  GasState<V> s = sample_side(e, k, V(0.0), select(left, front_l, -front_r), -e.a * k.c, wanted);
  V const mean = 0.5 * (front_l + front_r);
  auto const filled = left || right;
  s = {select(filled, s.rho, 0.0), select(filled, select(left, s.u, -s.u), mean), select(filled, s.p, 0.0)};
  return {s, V(0.0), mean, wanted};
}

/// Solves in P = p + p_inf. Lanes that are not active return unspecified values; they may hold any bits.
template <Lane V>
FaceSolution<V> face(double gamma, double p_inf, GasState<V> const& left, GasState<V> const& right,
                     Mask<V> active) noexcept {
  Exponents const e = exponents(gamma);
  V const P_l = left.p + p_inf, P_r = right.p + p_inf;
  V const inv_rho = 1.0 / (left.rho * right.rho), inv_P = 1.0 / (P_l * P_r);
  V const Z_l = sqrt(gamma * P_l * left.rho), Z_r = sqrt(gamma * P_r * right.rho);
  Side<V> const l{left.rho, left.u, P_l, Z_l * inv_rho * right.rho, Z_l, inv_P * P_r};
  Side<V> const r{right.rho, right.u, P_r, Z_r * inv_rho * left.rho, Z_r, inv_P * P_l};

  V const escape = e.a * (l.c + r.c), du = r.u - l.u;
  Mask<V> vacuum = active && du > 0.2 * escape;
  if (any(vacuum)) vacuum = vacuum && du >= escape * (1.0 - max(exp(-500.0 * e.z), 1e-9));

  Star<V> const s = star(e, l, r, active && !vacuum);
  V const u_star = 0.5 * ((l.u + r.u) + (s.f_r - s.f_l));
  auto const is_left = u_star >= V(0.0);
  Side<V> const k{select(is_left, l.rho, r.rho),
                  select(is_left, l.u, -r.u),
                  select(is_left, l.P, r.P),
                  select(is_left, l.c, r.c),
                  V(0.0),
                  V(0.0)};
  GasState<V> f = sample_side(e, k, s.P, abs(u_star), select(is_left, s.f_l, s.f_r), active);
  f.u = select(is_left, f.u, -f.u);
  FaceSolution<V> solution{f, s.P, u_star, s.converged};
  if (any(vacuum)) {
    FaceSolution<V> const v = vacuum_face(e, l, r, vacuum);
    solution = {{select(vacuum, v.face.rho, f.rho), select(vacuum, v.face.u, f.u), select(vacuum, v.face.p, f.p)},
                select(vacuum, v.p_star, s.P),
                select(vacuum, v.u_star, u_star),
                s.converged || vacuum};
  }
  solution.face.p -= p_inf;
  solution.p_star -= p_inf;
  return solution;
}

}  // namespace ideal

/// Exact solution at the face. Needs rho > 0 and p + p_inf > 0 on both sides, products of the two sides' densities and
/// pressures within the range of double. Star state to 1e-12 relative, sampled state to what that implies. A vacuum is
/// declared where the two rarefactions would leave a sound speed below 1e-9 of that before them.
template <Lane V>
[[nodiscard]] FaceSolution<V> fast_face(IdealGas const& eos, GasState<V> const& l, GasState<V> const& r,
                                        Mask<V> active) noexcept {
  return ideal::face(eos.gamma, 0.0, l, r, active);
}
template <Lane V>
[[nodiscard]] FaceSolution<V> fast_face(StiffenedGas const& eos, GasState<V> const& l, GasState<V> const& r,
                                        Mask<V> active) noexcept {
  return ideal::face(eos.gamma, eos.p_inf, l, r, active);
}

}  // namespace g27
