#include "verification/exact/von_neumann.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "verification/exact/numerics.hpp"

namespace g27 {

namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using Real = Eigen::MatrixXd;

/// Value on the face at the right of cell 0 of a mode exp(i k x/h), for a family that sweeps nu cells in the step.
Complex face_value(ModelPredictor predictor, double nu, double k) {
  auto const cell = [&](int m) { return std::exp(Complex(0, k * m)); };
  switch (predictor) {
    case ModelPredictor::first_order:
      return nu >= 0 ? cell(0) : cell(1);
    case ModelPredictor::linear:
      return 0.5 * (1.0 + nu) * cell(0) + 0.5 * (1.0 - nu) * cell(1);
    case ModelPredictor::parabolic: {
      // slope over the swept interval of the upwind cell's parabola: B + (s + 1)/3 (D - B), half differences
      double const s = std::fabs(nu);
      Complex const B = 0.5 * (cell(1) - cell(0));
      Complex const D = nu >= 0 ? 0.5 * (cell(0) - cell(-1)) : 0.5 * (cell(2) - cell(1));
      Complex const lin = B + (s + 1.0) / 3.0 * (D - B);
      return nu >= 0 ? cell(0) + (1.0 - s) * lin : cell(1) - (1.0 - s) * lin;
    }
  }
  return 0;
}

Matrix amplification(StabilityModel const& m, std::vector<ModelAxis> const& axes, double r,
                     std::vector<double> const& k) {
  int const d = m.dimensions, n = static_cast<int>(axes[0].flux.rows());
  Matrix G = Matrix::Identity(n, n);
  for (int a = 0; a < d; ++a) {
    // transverse half-step term of a cell: -(dt/2) sum of A_b d/db, central
    Matrix T = Matrix::Zero(n, n);
    for (int b = 0; b < d && m.transverse != ModelTransverse::none; ++b) {
      if (b != a)
        T -= (0.5 * r * Complex(0, std::sin(k[static_cast<std::size_t>(b)]))) * axes[static_cast<std::size_t>(b)].flux;
    }
    double const ka = k[static_cast<std::size_t>(a)];
    Complex const here(1, 0), next = std::exp(Complex(0, ka));
    Matrix face = Matrix::Zero(n, n);
    for (auto const& [speed, projector] : axes[static_cast<std::size_t>(a)].families) {
      Complex carried = speed > 0 ? here : speed < 0 ? next : 0.5 * (here + next);
      if (m.transverse == ModelTransverse::averaged) carried = 0.5 * (here + next);
      face += projector * (face_value(m.predictor, speed * r, ka) * Matrix::Identity(n, n) + carried * T);
    }
    G -= r * (1.0 - std::exp(Complex(0, -ka))) * (axes[static_cast<std::size_t>(a)].flux * face);
  }
  return G;
}

}  // namespace

/// Fields p, u_1 .. u_d, S.
ModelAxis gas_axis(int dimensions, int axis, double u) {
  int const n = dimensions + 2;
  ModelAxis out{Real::Identity(n, n) * u, {}};
  out.flux(0, 1 + axis) = out.flux(1 + axis, 0) = 1.0;
  Real fast = Real::Zero(n, n), slow = Real::Zero(n, n);
  for (int i : {0, 1 + axis}) {
    for (int j : {0, 1 + axis}) {
      fast(i, j) = 0.5;
      slow(i, j) = i == j ? 0.5 : -0.5;
    }
  }
  Real const rest = Real::Identity(n, n) - fast - slow;
  out.families = {{u + 1.0, fast}, {u - 1.0, slow}, {u, rest}};
  return out;
}

/// Fields u, p, S; density and energy follow them. With the rates R of (p, S) that u_,a causes and the traction T that
/// (p, S) is, u_t = T (p, S)_,a and (p, S)_t = R u_,a: speeds c^2 are the values of T R, a family is (r, -R r/c) and
/// (l, -l T/c)/2, l and r its left and right vectors.
ModelAxis solid_axis(SolidMaterial const& material, SolidPoint const& s, int axis) {
  std::size_t const a = static_cast<std::size_t>(axis);
  double const M = bulk_modulus(material.law, s.rho, s.p) + 4.0 / 3 * material.mu, c = std::sqrt(M / s.rho);
  Real R(7, 3), T = Real::Zero(3, 7);
  for (std::size_t k = 0; k < 3; ++k) {
    double L[3][3] = {};
    L[k][a] = 1;
    SolidPoint const rate = elastic_rate(material, s, L);
    R(0, static_cast<int>(k)) = rate.p / M;
    for (std::size_t q = 0; q < 6; ++q) R(1 + static_cast<int>(q), static_cast<int>(k)) = rate.S[q] / M;
    T(static_cast<int>(k), 1 + static_cast<int>(tensor_place[k][a])) = 1;
  }
  T(axis, 0) = -1;
  Eigen::EigenSolver<Real> const solver(Real(T * R));
  Real const right = solver.eigenvectors().real(), left = right.inverse();
  double const u = s.u[a] / c;
  ModelAxis out{Real::Identity(10, 10) * u, {}};
  out.flux.topRightCorner(3, 7) -= T, out.flux.bottomLeftCorner(7, 3) -= R;
  Real rest = Real::Identity(10, 10);
  for (int k = 0; k < 3; ++k) {
    std::complex<double> const square = solver.eigenvalues()(k);
    if (!(square.real() > 0) || square.imag() != 0) throw NumericsError("a wave of the solid without a real speed");
    for (double speed : {std::sqrt(square.real()), -std::sqrt(square.real())}) {
      Eigen::VectorXd r(10), l(10);
      r << right.col(k), -R * right.col(k) / speed;
      l << left.row(k).transpose(), -(left.row(k) * T).transpose() / speed;
      out.families.emplace_back(u + speed, 0.5 * r * l.transpose());
      rest -= out.families.back().second;
    }
  }
  out.families.emplace_back(u, rest);
  return out;
}

double spectral_radius(StabilityModel const& m, std::vector<ModelAxis> const& axes, double r, int waves) {
  double most = 0;
  std::vector<double> k(static_cast<std::size_t>(m.dimensions));
  // a mode and its conjugate grow alike: the last wave number may keep its sign
  int const span = 2 * waves;
  int const others = m.dimensions == 3 ? span : 1;
  for (int i = 0; i < span; ++i) {
    for (int j = 0; j < others; ++j) {
      for (int l = 0; l <= waves; ++l) {
        k[0] = std::numbers::pi * (i - waves) / waves;
        if (m.dimensions == 3) k[1] = std::numbers::pi * (j - waves) / waves;
        k.back() = std::numbers::pi * l / waves;
        Matrix const G = amplification(m, axes, r, k);
        Eigen::ComplexEigenSolver<Matrix> const solver(G, false);
        most = std::max(most, solver.eigenvalues().cwiseAbs().maxCoeff());
      }
    }
  }
  return most;
}

double spectral_radius(StabilityModel const& m, double cfl, double mach, std::array<double, 3> const& direction,
                       int waves) {
  double length = 0;
  for (int a = 0; a < m.dimensions; ++a) length = std::hypot(length, direction[static_cast<std::size_t>(a)]);
  std::vector<ModelAxis> axes;
  double sum = 0, largest = 0;
  for (int a = 0; a < m.dimensions; ++a) {
    double const u = mach * direction[static_cast<std::size_t>(a)] / length;
    axes.push_back(gas_axis(m.dimensions, a, u));
    sum += std::fabs(u) + 1.0, largest = std::max(largest, std::fabs(u) + 1.0);
  }
  return spectral_radius(m, axes, cfl / (m.max_rule ? largest : sum), waves);
}

double stability_limit(StabilityModel const& m, double const* machs, int count, double highest, double resolution,
                       int waves) {
  std::vector<std::array<double, 3>> directions{{1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}};
  if (m.dimensions == 3) directions = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0.5, 0.25}};
  auto const stable = [&](double cfl) {
    for (int i = 0; i < count; ++i) {
      for (auto const& d : directions) {
        if (spectral_radius(m, cfl, machs[i], d, waves) > 1.0 + 1e-9) return false;
        if (machs[i] == 0.0) break;
      }
    }
    return true;
  };
  if (stable(highest)) return highest;
  double low = 0, high = highest;
  while (high - low > resolution) {
    double const middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace g27
