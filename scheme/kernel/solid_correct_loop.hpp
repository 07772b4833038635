#pragma once
/// The corrector of a row of solid cells:
///   rho S <- rho S - dt div(rho u S) + dt rho_half (2 mu dev D + W Sbar - Sbar W),
/// gradients from the face velocities, Sbar the mean of the stresses on the faces, rho_half the mean of the old and the
/// new density; then the return to the yield surface, which leaves the total energy alone.
#include "riemann/state/solid.hpp"
#include "riemann/strength/jaumann.hpp"
#include "riemann/strength/von_mises.hpp"
#include "scheme/kernel/lane_sum.hpp"
#include "scheme/kernel/solid_kernels.hpp"

namespace g27 {

template <Lane V>
void solid_correct(SolidCorrectArguments& g) noexcept {
  namespace to = solid_conserved;
  namespace face = solid_face;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  int axes = 0;
  for (int a = 0; a < 3; ++a) axes += g.lower[static_cast<std::size_t>(a)].data != nullptr ? 1 : 0;
  double const share = 0.5 / axes;
  LaneSum<V> yielded, plastic_work;
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V q[to::fields], mean[6];
    unrolled<to::fields>([&](auto k) G27_INLINE_LAMBDA { q[k] = load<V>(g.now[k] + i); });
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { mean[k] = V(0.0); });
    V const mass_old = q[to::mass];
    // first the means, which the Jaumann terms of every axis share
    unrolled<3>([&](auto a) G27_INLINE_LAMBDA {
      if (g.lower[a].data == nullptr) return;
      FieldRows const &l = g.lower[a], &h = g.upper[a];
      V const lambda(g.lambda[a]), m_l = load<V>(l[face::mass] + i), m_h = load<V>(h[face::mass] + i);
      unrolled<5>([&](auto k) G27_INLINE_LAMBDA { q[k] -= lambda * V(load<V>(h[k] + i) - load<V>(l[k] + i)); });
      unrolled<6>([&](auto k) G27_INLINE_LAMBDA {
        V const S_l = load<V>(l[face::S + k] + i), S_h = load<V>(h[face::S + k] + i);
        q[to::S + k] -= lambda * V(m_h * S_h - m_l * S_l);
        mean[k] += share * V(S_l + S_h);
      });
      q[to::ep] -= lambda * V(m_h * load<V>(h[face::ep] + i) - m_l * load<V>(l[face::ep] + i));
    });
    if (g.source.data != nullptr) {
      unrolled<to::fields>([&](auto k) G27_INLINE_LAMBDA { q[k] += load<V>(g.source[k] + i); });
    }
    V const half_mass = 0.5 * (mass_old + q[to::mass]);
    unrolled<3>([&](auto a) G27_INLINE_LAMBDA {
      if (g.lower[a].data == nullptr) return;
      constexpr int c[6] = {frame_component(a, 0), frame_component(a, 1), frame_component(a, 2),
                            frame_component(a, 3), frame_component(a, 4), frame_component(a, 5)};
      V grad[3], rate[6];
      unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
        constexpr int row = face::u + (a + k) % 3;
        grad[k] = g.lambda[a] * V(load<V>(g.upper[a][row] + i) - load<V>(g.lower[a][row] + i));
      });
      V const S[6] = {mean[c[0]], mean[c[1]], mean[c[2]], mean[c[3]], mean[c[4]], mean[c[5]]};
      jaumann_along(g.strength.mu, S, grad, rate);
      unrolled<6>([&](auto k) G27_INLINE_LAMBDA { q[to::S + c[k]] += half_mass * rate[k]; });
    });
    if (g.plastic) {
      V const inv = 1.0 / q[to::mass];
      V S[6], ep = q[to::ep] * inv;
      unrolled<6>([&](auto k) G27_INLINE_LAMBDA { S[k] = q[to::S + k] * inv; });
      V const Y = g.strength.Y0 + g.strength.H * ep;
      Mask<V> const yields = mises_squared(S) > Y * Y;
      if (any(yields)) {
        V const before = ep;
        if (g.midpoint)
          midpoint_return(g.strength, S, ep, mean);
        else
          radial_return(g.strength, S, ep);
        unrolled<6>([&](auto k)
                        G27_INLINE_LAMBDA { q[to::S + k] = select(yields, V(q[to::mass] * S[k]), q[to::S + k]); });
        q[to::ep] = select(yields, V(q[to::mass] * ep), q[to::ep]);
        V const flow = ep - before, work = flow * (g.strength.Y0 + g.strength.H * 0.5 * (ep + before));
        yielded.add(select(yields, V(1.0), V(0.0)), n - i), plastic_work.add(select(yields, work, V(0.0)), n - i);
      }
    }
    unrolled<to::fields>([&](auto k) G27_INLINE_LAMBDA { store(g.next[k] + i, q[k]); });
  }
  g.yielded += yielded.total(), g.plastic_work += plastic_work.total();
}

}  // namespace g27
