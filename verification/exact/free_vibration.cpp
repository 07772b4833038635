#include "verification/exact/free_vibration.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// J_n(x), its first and its second derivative.
struct Bessel {
  double value, slope, bend;
};
Bessel cylinder(int n, double x) {
  double const j = gsl_sf_bessel_Jn(n, x), up = gsl_sf_bessel_Jn(n + 1, x), slope = n / x * j - up;
  return {j, slope, -slope / x - (1 - n * n / (x * x)) * j};
}

/// Coefficients of A and B in the tractions sigma_rr/(mu cos n theta) and sigma_rt/(mu sin n theta), times R^2.
struct DiscTraction {
  double rr_A, rr_B, rt_A, rt_B;
};
DiscTraction disc_traction(int n, double xl, double xt, double lambda_over_mu) {
  Bessel const l = cylinder(n, xl), t = cylinder(n, xt);
  return {xl * xl * (2 * l.bend - lambda_over_mu * l.value), 2 * n * (xt * t.slope - t.value),
          2 * n * (l.value - xl * l.slope), xt * t.slope - xt * xt * t.bend - n * n * t.value};
}

/// The `mode`-th change of sign of f above 0.
double nth_root(ScalarFunction const& f, int mode) {
  double const step = 0.02;
  double x = 0.1, value = f(x);
  for (int found = 0; x < 1000;) {
    double const next = f(x + step);
    if (value * next < 0 && ++found == mode) return find_root(f, x, x + step);
    x += step;
    value = next;
  }
  throw NumericsError("no such mode of vibration");
}

/// Psi_n = J_n(k r) exp(i n theta) and its derivatives: (d/dx +- i d/dy) Psi_n = -+ k Psi_(n +- 1).
struct Harmonic {
  double k;
  Vector3 x;
  [[nodiscard]] Complex psi(int n) const {
    return gsl_sf_bessel_Jn(n, k * std::hypot(x[0], x[1])) * std::polar(1.0, n * std::atan2(x[1], x[0]));
  }
  struct Derivatives {
    Complex x, y, xx, xy, yy;
  };
  [[nodiscard]] Derivatives derivatives(int n) const {
    Complex const up = -k * psi(n + 1), down = k * psi(n - 1), i{0, 1};
    Complex const up2 = k * k * psi(n + 2), down2 = k * k * psi(n - 2), middle = -k * k * psi(n);
    return {(up + down) / 2.0, (up - down) / (2.0 * i), (up2 + 2.0 * middle + down2) / 4.0, (up2 - down2) / (4.0 * i),
            -(up2 - 2.0 * middle + down2) / 4.0};
  }
};

/// j_n(x)/x^n, finite at 0; its derivative by x, over x, is -j_(n+1)/x^(n+1).
double reduced(int n, double x) {
  if (x > 0.5) return gsl_sf_bessel_jl(n, x) / std::pow(x, n);
  double term = 1, sum = 0;
  for (int k = 1; k <= n; ++k) term /= 2 * k + 1;
  for (int k = 0; k < 12; ++k) {
    sum += term;
    term *= -x * x / 2 / ((k + 1) * (2 * (n + k) + 3));
  }
  return sum;
}

}  // namespace

double ElasticSolid::longitudinal_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }
double ElasticSolid::transverse_speed() const { return std::sqrt(mu / rho); }

FreeVibration::FreeVibration(FreeBody body, ElasticSolid const& solid, double size, int order, int mode, double speed)
    : body_(body), solid_(solid), size_(size), order_(order) {
  if (order < 0 || order > 10 || mode < 1 || mode > 50 || (body == FreeBody::bar && order != 0))
    throw NumericsError("a free vibration has an order of 0 to 10 (a bar: 0) and a mode of 1 to 50");
  if (!(solid.mu > 0) || !(solid.lambda > -2.0 / 3 * solid.mu) || !(solid.rho > 0) || !(size > 0))
    throw NumericsError("a free vibration needs positive mu, lambda + 2 mu/3, density and size");
  double const ratio = solid.transverse_speed() / solid.longitudinal_speed(), L = solid.lambda / solid.mu;
  double xt = 0;  // k_T size
  if (body == FreeBody::bar) {
    xt = mode * pi / ratio;
  } else if (body == FreeBody::disc && order == 0) {
    xt = nth_root([&](double x) { return disc_traction(0, x, x / ratio, L).rr_A; }, mode) / ratio;
  } else if (body == FreeBody::disc) {
    auto traction = [&](double x) { return disc_traction(order, ratio * x, x, L); };
    xt = nth_root(
        [&](double x) {
          DiscTraction const t = traction(x);
          return t.rr_A * t.rt_B - t.rr_B * t.rt_A;
        },
        mode);
    DiscTraction const t = traction(xt);
    // from the row that determines them better
    bool const first = std::hypot(t.rr_A, t.rr_B) > std::hypot(t.rt_A, t.rt_B);
    A_ = first ? t.rr_B : t.rt_B;
    B_ = -(first ? t.rr_A : t.rt_A);
  } else if (order == 0) {
    // tan x = x/(1 - x^2 (lambda + 2 mu)/(4 mu))
    xt = nth_root([&](double x) { return std::sin(x) * (1 - x * x * (L + 2) / 4) - x * std::cos(x); }, mode) / ratio;
  } else {
    xt = nth_root(
        [&](double x) { return (order - 1) * gsl_sf_bessel_jl(order, x) - x * gsl_sf_bessel_jl(order + 1, x); }, mode);
  }
  frequency_ = xt / size * solid.transverse_speed();
  k_t_ = xt / size;
  k_l_ = k_t_ * ratio;
  double largest = 0;
  for (int i = 0; i <= 400; ++i) {
    double const angle = pi * i / 400;
    Vector3 x{size * std::cos(angle), size * std::sin(angle), 0};
    if (body == FreeBody::bar) x = {i % 2 * size, 0, 0};
    if (body == FreeBody::sphere) x = {size * std::sin(angle), 0, size * std::cos(angle)};
    Vector3 const U = unscaled(x).U;
    largest = std::max(largest, std::hypot(U[0], U[1], U[2]));
  }
  scale_ = speed / (frequency_ * largest);
}

double FreeVibration::wave_number() const { return k_t_ * size_; }

FreeVibration::Shape FreeVibration::unscaled(Vector3 const& x) const {
  Shape out;
  auto& G = out.gradient;
  if (body_ == FreeBody::bar) {
    out.U[0] = std::cos(k_l_ * x[0]);
    G[0][0] = -k_l_ * std::sin(k_l_ * x[0]);
    return out;
  }
  if (body_ == FreeBody::disc) {
    auto const l = Harmonic{k_l_, x}.derivatives(order_), t = Harmonic{k_t_, x}.derivatives(order_);
    // phi is the real, psi the imaginary part; U = (phi_x + psi_y, phi_y - psi_x)
    out.U = {A_ * l.x.real() + B_ * t.y.imag(), A_ * l.y.real() - B_ * t.x.imag(), 0};
    G[0][0] = A_ * l.xx.real() + B_ * t.xy.imag();
    G[0][1] = A_ * l.xy.real() + B_ * t.yy.imag();
    G[1][0] = A_ * l.xy.real() - B_ * t.xx.imag();
    G[1][1] = A_ * l.yy.real() - B_ * t.xy.imag();
    return out;
  }
  double const r = std::hypot(x[0], x[1], x[2]);
  if (order_ == 0) {
    // grad j_0 = -k^2 (j_1(kr)/(kr)) x
    double const k = k_l_, f = -k * k * reduced(1, k * r), slope = k * k * k * k * reduced(2, k * r);  // f'/r
    for (std::size_t i = 0; i < 3; ++i) {
      out.U[i] = f * x[i];
      for (std::size_t j = 0; j < 3; ++j) G[i][j] = slope * x[i] * x[j] + (i == j ? f : 0);
    }
    return out;
  }
  // (x cross grad) of f(r) H(x), f = j_n(kr)/(kr)^n and H = r^n P_n(z/r): the radial f drops out of the product, and
  // x cross grad H = (y H_z - z H_y, z H_x - x H_z, 0) = g (y, -x, 0) for H = H(q, z), q = r^2.
  // dH/dz at constant r of r^n P_n(z/r) is r^(n-1) P_n'(z/r) =: g.
  double const k = k_t_;
  int const n = order_;
  auto polynomial = [&](int derivative) {
    // r^(n - derivative) P_n^(derivative)(z/r): a polynomial in z and r^2
    double sum = 0;
    for (int m = 0; 2 * m + derivative <= n; ++m) {
      double c =
          std::pow(-1, m) * std::tgamma(2 * n - 2 * m + 1) /
          (std::pow(2, n) * std::tgamma(m + 1) * std::tgamma(n - m + 1) * std::tgamma(n - 2 * m - derivative + 1));
      sum += c * std::pow(x[2], n - 2 * m - derivative) * std::pow(r * r, m);
    }
    return sum;
  };
  // derivative of r^(n-1) P_n' by r^2, at constant z
  auto by_square = [&] {
    double sum = 0;
    for (int m = 1; 2 * m + 1 <= n; ++m) {
      double c = std::pow(-1, m) * std::tgamma(2 * n - 2 * m + 1) /
                 (std::pow(2, n) * std::tgamma(m + 1) * std::tgamma(n - m + 1) * std::tgamma(n - 2 * m));
      sum += c * m * std::pow(x[2], n - 2 * m - 1) * std::pow(r * r, m - 1);
    }
    return sum;
  };
  double const f = reduced(n, k * r), f_slope = -k * k * reduced(n + 1, k * r);  // f'/r
  double const g = polynomial(1), F = f * g;
  double const along = f_slope * g + 2 * f * by_square();  // times x_j: gradient at constant z
  Vector3 gradient{along * x[0], along * x[1], along * x[2] + f * polynomial(2)};
  out.U = {F * x[1], -F * x[0], 0};
  for (std::size_t j = 0; j < 3; ++j) {
    G[0][j] = gradient[j] * x[1] + (j == 1 ? F : 0);
    G[1][j] = -gradient[j] * x[0] - (j == 0 ? F : 0);
  }
  return out;
}

FreeVibration::Shape FreeVibration::shape(Vector3 const& x) const {
  Shape out = unscaled(x);
  for (std::size_t i = 0; i < 3; ++i) {
    out.U[i] *= scale_;
    for (std::size_t j = 0; j < 3; ++j) out.gradient[i][j] *= scale_;
  }
  return out;
}

Vector3 FreeVibration::displacement(Vector3 const& x, double t) const {
  Vector3 U = shape(x).U;
  for (double& u : U) u *= std::sin(frequency_ * t);
  return U;
}

SolidPoint FreeVibration::at(Vector3 const& x, double t) const {
  Shape const s = shape(x);
  auto const& G = s.gradient;
  double const phase = std::sin(frequency_ * t), volume = (G[0][0] + G[1][1] + G[2][2]) * phase;
  SolidPoint out;
  out.rho = solid_.rho * (1 - volume);
  out.p = -(solid_.lambda + 2.0 / 3 * solid_.mu) * volume;
  for (std::size_t i = 0; i < 3; ++i) {
    out.u[i] = s.U[i] * frequency_ * std::cos(frequency_ * t);
    for (std::size_t j = 0; j < 3; ++j) {
      double const strain = (G[i][j] + G[j][i]) / 2 * phase;
      double const S = 2 * solid_.mu * (strain - (i == j ? volume / 3 : 0));
      out.S[tensor_place[i][j]] = S;
      out.e += (S - (i == j ? out.p : 0)) * strain / (2 * solid_.rho);
    }
  }
  return out;
}

double FreeVibration::residual() const {
  double const t = pi / 2 / frequency_;
  double surface = 0, inside = 0;
  for (int i = 0; i <= 60; ++i) {
    double const a = pi * i / 60, b = 1.7 * i;
    for (int k = 0; k <= 20; ++k) {
      double const r = size_ * k / 20;
      Vector3 normal{std::cos(a), std::sin(a), 0};
      if (body_ == FreeBody::bar) normal = {1, 0, 0};
      if (body_ == FreeBody::sphere) normal = {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
      SolidPoint const s = at({r * normal[0], r * normal[1], r * normal[2]}, t);
      bool const free = k == 20 || (k == 0 && body_ == FreeBody::bar);
      for (std::size_t m = 0; m < 3; ++m) {
        double traction = 0;
        for (std::size_t n = 0; n < 3; ++n) {
          traction += s.stress(m, n) * normal[n];
          inside = std::max(inside, std::fabs(s.stress(m, n)));
        }
        if (free) surface = std::max(surface, std::fabs(traction));
      }
    }
  }
  return surface / inside;
}

double FreeVibration::rayleigh_gap() const {
  double const quarter = pi / 2 / frequency_;
  // integrands in the radius, after the exact mean over angles: trapezoidal in theta, Gauss in cos theta
  auto total = [&](auto density) {
    return integrate(
        [&](double r) {
          if (body_ == FreeBody::bar) return density(Vector3{r, 0, 0});
          double sum = 0;
          if (body_ == FreeBody::disc) {
            constexpr int points = 64;
            for (int i = 0; i < points; ++i)
              sum += density(Vector3{r * std::cos(2 * pi * i / points), r * std::sin(2 * pi * i / points), 0}) / points;
            return sum * r;
          }
          return r * r *
                 integrate(
                     [&](double z) {
                       return density(Vector3{r * std::sqrt(1 - z * z), 0, r * z});
                     },
                     -1, 1, 1e-12);
        },
        0, size_, 1e-11);
  };
  double const strain = total([&](Vector3 const& x) { return 2 * solid_.rho * at(x, quarter).e; });
  double const inertia = total([&](Vector3 const& x) {
    Vector3 const U = shape(x).U;
    return solid_.rho * (U[0] * U[0] + U[1] * U[1] + U[2] * U[2]);
  });
  return std::fabs(std::sqrt(strain / inertia) / frequency_ - 1);
}

}  // namespace g27
