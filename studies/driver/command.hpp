#pragma once
/// The commands of the program. Each takes its parsed arguments, prints its result on stdout and returns the exit
/// status: 0, or 1 when a claim fails or a run fails numerically. Mistakes of the user throw InputError (status 2).
#include <optional>
#include <string>
#include <vector>

namespace g27 {

struct RunArguments {
  std::string scene = "three-cubes-quick", out;
  std::vector<std::string> set;
  int threads = 0;  ///< 0: as many as the machine has
  bool json = false, resume = false, figures = true;
  double checkpoint_s = 30;
};
int command_run(RunArguments const& arguments);

struct CheckArguments {
  std::string scene;
  std::vector<std::string> set;
  bool json = false;
};
int command_check(CheckArguments const& arguments);

struct CaseArguments {
  std::string name;
  std::optional<int> cells, order;
  std::optional<double> cfl;
  std::optional<std::string> monotonicity, mesh, eos, scheme, feet, riemann;
  std::optional<std::string> transverse, cure, skip;
  std::optional<int> threads;
  std::vector<int> tile;         ///< empty, or cells along each axis
  std::vector<std::string> set;  ///< key=value
  bool json = false;
};
int command_case(CaseArguments const& arguments);
/// Title and parameters of the case named, if one is; throws InputError where there is none of that name.
std::string help_of(CaseArguments const& arguments);

struct StudyArguments {
  std::string name, out;
  bool json = false;
};
int command_study(StudyArguments const& arguments);

struct ExactArguments {
  std::string name;
  std::vector<std::string> values;  ///< key=value
  bool json = false;
};
int command_exact(ExactArguments const& arguments);
/// What it solves, its source and its keys, if one is named; throws InputError where there is none of that name.
std::string help_of(ExactArguments const& arguments);

struct FigureArguments {
  std::string name, out = "results/figures";
  std::vector<std::string> from;
  // of figures of the paper:
  std::vector<std::string> set;
  std::string scene;          ///< empty, or instead of the one it needs
  std::vector<double> grids;  ///< cell widths over the scene's; empty: 1
  int threads = 0;            ///< 0: as many as the machine has
  bool cached = false;        ///< results of another build are taken
};
int command_figure(FigureArguments const& arguments);

struct BenchArguments {
  std::string name;  ///< empty: every benchmark
  int cells = 0, threads = 1;
  bool json = false;
};
int command_bench(BenchArguments const& arguments);

struct StlArguments {
  std::string file, make, unit;       ///< a file or a shape; unit of the files, empty: metre
  std::vector<std::string> set;       ///< key=value of the shape
  std::string density, cell, remesh;  ///< quantities, or empty
  std::string repair_out, out;        ///< files to write, or empty
  bool json = false;
};
int command_stl(StlArguments const& arguments);

struct ListArguments {
  std::string kind;  ///< empty: everything
  bool json = false;
};
int command_list(ListArguments const& arguments);

/// Parses the command line and runs the command; maps errors to messages on stderr and to the exit status.
int run_program(int argc, char** argv);

}  // namespace g27
