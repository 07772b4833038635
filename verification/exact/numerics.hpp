#pragma once
/// Roots, quadrature and ordinary differential equations for the exact solutions: GSL and CVODE behind four functions.
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace g27 {

/// Thrown when a root is not bracketed or an integration does not reach its tolerance.
struct NumericsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using ScalarFunction = std::function<double(double)>;

/// Root of f in [lo, hi], to the last bits of the argument. Brent's method (GSL); f must change sign.
double find_root(ScalarFunction const& f, double lo, double hi);

/// y = f(x); both as long as the number of unknowns.
using VectorFunction = std::function<void(double const* x, double* y)>;

/// Root of a system near `start`: Powell's hybrid method (GSL). Nothing where it does not reach |y_i| <= tolerance.
std::optional<std::vector<double>> find_roots(VectorFunction const& f, std::vector<double> const& start,
                                              double tolerance = 1e-12);

/// Integral of f over [a, b] to the relative tolerance; adaptive Gauss-Kronrod (GSL). `scale` is a magnitude below
/// tolerance * scale the integral need not be resolved.
double integrate(ScalarFunction const& f, double a, double b, double tolerance = 1e-13, double scale = 0);

/// dy/dx = f(x, y); `slope` is as long as y.
using OdeSlope = std::function<void(double x, double const* y, double* slope)>;

/// Values y(x) at every node, y(nodes[0]) = start; nodes monotone. CVODE, Adams, functional iteration: for smooth and
/// non-stiff equations. Returns [nodes][components].
std::vector<std::vector<double>> solve_ode(OdeSlope const& f, std::vector<double> start,
                                           std::vector<double> const& nodes, double relative = 1e-13,
                                           double absolute = 1e-14);

/// Cubic Hermite interpolation: value at s in [0, 1] between (y0, slope d0) and (y1, slope d1), h apart.
inline double hermite(double s, double h, double y0, double d0, double y1, double d1) {
  double const r = 1 - s;
  return r * r * (1 + 2 * s) * y0 + s * s * (3 - 2 * s) * y1 + h * s * r * (r * d0 - s * d1);
}

}  // namespace g27
