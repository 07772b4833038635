#pragma once
/// The lane type V of every kernel: `double` (one problem) or `Simd` (one problem a lane).
///
/// Kernels are templates on V and are written with the functions below only, so the same source serves the
/// scalar oracle comparison and the vector sweep. A kernel file is compiled once per instruction set; everything
/// here is force-inlined, so that no symbol of one instruction set can be linked into another.
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <utility>

#define G27_INLINE [[gnu::always_inline]] inline
/// For lambdas: `auto f = [&](V x) G27_INLINE_LAMBDA { ... };`
#define G27_INLINE_LAMBDA __attribute__((always_inline))

namespace g27 {

namespace stdx = std::experimental;
using Simd = stdx::native_simd<double>;

template <class V>
struct LaneTraits;
template <>
struct LaneTraits<double> {
  using Mask = bool;
  static constexpr std::size_t width = 1;
};
template <class Abi>
struct LaneTraits<stdx::simd<double, Abi>> {
  using Mask = typename stdx::simd<double, Abi>::mask_type;
  static constexpr std::size_t width = stdx::simd<double, Abi>::size();
};

template <class V>
concept Lane = requires {
  typename LaneTraits<V>::Mask;
};
template <Lane V>
using Mask = typename LaneTraits<V>::Mask;
template <Lane V>
inline constexpr std::size_t width = LaneTraits<V>::width;

/// Stops template argument deduction, so that a literal converts to the lane type of the other arguments.
template <class V>
using Plain = std::type_identity_t<V>;

template <Lane V>
G27_INLINE V load(double const* p) noexcept {
  if constexpr (std::same_as<V, double>) {
    return *p;
  } else {
    return V(p, stdx::element_aligned);
  }
}
template <Lane V>
G27_INLINE void store(double* p, V v) noexcept {
  if constexpr (std::same_as<V, double>) {
    *p = v;
  } else {
    v.copy_to(p, stdx::element_aligned);
  }
}

/// m ? a : b, lane by lane; both sides are evaluated.
template <Lane V>
G27_INLINE V select(Mask<V> m, V a, Plain<V> b) noexcept {
  if constexpr (std::same_as<V, double>) {
    return m ? a : b;
  } else {
    stdx::where(m, b) = a;
    return b;
  }
}
template <class M>
G27_INLINE bool any(M m) noexcept {
  if constexpr (std::same_as<M, bool>) {
    return m;
  } else {
    return stdx::any_of(m);
  }
}
template <class M>
G27_INLINE bool all(M m) noexcept {
  if constexpr (std::same_as<M, bool>) {
    return m;
  } else {
    return stdx::all_of(m);
  }
}

template <Lane V>
G27_INLINE V min(V a, Plain<V> b) noexcept {
  if constexpr (std::same_as<V, double>) {
    return b < a ? b : a;
  } else {
    return stdx::min(a, b);
  }
}
template <Lane V>
G27_INLINE V max(V a, Plain<V> b) noexcept {
  if constexpr (std::same_as<V, double>) {
    return a < b ? b : a;
  } else {
    return stdx::max(a, b);
  }
}
template <Lane V>
G27_INLINE V abs(V a) noexcept {
  if constexpr (std::same_as<V, double>) {
    return std::fabs(a);
  } else {
    return stdx::fabs(a);
  }
}
template <Lane V>
G27_INLINE V sqrt(V a) noexcept {
  if constexpr (std::same_as<V, double>) {
    return __builtin_sqrt(a);
  } else {
    return stdx::sqrt(a);
  }
}
/// Largest and smallest of the lanes.
template <Lane V>
G27_INLINE double lane_max(V a) noexcept {
  if constexpr (std::same_as<V, double>) {
    return a;
  } else {
    return stdx::hmax(a);
  }
}
template <Lane V>
G27_INLINE double lane_min(V a) noexcept {
  if constexpr (std::same_as<V, double>) {
    return a;
  } else {
    return stdx::hmin(a);
  }
}
template <Lane V>
G27_INLINE double lane(V a, std::size_t i) noexcept {
  if constexpr (std::same_as<V, double>) {
    return a;
  } else {
    return a[i];
  }
}

/// f(0), f(1), ..., f(n - 1) with constants: small arrays of lanes indexed by them stay in registers.
template <int n, class F>
G27_INLINE void unrolled(F const& f) noexcept {
  [&]<int... k>(std::integer_sequence<int, k...>) G27_INLINE_LAMBDA { (f(std::integral_constant<int, k>{}), ...); }
  (std::make_integer_sequence<int, n>{});
}

}  // namespace g27
