/// Blake's spherical wave in a Cartesian box beside the cavity, driven through the sides that face it.
#include <cmath>
#include <memory>

#include "verification/cases/solid_problem.hpp"
#include "verification/exact/blake.hpp"

namespace g27 {

namespace {

/// Corners of the box along every axis [m]: the nearest one is just outside the cavity of 0.1 m.
constexpr double near_side = 0.06, far_side = 0.22;

SolidPoint state(Blake const& b, SolidMaterial const& m, Vec3 const& x, double t) {
  double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  Blake::Point const at = r < b.front(t) ? b.at(r, t) : Blake::Point{0, 0, 0, 0, 0, 0};
  double const mean = (at.stress_rr + 2 * at.stress_tt) / 3;
  SolidPoint s{.rho = b.rho * (1 - at.strain_rr - 2 * at.strain_tt), .p = -mean};
  for (std::size_t i = 0; i < 3; ++i) {
    s.u[i] = at.velocity * x[i] / r;
    for (std::size_t j = i; j < 3; ++j) {
      s.S[tensor_place[i][j]] =
          (at.stress_rr - at.stress_tt) * x[i] * x[j] / (r * r) + (i == j ? at.stress_tt - mean : 0.0);
    }
  }
  s.e = energy(m.law, s.rho, s.p);
  return s;
}

}  // namespace

Case blake_3d_case() {
  Case out{.name = "blake-3d",
           .title = "Blake's sphere: a box beside the cavity, the exact velocity on the sides that face it",
           .source = "Blake, J. Acoust. Soc. Am. 24 (1952) 211",
           .dimensions = 3,
           .default_cells = 32,
           .solid = true,
           .eos = {"elastic"},
           .meshes = {"fixed"}};
  out.run = [](CaseOptions const& options) {
    Blake const b{};
    double const K = b.lambda + 2.0 / 3 * b.mu;
    SolidMaterial const m{.law = LinearBulkLaw{K, b.rho}, .mu = b.mu};
    SolidProblem problem{.solid = {.eos = BulkModulus{b.rho, K}, .mu = b.mu},
                         .dimensions = 3,
                         .lower = {near_side, near_side, near_side},
                         .upper = {far_side, far_side, far_side}};
    // the front, past the middle of the box
    double const middle = std::sqrt(3.0) * 0.5 * (near_side + far_side);
    problem.t_end = (middle - b.radius) / b.sound_speed();
    auto const at = [=](Vec3 const& x, double t) { return state(b, m, x, t); };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      problem.sides[2 * axis] = {.kind = SolidBoundary::Kind::fixed,
                                 .velocity = [=](Vec3 const& x, double t) { return at(x, t).u; }};
      problem.sides[2 * axis + 1] = solid_inflow(at);
    }
    auto const mean = [=](double t) {
      return solid_mean(
          3, [=](Vec3 const& x) { return at(x, t); }, 3);
    };
    problem.initial = mean(0), problem.reference = mean(problem.t_end);
    // displacement: the velocity's integral over time, trapezoidal, in the cell nearest to the box's first quarter
    struct Probe {
      double displacement = 0, last = 0, r = 0;
      Int3 cell{};
    };
    auto const probe = std::make_shared<Probe>();
    problem.after_step = [=](SolidGrid const& grid, double dt) {
      int const i = grid.cells()[0] / 4;
      probe->cell = {i, i, i};
      Vec3 const x = grid.centre(probe->cell), u = grid.primitive(probe->cell).u;
      probe->r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      double const radial = (u[0] * x[0] + u[1] * x[1] + u[2] * x[2]) / probe->r;
      probe->displacement += 0.5 * dt * (radial + probe->last), probe->last = radial;
    };
    problem.measure = [=](SolidGrid const& grid, CaseResult& r) {
      double const exact = b.at(probe->r, grid.time()).displacement;
      r.facts["displacement"] = probe->displacement;
      r.facts["displacement_error"] = probe->displacement / exact - 1;
    };
    return run_problem("blake-3d", 32, problem, m, options);
  };
  return out;
}

}  // namespace g27
