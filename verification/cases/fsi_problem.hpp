#pragma once
/// A problem of gas beside a solid on lines that share a contact, as data, and how it is run and held against its
/// reference.
#include <functional>
#include <string>

#include "fsi/line/gas_solid_line.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/line_problem.hpp"
#include "verification/exact/solid.hpp"

namespace g27 {

struct FsiProblem {
  AnyEos eos{};
  AnySolid solid{};
  SolidMaterial material{};             ///< the same, as the exact solutions know it
  double x0 = -1, contact = 0, x1 = 1;  ///< gas from x0 to the contact, solid from there to x1, at the start [m]
  double t_end = 1;                     ///< [s]
  GasBoundary left{};                   ///< of the gas
  SolidBoundary right{.kind = SolidBoundary::Kind::free};  ///< of the solid
  CellMean gas_initial{};                                  ///< means of a cell [a, b], at the start and at t_end
  CellMean gas_reference{};
  std::function<SolidDensities(double a, double b)> solid_initial{}, solid_reference{};
  std::function<double(double t)>
      position{};  ///< of the contact [m]; a run's interface errors are norms over its steps
};

/// Runs the problem with as many cells in the solid as in the gas; throws std::runtime_error when a step fails. Errors:
/// gas_density gas_velocity gas_pressure, solid_density solid_velocity solid_pressure solid_sxx, interface_position and
/// interface_velocity (in time). Profiles: gas, then solid, pressure of the solid as minus its normal stress.
CaseResult run_problem(std::string const& name, int cells, FsiProblem const& problem, CaseOptions const& options);

/// The meshes of the gas: lagrangian, or stretched between its left end and the contact.
std::vector<std::string> fsi_meshes();

}  // namespace g27
