#include "verification/exact/oblique_shock.hpp"

#include <numbers>

#include "verification/exact/arguments.hpp"

namespace g27 {
namespace {

constexpr double degree = std::numbers::pi / 180;

OracleRecord solve(OracleArguments const& arguments) {
  double const gamma = number(arguments, "gamma"), mach = number(arguments, "mach"),
               angle = positive_number(arguments, "angle_deg");
  if (!(gamma > 1)) throw OracleError{"gamma", "is " + arguments.at("gamma"), "give a number above 1"};
  if (!(mach > 1)) throw OracleError{"mach", "is " + arguments.at("mach"), "give a number above 1"};
  bool const weak = word(arguments, "branch", {"weak", "strong"}) == "weak";
  double const detachment = detachment_angle(gamma, mach), most = shock_deflection(gamma, mach, detachment);
  if (angle * degree > most) {
    throw OracleError{"angle_deg", "detaches the shock", "give at most " + std::to_string(most / degree)};
  }
  ObliqueShock const s = oblique_shock(gamma, mach, angle * degree, weak ? ShockBranch::weak : ShockBranch::strong);
  return {{"shock_angle_deg", s.angle / degree},         {"density_ratio", s.density_ratio},
          {"pressure_ratio", s.pressure_ratio},          {"mach_behind", s.mach_behind},
          {"detachment_angle_deg", detachment / degree}, {"largest_deflection_deg", most / degree}};
}

}  // namespace

Oracle oblique_shock_oracle() {
  return {.name = "oblique-shock",
          .summary = "attached shock of an ideal gas on a wedge",
          .source = "Anderson, Modern Compressible Flow, 3rd ed., 4.3; NACA Report 1135",
          .parameters = {{"gamma", "1.4", "1", "ratio of specific heats"},
                         {"mach", "3", "1", "Mach number upstream"},
                         {"angle_deg", "15", "deg", "deflection of the flow: the angle of the wedge"},
                         {"branch", "weak", "", "weak or strong"}},
          .evaluate = solve};
}

}  // namespace g27
