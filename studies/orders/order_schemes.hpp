#pragma once
/// The schemes that every order study compares.
#include <array>

#include "scheme/step/gas_options.hpp"

namespace g27 {

struct OrderScheme {
  char const* name;
  Predictor predictor;
  Switch monotonicity;
};

inline constexpr std::array<OrderScheme, 5> order_schemes{{{"godunov", Predictor::godunov, Switch::off},
                                                           {"linear, off", Predictor::linear, Switch::off},
                                                           {"linear, graded", Predictor::linear, Switch::graded},
                                                           {"parabolic, off", Predictor::parabolic, Switch::off},
                                                           {"parabolic, on", Predictor::parabolic, Switch::graded}}};

}  // namespace g27
