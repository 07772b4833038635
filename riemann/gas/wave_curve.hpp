#pragma once
/// The wave curve of one state: every state that one shock or one rarefaction joins to it (Menikoff and Plohr 1989,
/// Rev. Mod. Phys. 61, 75; Toro, Riemann Solvers, 3rd ed., 4.2). Velocities are those of a wave facing a gas at rest.
///
/// Pressures are counted from the vacuum of the equation of state, q = p - vacuum_pressure(), so that nothing cancels
/// when q -> 0. `GammaLawCurve` is closed; `ThermalCurve` serves every law p = p_cold(rho) + t, e = e_cold(rho) +
/// t/(Gamma rho): its Hugoniot is closed in the density, its isentropes are closed up to the integral of c/rho.
#include <array>
#include <type_traits>

#include "riemann/base/lane_math.hpp"
#include "riemann/eos/concept.hpp"
#include "riemann/state/gas.hpp"

namespace g27 {

/// A law whose isentropes need more than a power of p - vacuum_pressure(): see eos/jwl.hpp.
template <class E>
concept ThermalForm = EquationOfState<E> && requires(E const& eos, double x) {
  { eos.cold_energy(x) } -> std::same_as<double>;
  { eos.cold_excess(x) } -> std::same_as<double>;
  { eos.thermal_ratio(x, x) } -> std::same_as<double>;
};

/// The state behind the wave at the pressure q.
template <Lane V>
struct WavePoint {
  V rho;   ///< density [kg/m^3]
  V jump;  ///< velocity given to the gas [m/s], > 0 for a shock, < 0 for a rarefaction
  V rate;  ///< d(jump)/dp [m/(s Pa)], > 0
};

/// Weak waves, |dp| < 1e-6 K, agree in both families up to third order: the series is exact to round-off.
inline constexpr double weak_wave = 1e-6;
/// A Newton step below this, over the unknown, is the last.
inline constexpr double newton_tolerance = 1e-10;

/// Ideal and stiffened gas.
template <Lane V, EquationOfState E>
class GammaLawCurve {
 public:
  G27_INLINE GammaLawCurve(E const& eos, GasState<V> const& k) noexcept
      : g_(eos.isentropic_exponent()), rho_(k.rho), q_(k.p - eos.vacuum_pressure()), c_(sqrt(V(g_ * q_ / k.rho))) {}

  [[nodiscard]] G27_INLINE V excess() const noexcept { return q_; }
  [[nodiscard]] G27_INLINE V sound_speed() const noexcept { return c_; }
  /// Velocity gained by expanding down to rho = 0.
  G27_INLINE V escape(Mask<V> /*active*/) noexcept { return (2.0 / (g_ - 1.0)) * c_; }
  [[nodiscard]] G27_INLINE V escape_at_least() const noexcept { return (2.0 / (g_ - 1.0)) * c_; }

  [[nodiscard]] G27_INLINE WavePoint<V> at(V q, Mask<V> /*active*/) noexcept {
    double const a = 0.5 * (g_ - 1.0) / g_;
    V const x = (q - q_) / q_;
    // Toro (4.6): shock
    V const flux = sqrt(V(0.5 * rho_ * ((g_ + 1.0) * q + (g_ - 1.0) * q_)));
    V const shock_jump = (q - q_) / flux;
    V const shock_rho = rho_ * ((g_ + 1.0) * q + (g_ - 1.0) * q_) / ((g_ - 1.0) * q + (g_ + 1.0) * q_);
    V const shock_rate = (1.0 - 0.25 * (g_ + 1.0) * rho_ * (q - q_) / (flux * flux)) / flux;
    // Toro (4.7): rarefaction; c/c_k = (q/q_k)^a
    V const ratio = pow(V(min(q, q_) / q_), V(a));
    V const fan_rho = rho_ * pow(V(min(q, q_) / q_), V(1.0 / g_));
    V const fan_jump = (2.0 / (g_ - 1.0)) * c_ * (ratio - 1.0);
    V const fan_rate = 1.0 / (fan_rho * c_ * ratio);
    // between the two, where ratio - 1 cancels
    V const y = x / g_;
    Mask<V> const shock = q > q_, weak = abs(y) < V(weak_wave);
    return {select(shock, shock_rho, fan_rho),
            select(shock, shock_jump, select(weak, c_ * y * (1.0 - 0.25 * (g_ + 1.0) * y), fan_jump)),
            select(shock, shock_rate, fan_rate)};
  }

  struct FanPoint {
    V rho, q, c;
  };
  /// The point of the fan where the gas moves at its own sound speed against the wave, given u of the state ahead.
  [[nodiscard]] G27_INLINE FanPoint sonic(V u, V /*rho_least*/, Mask<V> /*active*/) noexcept {
    V const r = max(2.0 / (g_ + 1.0) + (g_ - 1.0) / (g_ + 1.0) * u / c_, 1e-30);
    return {rho_ * pow(r, V(2.0 / (g_ - 1.0))), q_ * pow(r, V(2.0 * g_ / (g_ - 1.0))), c_ * r};
  }

 private:
  double g_;
  V rho_, q_, c_;
};

/// JWL and Mie-Grueneisen.
template <Lane V, ThermalForm E>
class ThermalCurve {
 public:
  G27_INLINE ThermalCurve(E const& eos, GasState<V> const& k) noexcept
      : eos_(&eos),
        rho_(k.rho),
        v_(1.0 / k.rho),
        p_(k.p),
        t_(eos.pressure_margin(k.rho, k.p)),
        q_(eos.cold_excess(k.rho) + t_),
        K_(eos.bulk_modulus_thermal(k.rho, t_)),
        c_(sqrt(V(K_ * v_))),
        G_(eos.fundamental_derivative(k.rho, k.p)),
        limit_(eos.strong_shock_volume(k.rho)),
        known_rho_(k.rho),
        known_gain_(V(0.0)) {}

  [[nodiscard]] G27_INLINE V excess() const noexcept { return q_; }
  [[nodiscard]] G27_INLINE V sound_speed() const noexcept { return c_; }

  /// Velocity gained by expanding down to rho = 0.
  V escape(Mask<V> active) noexcept {
    Reach const r = reach(rho_, V(0.0), active);
    return r.gain + eos_->thermal_escape(r.rho, r.c);
  }

  /// A bound from below, closed: what the thermal part of the sound speed alone gives.
  [[nodiscard]] G27_INLINE V escape_at_least() const noexcept {
    V const thermal = max(K_ - eos_->bulk_modulus_thermal(rho_, V(0.0)), 0.0);
    return eos_->thermal_escape(rho_, sqrt(V(thermal * v_)));
  }

  [[nodiscard]] WavePoint<V> at(V q, Mask<V> active) noexcept {
    V const x = (q - q_) / K_;
    Mask<V> const weak = abs(x) < V(weak_wave);
    V const strain = x * (1.0 - G_ * x);
    WavePoint<V> point{rho_ / (1.0 - strain), c_ * x * (1.0 - 0.5 * G_ * x), (1.0 - G_ * x) / (rho_ * c_)};
    Mask<V> const shock = active && !weak && q > q_, fan = active && !weak && q < q_;
    if (any(shock)) {
      blend(shock, point, shock_at(select(shock, q, q_ + weak_wave * K_), shock));
    }
    if (any(fan)) {
      blend(fan, point, fan_at(select(fan, q, q_), fan));
    }
    return point;
  }

  struct FanPoint {
    V rho, q, c;
  };
  /// The point of the fan where the gas moves at its own sound speed against the wave, given u of the state ahead;
  /// it lies between the density ahead and `rho_least`. Newton in ln(rho): d(u - c)/d ln(rho) = -c G.
  [[nodiscard]] FanPoint sonic(V u, V rho_least, Mask<V> active) noexcept {
    V low = select(active, max(rho_least, 1e-300), rho_), high = rho_, rho = rho_;
    Mask<V> open = active;
    FanPoint point{rho_, q_, c_};
    for (int i = 0; i < 80 && any(open); ++i) {
      V const t = thermal_at(rho);
      V const c = sqrt(V(eos_->bulk_modulus_thermal(rho, t) / rho));
      V const h = u + gain_to(rho, open) - c;
      point = {select(open, rho, point.rho), select(open, eos_->cold_excess(rho) + t, point.q),
               select(open, c, point.c)};
      high = select(open && h < V(0.0), rho, high);
      low = select(open && h >= V(0.0), rho, low);
      V const G = eos_->fundamental_derivative(rho, eos_->cold_excess(rho) + t + eos_->vacuum_pressure());
      V next = rho * exp(max(h / (c * G), -60.0));
      next = select(next >= low && next <= high, next, sqrt(low) * sqrt(high));
      open = open && abs(h) > 1e-14 * (abs(u) + c_) && abs(next - rho) > 2e-16 * rho;
      rho = select(open, next, rho);
    }
    return point;
  }

 private:
  struct Reach {
    V rho, c, gain;
  };

  G27_INLINE static void blend(Mask<V> m, WavePoint<V>& a, WavePoint<V> const& b) noexcept {
    a = {select(m, b.rho, a.rho), select(m, b.jump, a.jump), select(m, b.rate, a.rate)};
  }
  /// Thermal pressure on the isentrope through the state ahead.
  [[nodiscard]] G27_INLINE V thermal_at(V rho) const noexcept { return t_ * eos_->thermal_ratio(rho_, rho); }

  /// Hugoniot, e - e_k = (p + p_k)(v_k - v)/2: closed in v. Newton for ln q in y, v = limit + (v_k - limit) exp(-y):
  /// both are nearly linear in each other, for weak shocks and for strong ones.
  [[nodiscard]] WavePoint<V> shock_at(V q, Mask<V> active) noexcept {
    V const range = v_ - limit_;
    V const e_t = t_ * v_ / eos_->gruneisen(rho_), e_c = eos_->cold_energy(rho_);
    V y = log(1.0 + (q - q_) * v_ / (range * K_));
    V low(0.0), high(700.0), slope(1.0);
    V last(1e300), before_last(1e300);  // steps; bisect where two have not halved them
    Mask<V> open = active;
    for (int i = 0; i < 100 && any(open); ++i) {
      V const shrink = exp(-y);
      V const v_new = limit_ + range * shrink, delta = range * (1.0 - shrink);
      V const rho = 1.0 / v_new, gamma = eos_->gruneisen(rho);
      V const cold = eos_->cold_excess(rho);
      V const p_sum = cold + eos_->vacuum_pressure() + p_;
      V const half = max(v_new - 0.5 * gamma * delta, 1e-18 * v_new);
      V const t = gamma * (e_t + (e_c - eos_->cold_energy(rho)) + 0.5 * p_sum * delta) / half;
      V const q_new = cold + t;
      V const steep = (eos_->bulk_modulus_thermal(rho, t) - 0.5 * gamma * (q_new - q_)) / half;  // -(dp/dv)_H
      slope = select(open, steep, slope);
      Mask<V> const above = q_new > q;
      high = select(open && above, y, high);
      low = select(open && !above, y, low);
      V const step = log(max(q_new, 1e-12 * q_) / q) * q_new / (steep * range * shrink);
      V next = y - step;
      V const middle = select(high < V(700.0), 0.5 * (low + high), low + 2.0);
      // the last step, too, is taken: it squares what is left
      Mask<V> const close = abs(step) * range * shrink < newton_tolerance * v_new;
      Mask<V> const inside = next >= low && next <= high && abs(step) <= 0.5 * before_last;
      next = select(close || inside, next, middle);
      before_last = last, last = abs(step);
      y = select(open, next, y);
      open = open && !close;
    }
    V const shrink = exp(-y), strain = range * (1.0 - shrink), v = limit_ + range * shrink;
    V const dp = q - q_;
    V const jump = sqrt(V(dp * strain));
    return {1.0 / v, jump, 0.5 * (jump / dp + dp / (jump * slope))};
  }

  /// Isentrope: Newton for ln q in v. ln q is convex and falls with v (a sum of log-convex terms), and the start makes
  /// q too high, so that the iteration is monotone.
  [[nodiscard]] WavePoint<V> fan_at(V q, Mask<V> active) noexcept {
    V v = max(1.0 / eos_->expanded_density(rho_, t_, q), v_);
    Mask<V> open = active;
    for (int i = 0; i < 60 && any(open); ++i) {
      V const rho = 1.0 / v, t = thermal_at(rho);
      V const q_new = eos_->cold_excess(rho) + t;
      V const step = log(q_new / q) * q_new / (eos_->bulk_modulus_thermal(rho, t) * rho);
      V const next = max(v + step * (rho * v), v_);
      Mask<V> const more = abs(next - v) > newton_tolerance * v;
      v = select(open, next, v);
      open = open && more;
    }
    V const rho = 1.0 / v;
    return {rho, -gain_to(rho, active), 1.0 / (rho * speed(rho))};
  }

  /// Integral of c d(ln rho) from rho up to the density ahead, built on the last one known.
  [[nodiscard]] V gain_to(V rho, Mask<V> active) noexcept {
    V const lower = min(rho, known_rho_);
    Reach const r = reach(max(rho, known_rho_), lower, active);
    V const rest = eos_->thermal_escape(r.rho, r.c) - eos_->thermal_escape(lower, speed(lower));
    V const part = r.gain + select(r.rho > lower, rest, V(0.0));
    V const gain = known_gain_ + select(rho < known_rho_, part, -part);
    known_gain_ = select(active, gain, known_gain_);
    known_rho_ = select(active, rho, known_rho_);
    return known_gain_;
  }
  /// Sound speed on the isentrope through the state ahead.
  [[nodiscard]] G27_INLINE V speed(V rho) const noexcept {
    return sqrt(V(eos_->bulk_modulus_thermal(rho, thermal_at(rho)) / rho));
  }

  /// Integral of c d(ln rho) from `upper` down to `lower`, by Gauss-Legendre panels; stops early, at Reach::rho, where
  /// the cold part of c^2 or c itself no longer matters, so that the rest is closed.
  [[nodiscard]] Reach reach(V upper, V lower, Mask<V> active) noexcept {
    // nodes and weights of the 8-point rule on [-1, 1]
    constexpr std::array<double, 4> node{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
    constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
    V rho = upper, gain = V(0.0);
    Mask<V> open = active && lower < upper;
    while (any(open)) {
      V const K = eos_->bulk_modulus_thermal(rho, thermal_at(rho));
      V const K_cold = eos_->bulk_modulus_thermal(rho, V(0.0));
      open = open && K_cold > 1e-17 * K && K > 1e-36 * c_ * c_ * rho;
      V const step = eos_->smooth_step(rho);
      V const next = max(rho * exp(-step), lower);
      V const h = 0.5 * log(rho / max(next, 1e-300)), middle = sqrt(rho) * sqrt(next);
      V sum(0.0);
      for (std::size_t i = 0; i < node.size(); ++i) {
        V const stretch = exp(h * node[i]);
        sum += weight[i] * (speed(V(middle * stretch)) + speed(V(middle / stretch)));
      }
      gain = select(open, gain + h * sum, gain);
      rho = select(open, next, rho);
      open = open && rho > lower;
    }
    return {rho, speed(rho), gain};
  }

  E const* eos_;
  V rho_, v_, p_, t_, q_, K_, c_, G_, limit_;
  V known_rho_, known_gain_;
};

template <Lane V, EquationOfState E>
struct WaveCurveOf {
  using Type = GammaLawCurve<V, E>;
};
template <Lane V, ThermalForm E>
struct WaveCurveOf<V, E> {
  using Type = ThermalCurve<V, E>;
};
template <Lane V, EquationOfState E>
using WaveCurve = typename WaveCurveOf<V, E>::Type;

}  // namespace g27
