#pragma once
/// A verification case: initial data, exact solution where there is one, and how to run it.
/// One .cpp a case in this folder (`sod_case.cpp` defines `Case sod_case()`), found by CMake.
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scheme/step/gas_grid_options.hpp"
#include "scheme/step/gas_line.hpp"

namespace g27 {

/// What a study or the command line may vary of a case; unset: the case's own choice.
struct CaseOptions {
  std::optional<int> cells;
  std::optional<Predictor> predictor;
  std::optional<Switch> monotonicity;
  std::optional<double> cfl;
  std::optional<FootPoints> feet;
  std::optional<bool> single_foot;
  std::optional<RiemannSolver> riemann;
  std::optional<bool> linear_star;
  std::optional<int> threads;
  std::function<void(double done)> progress;  ///< called now and then with the part of the run that is done
  /// one of the case's meshes
  std::optional<std::string> mesh;
  /// ideal stiffened jwl mie-gruneisen, where the case exists for it
  std::optional<std::string> eos;
  /// of the case's own parameters, by name
  std::map<std::string, double> values;

  // Of grids alone
  std::optional<Transverse> transverse;
  std::optional<bool> cure, skip;
  std::optional<Int3> tile;
  bool fields = false;  ///< keep the final fields, and count where switch, cure and repair acted
};

/// A number that a case leaves to its user.
struct CaseParameter {
  std::string name;
  double value = 0;  ///< unless the options say otherwise
  std::string unit, what;
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  bool whole = false;  ///< it counts or chooses
};

struct Norms {
  double l1 = 0, l2 = 0, linf = 0;
};

/// Final fields of a grid in single precision, for figures: [nx ny nz], x fastest; 0 in solid blocks.
struct GridFields {
  Int3 cells{1, 1, 1};
  Vec3 lower{0, 0, 0}, widths{1, 1, 1};  ///< corner of the box and width of a cell [m]
  std::vector<float> density, velocity_x, velocity_y, velocity_z, pressure;
  std::vector<float> switched, cured, repaired;  ///< steps in which a face of the cell was
};

struct CaseResult {
  std::string name;
  int dimensions = 1;
  int cells = 0, order = 0;  ///< cells of a grid: along its longest axis
  Int3 grid{1, 1, 1};        ///< cells along each axis
  std::string scheme, monotonicity, mesh, eos;
  /// density velocity pressure; empty without a reference. Of a grid, velocity is the length of the vector of the
  /// components' errors, which follow as velocity_x velocity_y velocity_z
  std::map<std::string, Norms> errors;
  std::map<std::string, double> overshoot;  ///< beyond the reference's range, over its jump
  std::map<std::string, double> tv_excess;  ///< total variation over the reference's, minus 1
  double cpu_s = 0, wall_s = 0;
  GridCounters counters;                ///< of grids alone: 0 on a line
  GasLedger ledger;                     ///< of a grid, the momentum along the axis where most is unaccounted for
  std::map<std::string, double> facts;  ///< what else the case measures, by name
  double time = 0;
  std::vector<double> x, rho, u, p, switched;  ///< final profile at cell centres
  std::vector<double> rho_ref, u_ref, p_ref;   ///< cell averages of the reference
  /// of a solid in one dimension: by variable, the final profile and the reference's
  std::map<std::string, std::vector<double>> profile, profile_ref;
  std::optional<GridFields> fields;
};

struct Case {
  std::string name{}, title{}, source{};
  int dimensions = 1;
  int default_cells = 200;
  bool has_reference = true;
  bool solid = false;   ///< of the scheme for solids: the variables velocity_x.. and sxx.. beside the gas's
  bool bodies = false;  ///< gas and deforming bodies on overset grids: facts alone, no fields
  std::vector<std::string> eos{"ideal"};  ///< first: the default
  std::vector<std::string> meshes{"uniform", "graded", "alternating", "random", "moving", "moving-random"};
  std::vector<CaseParameter> parameters{};
  /// Runs the case; throws std::runtime_error when the scheme fails.
  std::function<CaseResult(CaseOptions const&)> run{};
};

/// The value of a parameter: that of the options, or its own. Throws std::invalid_argument for a name that is not
/// there.
double value_of(std::vector<CaseParameter> const& parameters, CaseOptions const& options, std::string const& name);

std::vector<Case> all_cases();

}  // namespace g27
