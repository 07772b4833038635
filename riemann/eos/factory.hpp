#pragma once
/// Equations of state by name, for the scene reader, the command line and `g27 list`.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "riemann/eos/registry.hpp"

namespace g27 {

struct EosParameterInfo {
  std::string name, unit, what;  ///< unit: dimension in SI units, "1" for a pure number
  double default_value = 0;
  double lowest = 0, highest = 0;  ///< admissible: lowest < value <= highest, or lowest <= value if `lowest_included`
  bool lowest_included = false;
};

/// Names of every equation of state, in the order of the registry.
std::vector<std::string> eos_names();

/// One line on the law. Throws std::invalid_argument for an unknown name.
std::string eos_title(std::string_view name);

/// Parameters of the equation of state, in the order of its struct. Throws std::invalid_argument for an unknown name.
std::vector<EosParameterInfo> eos_parameters(std::string_view name);

/// The equation of state `name` with every parameter given [SI]. Throws std::invalid_argument saying which parameter is
/// missing, unknown (with the nearest known one) or out of range, or why the parameters do not go together.
AnyEos make_eos(std::string_view name, std::map<std::string, double> const& parameters);

/// The name of the law held.
std::string eos_name(AnyEos const& eos);

/// Its parameters [SI], by name.
std::map<std::string, double> eos_values(AnyEos const& eos);

}  // namespace g27
