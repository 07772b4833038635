#include "verification/measure/order.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <stdexcept>

namespace g27 {

OrderFit fit_order(std::span<double const> h, std::span<double const> error) {
  std::size_t const n = h.size();
  if (n != error.size()) throw std::invalid_argument("fit_order: cell sizes and errors differ in number");
  if (n < 4) throw std::invalid_argument("fit_order: at least four grids are needed");
  std::vector<double> x(n), y(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(h[i] > 0) || !(error[i] > 0) || !std::isfinite(error[i]))
      throw std::invalid_argument("fit_order: cell sizes and errors must be positive");
    if (i > 0 && h[i] == h[i - 1]) throw std::invalid_argument("fit_order: two grids have the same cell size");
    x[i] = std::log(h[i]);
    y[i] = std::log(error[i]);
  }
  double intercept, slope, cov00, cov01, cov11, residual;
  gsl_fit_linear(x.data(), 1, y.data(), 1, n, &intercept, &slope, &cov00, &cov01, &cov11, &residual);
  OrderFit fit{.order = slope,
               .half_width = gsl_cdf_tdist_Pinv(0.975, static_cast<double>(n - 2)) * std::sqrt(cov11),
               .constant = std::exp(intercept),
               .between = {}};
  for (std::size_t i = 1; i < n; ++i) fit.between.push_back((y[i] - y[i - 1]) / (x[i] - x[i - 1]));
  return fit;
}

}  // namespace g27
