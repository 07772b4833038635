#include "verification/measure/norms.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace g27 {
namespace {

void check(bool good, char const* what) {
  if (!good) throw std::invalid_argument(what);
}

/// A reference that varies by less than this share of its magnitude is flat: what is left is its own round-off.
constexpr double flat = 1e-10;

/// What a deviation is compared with when the reference is flat.
double magnitude(std::span<double const> reference) {
  double largest = 0;
  for (double const r : reference) largest = std::max(largest, std::fabs(r));
  return largest > 0 ? largest : 1;
}

}  // namespace

Norms norms(std::span<double const> value, std::span<double const> reference, std::span<double const> measure) {
  check(!value.empty() && value.size() == reference.size() && value.size() == measure.size(),
        "norms: values, reference and measures differ in length");
  Norms out;
  double total = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    double const e = std::fabs(value[i] - reference[i]);
    out.l1 += e * measure[i];
    out.l2 += e * e * measure[i];
    out.linf = e <= out.linf ? out.linf : e;  // keeps a NaN
    total += measure[i];
  }
  out.l1 /= total;
  out.l2 = std::sqrt(out.l2 / total);
  if (std::isnan(out.l1)) out.linf = out.l1;
  return out;
}

double total_variation(std::span<double const> value, bool periodic) {
  double sum = 0;
  for (std::size_t i = 1; i < value.size(); ++i) sum += std::fabs(value[i] - value[i - 1]);
  if (periodic && !value.empty()) sum += std::fabs(value.front() - value.back());
  return sum;
}

double tv_excess(std::span<double const> value, std::span<double const> reference, bool periodic) {
  check(!reference.empty(), "tv_excess: no reference");
  double const of_value = total_variation(value, periodic), of_reference = total_variation(reference, periodic);
  double const size = magnitude(reference);
  return of_reference > flat * size ? of_value / of_reference - 1 : of_value / size;
}

double overshoot(std::span<double const> value, std::span<double const> reference) {
  check(!reference.empty(), "overshoot: no reference");
  auto const [low, high] = std::minmax_element(reference.begin(), reference.end());
  double beyond = 0;
  for (double const v : value) beyond = std::max({beyond, v - *high, *low - v});
  double const size = magnitude(reference);
  return beyond / (*high - *low > flat * size ? *high - *low : size);
}

}  // namespace g27
