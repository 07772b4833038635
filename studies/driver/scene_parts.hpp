#pragma once
/// The parts of a scene, each read by one function from its section. All throw InputError.
#include "scheme/step/lighting_times.hpp"
#include "studies/driver/scene.hpp"
#include "studies/driver/section.hpp"

namespace g27 {

/// [material.NAME] eos = { type = ..., parameters }.
AnyEos read_eos(Section const& root);

/// A material with strength.
struct Solid {
  AnySolid law;
  double density = 0;  ///< unstressed [kg/m^3]
  bool rigid = false;  ///< without a law
};
/// The one that a [[body]] names.
Solid read_solid(Section const& root, Section const& body);
/// State without deviatoric stress at a pressure [Pa]: compressed where the law is p(rho), else of the given density.
SolidPoint solid_at_rest(Solid const& solid, double pressure);

/// [domain] extent with cells or cell, and mesh: positions of the faces.
std::vector<double> read_faces(Section const& domain);
/// [domain] motion.
MeshMotion read_motion(Section const& domain, double left, double right);
/// [domain] boundary.left or .right.
GasBoundary read_boundary(Section const& domain, std::string const& side, AnyEos const& eos);

/// A charge: burnt, as the detonation wave from its centre reaches its surface, or unburnt at time 0, when it is lit.
struct Charge {
  double radius = 0, begin = 0;           ///< m, s since ignition
  Vec3 centre{0, 0, 0};                   ///< m; on a grid
  InitialState state;                     ///< at `begin`, over the distance to the centre
  ProgrammedBurn burn{};                  ///< of an unburnt one
  std::vector<IgnitionPoint> ignition{};  ///< where an unburnt one is lit
  std::vector<Obstacle> obstacles{};      ///< shapes in it without explosive
  bool central = true;                    ///< lit at its centre alone, and without obstacles
  Section section;
};
/// `dimensions` of the mesh: on a grid of 2 or 3 a charge has a `center`.
std::vector<Charge> read_charges(Section const& root, AnyEos const& eos, Symmetry symmetry, int dimensions = 1);

/// Where the cells do not hold the charge's mass to 5 %, says how much they hold: the centres of a grid's cells decide
/// on what is unburnt, a line has the state at a few points of each cell. Of a grid, `shape` is what the charge fills.
std::vector<std::string> mass_remarks(Charge const& charge, Symmetry symmetry, std::vector<double> const& faces);
std::vector<std::string> mass_remarks(Charge const& charge, std::function<double(Vec3 const&)> const& shape,
                                      GasGridSetup const& grid);

struct InitialData {
  InitialState state;
  std::optional<Charge> charge;
};
/// [ambient], [[region]], [[charge]] and [initial] over the cells between the faces.
InitialData read_initial(Section const& root, AnyEos const& eos, Symmetry symmetry, std::vector<double> const& faces);

/// [scheme]: one set of options a scheme asked for.
std::vector<GasSchemeOptions> read_schemes(Section const& root, double cfl);
std::vector<GridSchemeOptions> read_grid_schemes(Section const& root, double cfl, int dimensions);
/// [scheme] closure and remeshing.
void read_scheme_of_bodies(Section const& root, GridRun& grid);
/// Bodies know the schemes of first and second order, and the sum rule for the time step.
void check_schemes_of_bodies(Section const& root, GridSchemeOptions const& options, double body_cfl);

/// Where probes may lie: the corners of the domain, in its first `dimensions` entries, and the names of the bodies.
struct Extent {
  Vec3 lower{0, 0, 0}, upper{0, 0, 0};
  int dimensions = 1;
  std::vector<std::string> bodies{};
};
/// [output], for a run from `start` to `end`.
OutputPlan read_output(Section const& root, double start, double end, Extent const& extent);
/// Snapshots after `latest` are a slip: no run of the scene gets there.
void check_snapshots(Section const& root, int dimensions, double latest);

/// Throws for a probe that lies in the domain of no run.
void check_probes_seen(Section const& root, std::vector<SceneRun> const& runs);

/// [[expect]] of the runs of a scene.
std::vector<Expectation> read_expectations(Section const& root, std::vector<std::string> const& variants,
                                           std::vector<SceneRun> const& runs);

/// `keys` and those of a state: material, density, velocity, pressure.
std::vector<std::string> with_state_keys(std::vector<std::string> keys);
/// Density, velocity, pressure of a section, checked admissible for `eos`.
GasState<> read_state(Section const& section, AnyEos const& eos);
/// Throws through `where` unless density > 0 and the pressure margin > 0.
void check_admissible(Section const& where, AnyEos const& eos, GasState<> const& state);

}  // namespace g27
