#include "fsi/overset/rigid_step.hpp"

#include <cmath>

namespace g27 {

namespace {

Vec3 turned(std::array<Vec3, 3> const& rows, Vec3 const& v) noexcept {
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

}  // namespace

void start_rigid_step(Body& body, AnyEos const& gas, double time, double dt) {
  RigidBody& rigid = *body.rigid;
  auto const turn = rigid.turn(0.5 * dt);
  std::vector<RigidBody::Push> pushes;
  for (TriangleState& t : body.triangles) {
    for (Vec3* axis : {&t.frame.n, &t.frame.a, &t.frame.b}) *axis = turned(turn, *axis);
    double const resistance = std::sqrt(bulk_modulus(gas, t.gas[0]) * t.gas[0][gas_field::rho]) * t.area;
    pushes.push_back({.arm = turned(turn, t.centre - rigid.state.centre),
                      .normal = t.frame.n,
                      .force = resistance * dot(t.velocity, t.frame.n) - t.pressure * t.area,
                      .resistance = resistance});
  }
  rigid.during_step = rigid.half_step(pushes, time, dt);
  auto const& [velocity, spin] = rigid.during_step;
  for (std::size_t n = 0; n < body.triangles.size(); ++n) {
    body.triangles[n].velocity = velocity + cross(spin, pushes[n].arm);
  }
}

void finish_rigid_step(Body& body, double time, double dt, BodyMomentum& held) {
  RigidBody& rigid = *body.rigid;
  auto const turn = rigid.turn(0.5 * dt);
  Vec3 impulse{0, 0, 0}, moment{0, 0, 0};
  for (TriangleState const& t : body.triangles) {
    Vec3 const push = (-dt * t.pressure * t.area) * t.frame.n;
    impulse = impulse + push, moment = moment + cross(turned(turn, t.centre - rigid.state.centre), push);
    held.work += dot(push, t.velocity);
  }
  held.linear = held.linear + impulse, held.angular = held.angular + moment;
  rigid.advance(time, dt, impulse, moment);
  rigid.place(body.surface, body.cut);
  body.place_triangles();
}

}  // namespace g27
