#include <fmt/format.h>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/nearest_key.hpp"
#include "studies/driver/provenance.hpp"
#include "studies/driver/python.hpp"

namespace g27 {
namespace {

constexpr int bad_input = 2;

std::string version_text() {
  auto const facts = build_facts();
  return fmt::format("g27 {} ({}), {} {}", facts.version, facts.commit, facts.compiler, facts.build_type);
}

void json_flag(CLI::App* command, bool& json) {
  command->add_flag("--json", json,
                    "print one JSON object on stdout and nothing else there; what fails has the key error");
}

/// An empty name would be the current folder.
std::string not_empty(std::string const& text) { return text.empty() ? "needs the name of a folder" : ""; }

/// CLI::Range lets nan pass.
std::string a_number(std::string const& text) { return text == "nan" || text == "-nan" ? "needs a number" : ""; }

/// Each command shares its arguments with the action that CLI11 keeps.
template <class Arguments>
CLI::App* add_command(CLI::App& app, std::string const& name, std::string const& what, int (*command)(Arguments const&),
                      std::shared_ptr<Arguments> const& arguments, int& status) {
  CLI::App* sub = app.add_subcommand(name, what);
  sub->callback([=, &status] { status = command(*arguments); });
  return sub;
}

void add_run(CLI::App& app, int& status) {
  auto const a = std::make_shared<RunArguments>();
  auto* sub = add_command(app, "run", "run a scene, write its results and judge them", command_run, a, status);
  sub->add_option("scene", a->scene, "path, or name in studies/scenes")->capture_default_str();
  sub->add_option(
         "--out", a->out,
         "folder of the results (default: results/SCENE); those of a run before it stay in its folder 'earlier' "
         "until this one is complete")
      ->check(not_empty);
  sub->add_option("--set", a->set, "override a key: domain.cells=400")->allow_extra_args(false);
  sub->add_option("--threads", a->threads, "default: all of the machine")->check(CLI::Range(1, 1024));
  sub->add_flag("--resume", a->resume, "continue from the last checkpoint in the folder");
  sub->add_option("--checkpoint", a->checkpoint_s, "seconds between checkpoints")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9))
      ->check(a_number);
  sub->add_flag("!--no-figures", a->figures, "draw nothing");
  json_flag(sub, a->json);
}

void add_check(CLI::App& app, int& status) {
  auto const a = std::make_shared<CheckArguments>();
  auto* sub = add_command(app, "check", "read a scene and say what would be computed", command_check, a, status);
  sub->add_option("scene", a->scene, "path, or name in studies/scenes")->required();
  sub->add_option("--set", a->set, "override a key: domain.cells=400")->allow_extra_args(false);
  json_flag(sub, a->json);
}

void add_case(CLI::App& app, int& status) {
  auto const a = std::make_shared<CaseArguments>();
  auto* sub = add_command(app, "case", "run a verification case and print its errors", command_case, a, status);
  sub->add_option("name", a->name, "see: g27 list cases; with --help, its parameters")->required();
  sub->add_option("--cells", a->cells, "number of cells; of a grid, along its longest axis")
      ->check(CLI::Range(4, 50'000'000));
  auto* order = sub->add_option("--order", a->order, "1 Godunov, 2 linear, 3 parabolic")->check(CLI::Range(1, 3));
  sub->add_option("--scheme", a->scheme, "godunov, linear, parabolic or muscl")->excludes(order);
  sub->add_option("--switch", a->monotonicity, "on, off, graded, binary or literal");
  sub->add_option("--cfl", a->cfl, "Courant number, above 0 and up to 1");
  sub->add_option("--mesh", a->mesh,
                  "uniform, graded, alternating, random, moving or moving-random; of a grid, fixed or frame");
  sub->add_option("--eos", a->eos, "equation of state, where the case has a choice");
  sub->add_option("--feet", a->feet, "conservative, corrected-3.10 or printed-3.10");
  sub->add_option("--riemann", a->riemann, "fast, exact or hllc");
  sub->add_option("--threads", a->threads, "number of threads (default: 1)")->check(CLI::Range(1, 1024));
  sub->add_option("--set", a->set, "a parameter of the case: mach=5")->allow_extra_args(false);
  sub->add_option("--transverse", a->transverse, "of a grid: own-cell, averaged or none");
  sub->add_option("--cure", a->cure, "of a grid, of shocks along it: on or off");
  sub->add_option("--skip", a->skip, "of a grid, tiles where nothing happens: on or off");
  sub->add_option("--tile", a->tile, "of a grid: cells of a tile along x, y and z")->expected(3);
  sub->footer([a] { return help_of(*a); });
  json_flag(sub, a->json);
}

void add_study(CLI::App& app, int& status) {
  auto const a = std::make_shared<StudyArguments>();
  auto* sub = add_command(app, "study", "run a study: table, figure and verdict", command_study, a, status);
  sub->add_option("name", a->name, "see: g27 list studies")->required();
  sub->add_option("--out", a->out, "folder of the results (default: results/studies/NAME)")->check(not_empty);
  json_flag(sub, a->json);
}

void add_exact(CLI::App& app, int& status) {
  auto const a = std::make_shared<ExactArguments>();
  auto* sub = add_command(app, "exact", "evaluate an exact solution", command_exact, a, status);
  sub->add_option("name", a->name, "see: g27 list exact; with --help, its keys")->required();
  sub->add_option("values", a->values, "key=value ...");
  sub->footer([a] { return help_of(*a); });
  json_flag(sub, a->json);
}

void add_figure(CLI::App& app, int& status) {
  auto const a = std::make_shared<FigureArguments>();
  auto* sub =
      add_command(app, "figure", "draw a figure; those of the paper compute what they need", command_figure, a, status);
  sub->add_option("name", a->name, "see: g27 list figures; gallery: a page of all that have results")->required();
  sub->add_option("--from", a->from,
                  "HDF5 file or folder of results, or several (default: where the study or scene wrote them)")
      ->allow_extra_args(false);
  sub->add_option("--out", a->out, "folder of the figure")->capture_default_str()->check(not_empty);
  sub->add_option("--set", a->set, "of a figure of the paper, overrides a key of every scene: time.end='9 us'")
      ->allow_extra_args(false);
  sub->add_option("--scene", a->scene, "of a figure of the paper, instead of the scene it needs");
  sub->add_option("--grids", a->grids, "of a figure of the paper, cells of these widths over the scene's: 1,1.5,2")
      ->delimiter(',')
      ->check(CLI::Range(0.01, 100.0))
      ->check(a_number);
  sub->add_option("--threads", a->threads, "default: all of the machine")->check(CLI::Range(1, 1024));
  sub->add_flag("--cached", a->cached, "takes results of another build as they are");
}

void add_bench(CLI::App& app, int& status) {
  auto const a = std::make_shared<BenchArguments>();
  auto* sub = add_command(app, "bench", "measure rates beside a yardstick of the machine", command_bench, a, status);
  sub->add_option("name", a->name, "see: g27 list benchmarks (default: all)");
  sub->add_option("--cells", a->cells, "number of cells")->check(CLI::Range(4, 50'000'000));
  sub->add_option("--threads", a->threads, "number of threads")->capture_default_str()->check(CLI::Range(1, 1024));
  json_flag(sub, a->json);
}

void add_list(CLI::App& app, int& status) {
  auto const a = std::make_shared<ListArguments>();
  auto* sub = add_command(app, "list", "list what there is", command_list, a, status);
  sub->add_option("kind", a->kind, "scenes, cases, studies, exact, eos, schemes, figures or benchmarks");
  json_flag(sub, a->json);
}

void add_stl(CLI::App& app, int& status) {
  auto const a = std::make_shared<StlArguments>();
  auto* sub = add_command(app, "stl", "examine, repair, remesh or make the surface of a body", command_stl, a, status);
  auto* file = sub->add_option("file", a->file, "STL file, binary or ASCII");
  sub->add_option("--make", a->make, "box, cube, cylinder, disc, plate, sphere or tetrahedron instead of a file")
      ->excludes(file);
  sub->add_option("--set", a->set, "a length of the shape: side='1 cm'")->allow_extra_args(false);
  sub->add_option("--unit", a->unit, "unit of the files' coordinates (default: m; STL files state none)");
  sub->add_option("--density", a->density, "for mass and inertia: '7.8 g/cm3'");
  sub->add_option("--cell", a->cell, "cell size of the body's grid, to judge the edges by: '0.07 cm'");
  sub->add_option("--repair", a->repair_out, "repair what is safe to repair and write this file");
  sub->add_option("--remesh", a->remesh, "mesh anew with edges of this length: '0.07 cm'");
  sub->add_option("--out", a->out, "file of the shape made, or of the surface remeshed");
  json_flag(sub, a->json);
}

void add_test(CLI::App& app) {
  auto* sub = app.add_subcommand("test", "build and run the tests: ./g27 test [arguments of ctest]");
  sub->allow_extras();
  sub->callback(
      [] { throw InputError("g27", "test", "is a command of the launcher", "run ./g27 test in the source folder"); });
}

constexpr char interrupted_json[] = "{\"error\": {\"problem\": \"interrupted\"}}\n";

/// Where no command listens to signals itself. Only what a handler may call.
void say_interrupted(int signal) {
  if (write(STDOUT_FILENO, interrupted_json, sizeof(interrupted_json) - 1) < 0) _exit(1);
  _exit(128 + signal);
}

void answer_signals() {
  for (int const signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = say_interrupted;
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

/// Says on stderr what went wrong, and with --json on stdout as well: whoever reads one object gets one.
class Reporter {
 public:
  Reporter(int argc, char** argv) : json_(std::find(argv, argv + argc, std::string_view("--json")) != argv + argc) {
    if (json_) answer_signals();
  }

  [[nodiscard]] int bad(InputError const& error) const {
    fmt::print(stderr, "{}: {}: {}\n  -> {}\n", error.file, error.key, error.problem, error.remedy);
    return print({{"file", error.file}, {"key", error.key}, {"problem", error.problem}, {"remedy", error.remedy}},
                 bad_input);
  }
  [[nodiscard]] int failed(std::string const& problem, int status) const {
    return print({{"problem", problem}}, status);
  }

 private:
  int print(nlohmann::ordered_json const& error, int status) const {
    if (json_) fmt::print("{}\n", nlohmann::ordered_json{{"error", error}}.dump(2));
    return status;
  }
  bool json_;
};

}  // namespace

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error of the write, reported as such
  Reporter const reporter(argc, argv);
  int status = 0;
  CLI::App app{"godunov27: a verification-first testbed for shock physics", "g27"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  add_run(app, status);
  add_check(app, status);
  add_case(app, status);
  add_study(app, status);
  add_exact(app, status);
  add_figure(app, status);
  add_bench(app, status);
  add_list(app, status);
  add_stl(app, status);
  add_test(app);
  if (argc < 2) {
    fmt::print(stderr, "{}", app.help());
    return bad_input;
  }
  try {
    try {
      app.parse(argc, argv);
    } catch (CLI::Success const& done) {  // --help, --version; help of a name that is not there is a slip
      return app.exit(done);
    }
    if (status > 128) status = reporter.failed("interrupted", status);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw OutputError("cannot write to stdout");
    }
    return status;
  } catch (CLI::ParseError const& error) {
    std::vector<std::string> names;
    for (auto const* sub : app.get_subcommands({})) names.push_back(sub->get_name());
    if (argv[1][0] != '-' && std::find(names.begin(), names.end(), argv[1]) == names.end()) {
      return reporter.bad({"g27", argv[1], "is no command", suggestion(argv[1], names)});
    }
    app.exit(error);
    return reporter.failed(error.what(), bad_input);
  } catch (InputError const& error) {
    return reporter.bad(error);
  } catch (Interrupted const& stopped) {
    fmt::print(stderr, "interrupted\n");
    return reporter.failed("interrupted", 128 + stopped.signal);
  } catch (std::exception const& error) {
    fmt::print(stderr, "g27: {}\n", error.what());
    return reporter.failed(error.what(), 1);
  }
}

}  // namespace g27
