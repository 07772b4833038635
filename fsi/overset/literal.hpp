#pragma once
/// Where the paper leaves the method of overset grids open or has it otherwise, each reading of its words that is not
/// used, to be compared (study fsi-literal). OG section 9, and section 8 for the motion along normals.

namespace g27 {

struct Literal {
  bool reinterpolated_cores = false;  ///< step 2: cores as well start from cells and cloud, not from their own states
  bool clipped_velocities = false;    ///< interpolated velocities stay within the donors' range, as all else does
  bool normal_motion = false;         ///< vertices follow the normal velocities of their triangles alone
  bool level_motion = false;          ///< vertices take the velocities of their triangles' centres, without gradient
  bool deep_donors = false;       ///< step 2: cells of the third kind and the cloud give, those of the fourth do not
  bool continued_stress = false;  ///< lateral cells outside of the body have its stress, not the traction of the gas
};

}  // namespace g27
