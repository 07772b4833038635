#include "fsi/overset/donors.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace g27 {

namespace {

constexpr double reach = 1.6;          ///< radius of the donors, in cells
constexpr double widen = 1.5;          ///< by which it grows when there are too few
constexpr std::size_t fewest = 5;      ///< donors
constexpr double softening = 0.1;      ///< of the weights 1/(r^2 + softening)
constexpr double least_moment = 0.02;  ///< of the sum of the weights, along a direction in which a slope is fitted

/// -C^-1 m of a symmetric matrix C; along eigenvectors whose eigenvalue is below `least` nothing.
Vec3 minus_inverse_times(double const* c, Vec3 const& m, double least) {
  double const xx = c[0], yy = c[1], zz = c[2], xy = c[3], xz = c[4], yz = c[5], trace = xx + yy + zz;
  double const a = yy * zz - yz * yz, b = xz * yz - xy * zz, d = xy * yz - xz * yy;
  double const det = xx * a + xy * b + xz * d;
  // the least eigenvalue is at least 4 det/trace^2
  if (det * 4 > least * trace * trace) {
    double const e = xx * zz - xz * xz, f = xy * xz - xx * yz, g = xx * yy - xy * xy, k = -1 / det;
    return {k * (a * m[0] + b * m[1] + d * m[2]), k * (b * m[0] + e * m[1] + f * m[2]),
            k * (d * m[0] + f * m[1] + g * m[2])};
  }
  Eigen::Matrix3d C;
  C << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(C);
  Eigen::Vector3d const mean(m[0], m[1], m[2]);
  Eigen::Vector3d slope(0, 0, 0);
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] <= least) continue;
    Eigen::Vector3d const v = solver.eigenvectors().col(i);
    slope -= v * (v.dot(mean) / solver.eigenvalues()[i]);
  }
  return {slope[0], slope[1], slope[2]};
}

bool is_velocity(std::size_t f) noexcept { return f >= 1 && f <= 3; }

}  // namespace

template <class Fields>
void Donors<Fields>::set_cloud(std::vector<CloudPoint<Fields>> points) {
  cloud_ = std::move(points);
  head_.assign(kinds_.count(), -1);
  for (std::size_t n = 0; n < cloud_.size(); ++n) {
    int& head = head_[static_cast<std::size_t>(kinds_.index(kinds_.cell_of(cloud_[n].x)))];
    cloud_[n].next = head, head = static_cast<int>(n);
  }
}

template <class Fields>
void Donors<Fields>::gather(Vec3 const& x, double radius, From from, std::vector<Donor>& out) const {
  out.clear();
  WindowBox const& box = kinds_.box();
  double const inverse = 1 / box.h, limit = radius * radius;
  Int3 low{}, high{};
  Vec3 at{};  // in cells of the window
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = (x[a] - box.lower[a]) * inverse - box.first[a];
    low[a] = std::max(0, static_cast<int>(std::floor(at[a] - radius)));
    high[a] = std::min(box.size[a] - 1, static_cast<int>(std::floor(at[a] + radius)));
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      std::ptrdiff_t i = kinds_.index({low[0], j, k});
      for (int c = low[0]; c <= high[0]; ++c, ++i) {
        std::size_t const n = static_cast<std::size_t>(i);
        if (gives(n, from)) {
          Vec3 const r{c + 0.5 - at[0], j + 0.5 - at[1], k + 0.5 - at[2]};
          if (dot(r, r) < limit) out.push_back({r, &states_[n]});
        }
        for (int p = head_.empty() ? -1 : head_[n]; p >= 0; p = cloud_[static_cast<std::size_t>(p)].next) {
          CloudPoint<Fields> const& point = cloud_[static_cast<std::size_t>(p)];
          Vec3 const r = inverse * (point.x - x);
          if (dot(r, r) < limit) out.push_back({r, &point.q});
        }
      }
    }
  }
}

template <class Fields>
void Donors<Fields>::bound(Fields& q, Fields const& low, Fields const& high) noexcept {
  for (std::size_t f = 0; f < q.size(); ++f) {
    double const more = is_velocity(f) ? high[f] - low[f] : 0.0;
    q[f] = std::clamp(q[f], low[f] - more, high[f] + more);
  }
}

template <class Fields>
bool Donors<Fields>::multilinear(Vec3 const& x, From from, Fields& out) const {
  WindowBox const& box = kinds_.box();
  Int3 cell{};
  Vec3 part{};
  for (std::size_t a = 0; a < 3; ++a) {
    double const at = (x[a] - box.lower[a]) / box.h - box.first[a] - 0.5;
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
  out.fill(0);
  Fields low = states_[corner[0]], high = low;
  for (std::size_t c = 0; c < 8; ++c) {
    double const w = ((c & 1) != 0 ? part[0] : 1 - part[0]) * ((c & 2) != 0 ? part[1] : 1 - part[1]) *
                     ((c & 4) != 0 ? part[2] : 1 - part[2]);
    Fields const& q = states_[corner[c]];
    for (std::size_t f = 0; f < q.size(); ++f) {
      out[f] += w * q[f], low[f] = std::min(low[f], q[f]), high[f] = std::max(high[f], q[f]);
    }
  }
  // round-off would not let a uniform state stay uniform
  for (std::size_t f = 0; f < out.size(); ++f) out[f] = std::clamp(out[f], low[f], high[f]);
  return true;
}

template <class Fields>
Fields Donors<Fields>::fit(std::vector<Donor> const& donors) {
  thread_local std::vector<double> weight;
  weight.resize(donors.size());
  // moments of the weights: about the point, then about their mean
  double sum = 0, m[3] = {}, c[6] = {};
  for (std::size_t n = 0; n < donors.size(); ++n) {
    Vec3 const& r = donors[n].r;
    double const w = 1 / (dot(r, r) + softening);
    weight[n] = w, sum += w;
    for (std::size_t i = 0; i < 3; ++i) {
      m[i] += w * r[i];
      for (std::size_t j = i; j < 3; ++j) c[tensor_place[i][j]] += w * r[i] * r[j];
    }
  }
  for (double& x : m) x /= sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) c[tensor_place[i][j]] -= sum * m[i] * m[j];
  }
  Vec3 const slope = minus_inverse_times(c, {m[0], m[1], m[2]}, least_moment * sum);
  Fields out{}, low = *donors[0].q, high = low;
  double total = 0;
  double const level = 1 / sum - slope[0] * m[0] - slope[1] * m[1] - slope[2] * m[2];
  for (std::size_t n = 0; n < donors.size(); ++n) {
    double const share = weight[n] * (level + dot(slope, donors[n].r));
    total += share;
    Fields const& q = *donors[n].q;
    for (std::size_t f = 0; f < q.size(); ++f) {
      out[f] += share * q[f], low[f] = std::min(low[f], q[f]), high[f] = std::max(high[f], q[f]);
    }
  }
  for (double& x : out) x /= total;
  bound(out, low, high);
  return out;
}

template <class Fields>
Fields Donors<Fields>::at(Vec3 const& x, From from, Fields const& otherwise) const {
  Fields out{};
  if (multilinear(x, from, out)) return out;
  thread_local std::vector<Donor> donors;
  double radius = reach;
  for (int tries = 0; tries < 4; ++tries, radius *= widen) {
    gather(x, radius, from, donors);
    if (donors.size() >= fewest) break;
  }
  return donors.empty() ? otherwise : fit(donors);
}

template <class Fields>
void Donors<Fields>::Around::reset(Donors const& donors, Vec3 const& centre, double radius) {
  donors_ = &donors;
  WindowBox const& box = donors.kinds_.box();
  for (std::size_t a = 0; a < 3; ++a) centre_[a] = (centre[a] - box.lower[a]) / box.h - box.first[a];
  thread_local std::vector<Donor> all;
  donors.gather(centre, radius + reach, From::valid, all);
  std::size_t const n = all.size();
  x_.resize(n), y_.resize(n), z_.resize(n), q_.resize(n);
  for (std::size_t i = 0; i < n; ++i) x_[i] = all[i].r[0], y_[i] = all[i].r[1], z_[i] = all[i].r[2], q_[i] = all[i].q;
}

template <class Fields>
Fields Donors<Fields>::Around::at(Vec3 const& x, Fields const& otherwise) const {
  Fields out{};
  if (donors_->multilinear(x, From::valid, out)) return out;
  WindowBox const& box = donors_->kinds_.box();
  Vec3 r{};
  for (std::size_t a = 0; a < 3; ++a) r[a] = (x[a] - box.lower[a]) / box.h - box.first[a] - centre_[a];
  thread_local std::vector<Donor> near;
  thread_local std::vector<double> distance;
  std::size_t const n = x_.size();
  distance.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    double const dx = x_[i] - r[0], dy = y_[i] - r[1], dz = z_[i] - r[2];
    distance[i] = dx * dx + dy * dy + dz * dz;
  }
  near.clear();
  for (std::size_t i = 0; i < n; ++i) {
    if (distance[i] < reach * reach) near.push_back({{x_[i] - r[0], y_[i] - r[1], z_[i] - r[2]}, q_[i]});
  }
  return near.size() >= fewest ? fit(near) : donors_->at(x, From::valid, otherwise);
}

template class Donors<GasFields>;
template class Donors<SolidFields>;

}  // namespace g27
