#pragma once
/// What two media exchange across a contact: its pressure and its normal velocity. Shear is not passed on: they slip.

namespace g27 {

/// n points out of the first medium, into the second.
struct Contact {
  double p = 0;  ///< minus the normal traction n.s.n, the same on both sides [Pa]
  double u = 0;  ///< velocity along n [m/s]
};

}  // namespace g27
