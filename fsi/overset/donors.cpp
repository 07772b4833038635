#include "fsi/overset/donors.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace g27 {

namespace {

constexpr double reach = 1.6;          ///< radius of the donors, in cells
constexpr double widen = 1.5;          ///< by which it grows when there are too few
constexpr std::size_t fewest = 5;      ///< donors
constexpr double least_moment = 0.02;  ///< of the sum of the weights, along a direction in which a slope is fitted
constexpr double stiffness = 0.013;    ///< of a quadratic fit, see fsi/README.md
constexpr double everything = 1e10;    ///< radius that takes all that were gathered, in cells
constexpr double far_away = 1e30;      ///< where donors that do not give lie, in cells

/// Inverse of a symmetric matrix xx yy zz xy xz yz; along eigenvectors whose eigenvalue is below `least` nothing.
class Inverse {
 public:
  Inverse(std::array<double, 6> const& c, double least) {
    double const xx = c[0], yy = c[1], zz = c[2], xy = c[3], xz = c[4], yz = c[5], trace = xx + yy + zz;
    double const a = yy * zz - yz * yz, b = xz * yz - xy * zz, d = xy * yz - xz * yy;
    double const det = xx * a + xy * b + xz * d;
    // the least eigenvalue is at least 4 det/trace^2
    if (det * 4 > least * trace * trace) {
      scale_ = 1 / det;
      cofactors_ = {a, xx * zz - xz * xz, xx * yy - xy * xy, b, d, xy * xz - xx * yz};
      return;
    }
    Eigen::Matrix3d C;
    C << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(C);
    for (int i = 0; i < 3; ++i) {
      if (solver.eigenvalues()[i] <= least) continue;
      Eigen::Vector3d const v = solver.eigenvectors().col(i);
      values_[known_] = solver.eigenvalues()[i], vectors_[known_++] = {v[0], v[1], v[2]};
    }
  }

  [[nodiscard]] Vec3 times(Vec3 const& m) const noexcept {
    if (scale_ > 0) {
      auto const [a, e, g, b, d, f] = cofactors_;
      return {scale_ * (a * m[0] + b * m[1] + d * m[2]), scale_ * (b * m[0] + e * m[1] + f * m[2]),
              scale_ * (d * m[0] + f * m[1] + g * m[2])};
    }
    Vec3 out{0, 0, 0};
    for (std::size_t i = 0; i < known_; ++i) out = out + (dot(vectors_[i], m) / values_[i]) * vectors_[i];
    return out;
  }

 private:
  double scale_ = 0;
  std::array<double, 6> cofactors_{};
  std::size_t known_ = 0;
  std::array<double, 3> values_{};
  std::array<Vec3, 3> vectors_{};
};

/// Place of a medium's kernels in their tables.
template <class Fields>
inline constexpr std::size_t table = std::tuple_size_v<Fields> == gas_field::count ? 0 : 1;

/// Total energy per mass [J/kg]; of solids nothing.
double energy_of(AnyEos const& eos, GasFields const& q) noexcept {
  Vec3 const u = velocity_of(q);
  return std::visit([&](auto const& law) { return law.energy(q[gas_field::rho], q[gas_field::p]); }, eos) +
         0.5 * dot(u, u);
}
double energy_of(AnySolid const&, SolidFields const&) noexcept { return 0; }

double pressure_of(AnyEos const& eos, GasFields const& q, double energy) noexcept {
  Vec3 const u = velocity_of(q);
  return std::visit([&](auto const& law) { return law.pressure(q[gas_field::rho], energy - 0.5 * dot(u, u)); }, eos);
}

/// Of a quadratic fit, from the mean place of the donors and the inverse of their moments about it: the share of each
/// product xx .. yz that makes up for what its linear fit has at the point, where it is 0. What few donors tell of is
/// stiffened by a part of the sum of the weights: there the fit remains a linear one.
void find_curvature(FitArguments& g, Vec3 const& mean, Inverse const& inverse) {
  FitKernels const& kernels = fit_kernels();
  kernels.third(g);
  for (std::size_t i = 0; i < g.constant.size(); ++i) {
    g.linear[i] = inverse.times(Vec3(g.third[i]) - g.second[i] * mean);
    g.constant[i] = g.second[i] / g.sum - dot(g.linear[i], mean);
  }
  kernels.fourth(g);
  using Six = Eigen::Map<Eigen::Matrix<double, 6, 1>>;
  Eigen::Matrix<double, 6, 6> moments = Eigen::Map<Eigen::Matrix<double, 6, 6>>(g.fourth[0].data());
  moments.diagonal().array() += stiffness * g.sum;
  Six(g.curvature.data()) = -moments.llt().solve(Six(g.constant.data()));
}

/// Whether the fit may leave the donors' range in a field. Plastic strain, which only grows, never does.
bool is_free(std::size_t f, bool quadratic) noexcept {
  return (f >= 1 && f <= 3) || (quadratic && f != solid_field_of::ep);
}

bool any_crushed(FitArguments const& g) noexcept {
  return std::any_of(g.near, g.near + g.count, [&](int i) { return g.q[i][solid_field_of::ep] > crushed; });
}

}  // namespace

template <class Fields>
void Donors<Fields>::update([[maybe_unused]] int threads) {
  if constexpr (!of_gas) return;
  energy_.resize(states_.size());
#pragma omp parallel for num_threads(threads) schedule(static)
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (kinds_.valid(i)) energy_[i] = energy_of(law_, states_[i]);
  }
}

template <class Fields>
void Donors<Fields>::set_cloud(std::vector<CloudPoint<Fields>> const& points, bool dense) {
  block_ = kinds_.near(cells_around);
  auto const cell = [&](CloudPoint<Fields> const& p) {
    Int3 c = kinds_.cell_of(p.x);
    for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(c[a], block_.first[a], block_.last[a]);
    return in_block(c);
  };
  std::size_t const cells = block_.count();
  first_.assign(cells + 1, 0);
  for (auto const& p : points) ++first_[cell(p) + 1];
  for (std::size_t i = 0; i < cells; ++i) first_[i + 1] += first_[i];
  std::vector<std::size_t> next = first_;
  cloud_.resize(points.size());
  for (auto const& p : points) cloud_[next[cell(p)]++] = p;
  if constexpr (of_gas) {
    if (dense) merge_cloud();
    cloud_energy_.resize(cloud_.size());
    for (std::size_t n = 0; n < cloud_.size(); ++n) cloud_energy_[n] = energy_of(law_, cloud_[n].q);
  }
  list_by_cells();
}

template <class Fields>
void Donors<Fields>::list_by_cells() {
  constexpr auto valid = static_cast<std::size_t>(From::valid), own = static_cast<std::size_t>(From::own_update);
  std::size_t const cells = kinds_.count(), most = cells + cloud_.size() + fit_padding;
  for (auto* list : {&x_[valid], &x_[own], &y_, &z_}) list->resize(most);
  row_.resize(most), start_.resize(cells + 1);
  if constexpr (of_gas) energy_at_.resize(most), energy_.resize(cells);
  Int3 const size = kinds_.box().size;
  std::size_t n = 0, i = 0;
  auto const add = [&](Vec3 const& x, bool given, bool updated, Fields const& q, auto const& energy, std::size_t at) {
    x_[valid][n] = given ? x[0] : far_away, x_[own][n] = updated ? x[0] : far_away, y_[n] = x[1], z_[n] = x[2];
    row_[n] = q.data();
    if constexpr (of_gas) energy_at_[n] = &energy[at];
    ++n;
  };
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int c = 0; c < size[0]; ++c, ++i) {
        start_[i] = n;
        bool const given = gives(i, From::valid), updated = gives(i, From::own_update);
        if (given || updated) add({c + 0.5, j + 0.5, k + 0.5}, given, updated, states_[i], energy_, i);
        auto const [first, last] = in_row(c, c, j, k);
        for (std::size_t p = first; p < last; ++p)
          add(in_cells(cloud_[p].x), true, true, cloud_[p].q, cloud_energy_, p);
      }
    }
  }
  start_[cells] = n;
}

template <class Fields>
void Donors<Fields>::merge_cloud() requires of_gas {
  WindowBox const& box = kinds_.box();
  struct Mean {
    CloudPoint<Fields> first{};
    Vec3 x{0, 0, 0};
    GasDensities q{};
    int count = 0;
  };
  std::size_t kept = 0, from = 0;
  for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) {
    std::size_t const to = first_[cell + 1];
    std::array<Mean, 8> octants{};
    for (std::size_t n = std::exchange(from, to); n < to; ++n) {
      CloudPoint<Fields> const& p = cloud_[n];
      std::size_t octant = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        double const at = (p.x[a] - box.lower[a]) / box.h;
        octant |= static_cast<std::size_t>(at - std::floor(at) >= 0.5) << a;
      }
      Mean& mean = octants[octant];
      if (mean.count++ == 0) mean.first = p;
      GasDensities const q = densities_of(law_, p.q);
      mean.x = mean.x + p.x, mean.q.mass += q.mass, mean.q.energy += q.energy;
      for (std::size_t d = 0; d < 3; ++d) mean.q.momentum[d] += q.momentum[d];
    }
    first_[cell] = kept;
    for (Mean& mean : octants) {
      if (mean.count == 0) continue;
      cloud_[kept] = mean.first;
      if (mean.count > 1) {
        double const share = 1.0 / mean.count;
        mean.q.mass *= share, mean.q.energy *= share;
        for (double& p : mean.q.momentum) p *= share;
        cloud_[kept].x = share * mean.x, cloud_[kept].q = fields_of(law_, mean.q);
      }
      ++kept;
    }
  }
  first_.back() = kept;
  cloud_.resize(kept);
}

template <class Fields>
bool Donors<Fields>::multilinear(Vec3 const& x, From from, Fields& out) const {
  WindowBox const& box = kinds_.box();
  Int3 cell{};
  Vec3 part = in_cells(x);
  for (std::size_t a = 0; a < 3; ++a) {
    double const at = part[a] - 0.5;
    cell[a] = static_cast<int>(std::floor(at)), part[a] = at - cell[a];
    if (cell[a] < 0 || cell[a] + 1 >= box.size[a]) return false;
  }
  std::array<std::size_t, 8> corner{};
  for (std::size_t c = 0; c < 8; ++c) {
    corner[c] = static_cast<std::size_t>(
        kinds_.index({cell[0] + static_cast<int>(c & 1), cell[1] + static_cast<int>(c >> 1 & 1),
                      cell[2] + static_cast<int>(c >> 2)}));
    if (!gives(corner[c], from)) return false;
  }
  EightArguments g{.q = {}, .w = {}, .out = out.data()};
  for (std::size_t c = 0; c < 8; ++c) {
    g.w[c] = ((c & 1) != 0 ? part[0] : 1 - part[0]) * ((c & 2) != 0 ? part[1] : 1 - part[1]) *
             ((c & 4) != 0 ? part[2] : 1 - part[2]);
    g.q[c] = states_[corner[c]].data();
  }
  double rho = 0, energy = 0, low = 1e300, high = -1e300;
  if constexpr (of_gas) {
    // the shares of the mass
    for (std::size_t c = 0; c < 8; ++c) {
      Fields const& q = states_[corner[c]];
      g.w[c] *= q[gas_field::rho], rho += g.w[c];
      low = std::min(low, q[gas_field::p]), high = std::max(high, q[gas_field::p]);
    }
    for (std::size_t c = 0; c < 8; ++c) g.w[c] /= rho, energy += g.w[c] * energy_[corner[c]];
  }
  fit_kernels().multilinear[table<Fields>](g);
  if constexpr (of_gas) {
    auto const [least, most] = std::minmax_element(corner.begin(), corner.end(), [&](std::size_t a, std::size_t b) {
      return states_[a][gas_field::rho] < states_[b][gas_field::rho];
    });
    out[gas_field::rho] = std::clamp(rho, states_[*least][gas_field::rho], states_[*most][gas_field::rho]);
    out[gas_field::p] = std::clamp(pressure_of(law_, out, energy), low, high);
  }
  return true;
}

template <class Fields>
void Donors<Fields>::Gathered::take(Donors const& donors, From from, Vec3 const& middle, Frame const& frame,
                                    double half, double radius) {
  Int3 const size = donors.kinds_.box().size;
  Int3 low{}, high{};
  Vec3 far{};
  for (std::size_t a = 0; a < 3; ++a) {
    far[a] = half * (std::fabs(frame.n[a]) + std::fabs(frame.a[a]) + std::fabs(frame.b[a])) + radius;
    low[a] = std::max(0, static_cast<int>(std::floor(middle[a] - far[a])));
    high[a] = std::min(size[a] - 1, static_cast<int>(std::floor(middle[a] + far[a])));
  }
  count_ = 0, ranges_.clear(), ends_.clear();
  first_j_ = low[1], last_j_ = high[1], first_k_ = low[2], last_k_ = high[2];
  std::size_t most = fit_padding;
  double const ball = half * std::sqrt(3.0) + radius;
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      // the part of the row of cells that is within both the box and the ball around all that is wanted
      auto const beside = [&](double x) { return std::max(0.0, std::fabs(x) - 0.5); };
      double const y = beside(j + 0.5 - middle[1]), z = beside(k + 0.5 - middle[2]);
      double const along = std::min(far[0], std::sqrt(std::max(0.0, ball * ball - y * y - z * z)));
      int const first = std::max(low[0], static_cast<int>(middle[0] - along));
      int const last = std::min(high[0], static_cast<int>(middle[0] + along));
      DonorRange range;
      if (first <= last) {
        std::size_t const row = static_cast<std::size_t>(donors.kinds_.index({0, j, k}));
        range = {donors.start_[row + static_cast<std::size_t>(first)],
                 donors.start_[row + static_cast<std::size_t>(last) + 1]};
      }
      ranges_.push_back(range), most += range.last - range.first;
    }
  }
  if (ranges_.empty()) return;
  auto const& x = donors.x_[static_cast<std::size_t>(from)];
  if (near_.size() < most) {
    for (auto* one : {&x_, &y_, &z_, &energy_, &weight_, &rx_, &ry_, &rz_}) one->resize(most);
    if constexpr (!of_gas) bend_.resize(6 * most);  // products xx .. yz
    near_.resize(most), row_.resize(most);
  }
  ends_.resize(ranges_.size());
  NearCubeArguments g{.ranges = ranges_.size(),
                      .range = ranges_.data(),
                      .x = x.data(),
                      .y = donors.y_.data(),
                      .z = donors.z_.data(),
                      .middle = middle,
                      .axes = {frame.n, frame.a, frame.b},
                      .half = half,
                      .limit = radius * radius,
                      .kept = near_.data(),
                      .ends = ends_.data()};
  fit_kernels().near_cube(g);
  count_ = ends_.back();
  for (std::size_t n = 0; n < count_; ++n) {
    std::size_t const i = static_cast<std::size_t>(near_[n]);
    x_[n] = x[i], y_[n] = donors.y_[i], z_[n] = donors.z_[i], row_[n] = donors.row_[i];
    if constexpr (of_gas) energy_[n] = *donors.energy_at_[i];
  }
}

template <class Fields>
void Donors<Fields>::Gathered::fit(Vec3 const& x, Kind const& kind, Fields& out) {
  DonorRange const all{0, count_};
  fit(std::span(&all, 1), x, everything, 1, kind, out);
}

template <class Fields>
bool Donors<Fields>::Gathered::fit(Vec3 const& x, double radius, std::size_t few, Kind const& kind, Fields& out) {
  // rows of cells beside each other follow each other
  auto const cell = [&](std::size_t a, double by) { return static_cast<int>(std::floor(x[a] + by)); };
  int const j0 = std::max(first_j_, cell(1, -radius)), j1 = std::min(last_j_, cell(1, radius));
  int const k0 = std::max(first_k_, cell(2, -radius)), k1 = std::min(last_k_, cell(2, radius));
  ranges_.clear();
  for (int k = k0; k <= k1 && j0 <= j1; ++k) {
    int const row = (last_j_ - first_j_ + 1) * (k - first_k_) - first_j_;
    auto const end = [&](int j) { return row + j < 0 ? 0 : ends_[static_cast<std::size_t>(row + j)]; };
    ranges_.push_back({end(j0 - 1), end(j1)});
  }
  return fit(ranges_, x, radius, few, kind, out);
}

template <class Fields>
bool Donors<Fields>::Gathered::fit(std::span<DonorRange const> ranges, Vec3 const& x, double radius, std::size_t few,
                                   Kind const& kind, Fields& out) {
  Fields low, high, value;
  FitArguments g{.ranges = ranges.size(),
                 .range = ranges.data(),
                 .x = x_.data(),
                 .y = y_.data(),
                 .z = z_.data(),
                 .q = row_.data(),
                 .energy = energy_.data(),
                 .at = x,
                 .limit = radius * radius,
                 .near = near_.data(),
                 .weight = weight_.data(),
                 .rx = rx_.data(),
                 .ry = ry_.data(),
                 .rz = rz_.data(),
                 .out = value.data(),
                 .low = low.data(),
                 .high = high.data()};
  FitKernels const& kernels = fit_kernels();
  kernels.moments(g);
  if (g.count < few) return false;
  // moments about the donors' mean
  Vec3 const m = (1 / g.sum) * g.first;
  std::array<double, 6> c = g.second;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) c[tensor_place[i][j]] -= g.sum * m[i] * m[j];
  }
  Inverse const inverse(c, least_moment * g.sum);
  g.slope = -1.0 * inverse.times(m);
  g.level = 1 / g.sum - dot(g.slope, m);
  bool const quadratic = kind.quadratic && !any_crushed(g);
  if (quadratic) {
    for (std::size_t i = 0; i < g.bend.size(); ++i) g.bend[i] = bend_.data() + i * weight_.size();
    find_curvature(g, m, inverse);
    kernels.combine_quadratic(g);
  } else {
    kernels.combine[table<Fields>](g);
  }
  double energy = 0;
  if constexpr (of_gas) {
    double const rho = std::clamp(g.mass, low[gas_field::rho], high[gas_field::rho]);
    for (double& one : value) one /= rho;
    value[gas_field::rho] = rho, energy = g.mean_energy / rho;
  }
  for (std::size_t f = 0; f < out.size(); ++f) {
    double const beyond = is_free(f, quadratic) ? kind.excess * (high[f] - low[f]) : 0.0;
    out[f] = std::clamp(value[f], low[f] - beyond, high[f] + beyond);
  }
  if constexpr (of_gas) {
    out[gas_field::p] = std::clamp(pressure_of(kind.law, out, energy), low[gas_field::p], high[gas_field::p]);
  }
  return true;
}

template <class Fields>
Fields Donors<Fields>::at(Vec3 const& x, From from, Fields const& otherwise, bool curved) const {
  Fields out{};
  if (!curved && multilinear(x, from, out)) return out;
  thread_local Gathered donors;
  Vec3 const place = in_cells(x);
  double radius = reach;
  for (int tries = 0; tries < 4; ++tries, radius *= widen) {
    donors.take(*this, from, place, {}, 0, radius);
    if (donors.size() >= fewest) break;
  }
  if (donors.size() == 0) return otherwise;
  donors.fit(place, kind(curved), out);
  return out;
}

template <class Fields>
void Donors<Fields>::Around::reset(Vec3 const& centre, Frame const& frame) {
  constexpr double half = 1 + 1e-9;
  near_.take(donors_, From::valid, donors_.in_cells(centre), frame, half, reach);
}

template <class Fields>
Fields Donors<Fields>::Around::at(Vec3 const& x, Fields const& otherwise, bool inner) {
  Fields out{};
  bool const curved = !of_gas && (inner || donors_.curved(x));
  if (!curved && donors_.multilinear(x, From::valid, out)) return out;
  bool const enough = near_.fit(donors_.in_cells(x), reach, fewest, donors_.kind(curved), out);
  return enough ? out : donors_.at(x, From::valid, otherwise);
}

template class Donors<GasFields>;
template class Donors<SolidFields>;

}  // namespace g27
