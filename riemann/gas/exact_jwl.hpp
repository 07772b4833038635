#pragma once
/// Exact Riemann solver of JWL products, one problem a lane, at the cost that each problem needs.
///
/// v = rho0/rho, t = p - a - b with a = A exp(-R1 v), b = B exp(-R2 v). Along an isentrope, D1 = -dp/dv, D2 = d2p/dv2,
/// D3 = -d3p/dv3; Z = sqrt(rho0 D1) = rho c. With x = p - p_K a wave curve is f_K(p) = |u* - u_K|. Levels:
///   weak     |x| < 0.017 D1 v on both sides: f to third order in x and one Newton step
///   dilute   both exponentials vanish on either side of both waves: the ideal gas of gamma = 1 + omega
///   strong   each wave by its own v: Hugoniot relation, or f = -integral of c dln v by Gauss-Legendre panels
/// Masks choose the level lane by lane; any() only skips what no lane needs, so that mates never change a result.
#include <array>

#include "riemann/base/lane_math.hpp"
#include "riemann/eos/jwl.hpp"
#include "riemann/gas/exact_ideal.hpp"
#include "riemann/gas/face_solution.hpp"

namespace g27 {

namespace jwl {

inline constexpr double weak_limit = 0.017;  // neglected fourth order: 7e-7 of p

/// A point of an isentrope and the derivatives of its p(v).
template <Lane V>
struct Isentrope {
  V v, p, D1, D2, D3;
};
template <Lane V>
G27_INLINE Isentrope<V> isentrope(Jwl const& eos, V v, V inv_v, V a, V b, V t) noexcept {
  V const g = V(1.0 + eos.omega), t1 = g * t * inv_v, t2 = (g + 1.0) * t1 * inv_v, t3 = (g + 2.0) * t2 * inv_v;
  V const a1 = eos.R1 * a, b1 = eos.R2 * b, a2 = eos.R1 * a1, b2 = eos.R2 * b1;
  return {v, a + b + t, a1 + b1 + t1, a2 + b2 + t2, eos.R1 * a2 + eos.R2 * b2 + t3};
}

/// What a wave needs of the state ahead of it.
template <Lane V>
struct Side {
  V rho, u, p, v, a, b, t;
  Isentrope<V> s;
  V inv_D1, Z, inv_Z, c;
  V alpha;             // D2/D1^2: f = x/Z (1 - alpha x/4 + ...)
  V q_fan, q_shock;    // v_K - v = x/D1 (1 - alpha x/2 + q x^2 + ...)
  V f2_fan, f2_shock;  // f = x/Z (1 - alpha x/4 + f2 x^2 + ...)
};

template <Lane V>
G27_INLINE void exponentials(Jwl const& eos, V v, V& a, V& b) noexcept {
  a = eos.A * exp(-eos.R1 * v);  // the clamp of exp at -708 keeps both normal numbers
  b = eos.B * exp(-eos.R2 * v);
}

template <Lane V>
G27_INLINE void sides(Jwl const& eos, GasState<V> const& left, GasState<V> const& right, Side<V>& l,
                      Side<V>& r) noexcept {
  V const inv_rho = eos.rho0 / (left.rho * right.rho);
  auto const thermal = [&](GasState<V> const& k, V v, Side<V>& s) G27_INLINE_LAMBDA {
    s.rho = k.rho, s.u = k.u, s.p = k.p, s.v = v;
    exponentials(eos, v, s.a, s.b);
    s.t = k.p - s.a - s.b;
    s.s = isentrope(eos, v, k.rho * (1.0 / eos.rho0), s.a, s.b, s.t);
  };
  thermal(left, inv_rho * right.rho, l);
  thermal(right, inv_rho * left.rho, r);
  V const inv_D1 = 1.0 / (l.s.D1 * r.s.D1);
  auto const series = [&](Side<V>& k, V inv) G27_INLINE_LAMBDA {
    k.inv_D1 = inv;
    k.Z = sqrt(eos.rho0 * k.s.D1);
    k.inv_Z = k.Z * inv * (1.0 / eos.rho0);
    k.c = k.Z * k.v * (1.0 / eos.rho0);
    k.alpha = k.s.D2 * inv * inv;
    V const alpha2 = k.alpha * k.alpha, d3 = k.s.D3 * inv * inv * inv;
    k.q_fan = 0.5 * alpha2 - (1.0 / 6.0) * d3;
    k.f2_fan = (5.0 / 24.0) * alpha2 - (1.0 / 12.0) * d3;
    // entropy across the shock is of third order: E - E_s = D2 (v_K - v)^3/12
    k.q_shock = k.q_fan - (eos.omega / 12.0) * k.alpha * inv * (k.rho * (1.0 / eos.rho0));
    k.f2_shock = 0.5 * k.q_shock - (1.0 / 32.0) * alpha2;
  };
  series(l, inv_D1 * r.s.D1);
  series(r, inv_D1 * l.s.D1);
}

/// A point of a wave curve: f at p, slope = df/dp, bend = -f''/f', D = -dp/dv.
template <Lane V>
struct Point {
  V p, v, f, slope, bend, D;
};

template <Lane V>
G27_INLINE Point<V> weak_wave(Side<V> const& k, V p) noexcept {
  V const x = p - k.p;
  auto const shock = x > V(0.0);
  V const f2 = select(shock, k.f2_shock, k.f2_fan), q = select(shock, k.q_shock, k.q_fan);
  V const ax = k.alpha * x;
  return {p,
          k.v - x * k.inv_D1 * (1.0 - 0.5 * ax + q * x * x),
          x * k.inv_Z * (1.0 - 0.25 * ax + f2 * x * x),
          k.inv_Z * (1.0 - 0.5 * ax + 3.0 * f2 * x * x),
          0.5 * k.alpha,
          k.s.D1 * (1.0 + ax)};
}
template <Lane V>
G27_INLINE Mask<V> is_weak(Side<V> const& k, V p) noexcept {
  return abs(p - k.p) < weak_limit * k.s.D1 * k.v;
}

/// Contact with the waves as points of their curves.
template <Lane V>
struct Star {
  V p;
  Point<V> l, r;
  Mask<V> converged;
};

template <Lane V>
G27_INLINE V acoustic_pressure(Side<V> const& l, Side<V> const& r, V inv_sum) noexcept {
  return (r.Z * l.p + l.Z * r.p + l.Z * r.Z * (l.u - r.u)) * inv_sum;
}

template <Lane V>
G27_INLINE Star<V> weak_star(Side<V> const& l, Side<V> const& r) noexcept {
  V const inv_sum = 1.0 / (l.Z + r.Z);
  V p = acoustic_pressure(l, r, inv_sum);
  V const x_l = p - l.p, x_r = p - r.p;
  p += 0.25 * inv_sum * (r.Z * x_l * x_l * l.alpha + l.Z * x_r * x_r * r.alpha);
  Point<V> const a = weak_wave(l, p), b = weak_wave(r, p);
  p -= (a.f + b.f + (r.u - l.u)) / (a.slope + b.slope);
  return {p, weak_wave(l, p), weak_wave(r, p), is_weak(l, p) && is_weak(r, p)};
}

/// Two waves of any strength: Newton on p*, where each wave follows by its own v, so that nothing is nested.

/// c and its derivatives by ln v along the isentrope.
template <Lane V>
struct SoundSpeed {
  V c, d1, d2;
};
template <Lane V>
G27_INLINE SoundSpeed<V> sound_speed(Isentrope<V> const& s, V c) noexcept {
  V const inv = s.v / s.D1, G = 0.5 * inv * s.D2;  // fundamental derivative
  V const g1 = G + 2.0 * G * G - 0.5 * s.v * inv * s.D3;
  return {c, c * (1.0 - G), c * ((1.0 - G) * (1.0 - G) - g1)};
}

/// By two points and the derivatives there; error < 1e-7 of c for |h| < hermite_limit, sixth order in h.
template <Lane V>
G27_INLINE V integral_by_ends(SoundSpeed<V> const& k, SoundSpeed<V> const& e, V h) noexcept {
  return h * (0.5 * (k.c + e.c) + h * (0.1 * (k.d1 - e.d1) + h * ((1.0 / 120.0) * (k.d2 + e.d2))));
}
inline constexpr double hermite_limit = 0.12;  // accurate below
inline constexpr double hermite_start = 0.7;   // good enough below for the first steps of the iteration
inline constexpr double fine_panel = 0.7, coarse_panel = 3.0;

/// Integral of c d ln v from the side's v to v e^h, h > 0: Gauss-Legendre, six nodes a panel of at most the given
/// width, up to where the exponentials have vanished; then c follows v^(-omega/2).
template <Lane V>
V integral_of_c(Jwl const& eos, Side<V> const& k, V h, V panel, Mask<V> wanted) noexcept {
  constexpr std::array<double, 3> node{0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
  constexpr std::array<double, 3> weight{0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  double const slowest = eos.R1 < eos.R2 ? eos.R1 : eos.R2;
  V const reach = max(log(40.0 / (slowest * k.v)), 0.0);
  V const span = select(wanted, min(h, reach), 0.0);
  V const share = span / panel;
  double const longest = lane_max(share);
  V panels(1.0);
  int count = 1;
  for (; count < 1000 && count < longest; ++count) panels = select(share > V(double(count)), panels + 1.0, panels);
  V const wide = span / panels, thermal = (1.0 + eos.omega) * k.t;
  V sum(0.0);
  for (int i = 0; i < count && longest > 0.0; ++i) {
    V part(0.0);
    for (std::size_t n = 0; n < 6; ++n) {
      V const s = wide * (i + 0.5 + (n < 3 ? -0.5 : 0.5) * node[n % 3]);
      V const v = k.v * exp(s);
      V a, b;
      exponentials(eos, v, a, b);
      part += weight[n % 3] * sqrt(v * (v * (eos.R1 * a + eos.R2 * b) + thermal * exp((-1.0 - eos.omega) * s)));
    }
    sum = select(V(i) < panels, sum + part, sum);
  }
  V const ideal_c = sqrt(thermal * k.v);
  V const tail = select(h > span, exp((-0.5 * eos.omega) * span) - exp((-0.5 * eos.omega) * h), 0.0);
  return (0.5 * wide * sum + (2.0 / eos.omega) * ideal_c * tail) * (1.0 / sqrt(eos.rho0));
}

/// The rarefaction at v = v_K e^h.
template <Lane V>
Point<V> rarefaction(Jwl const& eos, Side<V> const& k, V h, Mask<V> exact, Mask<V> wanted) noexcept {
  V const v = k.v * exp(h);
  V a, b;
  exponentials(eos, v, a, b);
  Isentrope<V> const s = isentrope(eos, v, 1.0 / v, a, b, k.t * exp((-1.0 - eos.omega) * h));
  V const Z = sqrt(eos.rho0 * s.D1);
  V f = -integral_by_ends(sound_speed(k.s, k.c), sound_speed(s, Z * v * (1.0 / eos.rho0)), h);
  Mask<V> const quadrature = wanted && (h > V(hermite_start) || (exact && h > V(hermite_limit)));
  if (any(quadrature))
    f = select(quadrature, -integral_of_c(eos, k, h, select(exact, V(fine_panel), coarse_panel), quadrature), f);
  return {s.p, v, f, 1.0 / Z, 0.5 * s.D2 / (s.D1 * s.D1), s.D1};
}

/// The shock that compresses to v <= v_K: E - E_K = (p + p_K)(v_K - v)/2, f^2 = (p - p_K)(v_K - v)/rho0.
template <Lane V>
Point<V> shock(Jwl const& eos, Side<V> const& k, V v) noexcept {
  V a, b;
  exponentials(eos, v, a, b);
  V const d = k.v - v, inv_v = 1.0 / v, w = eos.omega * inv_v;
  // energy that is thermal, per initial volume, without the work of p - p_K
  V const E = (k.a - a) * (1.0 / eos.R1) + (k.b - b) * (1.0 / eos.R2) + k.t * k.v * (1.0 / eos.omega) + 0.5 * k.p * d;
  V const share = 1.0 - 0.5 * w * d;
  V const p = (a + b + w * E) / share;
  V const dN = -eos.R1 * a - eos.R2 * b + w * (a + b - 0.5 * k.p) - w * E * inv_v;
  V const dp_dv = (dN - p * (0.5 * w * k.v * inv_v)) / share;
  V const x = p - k.p, f = sqrt(max(x * d * (1.0 / eos.rho0), 1e-300));
  // a strong shock's f grows with the root of p
  return {p, v, f, (d - x / dp_dv) / (2.0 * eos.rho0 * f), 0.5 / p, -dp_dv};
}

template <Lane V>
G27_INLINE Point<V> select_point(Mask<V> m, Point<V> const& a, Point<V> const& b) noexcept {
  return {select(m, a.p, b.p),         select(m, a.v, b.v),       select(m, a.f, b.f),
          select(m, a.slope, b.slope), select(m, a.bend, b.bend), select(m, a.D, b.D)};
}

/// From a point of the wave curve to one whose pressure is near p: exact for an ideal gas.
template <Lane V>
Point<V> advance(Jwl const& eos, Side<V> const& k, Point<V> const& from, V p, Mask<V> exact, Mask<V> wanted) noexcept {
  auto const weak = is_weak(k, p), compressed = p > k.p;
  Point<V> to = weak_wave(k, p);
  // a point of the other branch is of no use: start at the undisturbed state
  auto const restart = compressed != (from.p > k.p);
  V const p0 = select(restart, k.p, from.p), v0 = select(restart, k.v, from.v), D0 = select(restart, k.s.D1, from.D);
  if (auto const m = wanted && !weak && compressed; any(m)) {
    V const pole = (eos.omega / (2.0 + eos.omega)) * k.v, y = 1.0 / (v0 - pole);
    V const v = pole + 1.0 / max(y + (p - p0) * y * y / D0, 1.0 / (k.v - pole));
    to = select_point(m, shock(eos, k, v), to);
  }
  if (auto const m = wanted && !weak && !compressed; any(m)) {
    V const h = log(v0 / k.v) - log(p / p0) * p0 / (v0 * D0);
    to = select_point(m, rarefaction(eos, k, V(max(h, 0.0)), exact, m), to);
  }
  return to;
}

/// The point moved by dp << p.
template <Lane V>
G27_INLINE Point<V> moved(Point<V> const& a, V p) noexcept {
  V const dp = p - a.p;
  return {p,  a.v - dp / a.D, a.f + a.slope * dp * (1.0 - 0.5 * a.bend * dp), a.slope * (1.0 - a.bend * dp), a.bend,
          a.D};
}

template <Lane V>
Star<V> strong_star(Jwl const& eos, Side<V> const& l, Side<V> const& r, Mask<V> active) noexcept {
  constexpr int limit = 60;
  constexpr double close = 5e-4;  // relative: what remains is of third order, of second in a shock
  constexpr double near = 0.03;   // from here on the integrals are worth their cost
  V const du = r.u - l.u;
  V const acoustic = acoustic_pressure(l, r, V(1.0 / (l.Z + r.Z)));
  V const low = min(l.p, r.p), high = max(l.p, r.p);
  V p = select(acoustic > 0.5 * low && acoustic < 2.0 * high, acoustic, select(acoustic < low, low, high));
  V const zero(0.0);
  Point<V> at_l{l.p, l.v, zero, l.inv_Z, 0.5 * l.alpha, l.s.D1}, at_r{r.p, r.v, zero, r.inv_Z, 0.5 * r.alpha, r.s.D1};
  Star<V> s{p, at_l, at_r, !active};
  V below(1e-200), above(1e200);
  Mask<V> exact(false);
  for (int i = 0; i < limit; ++i) {
    at_l = advance(eos, l, at_l, p, exact, !s.converged);
    at_r = advance(eos, r, at_r, p, exact, !s.converged);
    // the waves stand at nearly equal pressures, not yet at the one asked for
    V const S = at_l.slope + at_r.slope;
    p = (at_l.slope * at_l.p + at_r.slope * at_r.p) / S;
    V const d_l = p - at_l.p, d_r = p - at_r.p, gap = max(abs(d_l), abs(d_r));
    V const F = at_l.f + at_l.slope * d_l + at_r.f + at_r.slope * d_r + du, newton = -F / (p * S);
    V const bend = p * (at_l.slope * at_l.bend + at_r.slope * at_r.bend) / S;
    V const off = max(abs(newton), gap / p);
    V const next = p * (1.0 + newton / (1.0 - 0.5 * bend * newton));

    auto const ready = !s.converged && exact && off < close;
    s.p = select(ready, next, s.p);
    s.l = select_point(ready, moved(at_l, next), s.l);
    s.r = select_point(ready, moved(at_r, next), s.r);
    s.converged = s.converged || ready;
    if (all(s.converged)) break;
    exact = exact || off < near;

    V after = next;
    if (auto const far = !(abs(newton) < 0.1) && !s.converged; any(far)) {
      // F is nearly linear in p^(1 - bend); its sign bounds the root
      V const power = max(min(1.0 - bend, 0.5), 0.05), base = max(1.0 + power * newton, 0.05);
      V const root = min(1.0 + 0.5 * newton, 30.0);
      V const step = p * select(newton > V(0.0), root * root, pow(base, V(1.0 / power)));
      auto const sure = gap < 0.1 * p;
      above = select(sure && newton < V(0.0), min(above, p), above);
      below = select(sure && newton > V(0.0), max(below, p), below);
      after = select(far, select(step > below && step < above, step, sqrt(below) * sqrt(above)), after);
    }
    p = after;
  }
  return s;
}

/// Velocity that an expansion to the vacuum adds.
template <Lane V>
V escape_speed(Jwl const& eos, Side<V> const& k, Mask<V> wanted) noexcept {
  return integral_of_c(eos, k, V(1e6), V(fine_panel), wanted);
}

/// The fan at x/t = 0 of a wave that runs to the left: u = c. Newton in ln v from the undisturbed state, one-sided.
template <Lane V>
GasState<V> fan_state(Jwl const& eos, Side<V> const& k, Mask<V> wanted) noexcept {
  V h(0.0);
  GasState<V> s{k.rho, k.u, k.p};
  Mask<V> open = wanted;
  for (int i = 0; i < 50 && any(open); ++i) {
    Point<V> const a = rarefaction(eos, k, h, open, open);
    V const u = k.u - a.f, c = a.v / (eos.rho0 * a.slope);
    V const dh = (c - u) / (c * a.bend * a.v * a.D);
    // the last step is worth a linear move of the state only
    s.p = select(open, a.p - a.D * a.v * dh, s.p);
    s.u = select(open, u + c * dh, s.u);
    s.rho = select(open, eos.rho0 / (a.v * (1.0 + dh)), s.rho);
    open = open && abs(dh) > V(1e-5);
    h = max(h + dh, 0.0);
  }
  return s;
}

/// State at x/t = 0 on one side of the contact, in the frame where that side is the left one.
template <Lane V>
G27_INLINE GasState<V> sample_side(Jwl const& eos, Side<V> const& k, Point<V> const& star, V u_star,
                                   Mask<V> wanted) noexcept {
  V const x = star.p - k.p;
  auto const shock = x > V(0.0);
  auto const ahead = select(shock, k.u * k.rho * star.f - x, k.u - k.c) >= V(0.0);
  GasState<V> s{select(ahead, k.rho, eos.rho0 / star.v), select(ahead, k.u, u_star), select(ahead, k.p, star.p)};
  auto const fan = wanted && !shock && !ahead && u_star * eos.rho0 * star.slope > star.v;
  if (any(fan)) {
    GasState<V> const f = fan_state(eos, k, fan);
    s = {select(fan, f.rho, s.rho), select(fan, f.u, s.u), select(fan, f.p, s.p)};
  }
  return s;
}

template <Lane V>
G27_INLINE Side<V> select_side(Mask<V> m, Side<V> const& a, Side<V> const& b) noexcept {
  Side<V> s{};
  s.rho = select(m, a.rho, b.rho), s.u = select(m, a.u, -b.u), s.p = select(m, a.p, b.p), s.v = select(m, a.v, b.v);
  s.t = select(m, a.t, b.t), s.c = select(m, a.c, b.c);
  s.s = {s.v, s.p, select(m, a.s.D1, b.s.D1), select(m, a.s.D2, b.s.D2), select(m, a.s.D3, b.s.D3)};
  return s;
}

template <Lane V>
G27_INLINE FaceSolution<V> choose(Mask<V> m, FaceSolution<V> const& a, FaceSolution<V> const& b) noexcept {
  return {{select(m, a.face.rho, b.face.rho), select(m, a.face.u, b.face.u), select(m, a.face.p, b.face.p)},
          select(m, a.p_star, b.p_star),
          select(m, a.u_star, b.u_star),
          (m && a.converged) || (!m && b.converged)};
}

/// Two rarefactions that leave a vacuum between fronts of the given speeds.
template <Lane V>
FaceSolution<V> vacuum_face(Jwl const& eos, Side<V> const& l, Side<V> const& r, V front_l, V front_r,
                            Mask<V> wanted) noexcept {
  auto const left = front_l > V(0.0), filled = left || front_r < V(0.0);
  Side<V> const k = select_side(left, l, r);
  auto const ahead = k.u >= k.c;
  GasState<V> const f = fan_state(eos, k, wanted && filled && !ahead);
  V const mean = 0.5 * (front_l + front_r), u = select(ahead, k.u, f.u);
  return {{select(filled, select(ahead, k.rho, f.rho), 0.0), select(filled, select(left, u, -u), mean),
           select(filled, select(ahead, k.p, f.p), 0.0)},
          V(0.0),
          mean,
          wanted};
}

/// Lanes whose states on either side of both waves have no share of the exponentials, solved as an ideal gas.
template <Lane V>
FaceSolution<V> dilute_face(Jwl const& eos, GasState<V> const& l, GasState<V> const& r, Mask<V> wanted) noexcept {
  double const w = eos.omega, v = 40.0 / (eos.R1 < eos.R2 ? eos.R1 : eos.R2), densest = eos.rho0 / v;
  double const floor = 4e9 * (eos.A * exp(-eos.R1 * v) + eos.B * exp(-eos.R2 * v));  // the cold part is 1e-8 of it
  Mask<V> const thin = wanted && max(l.rho, r.rho) < V(densest) && min(l.p, r.p) > V(floor);
  FaceSolution<V> s = ideal::face(1.0 + w, 0.0, l, r, thin);
  auto const stays = [&](GasState<V> const& k) G27_INLINE_LAMBDA {
    return k.rho * ((2.0 + w) * s.p_star + w * k.p) < densest * (w * s.p_star + (2.0 + w) * k.p);
  };
  s.converged = thin && s.converged && stays(l) && stays(r);
  return s;
}

/// Lanes with a strong wave: their star states replace those of s, or the whole solution is returned.
template <Lane V>
FaceSolution<V> strong_face(Jwl const& eos, GasState<V> const& left, GasState<V> const& right, Side<V> const& l,
                            Side<V> const& r, Mask<V> wanted, Star<V>& s) noexcept {
  FaceSolution<V> solution = dilute_face(eos, left, right, wanted);
  Mask<V> const strong = wanted && !solution.converged;
  Mask<V> vacuum = strong && r.u - l.u > 0.5 * (l.c + r.c);
  if (any(vacuum)) {
    V const front_l = l.u + escape_speed(eos, l, vacuum), front_r = r.u - escape_speed(eos, r, vacuum);
    vacuum = vacuum && front_r - front_l >= -1e-6 * (l.c + r.c);
    if (any(vacuum)) solution = choose(vacuum, vacuum_face(eos, l, r, front_l, front_r, vacuum), solution);
  }
  if (Mask<V> const finite = strong && !vacuum; any(finite)) {
    Star<V> const w = strong_star(eos, l, r, finite);
    s = {select(finite, w.p, s.p), select_point(finite, w.l, s.l), select_point(finite, w.r, s.r),
         s.converged || (finite && w.converged)};
  }
  return solution;
}

}  // namespace jwl

/// Exact solution at the face. Needs rho > 0 and t > 0 on both sides; lanes that are not active may hold any bits.
/// Star state to 1e-6 relative (3e-6 at pressure ratios above 1000), jumps below 1 % to 1e-7.
template <Lane V>
[[nodiscard]] FaceSolution<V> fast_face(Jwl const& eos, GasState<V> const& left, GasState<V> const& right,
                                        Mask<V> active) noexcept {
  jwl::Side<V> l, r;
  jwl::sides(eos, left, right, l, r);
  jwl::Star<V> s = jwl::weak_star(l, r);
  FaceSolution<V> other{};
  Mask<V> done(false);
  if (Mask<V> const strong = active && !s.converged; any(strong)) {
    other = jwl::strong_face(eos, left, right, l, r, strong, s);
    done = strong && other.converged;
  }
  V const u_star = 0.5 * ((l.u + r.u) + (s.r.f - s.l.f));
  auto const is_left = u_star >= V(0.0);
  GasState<V> f = jwl::sample_side(eos, jwl::select_side(is_left, l, r), jwl::select_point(is_left, s.l, s.r),
                                   abs(u_star), active && s.converged && !done);
  f.u = select(is_left, f.u, -f.u);
  FaceSolution<V> const solution{f, s.p, u_star, s.converged};
  return any(done) ? jwl::choose(done, other, solution) : solution;
}

}  // namespace g27
