#pragma once
/// What running a scene would cost.
#include "studies/driver/scene.hpp"

namespace g27 {

struct BodyEstimate {
  std::string name;
  double triangles = 0, cells = 0;      ///< cells: of its own grid within it
  double window = 0;                    ///< cells of that grid
  double shortest = 0, longest = 0;     ///< edges, over the cell
  double volume = 0, mass = 0;          ///< unstressed [m^3], [kg]
  double bytes = 0;                     ///< of its arrays
  Vec3 lower{0, 0, 0}, upper{0, 0, 0};  ///< box that it may not leave [m]
  Vec3 from{0, 0, 0}, to{0, 0, 0};      ///< box of the surface at the start [m]
};

struct RunEstimate {
  std::string name;
  std::size_t cells = 0;
  double steps = 0, seconds = 0, bytes = 0;  ///< bytes: of the result files
  double memory = 0;                         ///< bytes of a grid's arrays at the start
  double line_steps = 0;                     ///< of a first phase on a line
  std::vector<BodyEstimate> bodies;
};

/// Throws InputError for a grid that cannot fit into the machine: every tile is stored when nothing is skipped; of
/// quiet scenes most may never be.
void require_memory(Scene const& scene);

/// Of the bodies of a run.
std::vector<BodyEstimate> body_estimates(SceneRun const& run);

/// Takes the first steps of every run, at most `budget_s` each, and extrapolates. Steps grow or shrink with the sound
/// speed, so the estimate is good to a factor of about two.
std::vector<RunEstimate> estimate(Scene const& scene, double budget_s = 0.1);

}  // namespace g27
