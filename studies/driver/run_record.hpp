#pragma once
/// What one run has produced so far, and all that is needed to continue it.
#include <map>
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

/// Adds what happened in a later piece of a run.
void add(LedgerEntry& total, LedgerEntry const& piece);

/// Where the content of a body, or of the gas outside of all bodies, went. `from_source`: what passed the contact, the
/// impulse and the work of the pressures on the triangles. The residual is what interpolation between the grids and the
/// motion of the surface gained or lost.
struct ContentLedger {
  LedgerEntry mass, energy;
  std::array<LedgerEntry, 3> momentum;
  std::array<LedgerEntry, 3> angular;  ///< of a body, about its centre of mass
};

/// Of model problems at the bodies' triangles.
struct ProblemCounts {
  double solved = 0, first_order = 0, kept = 0;  ///< redone by Godunov's scheme; failed there too and left as they were
  double skipped = 0;                            ///< of bodies that nothing had reached
  double renewed = 0;                            ///< cores of gas that alone would have set the time step
  double untangled = 0,
         tangled = 0;  ///< vertices drawn back where a surface ran through itself; steps when it stayed so
  /// Wall time of the parts of all steps: these problems, the gas's grid, the bodies' grids, where the surfaces are,
  /// and interpolation between the grids [s].
  double local_s = 0, gas_s = 0, bodies_s = 0, geometry_s = 0, interpolation_s = 0;
};

/// The same of a grid. Arrays are [nz][ny][nx]; none once the run has ended.
struct GridRestart {
  double time = 0;
  std::array<std::vector<double>, 5> averages;  ///< mass, momentum, energy
  std::array<std::vector<double>, 3> maps;      ///< switched, cured, repaired
  GridCounters counters;
  GridLedger ledger;                  ///< with bodies: of the gas outside of them
  std::vector<ContentLedger> bodies;  ///< [bodies]
  ProblemCounts problems;
  std::map<std::string, std::vector<double>> overset;  ///< with bodies: what their solver goes on from
};

/// The first phase of a grid's run, on a line.
struct LinePhase {
  std::string ended_by;            ///< "time", "radius", "obstacle", "end"; empty: there was none
  double time = 0, radius = 0;     ///< s, m: when and where the wave was mapped
  double cells = 0, steps = 0;     ///< of the line
  double grid_steps = 0;           ///< that the grid would have made meanwhile, at least
  double wall_s = 0, missing = 0;  ///< what the mapping corrected, relative
};

struct GridRecord {
  GridRestart restart;
  LinePhase line;
  std::vector<double> snapshot_times;             ///< of the states written so far
  std::vector<double> surface_sizes;              ///< [states][bodies][vertices, triangles]
  double cells = 0, cells_stored = 0, bytes = 0;  ///< cells outside blocks; largest number stored, and bytes
  double tiles = 0;
  double seen_updates = 0, seen_skipped = 0;  ///< cell updates up to the last row of the history
  bool begun = false;                         ///< the grid holds the state: past the first phase
};

/// A body at one time: its surface, and fields on its own grid.
struct BodySnapshot {
  std::string name;
  std::vector<double> vertices;            ///< [vertices][3], m
  std::vector<int> triangles;              ///< [triangles][3]
  std::vector<double> velocity, pressure;  ///< of the contact: [triangles][3], m/s; [triangles], Pa
  std::vector<HistoryColumn> fields;       ///< [nz][ny][nx]; 0 where the cell is not of the body
};

/// Fields of a grid at one time, each [nz][ny][nx].
struct GridSnapshot {
  double time = 0;
  std::vector<HistoryColumn> fields;  ///< name, unit, values
  std::vector<BodySnapshot> bodies;
};

struct RunRecord {
  explicit RunRecord(SceneRun const& run);

  std::vector<Snapshot> snapshots;
  SpaceTimeMap map;
  History history;
  Restart restart;
  std::optional<GridRecord> grid;  ///< instead of snapshots, map and restart
  bool complete = false;
  double wall_s = 0;

  [[nodiscard]] double time() const { return grid ? grid->restart.time : restart.time; }
  [[nodiscard]] GasCounters const& counters() const { return grid ? grid->restart.counters : restart.counters; }
  [[nodiscard]] LedgerEntry const& mass() const { return grid ? grid->restart.ledger.mass : restart.ledger.mass; }
  [[nodiscard]] LedgerEntry const& energy() const { return grid ? grid->restart.ledger.energy : restart.ledger.energy; }
};

}  // namespace g27
