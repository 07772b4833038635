#include "studies/orders/curve.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace g27 {

namespace {

TimeAtError extrapolate(std::span<CurvePoint const> curve, double error) {
  std::span<CurvePoint const> const last = curve.last(std::min<std::size_t>(4, curve.size()));
  std::vector<double> x, y;
  for (CurvePoint const& p : last) x.push_back(std::log(p.error)), y.push_back(std::log(p.seconds));
  double at_zero = 0, slope = 0, cov00 = 0, cov01 = 0, cov11 = 0, residual = 0;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &at_zero, &slope, &cov00, &cov01, &cov11, &residual);
  double line = 0, deviation = 0;
  gsl_fit_linear_est(std::log(error), at_zero, slope, cov00, cov01, cov11, &line, &deviation);
  return {.kind = TimeAtError::Kind::extrapolated,
          .seconds = std::exp(line),
          .uncertainty = last.back().spread + 2.0 * deviation};
}

}  // namespace

TimeAtError time_at(std::span<CurvePoint const> curve, double error) {
  if (curve.size() < 2) throw std::invalid_argument("time_at: a curve needs two points");
  for (CurvePoint const& p : curve) {
    if (!(p.error > 0) || !(p.seconds > 0)) throw std::invalid_argument("time_at: an error or a time is not positive");
  }
  if (curve.front().error <= error) {
    return {TimeAtError::Kind::coarsest, curve.front().seconds, curve.front().spread};
  }
  for (std::size_t i = 1; i < curve.size(); ++i) {
    CurvePoint const &a = curve[i - 1], &b = curve[i];
    if (b.error > error) continue;
    double const share = std::log(a.error / error) / std::log(a.error / b.error);
    return {TimeAtError::Kind::interpolated, a.seconds * std::pow(b.seconds / a.seconds, share),
            std::max(a.spread, b.spread)};
  }
  return extrapolate(curve, error);
}

}  // namespace g27
