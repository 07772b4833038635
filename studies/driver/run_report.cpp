#include "studies/driver/run_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/body_ledger.hpp"
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
          entry["model_problems"] = {
              {"solved", p.solved}, {"first_order", p.first_order}, {"kept", p.kept}, {"cores_renewed", p.renewed}};
          entry["surfaces"] = {{"vertices_untangled", p.untangled}, {"steps_tangled", p.tangled}};
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
  json["cost"] = {{"cpu_s", result.cpu_s}, {"wall_s", result.wall_s}, {"peak_bytes", result.peak_bytes}};
  json["holds"] = result.holds();
  return json;
}

}  // namespace

RunReport write_report(Scene const& scene, SceneResult const& result, std::filesystem::path const& out) {
  std::vector<Table> tables{run_table(scene, result)};
  if (scene.runs[0].grid) {
    tables.push_back(saved_table(scene, result));
  }
  if (std::any_of(scene.runs.begin(), scene.runs.end(),
                  [](SceneRun const& r) { return r.grid && !r.grid->bodies.empty(); })) {
    tables.push_back(body_table(scene, result));
    tables.push_back(problem_table(scene, result));
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
  RunReport report{.tables = std::move(tables), .summary = json.dump(2)};
  write_atomically(out / "summary.json", report.summary + "\n");
  return report;
}

}  // namespace g27
