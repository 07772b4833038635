#pragma once
/// What a predictor sees and what it returns: the four cells around a face, two Riemann states and, where the jump is
/// weak, the face state itself. Predictors know no equation of state: K = rho c^2 of each cell is all they need.
#include "riemann/state/gas.hpp"

namespace g27 {

/// Where the acoustic star state may stand for the exact solution: |dp| <= weak_pressure K, |du| <= weak_velocity c.
/// For an ideal gas with gamma = 1.4 that is |dp| <= 0.1 p.
inline constexpr double weak_pressure = 0.1 / 1.4;
inline constexpr double weak_velocity = 0.1;

/// Primitive state with its bulk modulus K = rho c^2 [Pa].
template <Lane V>
struct Cell {
  V rho, u, p, K;
  V dK_dp;  ///< along the isentrope; for predictors beyond second order
};

/// Cells i-1, i | i+1, i+2 = z, a | b, y around the face between a and b, and the mesh there.
template <Lane V>
struct Stencil {
  Cell<V> z, a, b, y;
  V h_a, h_b;                   ///< widths of a and b [m]
  V pair_za, pair_ab, pair_by;  ///< 1 / (sum of the two widths) across the three intervals [1/m]
  V triple_a, triple_b;         ///< 1 / (sum of the three widths) around a and b [1/m]
  V w;                          ///< face speed [m/s]
  V dt;                         ///< time step [s]
  V foot_shift, foot_factor;    ///< OG (3.10) only: corrections of the cell that the face is computed for [m, 1]
  bool linear_star;             ///< false: every face goes to the solver, so that no lane is weak
  bool incremented;             ///< the increments below are there
  bool own_increments;          ///< each side takes that of its own cell
  GasState<V> inc_a, inc_b;     ///< half-step increments of a and b from sources, geometry, transverse terms
  bool uniform = false;         ///< equal widths: h, pair and triple are the same on both sides
};

template <Lane V>
struct FacePrediction {
  GasState<V> star;         ///< face state where `weak`
  GasState<V> change;       ///< of the face state over dt/sqrt(12), where `weak`; set by predictors beyond second order
  GasState<V> left, right;  ///< states of the Riemann problem; set unless all lanes are weak
  Mask<V> weak;             ///< the acoustic star state is taken
  V switched;               ///< number of fields (0..3) on which the monotonicity switch acted
};

template <Lane V>
G27_INLINE GasState<V> state(Cell<V> const& c) noexcept {
  return {c.rho, c.u, c.p};
}

/// Increments that differ no more than the states of a weak jump may: where those of the two cells do, as beside a
/// shock that runs along the face, the jump that the cells show is not all there is.
template <Lane V>
G27_INLINE Mask<V> alike(GasState<V> const& a, GasState<V> const& b, V rho, V K, V c) noexcept {
  return abs(b.p - a.p) <= weak_pressure * K && abs(b.u - a.u) <= weak_velocity * c &&
         abs(b.rho - a.rho) <= weak_pressure * rho;
}

/// Weak-jump star state of two states: linearised about their mean (K, rho), upwinded when the face lies outside the
/// acoustic cone (Toro, 3rd ed., 9.3, with the mean impedance).
template <Lane V>
struct AcousticStar {
  GasState<V> state;
  Mask<V> weak;
};
template <Lane V>
G27_INLINE AcousticStar<V> acoustic_star(GasState<V> const& l, GasState<V> const& r, V K, V K_min, V w) noexcept {
  V const rho = 0.5 * (l.rho + r.rho);
  V const c2 = K / rho, c = sqrt(c2), Z = rho * c;
  V const dp = r.p - l.p, du = r.u - l.u, v = 0.5 * (l.u + r.u) - w;
  V p = 0.5 * (l.p + r.p) - 0.5 * Z * du, u = 0.5 * (l.u + r.u) - 0.5 * dp / Z;
  Mask<V> const from_left = v - c > 0.0, from_right = v + c < 0.0;
  p = select(from_left, l.p, select(from_right, r.p, p));
  u = select(from_left, l.u, select(from_right, r.u, u));
  Mask<V> const left_of_contact = u > w;
  V const rho_side = select(left_of_contact, l.rho, r.rho), p_side = select(left_of_contact, l.p, r.p);
  V const rho_star = rho_side + (p - p_side) / c2;
  return {.state = {rho_star, u, p},
          .weak = abs(dp) <= weak_pressure * K_min && abs(du) <= weak_velocity * c && rho_star > 0.2 * rho_side};
}

}  // namespace g27
