#pragma once
/// Five-point Gauss-Legendre rule on [0, 1]: exact for polynomials of degree 9 (Abramowitz and Stegun, 25.4.30).
#include <array>

namespace g27 {

inline constexpr std::array<double, 5> gauss5_node{0.046910077030668004, 0.23076534494715846, 0.5, 0.76923465505284154,
                                                   0.95308992296933200};
inline constexpr std::array<double, 5> gauss5_weight{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                     0.23931433524968324, 0.11846344252809454};

}  // namespace g27
