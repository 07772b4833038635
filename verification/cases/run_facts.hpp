#pragma once
/// What every result of a case says about its run: names of the scheme's parts, and the time it took.
#include "scheme/step/gas_options.hpp"

namespace g27 {

int order_of(Predictor p) noexcept;  ///< formal order on smooth flow
char const* name_of(Predictor p) noexcept;
char const* name_of(Switch s) noexcept;

/// CPU time of the process, all threads [s].
double cpu_seconds() noexcept;

}  // namespace g27
