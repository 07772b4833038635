#pragma once
/// Density errors of an independent implementation of the same schemes (other code, scalar, another Riemann solver):
/// what the study is held against.
#include <optional>
#include <string>

namespace g27 {

struct RecordedError {
  double value;   ///< density L1 over Godunov's, or [kg/m^3] where `absolute`
  double margin;  ///< by how much the study may exceed it
  bool absolute;
};

/// The record of a scheme on a row of the study (uniform mesh, CFL 0.8); empty where there is none.
std::optional<RecordedError> recorded_error(std::string const& problem, std::string const& scheme);

}  // namespace g27
