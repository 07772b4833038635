#include "verification/exact/von_neumann.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace g27 {

namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using Real = Eigen::MatrixXd;

/// Fields p, u_1 .. u_d, S; c = 1. The matrix of the flux along axis a and the projectors of its families.
struct Axis {
  Real flux;
  std::vector<std::pair<double, Real>> families;  ///< speed, projector
};

Axis axis_of(int d, int a, double u) {
  int const n = d + 2;
  Axis out{Real::Identity(n, n) * u, {}};
  out.flux(0, 1 + a) = out.flux(1 + a, 0) = 1.0;
  Real fast = Real::Zero(n, n), slow = Real::Zero(n, n);
  for (int i : {0, 1 + a}) {
    for (int j : {0, 1 + a}) {
      fast(i, j) = 0.5;
      slow(i, j) = i == j ? 0.5 : -0.5;
    }
  }
  Real const rest = Real::Identity(n, n) - fast - slow;
  out.families = {{u + 1.0, fast}, {u - 1.0, slow}, {u, rest}};
  return out;
}

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

Matrix amplification(StabilityModel const& m, std::vector<Axis> const& axes, double r, std::vector<double> const& k) {
  int const d = m.dimensions, n = d + 2;
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

double spectral_radius(StabilityModel const& m, double cfl, double mach, std::array<double, 3> const& direction,
                       int waves) {
  double length = 0;
  for (int a = 0; a < m.dimensions; ++a) length = std::hypot(length, direction[static_cast<std::size_t>(a)]);
  std::vector<Axis> axes;
  double sum = 0, largest = 0;
  for (int a = 0; a < m.dimensions; ++a) {
    double const u = mach * direction[static_cast<std::size_t>(a)] / length;
    axes.push_back(axis_of(m.dimensions, a, u));
    sum += std::fabs(u) + 1.0, largest = std::max(largest, std::fabs(u) + 1.0);
  }
  double const r = cfl / (m.max_rule ? largest : sum);
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
