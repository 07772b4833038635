#pragma once
/// States as overset grids exchange them: primitive variables by number, so that one code interpolates both media.
#include <array>

#include "fsi/overset/field_numbers.hpp"
#include "fsi/surface/vec3.hpp"
#include "riemann/eos/registry.hpp"
#include "riemann/solid/material.hpp"
#include "riemann/state/solid_point.hpp"
#include "scheme/kernel/solid_kernels.hpp"

namespace g27 {

using GasFields = std::array<double, gas_field::count>;
using SolidFields = std::array<double, solid_field_of::count>;

/// Axes of a triangle: the normal n, from the solid into the gas, and two more; right-handed, of length 1.
struct Frame {
  Vec3 n{1, 0, 0}, a{0, 1, 0}, b{0, 0, 1};
  [[nodiscard]] Vec3 into(Vec3 const& v) const noexcept { return {dot(v, n), dot(v, a), dot(v, b)}; }
  [[nodiscard]] Vec3 out_of(Vec3 const& v) const noexcept { return v[0] * n + v[1] * a + v[2] * b; }
};

/// Components along the frame's axes of a state given along x, y, z; and back.
GasFields into_frame(Frame const& frame, GasFields const& q) noexcept;
SolidFields into_frame(Frame const& frame, SolidFields const& q) noexcept;
GasFields out_of_frame(Frame const& frame, GasFields const& q) noexcept;
SolidFields out_of_frame(Frame const& frame, SolidFields const& q) noexcept;

/// Conserved densities of a state. Of a solid the energy is the one given.
GasDensities densities_of(AnyEos const& eos, GasFields const& q) noexcept;
SolidDensities densities_of(SolidFields const& q) noexcept;
/// The state of averages.
GasFields fields_of(AnyEos const& eos, GasDensities const& q) noexcept;
SolidFields fields_of(AnySolidEos const& eos, SolidDensities const& q) noexcept;

inline Vec3 velocity_of(GasFields const& q) noexcept { return {q[1], q[2], q[3]}; }
inline Vec3 velocity_of(SolidFields const& q) noexcept { return {q[1], q[2], q[3]}; }

/// rho c^2 of a gas, K of a solid [Pa].
template <class AnyLaw, class Fields>
double bulk_modulus(AnyLaw const& any, Fields const& q) {
  return std::visit([&](auto const& eos) { return eos.bulk_modulus(q[0], q[4]); }, any);
}
/// Modulus of P waves, K + 4 mu/3 [Pa].
inline double p_wave_modulus(AnySolid const& material, SolidFields const& q) {
  return bulk_modulus(material.eos, q) + 4.0 / 3.0 * material.mu;
}

}  // namespace g27
