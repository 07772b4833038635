/// Interpolation between overset grids, of one instruction set.
#include "fsi/overset/field_numbers.hpp"
#include "fsi/overset/fit_kernels.hpp"
#include "riemann/base/lane.hpp"

namespace g27 {
namespace G27_ISA {

namespace {

constexpr std::size_t lanes = width<Simd>;
static_assert(fit_padding % lanes == 0);

/// Appends the numbers of the donors of a range that are `inside` to `count` others. Without branches: where donors lie
/// is not to be foreseen, and every vector that is guessed wrong costs as much as three that are written in vain.
template <class Inside>
G27_INLINE void append(DonorRange const& range, Inside const& inside, int* numbers, std::size_t& count) noexcept {
  std::size_t const before = count;
  for (std::size_t i = range.first; i < range.last; i += lanes) {
    bool one[lanes];
    inside(i).copy_to(one, stdx::element_aligned);
    unrolled<lanes>([&](auto lane) G27_INLINE_LAMBDA {
      numbers[count] = static_cast<int>(i) + lane;
      count += one[lane] ? 1 : 0;
    });
  }
  while (count > before && numbers[count - 1] >= static_cast<int>(range.last)) --count;
}

void near_cube(NearCubeArguments& g) noexcept {
  Simd const x0 = g.middle[0], y0 = g.middle[1], z0 = g.middle[2], half = g.half, limit = g.limit;
  std::size_t count = 0;
  auto const inside = [&](std::size_t i) G27_INLINE_LAMBDA {
    Simd const x = load<Simd>(g.x + i) - x0, y = load<Simd>(g.y + i) - y0, z = load<Simd>(g.z + i) - z0;
    auto const beyond = [&](std::array<double, 3> const& axis) G27_INLINE_LAMBDA {
      return max(abs(axis[0] * x + axis[1] * y + axis[2] * z) - half, Simd(0));
    };
    Simd const n = beyond(g.axes[0]), a = beyond(g.axes[1]), b = beyond(g.axes[2]);
    return n * n + a * a + b * b < limit;
  };
  for (std::size_t r = 0; r < g.ranges; ++r) {
    append(g.range[r], inside, g.kept, count);
    g.ends[r] = count;
  }
}

void moments(FitArguments& g) noexcept {
  Simd const x0 = g.at[0], y0 = g.at[1], z0 = g.at[2], limit = g.limit;
  std::size_t count = 0;
  auto const inside = [&](std::size_t i) G27_INLINE_LAMBDA {
    Simd const x = load<Simd>(g.x + i) - x0, y = load<Simd>(g.y + i) - y0, z = load<Simd>(g.z + i) - z0;
    return x * x + y * y + z * z < limit;
  };
  for (std::size_t r = 0; r < g.ranges; ++r) append(g.range[r], inside, g.near, count);
  // the last vector is filled up with donors of weight 0
  for (std::size_t lane = 0; lane < lanes; ++lane) g.near[count + lane] = g.near[0];
  Simd const lane([](auto i) G27_INLINE_LAMBDA { return static_cast<double>(i); });
  Simd sum = 0, x1 = 0, y1 = 0, z1 = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (std::size_t n = 0; n < count; n += lanes) {
    auto const of = [&](double const* q)
                        G27_INLINE_LAMBDA { return Simd([&](auto i) G27_INLINE_LAMBDA { return q[g.near[n + i]]; }); };
    Simd const x = of(g.x) - x0, y = of(g.y) - y0, z = of(g.z) - z0;
    auto const there = lane < Simd(static_cast<double>(count - n));
    Simd const w = select(there, 1.0 / (x * x + y * y + z * z + fit_softening), 0.0);
    store(g.weight + n, w), store(g.rx + n, x), store(g.ry + n, y), store(g.rz + n, z);
    Simd const wx = w * x, wy = w * y, wz = w * z;
    sum += w, x1 += wx, y1 += wy, z1 += wz;
    xx += wx * x, yy += wy * y, zz += wz * z, xy += wx * y, xz += wx * z, yz += wy * z;
  }
  g.count = count, g.sum = stdx::reduce(sum);
  g.first = {stdx::reduce(x1), stdx::reduce(y1), stdx::reduce(z1)};
  g.second = {stdx::reduce(xx), stdx::reduce(yy), stdx::reduce(zz),
              stdx::reduce(xy), stdx::reduce(xz), stdx::reduce(yz)};
}

/// xx yy zz xy xz yz
std::array<Simd, 6> products(FitArguments const& g, std::size_t n) noexcept {
  Simd const x = load<Simd>(g.rx + n), y = load<Simd>(g.ry + n), z = load<Simd>(g.rz + n);
  return {x * x, y * y, z * z, x * y, x * z, y * z};
}

void third(FitArguments& g) noexcept {
  // ten of the eighteen differ: xxx xxy xxz yyx yyy yyz zzx zzy zzz xyz
  std::array<Simd, 10> sum{};
  for (std::size_t n = 0; n < g.count; n += lanes) {
    Simd const w = load<Simd>(g.weight + n), x = load<Simd>(g.rx + n), y = load<Simd>(g.ry + n),
               z = load<Simd>(g.rz + n);
    Simd const xx = w * x * x, yy = w * y * y, zz = w * z * z;
    sum[0] += xx * x, sum[1] += xx * y, sum[2] += xx * z;
    sum[3] += yy * x, sum[4] += yy * y, sum[5] += yy * z;
    sum[6] += zz * x, sum[7] += zz * y, sum[8] += zz * z;
    sum[9] += w * x * y * z;
  }
  std::array<double, 10> t{};
  for (std::size_t i = 0; i < 10; ++i) t[i] = stdx::reduce(sum[i]);
  g.third = {{{t[0], t[1], t[2]},
              {t[3], t[4], t[5]},
              {t[6], t[7], t[8]},
              {t[1], t[3], t[9]},
              {t[2], t[9], t[6]},
              {t[9], t[5], t[7]}}};
}

void fourth(FitArguments& g) noexcept {
  for (std::size_t n = 0; n < g.count; n += lanes) {
    Simd const x = load<Simd>(g.rx + n), y = load<Simd>(g.ry + n), z = load<Simd>(g.rz + n);
    std::array<Simd, 6> const q = products(g, n);
    unrolled<6>([&](auto i) G27_INLINE_LAMBDA {
      store<Simd>(g.bend[i] + n, q[i] - g.constant[i] - g.linear[i][0] * x - g.linear[i][1] * y - g.linear[i][2] * z);
    });
  }
  unrolled<6>([&](auto i) G27_INLINE_LAMBDA {
    std::array<Simd, 6> sum{};
    for (std::size_t n = 0; n < g.count; n += lanes) {
      Simd const one = load<Simd>(g.weight + n) * load<Simd>(g.bend[i] + n);
      unrolled<6>([&](auto j) G27_INLINE_LAMBDA {
        if constexpr (j >= i) sum[j] += one * load<Simd>(g.bend[j] + n);
      });
    }
    for (std::size_t j = i; j < 6; ++j) g.fourth[i][j] = g.fourth[j][i] = stdx::reduce(sum[j]);
  });
}

template <std::size_t fields, bool by_mass, bool quadratic>
void combine(FitArguments& g) noexcept {
  constexpr std::size_t rows = fields / lanes, rest = fields % lanes, at_rest = rows * lanes;
  Simd out[rows + 1], low[rows + 1], high[rows + 1];
  double out_rest[rest + 1], low_rest[rest + 1], high_rest[rest + 1];
  double const* const first = g.q[g.near[0]];
  for (std::size_t r = 0; r < rows; ++r) out[r] = 0, low[r] = high[r] = load<Simd>(first + r * lanes);
  for (std::size_t f = 0; f < rest; ++f) out_rest[f] = 0, low_rest[f] = high_rest[f] = first[at_rest + f];
  double total = 0, mass = 0, energy = 0;
  for (std::size_t n = 0; n < g.count; n += lanes) {
    Simd const x = load<Simd>(g.rx + n), y = load<Simd>(g.ry + n), z = load<Simd>(g.rz + n);
    Simd share = g.level + g.slope[0] * x + g.slope[1] * y + g.slope[2] * z;
    if constexpr (quadratic) {
      unrolled<6>([&](auto i) G27_INLINE_LAMBDA { share += g.curvature[i] * load<Simd>(g.bend[i] + n); });
    }
    store<Simd>(g.weight + n, load<Simd>(g.weight + n) * share);
  }
  for (std::size_t n = 0; n < g.count; ++n) {
    std::size_t const i = static_cast<std::size_t>(g.near[n]);
    double const* const q = g.q[i];
    double const share = g.weight[n];
    total += share;
    double const weight = by_mass ? share * q[0] : share;
    if constexpr (by_mass) mass += weight, energy += weight * g.energy[i];
    unrolled<rows>([&](auto r) G27_INLINE_LAMBDA {
      Simd const row = load<Simd>(q + r * lanes);
      out[r] += weight * row, low[r] = min(low[r], row), high[r] = max(high[r], row);
    });
    unrolled<rest>([&](auto f) G27_INLINE_LAMBDA {
      double const one = q[at_rest + f];
      out_rest[f] += weight * one, low_rest[f] = min(low_rest[f], one), high_rest[f] = max(high_rest[f], one);
    });
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
constexpr FitKernels fit_loops{
    .near_cube = &near_cube,
    .moments = &moments,
    .third = &third,
    .fourth = &fourth,
    .combine = {&combine<gas_field::count, true, false>, &combine<solid_field_of::count, false, false>},
    .combine_quadratic = &combine<solid_field_of::count, false, true>,
    .multilinear = {&multilinear<gas_field::count>, &multilinear<solid_field_of::count>}};

}  // namespace G27_ISA
}  // namespace g27
