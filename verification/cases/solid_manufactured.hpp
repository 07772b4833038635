#pragma once
/// Manufactured waves of solids in one to three dimensions.
#include <string>

#include "verification/cases/case.hpp"

namespace g27 {

/// All velocities and all six stresses vary and move along every axis.
Case solid_manufactured_case(std::string const& name, int dimensions);

}  // namespace g27
