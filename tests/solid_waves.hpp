#pragma once
/// Plane waves of infinitesimal amplitude in a uniformly pre-stressed, moving solid, from a dense eigenvalue problem:
/// nothing here comes from riemann/solid.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "scheme/step/solid_grid.hpp"

namespace g27_test {

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

inline Matrix tensor(g27::Sym3 const& S) {
  Matrix m;
  m << S[0], S[3], S[4], S[3], S[1], S[5], S[4], S[5], S[2];
  return m;
}
inline g27::Sym3 components(Matrix const& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)}; }

/// s_t = M u_x of the frame whose axis 1 is x: the traction's rate from the definitions of the Jaumann rate and of p.
inline Matrix acoustic_matrix(Matrix const& S, double K, double f, double mu) {
  Matrix M;
  for (int k = 0; k < 3; ++k) {
    Matrix G = Matrix::Zero();
    G(k, 0) = 1;
    Matrix const D = 0.5 * (G + G.transpose()), W = 0.5 * (G - G.transpose());
    Matrix const rate = 2 * mu * (D - D.trace() / 3 * Matrix::Identity()) + W * S - S * W;
    double const dp = -K * D.trace() + f * (S * D).trace();
    M.col(k) = rate.col(0) - Vector(dp, 0, 0);
  }
  return M;
}

struct PlaneWave {
  g27::AnySolid solid;
  double K, f;  ///< rho c^2 and (1/rho) dp/de of the mean state
  g27::SolidPoint mean;
  Vector n;          ///< direction
  double speed = 0;  ///< relative to the material [m/s]
  Vector u;          ///< velocity of unit amplitude
  Matrix S;          ///< what goes with it
  double rho = 0, p = 0;

  /// family 0: P, 1 and 2: S, by falling speed.
  PlaneWave(g27::AnySolid const& s, g27::SolidPoint const& state, Vector const& direction, int family)
      : solid(s), mean(state), n(direction.normalized()) {
    std::visit([&](auto const& e) { K = e.bulk_modulus(mean.rho, mean.p), f = e.gruneisen(mean.rho); }, solid.eos);
    Vector const other = std::fabs(n(0)) < 0.9 ? Vector::UnitX() : Vector::UnitY();
    Matrix R;  // rows: the frame
    R.row(0) = n, R.row(1) = n.cross(other).normalized(), R.row(2) = n.cross(R.row(1).transpose());
    Matrix const M = acoustic_matrix(R * tensor(mean.S) * R.transpose(), K, f, solid.mu);
    Eigen::EigenSolver<Matrix> const es(M);
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return es.eigenvalues()(a).real() > es.eigenvalues()(b).real(); });
    int const k = order[static_cast<std::size_t>(family)];
    speed = std::sqrt(es.eigenvalues()(k).real() / mean.rho);
    u = (R.transpose() * es.eigenvectors().col(k).real()).normalized();
    // f(n.x - speed t) times u: rates over -speed
    Matrix const G = u * n.transpose(), D = 0.5 * (G + G.transpose()), W = 0.5 * (G - G.transpose());
    Matrix const T = tensor(mean.S);
    Matrix const rate = 2 * solid.mu * (D - D.trace() / 3 * Matrix::Identity()) + W * T - T * W;
    S = -rate / speed;
    rho = mean.rho * D.trace() / speed;
    p = -(-K * D.trace() + f * (T * D).trace()) / speed;
  }

  /// State where the wave has the value v [m/s].
  [[nodiscard]] g27::SolidPoint state(double v) const {
    g27::SolidPoint q = mean;
    q.rho += rho * v, q.p += p * v;
    g27::Sym3 const s = components(S);
    for (std::size_t k = 0; k < 3; ++k) q.u[k] += u(static_cast<int>(k)) * v;
    for (std::size_t k = 0; k < 6; ++k) q.S[k] += s[k] * v;
    return q;
  }
  /// Over the grid [m/s].
  [[nodiscard]] double total_speed() const { return speed + Vector(mean.u[0], mean.u[1], mean.u[2]).dot(n); }
};

using Field = g27::SolidGrid::Field;
inline constexpr std::array<Field, 11> variables{
    Field::density, Field::velocity_x, Field::velocity_y, Field::velocity_z, Field::pressure, Field::sxx,
    Field::syy,     Field::szz,        Field::sxy,        Field::sxz,        Field::syz};

/// Mean over the cells of |a - b|.
inline double distance(std::vector<double> const& a, std::vector<double> const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

inline void run(g27::SolidGrid& g, double t_end) {
  while (g.time() < t_end) {
    if (g.step(t_end).status != g27::StepStatus::ok) throw std::runtime_error("a step failed");
  }
}

inline g27::SolidGridSetup periodic_box(g27::AnySolid const& solid, g27::Int3 const& cells) {
  g27::SolidGridSetup s;
  s.material = solid, s.cells = cells;
  for (g27::SolidBoundary& b : s.sides) b.kind = g27::SolidBoundary::Kind::periodic;
  return s;
}

}  // namespace g27_test
