#include "verification/exact/plane_wave.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

constexpr int curve_nodes = 256;

struct Along {
  SolidPoint slope;  ///< dU/dw
  Vector3 direction;
  double c;
};

/// The family's direction nearest to `last`, or, without one, that of the given rank.
Along along(SolidMaterial const& material, SolidPoint const& s, Vector3 const& n, int family, Vector3 const* last,
            bool plastic) {
  auto const rate = [&](double const(&L)[3][3]) {
    return plastic ? plastic_rate(material, s, L) : elastic_rate(material, s, L);
  };
  Eigen::Matrix3d M;
  for (std::size_t k = 0; k < 3; ++k) {
    double L[3][3] = {};
    for (std::size_t j = 0; j < 3; ++j) L[k][j] = n[j];
    SolidPoint const r = rate(L);
    for (std::size_t i = 0; i < 3; ++i) {
      double traction = 0;
      for (std::size_t j = 0; j < 3; ++j) traction += r.stress(i, j) * n[j];
      M(static_cast<int>(i), static_cast<int>(k)) = traction;
    }
  }
  Eigen::EigenSolver<Eigen::Matrix3d> const solver(M);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return solver.eigenvalues()(a).real() > solver.eigenvalues()(b).real(); });
  int chosen = order[static_cast<std::size_t>(family)];
  if (last) {
    auto const overlap = [&](int k) {
      Eigen::Vector3d const r = solver.eigenvectors().col(k).real().normalized();
      return std::fabs(r(0) * (*last)[0] + r(1) * (*last)[1] + r(2) * (*last)[2]);
    };
    chosen = *std::max_element(order.begin(), order.end(), [&](int a, int b) { return overlap(a) < overlap(b); });
  }
  double const stiffness = solver.eigenvalues()(chosen).real();
  if (!(stiffness > 0) || solver.eigenvalues()(chosen).imag() != 0)
    throw NumericsError("a plane wave without a real speed");
  Eigen::Vector3d r = solver.eigenvectors().col(chosen).real().normalized();
  Eigen::Vector3d const before =
      last ? Eigen::Vector3d((*last)[0], (*last)[1], (*last)[2]) : Eigen::Vector3d(n[0], n[1], n[2]);
  if (r.dot(before) < 0) r = -r;
  Along out{.slope = {}, .direction = {r(0), r(1), r(2)}, .c = std::sqrt(stiffness / s.rho)};
  double L[3][3];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) L[i][j] = -out.direction[i] * n[j] / out.c;
  out.slope = rate(L);
  out.slope.u = out.direction;
  return out;
}

SolidPoint moved(SolidPoint const& s, SolidPoint const& slope, double dw) {
  SolidPoint out = s;
  out.rho += dw * slope.rho, out.p += dw * slope.p, out.e += dw * slope.e, out.ep += dw * slope.ep;
  for (std::size_t i = 0; i < 3; ++i) out.u[i] += dw * slope.u[i];
  for (std::size_t c = 0; c < 6; ++c) out.S[c] += dw * slope.S[c];
  return out;
}

double along_normal(SolidPoint const& s, Vector3 const& n) { return s.u[0] * n[0] + s.u[1] * n[1] + s.u[2] * n[2]; }

std::array<double, 14> row_of(SolidPoint const& s, double speed) {
  return {s.rho, s.u[0], s.u[1], s.u[2], s.p, s.e, s.S[0], s.S[1], s.S[2], s.S[3], s.S[4], s.S[5], s.ep, speed};
}

}  // namespace

SolidPoint plastic_rate(SolidMaterial const& material, SolidPoint const& s, double const (&L)[3][3]) {
  SolidPoint out = elastic_rate(material, s, L);
  double power = 0, q_squared = 0;  // S:D, (3/2) S:S
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double const S = s.S[tensor_place[i][j]];
      power += S * L[i][j], q_squared += 1.5 * S * S;
    }
  }
  double const mu3 = 3 * material.mu, flow = mu3 * power / (mu3 + material.hardening);
  for (std::size_t c = 0; c < 6; ++c) out.S[c] -= s.S[c] * mu3 * flow / q_squared;
  out.ep = flow / std::sqrt(q_squared);
  return out;
}

PlaneWave::PlaneWave(SolidMaterial const& material, SolidPoint const& ahead, Vector3 const& n, int family, double low,
                     double high, std::function<double(double s)> profile, bool plastic)
    : n_(n), low_(low), high_(high), step_((high - low) / curve_nodes), profile_(std::move(profile)) {
  Along const start = along(material, ahead, n, family, nullptr, plastic);
  celerity_ = start.c;
  auto const slope = [&](SolidPoint const& s, Vector3 const& last) {
    return along(material, s, n, family, &last, plastic);
  };
  struct Node {
    SolidPoint s;
    Along a;
  };
  auto const next = [&](Node const& from, double h) -> Node {  // Runge-Kutta, fourth order
    Along const& k1 = from.a;
    Along const k2 = slope(moved(from.s, k1.slope, h / 2), k1.direction);
    Along const k3 = slope(moved(from.s, k2.slope, h / 2), k2.direction);
    Along const k4 = slope(moved(from.s, k3.slope, h), k3.direction);
    SolidPoint s = moved(from.s, k1.slope, h / 6);
    s = moved(moved(moved(s, k2.slope, h / 3), k3.slope, h / 3), k4.slope, h / 6);
    return {s, slope(s, k4.direction)};
  };
  Node node{ahead, start};
  if (low != 0) {
    int const parts = curve_nodes;
    for (int i = 0; i < parts; ++i) node = next(node, low / parts);
  }
  for (int i = 0; i <= curve_nodes; ++i) {
    nodes_.push_back(row_of(node.s, along_normal(node.s, n) + node.a.c));
    slopes_.push_back(row_of(node.a.slope, 0));
    if (i < curve_nodes) node = next(node, step_);
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {  // slopes of the speed: differences of fourth order
    auto const v = [&](std::size_t k) { return nodes_[k][13]; };
    std::size_t const m = nodes_.size() - 1, k = std::clamp(i, std::size_t{2}, m - 2);
    double const a = v(k - 2), b = v(k - 1), c = v(k), d = v(k + 1), e = v(k + 2);
    int const place = static_cast<int>(i) - static_cast<int>(k);
    double const by12 = place == 0    ? a - 8 * b + 8 * d - e
                        : place == -1 ? -3 * a - 10 * b + 18 * c - 6 * d + e
                        : place == 1  ? 3 * e + 10 * d - 18 * c + 6 * b - a
                        : place == -2 ? -25 * a + 48 * b - 36 * c + 16 * d - 3 * e
                                      : 25 * e - 48 * d + 36 * c - 16 * b + 3 * a;
    slopes_[i][13] = by12 / (12 * step_);
  }
  slowest_ = fastest_ = nodes_[0][13];
  for (Row const& r : nodes_) slowest_ = std::min(slowest_, r[13]), fastest_ = std::max(fastest_, r[13]);
}

PlaneWave::Row PlaneWave::row(double w) const {
  double const place = (std::clamp(w, low_, high_) - low_) / step_;
  std::size_t const i = std::min(static_cast<std::size_t>(place), nodes_.size() - 2);
  Row out;
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = hermite(place - static_cast<double>(i), step_, nodes_[i][k], slopes_[i][k], nodes_[i + 1][k],
                     slopes_[i + 1][k]);
  }
  return out;
}

double PlaneWave::speed(double w) const { return row(w)[13]; }

SolidPoint PlaneWave::state(double w) const {
  Row const r = row(w);
  return {.rho = r[0],
          .u = {r[1], r[2], r[3]},
          .p = r[4],
          .e = r[5],
          .S = {r[6], r[7], r[8], r[9], r[10], r[11]},
          .ep = r[12]};
}

double PlaneWave::at(double s, double t) const {
  if (t == 0) return profile_(s);
  double const margin = 0.1 * (fastest_ - slowest_) + 1e-9 * std::fabs(fastest_);
  auto const gap = [&](double from) { return from + speed(profile_(from)) * t - s; };
  return profile_(find_root(gap, s - (fastest_ + margin) * t, s - (slowest_ - margin) * t));
}

SolidPoint PlaneWave::state_at(Vector3 const& x, double t) const {
  return state(at(x[0] * n_[0] + x[1] * n_[1] + x[2] * n_[2], t));
}

PlaneWaveAt::PlaneWaveAt(PlaneWave const& wave, double s0, double s1, double t, int nodes)
    : s0_(s0), step_((s1 - s0) / (nodes - 1)) {
  for (int i = -2; i < nodes + 2; ++i) w_.push_back(wave.at(s0 + i * step_, t));
}

double PlaneWaveAt::operator()(double s) const {
  double const place = (s - s0_) / step_;
  std::size_t const i = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(w_.size() - 6))) + 2;
  auto const slope = [&](std::size_t k) {
    return (8 * (w_[k + 1] - w_[k - 1]) - (w_[k + 2] - w_[k - 2])) / (12 * step_);
  };
  return hermite(place + 2 - static_cast<double>(i), step_, w_[i], slope(i), w_[i + 1], slope(i + 1));
}

}  // namespace g27
