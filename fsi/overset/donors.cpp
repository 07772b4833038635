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
  double sum = 0;
  Eigen::Vector3d mean(0, 0, 0);
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < donors.size(); ++n) {
    Eigen::Vector3d const r(donors[n].r[0], donors[n].r[1], donors[n].r[2]);
    double const w = 1 / (r.squaredNorm() + softening);
    weight[n] = w, sum += w, mean += w * r, moment += w * r * r.transpose();
  }
  mean /= sum, moment -= sum * mean * mean.transpose();
  // slopes are dropped along directions in which the donors do not reach: by the trace's bound, else by eigenvectors
  double const least = least_moment * sum, trace = moment.trace();
  Eigen::Vector3d slope;
  if (moment.determinant() * 4 > least * trace * trace) {
    slope = -moment.inverse() * mean;
  } else {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(moment);
    slope.setZero();
    for (int e = 0; e < 3; ++e) {
      if (solver.eigenvalues()[e] <= least) continue;
      Eigen::Vector3d const v = solver.eigenvectors().col(e);
      slope -= v * (v.dot(mean) / solver.eigenvalues()[e]);
    }
  }
  Fields out{}, low = *donors[0].q, high = low;
  double total = 0;
  for (std::size_t n = 0; n < donors.size(); ++n) {
    Eigen::Vector3d const r(donors[n].r[0], donors[n].r[1], donors[n].r[2]);
    double const c = weight[n] * (1 / sum + slope.dot(r - mean));
    total += c;
    Fields const& q = *donors[n].q;
    for (std::size_t f = 0; f < q.size(); ++f) {
      out[f] += c * q[f], low[f] = std::min(low[f], q[f]), high[f] = std::max(high[f], q[f]);
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
bool Donors<Fields>::gradient(Vec3 const& x, double radius, std::array<Fields, 3>& out) const {
  thread_local std::vector<Donor> donors;
  gather(x, radius, From::valid, donors);
  if (donors.size() < fewest) return false;
  double sum = 0;
  Eigen::Vector3d mean(0, 0, 0);
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, static_cast<int>(std::tuple_size_v<Fields>), 3> cross_moment;
  Eigen::Matrix<double, static_cast<int>(std::tuple_size_v<Fields>), 1> q_mean;
  cross_moment.setZero(), q_mean.setZero();
  for (Donor const& d : donors) {
    Eigen::Vector3d const r(d.r[0], d.r[1], d.r[2]);
    double const w = 1 / (r.squaredNorm() + 0.3);
    Eigen::Map<Eigen::Matrix<double, static_cast<int>(std::tuple_size_v<Fields>), 1> const> const q(d.q->data());
    sum += w, mean += w * r, moment += w * r * r.transpose(), q_mean += w * q, cross_moment += w * q * r.transpose();
  }
  moment -= mean * mean.transpose() / sum, cross_moment -= q_mean * mean.transpose() / sum;
  double const trace = moment.trace();
  if (!(moment.determinant() > 1e-4 * trace * trace * trace)) return false;
  auto const g = (cross_moment * moment.inverse() / kinds_.box().h).eval();
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t f = 0; f < out[a].size(); ++f) out[a][f] = g(static_cast<int>(f), static_cast<int>(a));
  }
  return true;
}

template class Donors<GasFields>;
template class Donors<SolidFields>;

}  // namespace g27
