#pragma once
/// Contact of two solids that are bonded: velocity and traction are continuous, shear is passed on.
///
/// Each solid leaves a linear relation at the face, from its own outgoing characteristics, with its own families P and
/// impedances z: Z u - side s = b, Z = P^-1 diag(z) P, b = P^-1 out, out_k = l_k.(z_k u - side s); side = 1 of the
/// solid below the face (smaller x), -1 of that above. Together
///   u = (Z_below + Z_above)^-1 (b_below + b_above),  s = Z_below u - b_below.
#include <array>

namespace g27 {

using FaceVector = std::array<double, 3>;  ///< in the frame of the face: normal, and two along it

/// Z u - side s = b.
struct BondedTrace {
  std::array<FaceVector, 3> Z{};  ///< rows [Pa s/m]
  FaceVector b{};                 ///< [Pa]
};

/// A solid at a bonded face: elastic, and where it yields along the tangent modulus as well.
struct BondedSide {
  BondedTrace elastic{}, tangent{};
  bool yields = false;  ///< the cell beside the face lies on the yield surface; `tangent` is given
  FaceVector S{}, u{};  ///< of that cell: S11 S12 S13 [Pa], velocity [m/s]
  double work = 0;      ///< S:D of directions along the face, times the distance of the cell's two faces [Pa m/s]
};

struct BondedContact {
  FaceVector u{}, s{};                                ///< velocity [m/s] and traction [Pa] of both
  bool plastic_below = false, plastic_above = false;  ///< the branch that the side took
};

/// A side that yields takes its tangent modulus where the elastic solution would load it further, S:D > 0 between its
/// cell and the face.
/// in  Z_below + Z_above regular: not both are fluids
[[nodiscard]] BondedContact bonded_contact(BondedSide const& below, BondedSide const& above) noexcept;

}  // namespace g27
