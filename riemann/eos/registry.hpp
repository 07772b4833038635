#pragma once
/// Every equation of state. To add one: its header, and its type in this list.
#include <variant>

#include "riemann/base/type_list.hpp"
#include "riemann/eos/ideal_gas.hpp"
#include "riemann/eos/jwl.hpp"
#include "riemann/eos/mie_gruneisen.hpp"
#include "riemann/eos/stiffened_gas.hpp"

namespace g27 {

using EosList = TypeList<IdealGas, StiffenedGas, Jwl, MieGruneisen>;
using AnyEos = EosList::Variant;

}  // namespace g27
