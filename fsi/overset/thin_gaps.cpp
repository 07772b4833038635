#include "fsi/overset/thin_gaps.hpp"

#include <cmath>

namespace g27 {

namespace {

/// Over c/h, c the speed of sound. Left alone, cores within the other body grow by 2 % a step in gaps of half a cell to
/// one that a uniform stream carries along; rates from 1.6 on keep them at round-off for 500 steps.
constexpr double rate = 2;

}  // namespace

void tie_thin_gaps(Body& body, double dt) {
  double const h = body.gas.kinds.box().h;
  for (TriangleState& t : body.triangles) {
    if (body.gas.kinds.in_medium(core_centre(t, 1, h))) continue;
    GasFields const& q = t.gas[0];
    double const K = bulk_modulus(body.gas.donors.law(), q);
    double const part = 1 - std::exp(-rate * std::sqrt(K / q[gas_field::rho]) * dt / h);
    for (std::size_t f = 0; f < gas_field::count; ++f) t.gas[1][f] += part * (q[f] - t.gas[1][f]);
  }
}

}  // namespace g27
