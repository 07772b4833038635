#pragma once
/// What is needed to look into a failed step: the cell, its stencil and the inputs.
#include <string>

#include "studies/driver/scene.hpp"

namespace g27 {

/// JSON: status, time, step, cell, EOS with parameters, options, and the state of the cells within four of the failed
/// one (positions, primitive state, conserved averages, pressure margin).
std::string failure_capsule(SceneRun const& run, GasLine const& line, StepReport const& report);
/// The same of a grid: the cells within two of the failed one along each axis.
std::string failure_capsule(SceneRun const& run, GasGrid const& grid, GridStepReport const& report);
/// Of a run that had to end for another reason.
std::string failure_capsule(SceneRun const& run, std::string const& why, double time);

}  // namespace g27
