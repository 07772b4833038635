#pragma once
/// What running a scene would cost.
#include "studies/driver/scene.hpp"

namespace g27 {

struct RunEstimate {
  std::string name;
  std::size_t cells = 0;
  double steps = 0, seconds = 0, bytes = 0;  ///< bytes: of the result files
  double memory = 0;                         ///< bytes of a grid's arrays at the start
  double line_steps = 0;                     ///< of a first phase on a line
};

/// Throws InputError for a grid that cannot fit into the machine: every tile is stored when nothing is skipped; of
/// quiet scenes most may never be.
void require_memory(Scene const& scene);

/// Takes the first steps of every run, at most `budget_s` each, and extrapolates. Steps grow or shrink with the sound
/// speed, so the estimate is good to a factor of about two.
std::vector<RunEstimate> estimate(Scene const& scene, double budget_s = 0.1);

}  // namespace g27
