#include "verification/exact/kenamond.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/arguments.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  auto const at = [&](char const* key) { return number(arguments, key); };
  Kenamond const problem{.speed = positive_number(arguments, "speed"),
                         .radius = at("radius"),
                         .centre = {at("centre_x"), at("centre_y"), at("centre_z")},
                         .ignition = {at("ignition_x"), at("ignition_y"), at("ignition_z")}};
  if (problem.radius < 0) throw OracleError{"radius", "is " + arguments.at("radius"), "give 0 or more"};
  auto const inside = [&](std::array<double, 3> const& p) {
    auto const& c = problem.centre;
    return std::hypot(p[0] - c[0], p[1] - c[1], p[2] - c[2]) < problem.radius;
  };
  if (inside(problem.ignition)) throw OracleError{"ignition_x", "is within the sphere", "light the explosive"};
  double const y = at("y"), z = at("z");
  std::vector<double> const x = numbers(arguments, "x");
  std::vector<double> time, arc;
  for (double const position : x) {
    std::array<double, 3> const p{position, y, z};
    if (inside(p)) {
      throw OracleError{"x", "holds " + std::to_string(position) + ", within the sphere", "choose points of explosive"};
    }
    time.push_back(problem.time(p));
    arc.push_back(problem.radius > 0 ? std::max(0.0, problem.arc(p)) : 0.0);
  }
  return {{"x", x}, {"time", time}, {"arc", arc}};
}

}  // namespace

Oracle kenamond_oracle() {
  return {.name = "kenamond",
          .summary = "lighting times of an explosive around an inert sphere (in the plane: a disc), or without one",
          .source = "Kenamond's problems 1 and 3 of programmed burn, as in ExactPack 1.7.11",
          .parameters = {{"speed", "1", "m/s", "of the detonation front"},
                         {"radius", "0.5", "m", "of the inert sphere; 0: there is none"},
                         {"centre_x", "0", "m", "of the sphere"},
                         {"centre_y", "0", "m", "of the sphere"},
                         {"centre_z", "0", "m", "of the sphere"},
                         {"ignition_x", "0", "m", "point of ignition, at time 0"},
                         {"ignition_y", "-1", "m", "point of ignition"},
                         {"ignition_z", "0", "m", "point of ignition"},
                         {"y", "1", "m", "where"},
                         {"z", "0", "m", "where"},
                         {"x", "-1:1:9", "m", "where: a number, a list 0,0.5,1 or a range 0:1:101"}},
          .evaluate = solve};
}

}  // namespace g27
