#pragma once
/// What the factory, the scene reader and `g27 list` know of one parameter of an equation of state.

namespace g27 {

template <class E>
struct EosParameter {
  char const* name;  ///< key in scenes and on the command line
  double E::*member;
  char const* unit;  ///< dimension in SI units: "1" for a pure number
  char const* what;
  double above, up_to;  ///< admissible: above < value <= up_to; `lowest_included`: value >= above
  bool lowest_included = false;
};

}  // namespace g27
