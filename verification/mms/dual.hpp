#pragma once
/// Forward-mode automatic differentiation: a value and its derivatives by N variables (Griewank and Walther, 2nd ed.,
/// ch. 3). Enough for the fields and laws of manufactured solutions.
#include <array>
#include <cmath>
#include <cstddef>

namespace g27 {

template <std::size_t N>
struct Dual {
  double value = 0;
  std::array<double, N> d{};

  constexpr Dual() = default;
  constexpr Dual(double v) : value(v) {}  // a constant: conversion is the point
  /// The k-th independent variable.
  static constexpr Dual variable(double v, std::size_t k) {
    Dual out(v);
    out.d[k] = 1;
    return out;
  }

  friend constexpr Dual operator+(Dual a, Dual const& b) {
    a.value += b.value;
    for (std::size_t k = 0; k < N; ++k) a.d[k] += b.d[k];
    return a;
  }
  friend constexpr Dual operator-(Dual a, Dual const& b) {
    a.value -= b.value;
    for (std::size_t k = 0; k < N; ++k) a.d[k] -= b.d[k];
    return a;
  }
  friend constexpr Dual operator-(Dual const& a) { return Dual(0) - a; }
  friend constexpr Dual operator*(Dual const& a, Dual const& b) {
    Dual out(a.value * b.value);
    for (std::size_t k = 0; k < N; ++k) out.d[k] = a.d[k] * b.value + a.value * b.d[k];
    return out;
  }
  friend constexpr Dual operator/(Dual const& a, Dual const& b) {
    Dual out(a.value / b.value);
    for (std::size_t k = 0; k < N; ++k) out.d[k] = (a.d[k] - out.value * b.d[k]) / b.value;
    return out;
  }
  /// Ordered by value: branches of piecewise laws.
  friend constexpr bool operator<(Dual const& a, Dual const& b) { return a.value < b.value; }

  /// f(a), given f and its derivative at a.value.
  [[nodiscard]] constexpr Dual chain(double f, double slope) const {
    Dual out(f);
    for (std::size_t k = 0; k < N; ++k) out.d[k] = slope * d[k];
    return out;
  }
  friend Dual exp(Dual const& a) { return a.chain(std::exp(a.value), std::exp(a.value)); }
  friend Dual log(Dual const& a) { return a.chain(std::log(a.value), 1 / a.value); }
  friend Dual sin(Dual const& a) { return a.chain(std::sin(a.value), std::cos(a.value)); }
  friend Dual cos(Dual const& a) { return a.chain(std::cos(a.value), -std::sin(a.value)); }
  friend Dual sqrt(Dual const& a) { return a.chain(std::sqrt(a.value), 0.5 / std::sqrt(a.value)); }
  friend Dual pow(Dual const& a, double n) { return a.chain(std::pow(a.value, n), n * std::pow(a.value, n - 1)); }
  friend Dual tanh(Dual const& a) {
    double const t = std::tanh(a.value);
    return a.chain(t, 1 - t * t);
  }
};

}  // namespace g27
