/// A shell of beryllium that is thrown inwards and stops when its kinetic energy has gone into plastic work.
#include <limits>
#include <memory>

#include "verification/cases/solid_line_problem.hpp"
#include "verification/cases/solid_media.hpp"
#include "verification/exact/be_shell.hpp"

namespace g27 {

namespace {

/// Where and when the inner wall stops: its speed is linear in time between the middles of the last two steps.
struct Stop {
  double start_energy = 0;
  double time = 0, speed = 0;  ///< middle of the last step, and the wall's speed during it
  double radius = std::numeric_limits<double>::quiet_NaN(), stop_time = radius;
  double last_end = 0;

  bool reached(SolidLine const& line) {
    double const t = line.time(), dt = t - last_end, w = line.face_speeds().front();
    if (t == 0) {
      start_energy = line.kinetic_energy();
      return false;
    }
    double const middle = last_end + 0.5 * dt;
    if (w >= 0) {
      stop_time = time + (middle - time) * speed / (speed - w);
      // from the end of the last step before it turned
      double const inner = line.faces().front() - w * dt, slope = (w - speed) / (middle - time);
      double const at_end = speed + slope * (last_end - time), after = stop_time - last_end;
      radius = inner + after * (at_end + 0.5 * slope * after);
      return true;
    }
    time = middle, speed = w, last_end = t;
    return false;
  }
};

}  // namespace

Case be_shell_case() {
  Case out{.name = "be-shell",
           .title = "spherical shell of beryllium, 8 to 10 cm, thrown inwards: where its inner wall stops",
           .source =
               "Verney, IUTAM symposium Behaviour of Dense Media under High Dynamic Pressures (1968); Howell and "
               "Ball, J. Comput. Phys. 175 (2002) 128; exact for incompressible, rigid-plastic material",
           .dimensions = 1,
           .default_cells = 100,
           .has_reference = false,
           .solid = true,
           .eos = {"beryllium"},
           .meshes = {"lagrangian"},
           .parameters = {{.name = "u0",
                           .value = 619.787,
                           .unit = "m/s",
                           .what = "of the inner wall, inwards",
                           .least = 50,
                           .most = 720}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("beryllium"), true);
    Shell const shell{.inner = 0.08, .outer = 0.10, .rho = m.rho0, .yield = m.exact.yield, .hardening = 0};
    double const u0 = value_of(parameters, options, "u0"), exact = shell.stop_radius(u0);
    SolidLineProblem problem{.solid = m.scheme, .symmetry = Symmetry::spherical, .x0 = shell.inner, .x1 = shell.outer};
    problem.t_end = 3 * shell.stop_time(u0);
    problem.initial = [=](double r) {
      return SolidPoint{.rho = m.rho0, .u = {-u0 * shell.inner * shell.inner / (r * r), 0, 0}};
    };
    auto const stop = std::make_shared<Stop>();
    problem.finished = [=](SolidLine const& line) { return stop->reached(line); };
    problem.measure = [=](SolidLine const& line, CaseResult& r) {
      r.facts["stop_radius"] = stop->radius, r.facts["exact_stop_radius"] = exact;
      r.facts["stop_radius_error"] = stop->radius / exact - 1;
      r.facts["stop_time"] = stop->stop_time, r.facts["exact_stop_time"] = shell.stop_time(u0);
      r.facts["kinetic_share"] = line.kinetic_energy() / stop->start_energy;
      r.facts["plastic_work_share"] = line.ledger().plastic_work / stop->start_energy;
    };
    return run_problem("be-shell", 100, problem, options);
  };
  return out;
}

}  // namespace g27
