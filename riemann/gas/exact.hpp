#pragma once
/// Exact Riemann solver for any two convex equations of state (Toro, Riemann Solvers, 3rd ed., chapter 4; Menikoff and
/// Plohr 1989 for general laws; the wave curves are in wave_curve.hpp).
///
/// The unknown is m = p* - p_vac, p_vac the higher of the two vacuum pressures; F(m) = f_l + f_r + u_r - u_l grows
/// with m. If F(0) >= 0 the two gases part: the one whose vacuum pressure is p_vac has expanded to density zero (an
/// ideal gas to p = 0, a stiffened one to p = -p_inf), and the other, if its vacuum is lower still, ends in a free
/// surface at p_vac. Otherwise a bracketed Newton iteration: in sqrt(m), nearly linear for shocks, or in the power of m
/// that is linear for rarefactions. Lanes are frozen as they converge, so that none depends on its neighbours.
#include "riemann/gas/face_solution.hpp"
#include "riemann/gas/wave_curve.hpp"

namespace g27 {

/// Largest |f_l + f_r + u_r - u_l| of a converged solution, over c_l + c_r + |u_r - u_l|.
inline constexpr double exact_tolerance = 1e-12;

/// Everything between the two outermost waves.
template <Lane V = double>
struct RiemannStar {
  V p, u;            ///< contact; in a vacuum: its pressure, and the mean of its two edges' speeds
  V rho_l, rho_r;    ///< densities beside the contact [kg/m^3]; 0 in a vacuum
  V u_l, u_r;        ///< velocities beside the contact: equal but in a vacuum, where they are its edges' speeds
  V excess;          ///< m = p - p_vac [Pa], exact where p itself cancels
  V head_l, tail_l;  ///< speeds of the left wave's edges, head <= tail [m/s]; equal for a shock
  V tail_r, head_r;  ///< the right wave's, tail <= head
  Mask<V> shock_l, shock_r, vacuum, converged;
  V residual;  ///< |f_l + f_r + u_r - u_l|/(c_l + c_r + |u_r - u_l|); 0 in a vacuum
  V iterations;
};

namespace exact {

/// Edges of one wave in the frame in which it moves to the left.
template <Lane V>
struct Edges {
  V head, tail;
};

template <Lane V, class Curve>
G27_INLINE Edges<V> edges(Curve const& curve, GasState<V> const& k, V dp, V jump, V c_star, Mask<V> shock) noexcept {
  // mass flux of the shock dp/jump; weaker than round-off it is a sound wave
  Mask<V> const sound = !(jump > 1e-15 * curve.sound_speed());
  V const s = k.u - select(sound, curve.sound_speed(), dp / (select(sound, V(1.0), jump) * k.rho));
  return {select(shock, s, k.u - curve.sound_speed()), select(shock, s, k.u - jump - c_star)};
}

/// State at x/t = 0 of the left wave, seen in its frame; beyond the contact it is of no meaning.
template <Lane V, class Curve>
G27_INLINE GasState<V> behind(Curve& curve, GasState<V> const& k, double p_vacuum, V rho_star, V u_star, V p_star,
                              Edges<V> const& e, Mask<V> active) noexcept {
  Mask<V> const ahead = e.head >= V(0.0), fan = active && !ahead && e.tail > V(0.0);
  GasState<V> s{select(ahead, k.rho, rho_star), select(ahead, k.u, u_star), select(ahead, k.p, p_star)};
  if (any(fan)) {
    auto const point = curve.sonic(k.u, rho_star, fan);
    s = {select(fan, point.rho, s.rho), select(fan, point.c, s.u), select(fan, point.q + p_vacuum, s.p)};
  }
  return s;
}

/// Where to look for the root next: Newton's point if it lies inside the bracket (low, high), else its middle in ln m
/// or, while no upper bound is known, far above.
template <Lane V>
G27_INLINE V newton(V m, V f, V rate, V kink, double fan_power, V low, V high, Mask<V> bisect) noexcept {
  V const middle = select(high < V(1e299), sqrt(low) * sqrt(min(high, 1e299)), 1e3 * m);
  V const slope = m * rate;
  V const root = 1.0 - 0.5 * f / slope;
  V const by_shock = m * root * root;
  V const base = 1.0 - fan_power * f / slope;
  V const by_fan = m * pow(V(max(base, 1e-30)), V(1.0 / fan_power));
  V const next = select(root > V(0.0) && (by_shock > kink || f < V(0.0)), by_shock, by_fan);
  return select(!bisect && next >= low && next <= high, next, middle);
}

template <Lane V, EquationOfState L, EquationOfState R>
struct Problem {
  L const& eos_l;
  R const& eos_r;
  GasState<V> left, right;
  double p_vacuum, offset_l, offset_r;
  WaveCurve<V, L> curve_l;
  WaveCurve<V, R> curve_r;

  G27_INLINE Problem(L const& l, R const& r, GasState<V> const& k_l, GasState<V> const& k_r) noexcept
      : eos_l(l),
        eos_r(r),
        left(k_l),
        right(k_r),
        p_vacuum(l.vacuum_pressure() > r.vacuum_pressure() ? l.vacuum_pressure() : r.vacuum_pressure()),
        offset_l(p_vacuum - l.vacuum_pressure()),
        offset_r(p_vacuum - r.vacuum_pressure()),
        curve_l(l, k_l),
        curve_r(r, k_r) {}

  /// Velocity given to the gas on one side when p = p_vac, and its density there.
  template <class Curve>
  G27_INLINE static WavePoint<V> at_vacuum(Curve& curve, double offset, Mask<V> active) noexcept {
    if (offset > 0.0) {
      return curve.at(V(offset), active);
    }
    return {V(0.0), -curve.escape(active), V(0.0)};
  }

  [[nodiscard]] RiemannStar<V> star(Mask<V> active) noexcept {
    V const c_l = curve_l.sound_speed(), c_r = curve_r.sound_speed();
    V const du = right.u - left.u, scale = c_l + c_r + abs(du);
    V const m_l = curve_l.excess() - offset_l, m_r = curve_r.excess() - offset_r;
    V const unit = max(max(m_l, m_r), 1e-3 * (min(curve_l.excess(), curve_r.excess())));
    V const tiny = 1e-200 * unit;

    RiemannStar<V> s{};
    Mask<V> const none(false);
    s.vacuum = none;
    V jump_l(0.0), jump_r(0.0), rho_l(0.0), rho_r(0.0);
    // a vacuum needs gases that part, or a side whose pressure starts below that vacuum
    Mask<V> const suspect = active && (du > V(0.0) || min(m_l, m_r) <= V(0.0));
    if (any(suspect)) {
      WavePoint<V> const l = at_vacuum(curve_l, offset_l, suspect), r = at_vacuum(curve_r, offset_r, suspect);
      s.vacuum = suspect && l.jump + r.jump + du >= V(0.0);
      jump_l = l.jump, jump_r = r.jump, rho_l = l.rho, rho_r = r.rho;
    }

    // Start: acoustic where it stays positive, else halfway down to the vacuum.
    V const z_l = left.rho * c_l, z_r = right.rho * c_r;
    V const acoustic = (z_r * m_l + z_l * m_r - z_l * z_r * du) / (z_l + z_r);
    V const least = select(m_l > V(0.0) && m_r > V(0.0), min(m_l, m_r), 1e-3 * unit);
    V m = select(acoustic > 0.1 * least, acoustic, 0.1 * least);
    V low = tiny, high = V(1e300);
    double const g_l = eos_l.isentropic_exponent(), g_r = eos_r.isentropic_exponent();
    double const g = g_l < g_r ? g_l : g_r, fan_power = 0.5 * (g - 1.0) / g;
    Mask<V> open = active && !s.vacuum;
    V residual(1e300), last(1e300), before_last(1e300);
    V p_excess = select(s.vacuum, V(0.0), m);
    for (int i = 0; i < 100 && any(open); ++i) {
      WavePoint<V> const l = curve_l.at(V(m + offset_l), open), r = curve_r.at(V(m + offset_r), open);
      V const f = l.jump + r.jump + du;
      V const now = abs(f) / scale;
      Mask<V> const better = open && now < residual;
      p_excess = select(better, m, p_excess);
      jump_l = select(better, l.jump, jump_l), rho_l = select(better, l.rho, rho_l);
      jump_r = select(better, r.jump, jump_r), rho_r = select(better, r.rho, rho_r);
      // at the round-off of f Newton's steps no longer improve
      Mask<V> const stalled = now < V(exact_tolerance) && !better;
      residual = select(better, now, residual);
      s.iterations = select(open, s.iterations + 1.0, s.iterations);
      high = select(open && f > V(0.0), m, high);
      low = select(open && f <= V(0.0), m, low);
      // bisect where two steps have not halved |F|
      Mask<V> const slow = now > 0.5 * before_last;
      before_last = last, last = now;
      V const next = newton(m, f, V(l.rate + r.rate), V(min(m_l, m_r)), fan_power, low, high, slow);
      open = open && residual > V(2e-16) && !stalled && high > low * (1.0 + 2e-16);
      m = select(open, next, m);
    }
    // Below the least pressure representable a fan is a vacuum to round-off.
    s.vacuum = s.vacuum || (active && p_excess < 1e3 * tiny);
    s.converged = s.vacuum || residual <= V(exact_tolerance);
    s.residual = select(s.vacuum, V(0.0), residual);
    s.excess = select(s.vacuum, V(0.0), p_excess);
    s.p = p_vacuum + s.excess;
    s.u_l = left.u - jump_l, s.u_r = right.u + jump_r;
    V const mean = 0.5 * (s.u_l + s.u_r);
    s.u = mean;
    s.u_l = select(s.vacuum, s.u_l, mean), s.u_r = select(s.vacuum, s.u_r, mean);
    s.rho_l = rho_l, s.rho_r = rho_r;

    V const dp_l = s.excess - m_l, dp_r = s.excess - m_r;
    s.shock_l = dp_l > V(0.0), s.shock_r = dp_r > V(0.0);
    V const cs_l = star_speed(eos_l, rho_l, s.p, offset_l == 0.0 ? s.vacuum : Mask<V>(false));
    V const cs_r = star_speed(eos_r, rho_r, s.p, offset_r == 0.0 ? s.vacuum : Mask<V>(false));
    Edges<V> const l = edges(curve_l, left, dp_l, jump_l, cs_l, s.shock_l);
    Edges<V> const r = edges(curve_r, mirror(right), dp_r, jump_r, cs_r, s.shock_r);
    s.head_l = l.head, s.tail_l = l.tail, s.head_r = -r.head, s.tail_r = -r.tail;
    return s;
  }

  template <class E>
  G27_INLINE static V star_speed(E const& eos, V rho, V p, Mask<V> empty) noexcept {
    V const safe = select(empty, V(1.0), rho);
    return select(empty, V(0.0), sqrt(V(max(eos.bulk_modulus(safe, p), 0.0) / safe)));
  }

  /// State at x/t = 0.
  [[nodiscard]] GasState<V> face(RiemannStar<V> const& s, Mask<V> active) noexcept {
    Mask<V> const from_left = select(s.vacuum, V(s.u_l), s.u) >= V(0.0);
    Mask<V> const from_right = !from_left && select(s.vacuum, V(s.u_r), s.u) < V(0.0);
    GasState<V> const l = behind(curve_l, left, eos_l.vacuum_pressure(), s.rho_l, s.u_l, s.p,
                                 Edges<V>{s.head_l, s.tail_l}, Mask<V>(active && from_left));
    GasState<V> const r = mirror(behind(curve_r, mirror(right), eos_r.vacuum_pressure(), s.rho_r, V(-s.u_r), s.p,
                                        Edges<V>{-s.head_r, -s.tail_r}, Mask<V>(active && from_right)));
    return {select(from_left, l.rho, select(from_right, r.rho, V(0.0))),
            select(from_left, l.u, select(from_right, r.u, s.u)), select(from_left, l.p, select(from_right, r.p, s.p))};
  }
};

}  // namespace exact

/// Star region of the Riemann problem of two gases, of admissible states. Lanes that are not `active` hold no meaning.
template <Lane V, EquationOfState L, EquationOfState R>
[[nodiscard]] RiemannStar<V> exact_star(L const& eos_l, R const& eos_r, GasState<V> const& left,
                                        GasState<V> const& right, Mask<V> active) noexcept {
  return exact::Problem<V, L, R>(eos_l, eos_r, left, right).star(active);
}

/// Solution on the face x/t = 0. Lanes that are not `active` hold no meaning.
template <Lane V, EquationOfState L, EquationOfState R>
[[nodiscard]] FaceSolution<V> exact_face(L const& eos_l, R const& eos_r, GasState<V> const& left,
                                         GasState<V> const& right, Mask<V> active) noexcept {
  exact::Problem<V, L, R> problem(eos_l, eos_r, left, right);
  RiemannStar<V> const s = problem.star(active);
  return {problem.face(s, active), s.p, s.u, s.converged};
}

}  // namespace g27
