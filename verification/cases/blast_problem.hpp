#pragma once
/// Cases in curved symmetry with an exact solution: Noh's implosion and Sedov's explosion.
#include <string>

#include "verification/cases/line_problem.hpp"

namespace g27 {

/// gamma = 5/3, gas at 1 falling in at 1 from r = 1 until t = 0.6; the cold gas has p = 1e-8.
Case noh_case(std::string const& name, std::string const& title, Symmetry symmetry);
/// gamma = 1.4, gas at 1 and p = 1e-8; the energy starts in r < 0.04, and the shock reaches r = 1 at the end, t = 1.
/// Cylindrical or spherical.
Case sedov_case(std::string const& name, std::string const& title, Symmetry symmetry);

}  // namespace g27
