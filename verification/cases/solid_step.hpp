#pragma once
/// A square wave of the velocity in an elastic solid, along an axis or across the grid: steps of P and S waves.
#include <string>

#include "verification/cases/case.hpp"

namespace g27 {

/// Parameters: `normal` and `shear`, the step's components over each other, and `stress`, the pre-stress over the bulk
/// modulus. Facts: how far the velocities along and across the wave's normal lie beyond the exact ones, over the step.
Case solid_step_case(std::string const& name, int dimensions);

}  // namespace g27
