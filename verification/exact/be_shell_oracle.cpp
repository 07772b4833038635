#include "verification/exact/arguments.hpp"
#include "verification/exact/be_shell.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  Shell shell{.symmetry = symmetry_argument(arguments),
              .inner = positive_number(arguments, "inner"),
              .outer = positive_number(arguments, "outer"),
              .rho = positive_number(arguments, "rho"),
              .yield = positive_number(arguments, "yield"),
              .hardening = number(arguments, "hardening")};
  if (shell.symmetry == 0) throw OracleError{"symmetry", "is planar", "choose cylindrical or spherical"};
  if (!(shell.outer > shell.inner)) throw OracleError{"outer", "is not above inner", "give a larger radius"};
  if (shell.hardening < 0) throw OracleError{"hardening", "is negative", "give a number of at least 0"};
  if (given(arguments, "u0") && given(arguments, "stop"))
    throw OracleError{"stop", "and u0 determine each other", "give one of the two"};
  double const wanted = given(arguments, "stop") ? positive_number(arguments, "stop") : shell.inner / 2;
  if (!(wanted < shell.inner)) throw OracleError{"stop", "is not below inner", "give a smaller radius"};
  double const u0 = given(arguments, "u0") ? positive_number(arguments, "u0") : shell.launch_speed(wanted);
  double const stop = shell.stop_radius(u0);
  return {{"u0", u0},
          {"stop", stop},
          {"stop_outer", shell.outer_radius(stop)},
          {"time", shell.stop_time(u0)},
          {"kinetic_energy", shell.kinetic_energy(shell.inner, u0)},
          {"plastic_work", shell.plastic_work(stop)},
          {"residual", shell.residual(stop)}};
}

}  // namespace

Oracle be_shell_oracle() {
  return {.name = "be-shell",
          .summary = "collapse of an incompressible rigid-plastic shell: where and when it stops",
          .source =
              "Verney, IUTAM symposium Behaviour of Dense Media under High Dynamic Pressures (1968); Howell and Ball, "
              "J. Comput. Phys. 175 (2002) 128",
          .parameters = {symmetry_parameter("spherical"),
                         {"inner", "0.08", "m", "inner radius"},
                         {"outer", "0.10", "m", "outer radius"},
                         {"rho", "1845", "kg/m^3", "density"},
                         {"yield", "330e6", "Pa", "yield stress in tension"},
                         {"hardening", "0", "Pa", "its growth by plastic strain"},
                         {"u0", not_given, "m/s", "speed of the inner wall at the start, inwards"},
                         {"stop", not_given, "m", "radius at which the inner wall shall stop (half of inner)"}},
          .evaluate = solve};
}

}  // namespace g27
