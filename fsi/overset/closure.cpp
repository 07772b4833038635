#include "fsi/overset/closure.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace g27 {

namespace {

/// Of the mass that is lacking, put back in a step: enough to follow what vertices lose by and by, and little enough
/// that the noise of what cut cells hold does not move the surface; a fifth draws more fins out of a crushed cube.
constexpr double share_of_mass = 0.05;

}  // namespace

BodyMomentum momentum_of(Body const& body) {
  BodyIntegrals const now = integrals(body);
  return {.linear = now.momentum, .angular = now.angular, .mass = now.mass};
}

void add_impulse(Body const& body, double dt, BodyMomentum& held) {
  // about a fixed point the round-off of a body that is carried along would grow with its way
  Vec3 const centre = enclosed(body).centroid;
  for (TriangleState const& t : body.triangles) {
    Vec3 const push = (-dt * t.pressure * t.area) * t.frame.n;
    held.linear = held.linear + push, held.angular = held.angular + cross(t.centre - centre, push);
    held.work += dot(push, t.velocity);
  }
}

void close_content(Body& body, BodyMomentum& held) {
  if (body.rigid || body.cut.mirrors.clamps.any()) return;  // a clamp gives a momentum that nothing else tells
  BodyIntegrals const now = integrals(body);
  double area = 0;
  for (TriangleState const& t : body.triangles) area += t.area;
  held.growth = share_of_mass * (held.mass - now.mass) * now.volume / (now.mass * area);
  Vec3 du = (1 / now.mass) * (held.linear - now.momentum), lacking = held.angular - now.angular;
  auto m = now.inertia;
  // A plane holds the motion along its normal and lets turns about it alone; the whole body's products of inertia with
  // that axis vanish.
  for (std::size_t a = 0; a < 3; ++a) {
    if (!body.cut.mirrors.across(a)) continue;
    du[a] = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      if (b != a) lacking[b] = 0, m[tensor_place[std::min(a, b)][std::max(a, b)]] = 0;
    }
  }
  Eigen::Matrix3d I;
  I << m[1] + m[2], -m[3], -m[4], -m[3], m[0] + m[2], -m[5], -m[4], -m[5], m[0] + m[1];
  Eigen::Vector3d const turn = I.inverse() * Eigen::Vector3d(lacking[0], lacking[1], lacking[2]);
  Vec3 const omega{turn[0], turn[1], turn[2]};
  auto const add = [&](SolidFields& q, Vec3 const& x) {
    Vec3 const v = du + cross(omega, x - now.centre);
    for (std::size_t a = 0; a < 3; ++a) q[solid_field_of::u + a] += v[a];
  };
  CellKinds const& kinds = body.solid.kinds;
  kinds.for_each_near(cells_around, [&](std::size_t i) {
    if (kinds.valid(i)) add(body.solid.states[i], kinds.centre(kinds.cell(i)));
  });
  for (TriangleState& t : body.triangles) {
    for (std::size_t k = 0; k < core_layers; ++k) {
      add(t.solid[k], core_centre(t, k, -body.setup.cell));
    }
  }
}

}  // namespace g27
