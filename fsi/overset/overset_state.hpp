#pragma once
/// What a solver of gas and bodies holds between two steps, as arrays by name: to be stored, and to go on from.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fsi/overset/closure.hpp"
#include "fsi/surface/local_remesh.hpp"

namespace g27 {

struct OversetCounters {
  std::uint64_t steps = 0, problems = 0;  ///< model problems solved
  std::uint64_t skipped = 0;              ///< model problems of bodies that nothing had reached
  std::uint64_t first_order = 0;          ///< of them redone by Godunov's scheme
  std::uint64_t failed = 0;               ///< of those kept as they were
  std::uint64_t renewed = 0;              ///< cores of gas, see fast_cores.hpp
  LocalRemeshCounts remeshing{};
  std::uint64_t untangled = 0;  ///< vertices moved where a surface had run through itself
  std::uint64_t tangled = 0;    ///< steps of a body after which it still did
  double seconds_local = 0, seconds_gas = 0, seconds_solid = 0, seconds_geometry = 0, seconds_fill = 0;
};

/// Arrays by name, [SI]: "gas/mass" [cells, x fastest], "body/0/vertices" [vertices x 3], "clock", ...
struct OversetState {
  std::map<std::string, std::vector<double>> arrays;

  /// Throws std::out_of_range for a name that is not there.
  [[nodiscard]] std::vector<double> const& at(std::string const& name) const { return arrays.at(name); }
};

struct OversetClock {
  double time = 0, last_dt = 0;  ///< [s]
  OversetCounters counters;
};

void save_gas(GasGrid const& gas, OversetState& out);
void restore_gas(OversetState const& from, GasGrid& gas);

/// Of body `n`. Cells' kinds and clouds are not stored: they follow from the surface and the triangles. Restoring
/// throws std::invalid_argument for a body whose grids are others.
void save_body(Body const& body, BodyMomentum const& held, std::size_t n, OversetState& out);
BodyMomentum restore_body(OversetState const& from, std::size_t n, Body& body);

void save_clock(OversetClock const& clock, OversetState& out);
OversetClock clock_of(OversetState const& from);

}  // namespace g27
