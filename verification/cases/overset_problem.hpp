#pragma once
/// Runs gas and bodies on overset grids and measures them.
#include <functional>
#include <string>

#include "fsi/overset/overset_solver.hpp"
#include "verification/cases/case.hpp"

namespace g27 {

struct OversetProblem {
  OversetSetup setup;
  std::function<GasPoint(Vec3 const&)> gas;  ///< state at the start
  double t_end = 0;                          ///< [s]
  long steps = 0;                            ///< instead of t_end, when > 0
  /// after every step; false ends the run
  std::function<bool(OversetSolver const&)> after_step{};
  std::function<void(OversetSolver const&, CaseResult&)> measure{};
};

/// A cube of `cells` cells of gas along [0, size].
GasGridSetup gas_cube(AnyEos const& eos, double size, int cells);

/// The same about the origin; the first `planes` planes x = 0, y = 0, z = 0 are walls, and what lies below them is left
/// out. The number of cells is even.
GasGridSetup symmetric_cube(AnyEos const& eos, double size, int cells, int planes);

/// The part of the surface above the first `planes` of the planes x = 0, y = 0, z = 0; `snap` as of clip_surface.
TriangleSurface clip_at_origin(TriangleSurface surface, int planes, double snap);

/// The surface turned by `angle` about `axis` (of any length) and moved to `centre`.
TriangleSurface placed(TriangleSurface surface, Vec3 const& axis, double angle, Vec3 const& centre);

/// Parameter `literal` of a case: a reading of the paper that is compared with what is used.
CaseParameter literal_parameter();
Literal literal_reading(double number);

/// A case of this kind; its run is the caller's.
Case overset_case(std::string const& name, std::string const& title, std::string const& source, int cells,
                  std::vector<CaseParameter> const& parameters);

/// Sets predictor, switch, CFL number and threads of all grids by the options. Facts of every run: triangles, steps,
/// model problems redone at first order and kept, us of a triangle's step and its parts of the time.
CaseResult run_problem(std::string const& name, int cells, OversetProblem problem, CaseOptions const& options);

}  // namespace g27
