#include "fsi/overset/fast_cores.hpp"

#include <cmath>

namespace g27 {

namespace {

constexpr double too_fast = 4;  ///< over the grid's fastest cell

}  // namespace

double signal_rate(AnyEos const& eos, TriangleState const& t, GasFields const& q, double h) {
  Vec3 const v = t.frame.into(velocity_of(q) - t.velocity);
  double const c = std::sqrt(bulk_modulus(eos, q) / q[gas_field::rho]);
  return (std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]) + 3 * c) / h;
}

std::size_t renew_fast_cores(Body& body, double fastest) {
  double const h = body.gas.kinds.box().h;
  AnyEos const& eos = body.gas.donors.law();
  auto const slow = [&](TriangleState const& t, GasFields const& q) {
    return signal_rate(eos, t, q, h) <= too_fast * fastest;
  };
  std::size_t renewed = 0;
  for (TriangleState& t : body.triangles) {
    if (slow(t, t.gas[0]) || !slow(t, t.gas[1])) continue;
    t.gas[0] = t.gas[1], ++renewed;
  }
  return renewed;
}

}  // namespace g27
