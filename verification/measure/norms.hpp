#pragma once
/// How far cell values are from a reference: norms, total variation, overshoot. All spans are as long as the grid.
#include <span>

#include "verification/cases/case.hpp"

namespace g27 {

/// L1 = sum |e| V/sum V, L2 = sqrt(sum e^2 V/sum V), Linf = max |e|, with e the difference of the cell averages and V
/// the cells' measures. Throws std::invalid_argument for lengths that differ. A value that is not finite gives NaN.
Norms norms(std::span<double const> value, std::span<double const> reference, std::span<double const> measure);

/// Sum of |differences of neighbours|; with `periodic`, also of the last and the first.
double total_variation(std::span<double const> value, bool periodic = false);

/// Total variation over the reference's, minus 1; of a flat reference, the variation over its largest magnitude.
double tv_excess(std::span<double const> value, std::span<double const> reference, bool periodic = false);

/// Farthest that values lie beyond [min, max] of the reference, over max - min (over |max| for a flat reference).
double overshoot(std::span<double const> value, std::span<double const> reference);

}  // namespace g27
