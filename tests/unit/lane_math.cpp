/// exp, log and pow of a lane against long double functions of the C library (64-bit significand: 2^-11 of our ulp).
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "riemann/base/lane_math.hpp"
#include "tests/catch.hpp"

namespace {

using g27::Simd;

/// |value - reference| in units of the last place of the reference rounded to double.
double ulps(double value, long double reference) {
  int exponent = 0;
  (void)std::frexp(static_cast<double>(reference), &exponent);
  return static_cast<double>(std::fabs(value - reference) / std::ldexp(1.0L, std::max(exponent - 53, -1074)));
}

double any_positive_normal(std::mt19937_64& random) {
  return std::ldexp(std::uniform_real_distribution<double>(1, 2)(random),
                    std::uniform_int_distribution<int>(-1022, 1023)(random));
}

}  // namespace

TEST_CASE("exp is within 1.1 ulp over its whole range", "[lane]") {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    // the upper half dense around 0, where the result is near 1 and small arguments must not be lost
    double const x = i % 2 == 0 ? std::uniform_real_distribution<double>(-708, 709)(random)
                                : std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), -i / 2 % 60);
    worst = std::max(worst, ulps(g27::exp(x), std::exp(static_cast<long double>(x))));
  }
  INFO("largest error " << worst << " ulp");
  CHECK(worst < 1.1);
  CHECK(worst > 0.5);  // the measure works: nothing less than correct rounding stays below
}

TEST_CASE("log is within one ulp over all positive numbers", "[lane]") {
  std::mt19937_64 random(2);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    double x = any_positive_normal(random);
    if (i % 4 == 1) x = std::uniform_real_distribution<double>(0.5, 2)(random);
    if (i % 4 == 2) x = 1 + std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), -i / 4 % 52);
    if (i % 4 == 3)
      x = std::ldexp(std::uniform_real_distribution<double>(1, 2)(random), -1023 - i / 4 % 51);  // subnormal
    worst = std::max(worst, ulps(g27::log(x), std::log(static_cast<long double>(x))));
  }
  INFO("largest error " << worst << " ulp");
  CHECK(worst < 1.0);
  CHECK(worst > 0.5);
  CHECK(g27::log(1.0) == 0.0);
}

TEST_CASE("pow keeps its stated error", "[lane]") {
  std::mt19937_64 random(3);
  double worst = 0, worst_moderate = 0;
  for (int i = 0; i < 400000; ++i) {
    double const x =
        i % 2 == 0 ? any_positive_normal(random) : std::exp2(std::uniform_real_distribution<double>(-4, 4)(random));
    double const y = i % 2 == 0 ? std::uniform_real_distribution<double>(-700, 700)(random) / std::log(x)
                                : std::uniform_real_distribution<double>(-1, 1)(random);
    long double const reference = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    double const error = static_cast<double>(std::fabs(g27::pow(x, y) / reference - 1));
    worst = std::max(worst, error / (1 + std::fabs(y * std::log(x))));
    if (i % 2 == 1) worst_moderate = std::max(worst_moderate, error);
  }
  // log and exp err by one ulp each, and log by up to |y ln x| = 2.8 times half of one
  INFO("relative error over (1 + |y ln x|): " << worst << ", for x in [1/16, 16], |y| <= 1: " << worst_moderate);
  CHECK(worst < 2.3e-16);
  CHECK(worst_moderate < 6e-16);
}

TEST_CASE("the ends of the range and not-a-number", "[lane]") {
  double const infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(g27::exp(0.0) == 1.0);
  CHECK(g27::exp(-1e4) == g27::exp(-708.0));
  CHECK(g27::exp(-infinity) == g27::exp(-708.0));
  CHECK(g27::exp(1e4) == g27::exp(709.0));
  CHECK(g27::exp(infinity) == g27::exp(709.0));
  CHECK(std::isfinite(g27::exp(709.0)));
  CHECK(std::isnormal(g27::exp(-708.0)));
  CHECK(std::isnan(g27::exp(nan)));
  CHECK(std::isnan(g27::log(nan)));
  CHECK(std::isnan(g27::log(infinity)));
  CHECK(std::isnan(g27::pow(nan, 0.3)));
}

TEST_CASE("a vector of lanes computes what the scalar computes", "[lane]") {
  std::mt19937_64 random(4);
  int differing = 0;
  for (int i = 0; i < 20000; ++i) {
    Simd x, y;
    for (std::size_t k = 0; k < Simd::size(); ++k) {
      x[k] = any_positive_normal(random);
      y[k] = std::uniform_real_distribution<double>(-720, 720)(random);
    }
    Simd const e = g27::exp(y), l = g27::log(x), p = g27::pow(x, y / 720.0);
    for (std::size_t k = 0; k < Simd::size(); ++k) {
      differing += g27::lane(e, k) != g27::exp(g27::lane(y, k));
      differing += g27::lane(l, k) != g27::log(g27::lane(x, k));
      differing += g27::lane(p, k) != g27::pow(g27::lane(x, k), g27::lane(y, k) / 720.0);
    }
  }
  CHECK(differing == 0);  // the same operations in the same order
}
