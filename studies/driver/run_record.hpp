#pragma once
/// What one run has produced so far, and all that is needed to continue it.
#include <string>
#include <vector>

#include "studies/driver/history.hpp"
#include "studies/driver/scene.hpp"

namespace g27 {

struct Snapshot {
  double time = 0;                                         ///< s
  std::vector<double> faces, density, velocity, pressure;  ///< [cells + 1], then [cells]; SI
};

/// Pressure and density over position and time, thinned for drawing.
struct SpaceTimeMap {
  std::vector<double> time;                  ///< [slices]
  std::vector<double> x, density, pressure;  ///< [slices][points]
  std::size_t points = 0;
};

/// Cell averages of the conserved densities, the mesh, and the totals since the start.
struct Restart {
  double time = 0;
  std::vector<double> faces, mass, momentum, energy, switched;
  GasCounters counters;
  GasLedger ledger;
};

struct RunRecord {
  explicit RunRecord(SceneRun const& run) : history(run.output) {}

  std::vector<Snapshot> snapshots;
  SpaceTimeMap map;
  History history;
  Restart restart;
  bool complete = false;
  double wall_s = 0;
};

}  // namespace g27
