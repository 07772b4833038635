#pragma once
/// A one-dimensional verification case: initial data, exact solution where there is one, and how to run it.
/// One .cpp a case in this folder (`sod_case.cpp` defines `Case sod_case()`), found by CMake.
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

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
  /// uniform graded alternating random moving moving-random
  std::optional<std::string> mesh;
  /// ideal stiffened jwl mie-gruneisen, where the case exists for it
  std::optional<std::string> eos;
};

struct Norms {
  double l1 = 0, l2 = 0, linf = 0;
};

struct CaseResult {
  std::string name;
  int cells = 0, order = 0;
  std::string scheme, monotonicity, mesh, eos;
  std::map<std::string, Norms> errors;      ///< density velocity pressure; empty without a reference
  std::map<std::string, double> overshoot;  ///< beyond the reference's range, over its jump
  std::map<std::string, double> tv_excess;  ///< total variation over the reference's, minus 1
  double cpu_s = 0, wall_s = 0;
  GasCounters counters;
  GasLedger ledger;
  double time = 0;
  std::vector<double> x, rho, u, p, switched;  ///< final profile at cell centres
  std::vector<double> rho_ref, u_ref, p_ref;   ///< cell averages of the reference
};

struct Case {
  std::string name{}, title{}, source{};
  int default_cells = 200;
  bool has_reference = true;
  std::vector<std::string> eos{"ideal"};  ///< first: the default
  /// Runs the case; throws std::runtime_error when the scheme fails.
  std::function<CaseResult(CaseOptions const&)> run{};
};

std::vector<Case> all_cases();

}  // namespace g27
