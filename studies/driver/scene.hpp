#pragma once
/// A scene as the program runs it: everything checked, in SI.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fsi/overset/body.hpp"
#include "scheme/step/gas_grid.hpp"

namespace g27 {

/// State at (x, t = start).
using InitialState = std::function<GasState<>(double x)>;

/// Mean of the conserved densities at the start over the cell with this centre and these widths.
using GridInitial = std::function<GasDensities(Vec3 const& centre, Vec3 const& widths)>;

struct Probe {
  std::string name;
  Vec3 position{0, 0, 0};  ///< m; a line's in the first entry
};

/// Follows the triangles of a body that faced one way at the start.
struct BodyProbe {
  std::string name;
  std::size_t body = 0;  ///< in the run's bodies
  std::size_t axis = 0;  ///< of the outward normal
  double sign = 1;
};

/// What a run records.
struct OutputPlan {
  std::vector<double> snapshots;  ///< times [s], increasing, within the run
  double history_every = 0;       ///< s; 0: every step
  double threshold = 0;           ///< pressure [Pa] that marks a shock's or a wall's arrival
  std::vector<Probe> probes;
  std::vector<BodyProbe> body_probes;
  int map_times = 200;               ///< slices of a line's x-t map
  Vec3 origin{0, 0, 0};              ///< of a grid: where the rays that measure shock radii start
  bool repairs = false;              ///< of a grid: how often switch, cure and repair acted in each cell
  std::vector<std::string> remarks;  ///< on probes that see no gas at the start, and on the charge's mass
};

/// A first phase on a line, for data that are symmetric about a centre; then mapped onto the grid.
struct LineStart {
  GasLineSetup setup;
  std::vector<GasConserved<>> averages;
  Vec3 centre{0, 0, 0};
  double earliest = -1e300;  ///< s; the phase goes on until then: a mixture of unburnt explosive and air is no state
  double until = 1e300;      ///< s
  double radius = 1e300;     ///< m; the phase ends as soon as one of the two is reached
  double clearance = 0;  ///< distance of the centre to the nearest obstacle: the phase ends before the wave gets there
};

/// A body in the gas.
struct SceneBody {
  std::string name, key;             ///< "top", "body.0"
  std::string file;                  ///< of its surface, as the scene names it
  std::uint64_t fingerprint = 0;     ///< of that file's bytes
  std::vector<std::string> remarks;  ///< what was repaired, and whether it was meshed anew
  double density = 0;                ///< unstressed [kg/m^3]
  TriangleSurface whole;             ///< before planes of symmetry cut it
  Mirrors cut;                       ///< those planes
  BodySetup setup;
};

/// What a run on a grid of two or three dimensions has in the place of a line's setup.
struct GridRun {
  GasGridSetup setup;
  GridInitial initial;
  std::optional<LineStart> line;
  std::vector<SceneBody> bodies;
  std::function<GasPoint(Vec3 const& x)> point{};  ///< of a run with bodies: the state at the start
  double cfl = 0, body_cfl = 0;                    ///< of runs with bodies: of the gas, of the solids; 0: chosen
  bool closure = false;                            ///< momentum of bodies is what the pressures gave them
  bool remeshing = true;                           ///< surfaces of bodies are meshed anew where triangles grow bad
};

/// One run of a scene: a variant of the scene with one scheme.
struct SceneRun {
  std::string name;             ///< unique within the scene, fit for a file name: "free-field-linear"
  std::string variant;          ///< "free field", "wall at 6 cm"
  std::string scheme;           ///< "godunov", "linear", "parabolic", "muscl"
  GasLineSetup setup;           ///< of a line
  InitialState initial;         ///< of a line
  std::optional<GridRun> grid;  ///< two or three dimensions: instead of these two
  double start = 0, end = 0;    ///< s
  OutputPlan output;

  [[nodiscard]] AnyEos const& eos() const { return grid ? grid->setup.eos : setup.eos; }
  /// Dimensions of the mesh: 1, 2 or 3.
  [[nodiscard]] int dimensions() const { return !grid ? 1 : grid->setup.cells[2] > 1 ? 3 : 2; }
  [[nodiscard]] std::size_t cells() const;
  void set_threads(int threads);
};

/// A figure that a run must reproduce.
struct Expectation {
  std::string quantity;  ///< a name of all_quantities()
  std::string variant, probe, body, axis;
  std::vector<std::string> schemes;           ///< judged; the others are shown
  std::optional<double> time, after, window;  ///< s; `after`: since arrival
  double value = 0, tolerance = 0;            ///< SI; the tolerance is absolute
  std::string unit;                           ///< in which it was written
  double unit_si = 1;                         ///< SI value of that unit
  std::string source;
  bool judged = true;  ///< false: shown beside the measured values, no verdict
};

struct Scene {
  std::filesystem::path file;
  std::string name, title, source, text;  ///< text: verbatim
  std::vector<std::string> overrides;     ///< of --set
  std::string digest;                     ///< of all that determines its results (scene_digest.hpp)
  std::vector<SceneRun> runs;
  std::vector<Expectation> expect;
  std::vector<std::string> bare_numbers;  ///< numbers without a unit, taken as SI
};

/// What the user should know before a run: of surfaces and probes; each once.
std::vector<std::string> remarks_on(Scene const& scene);

/// Names in scenes and on the command line, in the order of the enumerations.
std::vector<std::string> const& predictor_names();   ///< godunov linear parabolic muscl
std::vector<std::string> const& switch_names();      ///< off literal binary graded
std::vector<std::string> const& riemann_names();     ///< fast exact hllc
std::vector<std::string> const& feet_names();        ///< conservative corrected-3.10 printed-3.10
std::vector<std::string> const& symmetry_names();    ///< planar cylindrical spherical
std::vector<std::string> const& transverse_names();  ///< own-cell averaged none
std::vector<std::string> const& side_names();        ///< x_low x_high y_low y_high z_low z_high
std::vector<std::string> const& ray_names();         ///< x y z diagonal
std::vector<std::string> const& face_names();        ///< -x +x -y +y -z +z

}  // namespace g27
