#pragma once
/// exp, log and pow of a lane type: one algorithm for `double` and for `Simd` on every instruction set.
///
/// `stdx::exp` and its kin call the scalar library once a lane; these stay in vector registers. Only 64-bit integer
/// additions, logical shifts and bit operations are used beside arithmetic: what SSE2, AVX2 and AVX-512 all have.
/// Not templates, so that they are preferred to those of <experimental/simd> where argument-dependent lookup finds
/// both.
///
/// Method: Cody and Waite, "Software Manual for the Elementary Functions" (1980), chapters 5 and 6; polynomials by
/// Chebyshev interpolation in quadruple precision. Errors are asserted by tests/unit/lane_math.cpp.
#include <bit>
#include <cstdint>

#include "riemann/base/lane.hpp"

namespace g27 {

namespace lane_bits {

template <Lane V>
struct Word {
  using Type = stdx::rebind_simd_t<std::uint64_t, V>;
};
template <>
struct Word<double> {
  using Type = std::uint64_t;
};
/// The bits of a lane, as unsigned integers of the same width.
template <Lane V>
using Bits = typename Word<V>::Type;

template <Lane V>
G27_INLINE Bits<V> bits(V x) noexcept {
  return std::bit_cast<Bits<V>>(x);
}
template <Lane V>
G27_INLINE V value(Bits<V> b) noexcept {
  return std::bit_cast<V>(b);
}

inline constexpr double round_to_integer = 0x1.8p52;  // x + this has round(x) in its low bits, for |x| < 2^51
inline constexpr double ln2_high = 0x1.62e42feep-1;   // 31 bits: times an exponent it is exact
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;

template <Lane V>
G27_INLINE V exp(V const x) noexcept {
  // NaN passes through: a comparison with it is false.
  V const y = select(x < V(-708.0), V(-708.0), select(x > V(709.0), V(709.0), x));
  V const shifted = y * V(0x1.71547652b82fep0) + V(round_to_integer);
  V const n = shifted - V(round_to_integer);
  V const r = (y - n * V(ln2_high)) - n * V(ln2_low);
  V const r2 = r * r, r4 = r2 * r2;
  // (exp(r) - 1 - r)/r^2 on |r| <= ln(2)/2
  V const q01 = V(0x1.0000000000001p-1) + V(0x1.5555555555556p-3) * r;
  V const q23 = V(0x1.5555555553d63p-5) + V(0x1.11111111109b3p-7) * r;
  V const q45 = V(0x1.6c16c1788bd9p-10) + V(0x1.a01a01a7c41d5p-13) * r;
  V const q67 = V(0x1.a019b90d2ae7ap-16) + V(0x1.71de0dae63bb3p-19) * r;
  V const q89 = V(0x1.289185613a3d6p-22) + V(0x1.af38a9b0ec855p-26) * r;
  V const q = (q01 + r2 * q23) + r4 * ((q45 + r2 * q67) + r4 * q89);
  V const m = V(1.0) + (r + r2 * q);
  // |n| <= 1023 and m in [0.70, 1.42]: adding n to the exponent field is exact.
  return value<V>(bits(m) + (bits(shifted) << 52));
}

template <Lane V>
G27_INLINE V log(V const x) noexcept {
  auto const tiny = x < V(0x1p-1022);
  V const scaled = select(tiny, x * V(0x1p54), x);
  // x = 2^k m with m in [sqrt(1/2), sqrt(2))
  Bits<V> const offset = Bits<V>(0x3ff0000000000000u - 0x3fe6a09e667f3bcdu);
  Bits<V> const shifted = bits(scaled) + offset;
  V const m = value<V>((shifted & Bits<V>(0x000fffffffffffffu)) + Bits<V>(0x3fe6a09e667f3bcdu));
  V const biased = value<V>((shifted >> 52) | Bits<V>(0x4330000000000000u));  // 2^52 + 1023 + k
  V const k = biased - select(tiny, V(0x1p52 + 1023.0 + 54.0), V(0x1p52 + 1023.0));
  V const f = m - V(1.0);
  V const half = V(0.5) * f * f;
  V const s = f / (V(2.0) + f);
  V const z = s * s, z2 = z * z;
  // (2 atanh(s) - 2 s)/(s^3) on |s| <= (sqrt(2) - 1)/(sqrt(2) + 1)
  V const p01 = V(0x1.5555555555558p-1) + V(0x1.9999999995273p-2) * z;
  V const p23 = V(0x1.2492492dfd86cp-2) + V(0x1.c71c62d5e53ep-3) * z;
  V const p45 = V(0x1.7462b91b8df65p-3) + V(0x1.39fdcceb4bb45p-3) * z;
  V const p = (p01 + z2 * p23) + z2 * z2 * (p45 + z2 * V(0x1.2b5f68a50d903p-3));
  // 2 atanh(s) = f - f^2/2 + s (f^2/2 + z p); x - x is NaN for NaN and infinity
  V const tail = s * (half + z * p) + (k * V(ln2_low) + (x - x));
  return k * V(ln2_high) - ((half - tail) - f);
}

}  // namespace lane_bits

/// e^x for x in [-708, 709], error < 1.1 ulp; beyond, e^-708 and e^709: neither 0 nor infinity. NaN gives NaN.
G27_INLINE double exp(double x) noexcept { return lane_bits::exp(x); }
G27_INLINE Simd exp(Simd x) noexcept { return lane_bits::exp(x); }

/// Natural logarithm of x > 0, subnormal numbers included, error < 1 ulp. NaN and infinity give NaN; x <= 0 gives an
/// unspecified number.
G27_INLINE double log(double x) noexcept { return lane_bits::log(x); }
G27_INLINE Simd log(Simd x) noexcept { return lane_bits::log(x); }

/// x^y for x > 0 and |y ln x| <= 708, relative error <= (1 + |y ln x|) 2.3e-16; the limits of exp apply beyond.
G27_INLINE double pow(double x, double y) noexcept { return lane_bits::exp(y * lane_bits::log(x)); }
G27_INLINE Simd pow(Simd x, Simd y) noexcept { return lane_bits::exp(y * lane_bits::log(x)); }

}  // namespace g27
