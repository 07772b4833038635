#include <cmath>

#include "verification/exact/rigid_rotation.hpp"
#include "verification/exact/solid_arguments.hpp"

namespace g27 {
namespace {

char const* const components[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
char const* const axes[] = {"x", "y", "z"};

OracleRecord solve(OracleArguments const& arguments) {
  SolidMaterial const material = solid_material_argument(arguments);
  SolidPoint const state = solid_state_argument(arguments, material);
  RigidRotation body{.law = material.law, .rho = state.rho, .p = state.p, .rate = number(arguments, "rate")};
  for (std::size_t c = 0; c < 6; ++c) body.S[c] = number(arguments, std::string("s") + components[c]);
  Vector3 x;
  for (std::size_t i = 0; i < 3; ++i) {
    body.axis[i] = number(arguments, std::string("axis_") + axes[i]);
    body.drift[i] = number(arguments, std::string("u") + axes[i]);
    x[i] = number(arguments, axes[i]);
  }
  if (!(std::hypot(body.axis[0], body.axis[1], body.axis[2]) > 0))
    throw OracleError{"axis_z", "leaves no axis", "give one of axis_x, axis_y and axis_z"};
  SolidPoint const s = body.at(x, number(arguments, "t"));
  OracleRecord out{{"rho", s.rho}, {"p", s.p}, {"e", s.e}};
  for (std::size_t i = 0; i < 3; ++i) out.push_back({std::string("u") + axes[i], s.u[i]});
  for (std::size_t c = 0; c < 6; ++c) out.push_back({std::string("s") + components[c], s.S[c]});
  return out;
}

}  // namespace

Oracle rigid_rotation_oracle() {
  std::vector<OracleParameter> parameters{{"t", "0", "s", "time"},
                                          {"x", "0", "m", "where; the axis starts at the origin"},
                                          {"y", "0", "m", "where"},
                                          {"z", "0", "m", "where"},
                                          {"rate", "1000", "rad/s", "angular velocity"},
                                          {"axis_x", "0", "1", "direction of the axis, of any length"},
                                          {"axis_y", "0", "1", "direction of the axis"},
                                          {"axis_z", "1", "1", "direction of the axis"}};
  for (char const* axis : axes) parameters.push_back({std::string("u") + axis, "0", "m/s", "velocity of the axis"});
  for (char const* c : components) parameters.push_back({std::string("s") + c, "0", "Pa", "deviator at t = 0"});
  for (auto const& p : solid_state_parameters()) parameters.push_back(p);
  for (auto const& p : solid_parameters()) parameters.push_back(p);
  return {.name = "rigid-rotation",
          .summary = "stressed body in rigid rotation: the stress turns with it",
          .source = "Truesdell and Noll, The Non-Linear Field Theories of Mechanics (1965)",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
