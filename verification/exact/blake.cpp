#include "verification/exact/blake.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

double Blake::sound_speed() const { return std::sqrt((lambda + 2 * mu) / rho); }
double Blake::front(double t) const { return radius + sound_speed() * t; }
double Blake::static_displacement() const { return pressure * radius / (4 * mu); }

Blake::Point Blake::at(double r, double t) const {
  r = std::max(r, radius);
  double const c = sound_speed(), tau = t - (r - radius) / c;
  if (!(t > 0) || tau < 0) return {};
  double const b = 2 * mu / (rho * radius * c), w0 = 4 * mu / (rho * radius * radius), w = std::sqrt(w0 - b * b);
  double const decay = std::exp(-b * tau), sine = decay * std::sin(w * tau), cosine = decay * std::cos(w * tau);
  // derivatives of F by tau
  double const unit = pressure * radius / rho;
  double const F0 = -unit / w0 * (1 - cosine - b / w * sine), F1 = -unit / w * sine,
               F2 = -unit * (cosine - b / w * sine);
  Point out{};
  out.displacement = -F0 / (r * r) - F1 / (c * r);
  out.velocity = -F1 / (r * r) - F2 / (c * r);
  out.strain_tt = out.displacement / r;
  out.strain_rr = 2 * F0 / (r * r * r) + 2 * F1 / (c * r * r) + F2 / (c * c * r);
  double const volume = out.strain_rr + 2 * out.strain_tt;
  out.stress_rr = lambda * volume + 2 * mu * out.strain_rr;
  out.stress_tt = lambda * volume + 2 * mu * out.strain_tt;
  return out;
}

}  // namespace g27
