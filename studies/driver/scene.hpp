#pragma once
/// A scene as the program runs it: everything checked, in SI.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scheme/step/gas_line.hpp"

namespace g27 {

/// State at (x, t = start).
using InitialState = std::function<GasState<>(double x)>;

struct Probe {
  std::string name;
  double position = 0;  ///< m
};

/// What a run records.
struct OutputPlan {
  std::vector<double> snapshots;  ///< times [s], increasing, within the run
  double history_every = 0;       ///< s; 0: every step
  double threshold = 0;           ///< pressure [Pa] that marks a shock's or a wall's arrival
  std::vector<Probe> probes;
  int map_times = 200;  ///< slices of the x-t map
};

/// One run of a scene: a variant of the scene with one scheme.
struct SceneRun {
  std::string name;     ///< unique within the scene, fit for a file name: "free-field-linear"
  std::string variant;  ///< "free field", "wall at 6 cm"
  std::string scheme;   ///< "godunov", "linear", "parabolic", "muscl"
  GasLineSetup setup;
  InitialState initial;
  double start = 0, end = 0;  ///< s
  OutputPlan output;
};

/// A figure that a run must reproduce.
struct Expectation {
  std::string quantity;  ///< a name of all_quantities()
  std::string variant, probe;
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
  std::vector<SceneRun> runs;
  std::vector<Expectation> expect;
  std::vector<std::string> bare_numbers;  ///< numbers without a unit, taken as SI
};

/// Names in scenes and on the command line, in the order of the enumerations.
std::vector<std::string> const& predictor_names();  ///< godunov linear parabolic muscl
std::vector<std::string> const& switch_names();     ///< off literal binary graded
std::vector<std::string> const& riemann_names();    ///< fast exact hllc
std::vector<std::string> const& feet_names();       ///< conservative corrected-3.10 printed-3.10
std::vector<std::string> const& symmetry_names();   ///< planar cylindrical spherical

}  // namespace g27
