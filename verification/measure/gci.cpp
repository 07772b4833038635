#include "verification/measure/gci.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace g27 {
namespace {

/// p of (coarse - medium)/(medium - fine) = r21^p (r32^p - 1)/(r21^p - 1); the right side grows with p.
double observed_order(double quotient, double r21, double r32) {
  auto excess = [&](double p) {
    return std::log(std::expm1(p * std::log(r32)) / std::expm1(p * std::log(r21))) + p * std::log(r21) -
           std::log(quotient);
  };
  double lo = 1e-9, hi = 20;
  if (excess(lo) >= 0) return lo;
  if (excess(hi) <= 0) return hi;
  while (hi - lo > 1e-12 * hi) {
    double const middle = (lo + hi) / 2;
    (excess(middle) > 0 ? hi : lo) = middle;
  }
  return (lo + hi) / 2;
}

}  // namespace

GridConvergence grid_convergence(double fine, double medium, double coarse, double ratio_21, double ratio_32,
                                 double formal_order) {
  if (!(ratio_21 > 1) || !(ratio_32 > 1) || !(formal_order > 0))
    throw std::invalid_argument("grid_convergence: refinement ratios must exceed 1, the order 0");
  double const d21 = medium - fine, d32 = coarse - medium;
  double const size = std::max({std::fabs(fine), std::fabs(medium), std::fabs(coarse)});
  GridConvergence out{.richardson = fine};
  if (std::fabs(d21) <= 4 * std::numeric_limits<double>::epsilon() * size) {
    out.band = std::fabs(d21);
    return out;
  }
  // f = f0 + C h^p gives |d32/d21| = ln r32/ln r21 in the limit p -> 0, and more for p > 0.
  bool const decreasing = std::fabs(d32 / d21) > std::log(ratio_32) / std::log(ratio_21);
  if (d21 * d32 <= 0 || !decreasing) {
    out.behaviour = decreasing ? Convergence::oscillatory : Convergence::divergent;
    auto const [low, high] = std::minmax({fine, medium, coarse});
    out.band = 3 * (high - low);
    return out;
  }
  out.behaviour = Convergence::monotone;
  out.order = observed_order(d32 / d21, ratio_21, ratio_32);
  out.used_order = std::clamp(out.order, 0.5, std::max(0.5, formal_order));
  bool const asymptotic = std::fabs(out.order - formal_order) <= 0.1 * formal_order;
  double const correction = d21 / (std::pow(ratio_21, out.used_order) - 1);
  out.richardson = fine - correction;
  out.band = (asymptotic ? 1.25 : 3.0) * std::fabs(correction);
  return out;
}

}  // namespace g27
