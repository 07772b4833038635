#pragma once
/// A problem of two solids bonded at x = 0, on lines that move with the material, as data, and how it is run and held
/// against its reference.
#include <functional>
#include <string>

#include "fsi/line/solid_solid_line.hpp"
#include "verification/cases/case.hpp"
#include "verification/cases/solid_media.hpp"

namespace g27 {

struct BondedProblem {
  struct Side {
    SolidMedium medium;
    double length = 1;                                                         ///< of the solid at the start [m]
    SolidBoundary outer{.kind = SolidBoundary::Kind::free};                    ///< of its other end
    std::function<SolidDensities(double a, double b)> initial{}, reference{};  ///< means of a cell, then and at t_end
  };
  Side left, right;
  double t_end = 1;                               ///< [s]
  std::function<SolidPoint(double t)> contact{};  ///< the exact state at the bonded face: its velocity and traction
};

/// steel-aluminium aluminium-steel steel-steel aluminium-aluminium: the solids on the left and on the right.
std::vector<std::string> bonded_pairs();
/// Throws std::invalid_argument for another pair.
std::pair<SolidMedium, SolidMedium> bonded_media(std::string const& pair, bool plastic);

/// Runs the problem with as many cells on the right as on the left; throws std::runtime_error when a step fails.
/// Errors: velocity and every variable of solid_variables() over both solids, the latter of each with left_ and right_
/// before it, and in time contact_velocity_x.. and contact_traction_x.., held against the middle of each step.
/// Profiles: both solids, from left to right.
CaseResult run_problem(std::string const& name, int cells, BondedProblem const& problem, CaseOptions const& options);

}  // namespace g27
