#pragma once
/// Density errors that an independent implementation of the same schemes gave: what the study is held against.
#include <optional>
#include <string>

namespace g27 {

struct RecordedError {
  double value;     ///< density L1 over Godunov's, or [kg/m^3] where `absolute`
  double rounding;  ///< what the last digit on record leaves open
  bool absolute;
};

/// The record of a scheme on a problem, uniform mesh of 200 cells, CFL 0.8; empty where there is none.
std::optional<RecordedError> recorded_error(std::string const& problem, std::string const& scheme);

}  // namespace g27
