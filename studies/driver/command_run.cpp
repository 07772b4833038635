#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/body_ledger.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/earlier_results.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/scene_check.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"
#include "studies/driver/table_json.hpp"

namespace g27 {
namespace {

using Json = nlohmann::ordered_json;

Json ledger_json(RunRecord const& record) {
  Json json{{"mass", record.mass().residual()}, {"energy", record.energy().residual()}};
  if (!record.grid) {
    json["momentum"] = record.restart.ledger.momentum.residual();
    return json;
  }
  json["momentum"] = Json::array();
  for (LedgerEntry const& entry : record.grid->restart.ledger.momentum) {
    json["momentum"].push_back(entry.residual());
  }
  return json;
}

Json saved_json(GridRecord const& grid) {
  Saved const saved = saved_by(grid);
  Json json{{"cell_updates", saved.updates},
            {"skipped_share", saved.skipped_share},
            {"unstored_share", saved.unstored_share},
            {"weak_share", saved.weak_share},
            {"bytes", grid.bytes},
            {"factor", saved.factor}};
  if (!grid.line.ended_by.empty()) {
    json["line_phase"] = {{"until_s", grid.line.time},      {"radius_m", grid.line.radius},
                          {"ended_by", grid.line.ended_by}, {"cells", grid.line.cells},
                          {"steps", grid.line.steps},       {"wall_s", grid.line.wall_s},
                          {"corrected", grid.line.missing}, {"cell_updates_saved", saved.line_updates}};
  }
  return json;
}

/// At the end of the run, and how the model problems went.
Json bodies_json(SceneRun const& run, RunRecord const& record) {
  Json out = Json::array();
  for (std::size_t n = 0; n < record.grid->restart.bodies.size(); ++n) {
    std::string const& name = run.grid->bodies[n].name;
    Json body{{"name", name}};
    for (HistoryColumn const& column : record.history.columns()) {
      std::string const of = "body/" + name + "/";
      if (column.name.rfind(of, 0) == 0 && !column.values.empty()) {
        body[column.name.substr(of.size())] = column.values.back();
      }
    }
    ContentLedger const& ledger = record.grid->restart.bodies[n];
    body["ledger"] = {{"mass", ledger.mass.residual()}, {"energy", ledger.energy.residual()}};
    body["ledger"]["momentum"] = Json::array();
    for (LedgerEntry const& entry : ledger.momentum) body["ledger"]["momentum"].push_back(entry.residual());
    out.push_back(std::move(body));
  }
  return out;
}

Json result_json(Scene const& scene, SceneResult const& result, std::filesystem::path const& out) {
  Json json{{"scene", scene.name}, {"title", scene.title}, {"out", out.string()}, {"runs", Json::array()}};
  for (SceneRun const& run : scene.runs) {
    Json entry{{"name", run.name}, {"variant", run.variant}, {"scheme", run.scheme}};
    if (auto const found = result.records.find(run.name); found != result.records.end()) {
      RunRecord const& record = found->second;
      entry.update({{"complete", record.complete},
                    {"cells", run.cells()},
                    {"steps", record.counters().steps},
                    {"wall_s", record.wall_s},
                    {"time_s", record.time()},
                    {"ledger", ledger_json(record)}});
      if (record.grid) {
        entry["saved"] = saved_json(*record.grid);
        if (!run.grid->bodies.empty()) {
          ProblemCounts const& p = record.grid->restart.problems;
          entry["bodies"] = bodies_json(run, record);
          entry["model_problems"] = {{"solved", p.solved}, {"first_order", p.first_order}, {"kept", p.kept}};
        }
      }
    }
    if (auto const failed = result.failures.find(run.name); failed != result.failures.end()) {
      entry["failure"] = failed->second;
    }
    json["runs"].push_back(std::move(entry));
  }
  json["expect"] = Json::array();
  for (Judgement const& j : result.judgements) {
    json["expect"].push_back({{"variant", j.expected.variant},
                              {"quantity", j.expected.quantity},
                              {"scheme", j.scheme},
                              {"expected", j.expected.value},
                              {"tolerance", j.expected.tolerance},
                              {"measured", j.measured ? Json(*j.measured) : Json(nullptr)},
                              {"judged", j.judged},
                              {"holds", j.holds()},
                              {"source", j.expected.source}});
  }
  json["holds"] = result.holds();
  return json;
}

/// The default figure of every variant: profiles, x-t map and history of its runs together.
/// One figure a variant; false when one could not be drawn.
bool draw_variants(Scene const& scene, SceneResult const& result, std::filesystem::path const& out) {
  bool drawn = true;
  std::vector<std::string> variants;
  for (SceneRun const& run : scene.runs) {
    if (variants.empty() || variants.back() != run.variant) {
      variants.push_back(run.variant);
    }
  }
  for (std::string const& variant : variants) {
    std::vector<std::string> files;
    std::string name;
    for (SceneRun const& run : scene.runs) {
      if (run.variant == variant && result.records.contains(run.name)) {
        files.push_back((out / (run.name + ".h5")).string());
        name = run.name.substr(0, run.name.size() - run.scheme.size() - 1);
      }
    }
    if (!files.empty()) {
      files.push_back((out / (name + ".png")).string());
      auto const& grid = scene.runs[0].grid;
      drawn = draw(!grid ? "scene" : grid->bodies.empty() ? "scene-nd" : "scene-bodies", files) && drawn;
    }
  }
  return drawn;
}

std::string quoted(std::string const& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%") ==
      std::string::npos) {
    return word;
  }
  std::string out = "'";
  for (char const c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The command that goes on from the checkpoints in `out`.
std::string resume_command(RunArguments const& arguments, std::filesystem::path const& out) {
  std::string command = "g27 run " + quoted(arguments.scene);
  for (std::string const& assignment : arguments.set) command += " --set " + quoted(assignment);
  return command + " --out " + quoted(out.string()) + " --resume";
}

bool has_checkpoint(Scene const& scene, std::filesystem::path const& out) {
  return std::any_of(scene.runs.begin(), scene.runs.end(),
                     [&](SceneRun const& run) { return std::filesystem::exists(out / (run.name + ".h5")); });
}

}  // namespace

int command_run(RunArguments const& arguments) {
  Scene const scene = read_scene(find_scene(arguments.scene), arguments.set);
  std::filesystem::path const out = arguments.out.empty() ? "results/" + scene.name : arguments.out;
  if (arguments.resume && !has_checkpoint(scene, out)) {
    throw InputError("g27 run", "--resume", fmt::format("{} holds no run of this scene", out.string()),
                     "leave --resume out, or name the folder with --out");
  }
  require_memory(scene);
  for (std::string const& remark : remarks_on(scene)) fmt::print(stderr, "{}\n", remark);
  int const machine = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  fmt::print(stderr, "{}: {} run{} into {}\n", scene.title, scene.runs.size(), scene.runs.size() == 1 ? "" : "s",
             out.string());
  EarlierResults const earlier(out);
  if (!arguments.resume) earlier.set_aside();
  SceneResult const result = run_scene(scene, {.out = out,
                                               .threads = arguments.threads > 0 ? arguments.threads : machine,
                                               .resume = arguments.resume,
                                               .checkpoint_s = arguments.checkpoint_s});
  if (result.interrupted != 0) {
    bool const saved = has_checkpoint(scene, out);
    fmt::print(stderr, "interrupted; {}\n",
               saved ? "to continue: " + resume_command(arguments, out) : "nothing was saved yet");
    return 128 + result.interrupted;
  }
  std::vector<Table> tables{run_table(scene, result)};
  if (scene.runs[0].grid) {
    tables.push_back(saved_table(scene, result));
  }
  if (std::any_of(scene.runs.begin(), scene.runs.end(),
                  [](SceneRun const& r) { return r.grid && !r.grid->bodies.empty(); })) {
    tables.push_back(body_table(scene, result));
    tables.push_back(ledger_table(scene, result));
  }
  if (!result.judgements.empty()) {
    tables.push_back(verdict_table(scene, result.judgements));
  }
  std::erase_if(tables, [](Table const& table) { return table.rows.empty(); });  // every run has failed
  for (Table const& table : tables) {
    write_csv(out, table);
  }
  Json const json = result_json(scene, result, out);
  write_atomically(out / "summary.json", json.dump(2) + "\n");
  if (result.failures.empty()) earlier.remove();
  for (auto const& [name, message] : result.failures) {
    fmt::print(stderr, "failed: {}\n  see {}/{}.failure.json\n", message, out.string(), name);
  }
  bool drawn = true;
  if (arguments.figures) {
    drawn = draw_variants(scene, result, out);
    if (!drawn) fmt::print(stderr, "a figure could not be drawn; the results themselves are complete\n");
  }
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    for (Table const& table : tables) {
      fmt::print("{}\n", to_text(table));
    }
    if (!result.judgements.empty()) {
      fmt::print("{}\n", result.holds() ? "Every judged figure holds." : "A JUDGED FIGURE FAILS.");
    }
  }
  return result.holds() && drawn ? 0 : 1;
}

}  // namespace g27
