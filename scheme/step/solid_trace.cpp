/// Surface of a solid line at a contact: its velocity over the pressure, in the middle of a step.
#include <algorithm>
#include <cmath>

#include "scheme/step/solid_line_end.hpp"

namespace g27 {

namespace {

/// v = free_velocity + P compliance along the normal into the solid, without shear.
struct Response {
  double free_velocity, compliance;
};

/// The boundary condition of a traction (-P, 0, 0), resolved for the normal velocity.
template <class W>
Response response(W const& w, double side, Triple<double> const& out) noexcept {
  Triple<double> free, push;
  Triple<double> const P = w.project(Triple<double>{{1.0, 0.0, 0.0}});
  for (int k = 0; k < 3; ++k) free[k] = out[k] * w.inv_z[k], push[k] = P[k] * w.inv_z[k];
  return {-side * w.unproject(free)[0], w.unproject(push)[0]};
}

/// The larger pressure P at which the deviator S_0 + P S_1 yields; none: infinity.
double yield_at(double const* S_0, double const* S_1, double Y) noexcept {
  double const a = mises_squared(S_1), b = 1.5 * contraction(S_0, S_1), c = mises_squared(S_0) - Y * Y;
  double const root = b * b - a * c;
  return a > 0 && root >= 0 ? (-b + std::sqrt(root)) / a : std::numeric_limits<double>::infinity();
}

}  // namespace

/// Elastic amplitudes give the velocity as far as the material does not yield. Where it does already, and is
/// compressed, those of the tangent modulus, traced to their own foot, give a second and softer line: loading follows
/// it above the pressure at which the two meet. Where it does not yet, the softer line begins at the pressure that
/// brings the deviator on the surface to the yield surface.
SolidTrace SolidLine::Impl::trace(LineEnd end, double dt) {
  set_terms(dt);
  End const here(*this, end == LineEnd::left, dt);
  ElasticWaves<double> const elastic(here.at.frozen);
  Outgoing<double> const out = here.outgoing(elastic);
  Response const e = response(elastic, here.g.side, out.amplitude);
  SolidTrace trace{.free_velocity = e.free_velocity, .impedance = 1.0 / e.compliance};
  if (!plastic || !setup.options.tangent) return trace;

  SolidState<double> const c0 = here.q.state<double>(here.edge);
  double const Y = strength.Y0 + strength.H * c0.ep;
  if (mises_squared(c0.S) > yield_share * Y * Y) {
    if (!(c0.S[0] < 0)) return trace;
    TangentWaves<double> const tangent(here.at.frozen, strength);
    Response const t = response(tangent, here.g.side, here.outgoing(tangent).amplitude);
    double const softer = t.compliance - e.compliance;
    if (!(softer > 1e-6 * e.compliance)) return trace;
    trace.yield_pressure = (e.free_velocity - t.free_velocity) / softer;
    trace.plastic_impedance = 1.0 / t.compliance;
    return trace;
  }
  // the deviator on the surface is linear in P
  auto const deviator = [&](double P, double* S) {
    Triple<double> const s{{-P, 0.0, 0.0}};
    SolidFace<double> const face =
        carry(out.foot, elastic.path(elastic.project(s - out.foot.traction())), Triple<double>{}, s);
    std::copy(std::begin(face.S), std::end(face.S), S);
  };
  double S_0[6], S_1[6], unit = here.at.frozen.longitudinal();
  deviator(0.0, S_0), deviator(unit, S_1);
  for (int k = 0; k < 6; ++k) S_1[k] -= S_0[k];
  double const share = yield_at(S_0, S_1, Y);
  if (!(share < 1.0)) return trace;  // as much as the modulus itself: beyond every use
  FrozenSolid<double> yielding = here.at.frozen;
  for (int k = 0; k < 6; ++k) yielding.S[k] = S_0[k] + share * S_1[k];
  yielding.p = share * unit + yielding.S[0];
  TangentWaves<double> const tangent(yielding, strength);
  double const softer = response(tangent, here.g.side, out.amplitude).compliance;
  if (!(softer > e.compliance)) return trace;
  trace.yield_pressure = share * unit;
  trace.plastic_impedance = 1.0 / softer;
  return trace;
}

}  // namespace g27
