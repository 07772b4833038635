#pragma once
/// Plane simple waves of finite amplitude in solids: along an axis or across the grid, periodic or driven from the
/// sides, elastic or in material that yields everywhere.
#include "verification/cases/solid_problem.hpp"

namespace g27 {

struct SolidWaveCase {
  std::string name, title;
  int dimensions = 1;
  int family = 0;          ///< 0: P; 1, 2: S by falling speed
  double amplitude = 0.1;  ///< of the velocity, over the speed of P waves
  double stress = 0;       ///< scale of the deviator ahead, over the bulk modulus of the material
  enum class Sides {
    periodic,
    fixed,     ///< the exact velocities
    traction,  ///< the exact stresses
    wall       ///< the exact normal velocity, without shear: P waves alone
  };
  Sides sides = Sides::periodic;  ///< along x in one dimension
  /// material on the yield surface that loads everywhere; uniaxial, or with shear
  enum class Loading { elastic, uniaxial, sheared };
  Loading loading = Loading::elastic;
};

/// A sine over one period of the carrying characteristic; of loading, a smooth step.
Case solid_wave_case(SolidWaveCase const& wave);

}  // namespace g27
