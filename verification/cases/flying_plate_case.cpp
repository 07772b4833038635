/// A plate that flies through material at rest, bonded to it at both faces: it yields in compression ahead and in
/// tension behind, exact until the waves of the two faces meet.
#include <algorithm>
#include <cmath>
#include <memory>

#include "verification/cases/solid_problem.hpp"
#include "verification/exact/ep_riemann.hpp"

namespace g27 {

namespace {

constexpr double thickness = 0.04, length = 0.1;  ///< [m]

}  // namespace

Case flying_plate_case() {
  Case out{.name = "flying-plate",
           .title = "plate at 300 m/s between material at rest, before the waves of its faces meet",
           .source = "exact Riemann problem of uniaxial strain at both faces: verification/exact/ep_riemann.hpp",
           .dimensions = 1,
           .default_cells = 800,
           .solid = true,
           .eos = solid_media(),
           .meshes = {"fixed"},
           .parameters = {
               {.name = "velocity", .value = 300, .unit = "m/s", .what = "of the plate", .least = 1, .most = 2000}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    SolidMedium const m = solid_medium(options.eos.value_or("steel"), true);
    double const u = value_of(parameters, options, "velocity");
    SolidPoint const rest = axial_state(m.exact, m.rho0, 0, 0), plate = axial_state(m.exact, m.rho0, u, 0);
    double const rear = 0.5 * (length - thickness), face = 0.5 * (length + thickness);
    struct Faces {
      EpRiemann rear, front;
    };
    auto const exact = std::make_shared<Faces>(
        Faces{EpRiemann(m.exact, rest, m.exact, plate), EpRiemann(m.exact, plate, m.exact, rest)});
    double const forwards = exact->rear.speeds().back(), backwards = -exact->front.speeds().front();
    SolidProblem problem{.solid = m.scheme, .dimensions = 1, .upper = {length, 1, 1}};
    problem.t_end = 0.95 * thickness / (forwards + backwards);
    for (std::size_t side : {0u, 1u}) problem.sides[side] = solid_inflow([=](Vec3 const&, double) { return rest; });
    auto const at = [=](double t) {
      return [=](Vec3 const& x, Vec3 const& h) {
        // the two faces' waves divide the plate between them
        double const middle = rear + thickness * forwards / (forwards + backwards);
        std::vector<double> breaks{middle};
        for (double s : exact->rear.speeds()) breaks.push_back(rear + s * t);
        for (double s : exact->front.speeds()) breaks.push_back(face + s * t);
        std::sort(breaks.begin(), breaks.end());
        auto const state = [&](double s) {
          if (t == 0) return s > rear && s < face ? plate : rest;
          return s < middle ? exact->rear.at((s - rear) / t) : exact->front.at((s - face) / t);
        };
        return solid_average(state, x[0] - 0.5 * h[0], x[0] + 0.5 * h[0], breaks);
      };
    };
    problem.initial = at(0), problem.reference = at(problem.t_end);
    return run_problem("flying-plate", 800, problem, m.exact, options);
  };
  return out;
}

}  // namespace g27
