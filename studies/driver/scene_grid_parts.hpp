#pragma once
/// The parts of a scene on a grid of two or three dimensions, each read by one function. All throw InputError.
#include "scheme/step/map_line_to_grid.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {

/// [domain] extent is a list of intervals.
bool is_grid(Section const& domain);

/// [domain] extent with cells or cell.
GridBox read_box(Section const& domain);
int dimensions_of(GridBox const& box);

/// [domain] boundary: every side's condition, in the order of Side.
std::array<GridBoundary, 6> read_sides(Section const& domain, AnyEos const& eos, int dimensions);
/// [[domain.patch]].
std::vector<BoundaryPatch> read_patches(Section const& domain, AnyEos const& eos, GridBox const& box);
/// [[block]]: boxes rounded to whole cells.
std::vector<SolidBlock> read_blocks(Section const& root, GridBox const& box);
std::vector<std::array<double, 2>> extent_of(SolidBlock const& block, GridBox const& box);
double distance_to_block(SolidBlock const& block, GridBox const& box, Vec3 const& x);

/// Distance to a surface, no more than the true one; < 0 inside.
using Distance = std::function<double(Vec3 const&)>;
Distance distance_to_box(std::vector<std::array<double, 2>> const& extent);
/// shape = "sphere", ... with its keys; and those of all shapes.
Distance read_shape(Section const& any, int dimensions);
std::vector<std::string> shape_keys();

/// Part of space with a state of its own.
struct GridRegion {
  std::string kind;  ///< "ambient", "box", "sphere", "charge", ...
  Distance distance{};
  std::function<GasPoint(Vec3 const&)> state{};  ///< inside
  bool uniform = true;                           ///< the state is the same everywhere
  bool whole_cells = false;                      ///< a cell is of it wholly or not at all, by its centre
  Vec3 centre{0, 0, 0};                          ///< of a sphere
  double radius = 0;
  InitialState radial{};  ///< of a sphere: the state over the distance to its centre
  Section section;
};
struct GridRegions {
  std::vector<GridRegion> list;  ///< the first is the ambient; later ones lie over earlier ones
  std::optional<Charge> charge;
};
/// [ambient], [[region]] and [[charge]].
GridRegions read_regions(Section const& root, AnyEos const& eos, int dimensions);
/// Throws where one of them, or an obstacle of the charge, is beside the grid or between the centres of its cells, and
/// where the blocks leave no cell.
void check_covers(GridRegions const& regions, std::vector<SolidBlock> const& blocks, GridBox const& box);
/// obstacle = [{ shape = ... }, ...] of a charge.
std::vector<Obstacle> read_obstacles(Section const& charge, double radius, int dimensions);
/// The burn of a charge. The front goes around its obstacles and the grid's blocks.
ProgrammedBurn burn_around(Charge const& charge, GasGridSetup const& grid);

/// Cell averages: cells that a surface may cut by their mean over 8^3 (16^2) points, those whose state
/// varies over 4^3 (4^2).
GridInitial make_initial(std::vector<GridRegion> regions, AnyEos const& eos, int dimensions);

/// The same at a point: the state of the topmost region there.
std::function<GasPoint(Vec3 const&)> make_point_initial(std::vector<GridRegion> regions);

/// [[body]]: placed, meshed, cut by sides that are planes of symmetry, and checked. `point`: the gas's state at the
/// start.
std::vector<SceneBody> read_bodies(Section const& root, GasGridSetup const& gas,
                                   std::function<GasPoint(Vec3 const&)> const& point);
/// clamped = ["y_low", ...] of a body that these planes cut.
Clamps read_clamps(Section const& body, Mirrors const& cut, bool rigid);
/// Gas cells that a body keeps from the sides of the domain, and from other bodies.
inline constexpr double side_gap_cells = 3, body_gap_cells = 1;

/// [start]: a first phase in one dimension.
std::optional<LineStart> read_line_start(Section const& root, GridRegions const& regions, GridRun const& grid,
                                         double start, double end);

/// Density, velocity (a list, by default at rest) and pressure, checked admissible.
GasPoint read_point_state(Section const& section, AnyEos const& eos, int dimensions);
/// Conserved densities of a state.
GasDensities densities(AnyEos const& eos, GasPoint const& state);
/// A direction of length 1.
Vec3 read_normal(Section const& section, int dimensions);

}  // namespace g27
