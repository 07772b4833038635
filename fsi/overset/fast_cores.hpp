#pragma once
/// Cores of gas that waves cross faster than any cell of the gas's grid.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Cells of the gas's width that waves cross in a unit of time, summed over the axes, seen from the contact [1/s].
double signal_rate(AnyEos const& eos, TriangleState const& t, GasFields const& q, double h);

/// Where gas leaves a surface for near-vacuum, what stays at the wall may lose its density and keep its pressure, until
/// it alone sets the time step. A first core that is crossed more than four times as fast as `fastest`, the largest
/// rate of the grid's cells [1/s], takes the state of the second. Returns how many did.
std::size_t renew_fast_cores(Body& body, double fastest);

}  // namespace g27
