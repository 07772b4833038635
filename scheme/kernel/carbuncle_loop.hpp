#pragma once
/// The cure of the carbuncle: cells in a strong shock that runs along a grid line take HLLE's flux between cell
/// averages on all their faces. The exact solver resolves the contacts that waves along such a shock make, and lets
/// them grow (Quirk, Int. J. Numer. Meth. Fluids 18 (1994) 555); HLLE (Einfeldt, SIAM J. Numer. Anal. 25 (1988) 294)
/// does not.
#include "riemann/base/lane.hpp"
#include "riemann/eos/concept.hpp"
#include "scheme/kernel/grid_kernels.hpp"
#include "scheme/predictor/parabolic.hpp"

namespace g27 {

inline constexpr double cure_noise = 1e-14;    ///< waves below this share of rho, K, c are round-off
inline constexpr double cure_alignment = 0.2;  ///< transverse over normal pressure difference up to which it acts

/// A cell is in such a shock where over the three cells along an axis pressure changes by more than shock_pressure K
/// (for an ideal gas: more than the least pressure), the velocity along it decreases, the shock moves over the grid no
/// faster than the sound behind it (or than the square root of dp/drho), and the pressure differences along the other
/// axes are small beside it. A flow of one dimension has nothing to cure. Shocks that move faster leave a cell before
/// the waves have grown; there the cure would cost accuracy (a third of the error of a blast wave) and bring nothing.
template <int dims, Lane V>
G27_INLINE V shock_flag(RowIn const& primitive, double const* K, std::array<std::ptrdiff_t, 3> const& stride,
                        std::ptrdiff_t i) noexcept {
  V const p = load<V>(primitive.last + i), rho = load<V>(primitive.first + i), K_here = load<V>(K + i);
  V most[dims], d_p[dims];
  Mask<V> shock[dims], waves[dims], strong(false);
  unrolled<dims>([&](auto a) G27_INLINE_LAMBDA {
    std::ptrdiff_t const s = stride[a];
    V const below = load<V>(primitive.last + i - s), above = load<V>(primitive.last + i + s);
    V const K_least = min(K_here, min(load<V>(K + i - s), load<V>(K + i + s)));
    V const change = max(p, max(below, above)) - min(p, min(below, above));
    d_p[a] = above - below, most[a] = abs(d_p[a]);
    waves[a] = abs(above - p) + abs(p - below) > cure_noise * K_here;
    shock[a] = change > parabolic::shock_pressure * K_least;
    strong = strong || shock[a];
  });
  V flag(0.0);
  if (!any(strong)) return flag;
  unrolled<dims>([&](auto a) G27_INLINE_LAMBDA {
    std::ptrdiff_t const s = stride[a];
    auto const changes = [&](double const* q) G27_INLINE_LAMBDA {
      V const here = load<V>(q);
      return abs(load<V>(q + s) - here) + abs(here - load<V>(q - s));
    };
    waves[a] = waves[a] || V(changes(primitive.first + i)) > cure_noise * rho;
    unrolled<dims>([&](auto c) G27_INLINE_LAMBDA {
      V const change = changes(primitive.vector[c] + i);
      waves[a] = waves[a] || change * change * rho > (cure_noise * cure_noise) * K_here;
    });
    V const rho_b = load<V>(primitive.first + i - s), rho_a = load<V>(primitive.first + i + s);
    V const u_b = load<V>(primitive.vector[a] + i - s), u_a = load<V>(primitive.vector[a] + i + s);
    V const c2 = max(load<V>(K + i - s) / rho_b, load<V>(K + i + s) / rho_a);
    // Its speed s is the jump of the mass flux over that of density; (u_1 - s)(u_2 - s) is that of pressure over it,
    // halfway up the shock as well.
    V const mass = rho_a * u_a - rho_b * u_b, d_rho = rho_a - rho_b;
    shock[a] = shock[a] && u_a < u_b && mass * mass <= max(V(c2 * d_rho * d_rho), abs(V(d_p[a] * d_rho)));
  });
  unrolled<dims>([&](auto a) G27_INLINE_LAMBDA {
    Mask<V> in_shock = shock[a], disturbed(false);
    unrolled<dims>([&](auto b) G27_INLINE_LAMBDA {
      if constexpr (a != b) {
        in_shock = in_shock && most[b] <= cure_alignment * most[a];
        disturbed = disturbed || waves[b];
      }
    });
    flag = select(in_shock && disturbed, V(1.0), flag);
  });
  return flag;
}

/// Whether a lane of the row, not beyond it, is flagged.
template <Lane V>
G27_INLINE bool flagged(V flag, std::ptrdiff_t i, std::ptrdiff_t n) noexcept {
  bool found = false;
  for (std::size_t k = 0; k < width<V> && i + static_cast<std::ptrdiff_t>(k) < n; ++k) {
    found = found || lane(flag, k) > 0.0;
  }
  return found;
}

template <int dims, Lane V>
void shock_flags(ShockFlagArguments& g) noexcept {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.cells);
  g.any = false;
  for (std::ptrdiff_t i = 0; i < n; i += static_cast<std::ptrdiff_t>(width<V>)) {
    V const flag = shock_flag<dims, V>(g.primitive, g.K, g.stride, i);
    if (any(flag > 0.0)) g.any = g.any || flagged(flag, i, n);
    store(g.flag + i, flag);
  }
}

/// Flux of HLLE, wave speeds from Roe's averages bounded by each side's own (Einfeldt 1988; Toro, 3rd ed., 10.5.1).
template <int dims, class E, Lane V>
void hlle(HlleArguments const& g) noexcept {
  E const& eos = *static_cast<E const*>(g.eos);
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces), s = g.stride;
  int const axis = g.axis;
  for (std::ptrdiff_t f = 0; f < n; f += static_cast<std::ptrdiff_t>(width<V>)) {
    Mask<V> const wanted = load<V>(g.mark + f) > 0.0;
    if (!any(wanted)) continue;
    auto const side = [&](std::ptrdiff_t i, V& rho, V* u, V& p, V& c2, V& energy) G27_INLINE_LAMBDA {
      rho = load<V>(g.primitive.first + i), p = load<V>(g.primitive.last + i);
      V kinetic(0.0);
#pragma GCC unroll 3
      for (int c = 0; c < dims; ++c) u[c] = load<V>(g.primitive.vector[c] + i), kinetic += u[c] * u[c];
      c2 = eos.bulk_modulus(rho, p) / rho;
      energy = rho * (eos.energy(rho, p) + 0.5 * kinetic);
    };
    V rho_l, u_l[3], p_l, c2_l, e_l, rho_r, u_r[3], p_r, c2_r, e_r;
    side(f, rho_l, u_l, p_l, c2_l, e_l), side(f + s, rho_r, u_r, p_r, c2_r, e_r);
    V const n_l = axis == 0 ? u_l[0] : axis == 1 ? u_l[1] : u_l[dims - 1];
    V const n_r = axis == 0 ? u_r[0] : axis == 1 ? u_r[1] : u_r[dims - 1];
    V const w_l = sqrt(rho_l), w_r = sqrt(rho_r), w = 1.0 / (w_l + w_r), du = n_r - n_l;
    V const u_m = (w_l * n_l + w_r * n_r) * w;
    V const c_m = sqrt(V((w_l * c2_l + w_r * c2_r) * w + 0.5 * w_l * w_r * w * w * du * du));
    V const zero(0.0);
    V const s_l = min(zero, min(V(n_l - sqrt(c2_l)), V(u_m - c_m)));
    V const s_r = max(zero, max(V(n_r + sqrt(c2_r)), V(u_m + c_m)));
    V const inv = 1.0 / (s_r - s_l), both = s_l * s_r;
    auto const flux = [&](V f_l, V f_r, V q_l, V q_r)
                          G27_INLINE_LAMBDA { return V((s_r * f_l - s_l * f_r + both * (q_r - q_l)) * inv); };
    auto const put = [&](double* to, V value)
                         G27_INLINE_LAMBDA { store(to + f, select(wanted, value, load<V>(to + f))); };
    V const m_l = rho_l * n_l, m_r = rho_r * n_r;
    put(g.flux.first, flux(m_l, m_r, rho_l, rho_r));
    put(g.flux.last, flux(V((e_l + p_l) * n_l), V((e_r + p_r) * n_r), e_l, e_r));
#pragma GCC unroll 3
    for (int c = 0; c < dims; ++c) {
      V const push_l = c == axis ? V(m_l * u_l[c] + p_l) : V(m_l * u_l[c]);
      V const push_r = c == axis ? V(m_r * u_r[c] + p_r) : V(m_r * u_r[c]);
      put(g.flux.vector[c], flux(push_l, push_r, V(rho_l * u_l[c]), V(rho_r * u_r[c])));
    }
  }
}

}  // namespace g27
