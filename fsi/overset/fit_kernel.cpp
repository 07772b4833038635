/// Interpolation between overset grids, of one instruction set.
#include "fsi/overset/field_numbers.hpp"
#include "fsi/overset/fit_kernels.hpp"
#include "riemann/base/lane.hpp"

namespace g27 {
namespace G27_ISA {

namespace {

constexpr std::size_t lanes = width<Simd>;
static_assert(fit_padding % lanes == 0);

/// Numbers of the lanes that are set, from `first` on, after `count` others; writes as many as there are lanes.
template <class Mask>
G27_INLINE void append(Mask const& set, std::size_t first, int* numbers, std::size_t& count) noexcept {
  bool one[lanes];
  set.copy_to(one, stdx::element_aligned);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    numbers[count] = static_cast<int>(first + lane);
    count += one[lane] ? 1 : 0;
  }
}

void near_cube(NearCubeArguments& g) noexcept {
  Simd const x0 = g.middle[0], y0 = g.middle[1], z0 = g.middle[2], half = g.half, limit = g.limit;
  std::size_t count = 0;
  for (std::size_t i = 0; i < g.donors; i += lanes) {
    Simd const x = load<Simd>(g.x + i) - x0, y = load<Simd>(g.y + i) - y0, z = load<Simd>(g.z + i) - z0;
    Simd square = 0;
    for (auto const& axis : g.axes) {
      Simd const beyond = max(abs(axis[0] * x + axis[1] * y + axis[2] * z) - half, Simd(0));
      square += beyond * beyond;
    }
    auto const inside = square < limit;
    if (any(inside)) append(inside, i, g.kept, count);
  }
  g.count = count;
}

void moments(FitArguments& g) noexcept {
  Simd const x0 = g.at[0], y0 = g.at[1], z0 = g.at[2], limit = g.limit;
  Simd sum = 0, x1 = 0, y1 = 0, z1 = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < g.donors; i += lanes) {
    Simd const x = load<Simd>(g.x + i) - x0, y = load<Simd>(g.y + i) - y0, z = load<Simd>(g.z + i) - z0;
    Simd const square = x * x + y * y + z * z;
    auto const inside = square < limit;
    if (!any(inside)) continue;
    Simd const w = select(inside, 1.0 / (square + fit_softening), 0.0);
    store(g.weight + i, w);
    append(inside, i, g.near, count);
    Simd const wx = w * x, wy = w * y, wz = w * z;
    sum += w, x1 += wx, y1 += wy, z1 += wz;
    xx += wx * x, yy += wy * y, zz += wz * z, xy += wx * y, xz += wx * z, yz += wy * z;
  }
  g.count = count, g.sum = stdx::reduce(sum);
  g.first = {stdx::reduce(x1), stdx::reduce(y1), stdx::reduce(z1)};
  g.second = {stdx::reduce(xx), stdx::reduce(yy), stdx::reduce(zz),
              stdx::reduce(xy), stdx::reduce(xz), stdx::reduce(yz)};
}

template <std::size_t fields, bool by_mass>
void combine(FitArguments& g) noexcept {
  constexpr std::size_t rows = fields / lanes, rest = fields % lanes, at_rest = rows * lanes;
  Simd out[rows + 1], low[rows + 1], high[rows + 1];
  double out_rest[rest + 1], low_rest[rest + 1], high_rest[rest + 1];
  double const* const first = g.q[g.near[0]];
  for (std::size_t r = 0; r < rows; ++r) out[r] = 0, low[r] = high[r] = load<Simd>(first + r * lanes);
  for (std::size_t f = 0; f < rest; ++f) out_rest[f] = 0, low_rest[f] = high_rest[f] = first[at_rest + f];
  double total = 0, mass = 0, energy = 0;
  for (std::size_t n = 0; n < g.count; ++n) {
    std::size_t const i = static_cast<std::size_t>(g.near[n]);
    double const* const q = g.q[i];
    double const share = g.weight[i] * (g.level + g.slope[0] * (g.x[i] - g.at[0]) + g.slope[1] * (g.y[i] - g.at[1]) +
                                        g.slope[2] * (g.z[i] - g.at[2]));
    total += share;
    double const weight = by_mass ? share * q[0] : share;
    if constexpr (by_mass) mass += weight, energy += weight * g.energy[i];
    for (std::size_t r = 0; r < rows; ++r) {
      Simd const row = load<Simd>(q + r * lanes);
      out[r] += weight * row, low[r] = min(low[r], row), high[r] = max(high[r], row);
    }
    for (std::size_t f = 0; f < rest; ++f) {
      double const one = q[at_rest + f];
      out_rest[f] += weight * one, low_rest[f] = min(low_rest[f], one), high_rest[f] = max(high_rest[f], one);
    }
  }
  g.mass = mass / total, g.mean_energy = energy / total;
  for (std::size_t r = 0; r < rows; ++r) {
    store<Simd>(g.out + r * lanes, out[r] / total);
    store(g.low + r * lanes, low[r]), store(g.high + r * lanes, high[r]);
  }
  for (std::size_t f = 0; f < rest; ++f) {
    g.out[at_rest + f] = out_rest[f] / total, g.low[at_rest + f] = low_rest[f], g.high[at_rest + f] = high_rest[f];
  }
}

template <Lane V>
G27_INLINE void eight(EightArguments const& g, std::size_t f) noexcept {
  V out = 0, low = load<V>(g.q[0] + f), high = low;
  for (std::size_t c = 0; c < 8; ++c) {
    V const q = load<V>(g.q[c] + f);
    out += g.w[c] * q, low = min(low, q), high = max(high, q);
  }
  store<V>(g.out + f, min(max(out, low), high));
}

template <std::size_t fields>
void multilinear(EightArguments const& g) noexcept {
  std::size_t f = 0;
  for (; f + lanes <= fields; f += lanes) eight<Simd>(g, f);
  for (; f < fields; ++f) eight<double>(g, f);
}

}  // namespace

extern FitKernels const fit_loops;
constexpr FitKernels fit_loops{.near_cube = &near_cube,
                               .moments = &moments,
                               .combine = {&combine<gas_field::count, true>, &combine<solid_field_of::count, false>},
                               .multilinear = {&multilinear<gas_field::count>, &multilinear<solid_field_of::count>}};

}  // namespace G27_ISA
}  // namespace g27
