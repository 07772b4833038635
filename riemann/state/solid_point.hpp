#pragma once
/// States of an elastoplastic solid at a point of space, as grids, boundaries and exact solutions exchange them.
#include <array>
#include <cstddef>

namespace g27 {

/// Symmetric tensor: xx yy zz xy xz yz.
using Sym3 = std::array<double, 6>;
/// Place of component (i, j) in it.
inline constexpr std::size_t tensor_place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

/// Density [kg/m^3], velocity [m/s], pressure [Pa], specific internal energy [J/kg], deviatoric stress [Pa],
/// equivalent plastic strain. Where the scheme is given a state it takes the energy from density and pressure; with a
/// law p(rho) it does not read the pressure either.
struct SolidPoint {
  double rho = 0;
  std::array<double, 3> u{};
  double p = 0, e = 0;
  Sym3 S{};
  double ep = 0;
  /// Component of the stress -p I + S.
  [[nodiscard]] double stress(std::size_t i, std::size_t j) const { return S[tensor_place[i][j]] - (i == j ? p : 0); }
};

/// Conserved densities: mass [kg/m^3], momentum [kg/(m^2 s)], total energy [J/m^3]; rho S [Pa kg/m^3] and rho ep, which
/// are carried in conservative form.
struct SolidDensities {
  double mass = 0;
  std::array<double, 3> momentum{};
  double energy = 0;
  Sym3 rho_S{};
  double rho_ep = 0;
};

}  // namespace g27
