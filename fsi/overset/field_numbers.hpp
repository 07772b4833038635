#pragma once
/// Numbers of the primitive variables in the states that overset grids exchange.
#include <cstddef>

namespace g27 {

/// Density, velocity, pressure.
namespace gas_field {
inline constexpr std::size_t rho = 0, u = 1, p = 4, count = 5;
inline constexpr std::size_t energy = 5;  ///< total, per mass: of donors
}  // namespace gas_field
/// Density, velocity, pressure, specific internal energy, deviatoric stress xx yy zz xy xz yz, plastic strain.
namespace solid_field_of {
inline constexpr std::size_t rho = 0, u = 1, p = 4, e = 5, S = 6, ep = 12, count = 13;
}

}  // namespace g27
