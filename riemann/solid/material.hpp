#pragma once
/// A solid: its equation of state and its strength. To add a law: its header, and its type in this list.
#include <cmath>
#include <limits>
#include <variant>

#include "riemann/base/type_list.hpp"
#include "riemann/eos/bulk_modulus.hpp"
#include "riemann/eos/mie_gruneisen.hpp"
#include "riemann/eos/stiffened_gas.hpp"
#include "riemann/solid/law.hpp"

namespace g27 {

using SolidEosList = TypeList<BulkModulus, MieGruneisen, StiffenedGas>;
using AnySolidEos = SolidEosList::Variant;

struct AnySolid {
  AnySolidEos eos{};
  double mu = 80.77e9;                                  ///< shear modulus [Pa]; 0: a fluid
  double Y0 = std::numeric_limits<double>::infinity();  ///< yield stress [Pa]; infinite or <= 0: elastic
  double H = 0;                                         ///< linear hardening: Y = Y0 + H ep [Pa]

  [[nodiscard]] bool plastic() const noexcept { return Y0 > 0 && std::isfinite(Y0); }
};

}  // namespace g27
