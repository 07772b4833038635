#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "studies/driver/command.hpp"
#include "studies/driver/folder_lock.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/progress.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/study.hpp"
#include "studies/driver/table_json.hpp"

namespace g27 {

int command_study(StudyArguments const& arguments) {
  Study const study = find_by_name(all_studies(), arguments.name, "g27 study");
  std::filesystem::path const out = arguments.out.empty() ? "results/studies/" + study.name : arguments.out;
  FolderLock const lock(out, "g27 study");
  StudyReport report;
  {
    Progress progress({1.0});
    report = study.run({out, [&](double fraction, std::string const& what) { progress.update(0, fraction, what); }});
  }
  auto const file = out / "study.h5";
  write_tables(file, report.tables);
  for (Table const& table : report.tables) {
    write_csv(out, table);
  }
  auto const figures = figure_names();
  if (std::find(figures.begin(), figures.end(), study.name) != figures.end()) {
    draw(study.name, {file.string(), (out / (study.name + ".png")).string()});
  }
  bool const holds =
      std::all_of(report.findings.begin(), report.findings.end(), [](Finding const& f) { return f.holds; });
  if (arguments.json) {
    nlohmann::ordered_json json{{"study", study.name}, {"claim", study.claim}, {"holds", holds}, {"out", out.string()}};
    json["findings"] = nlohmann::ordered_json::array();
    for (Finding const& f : report.findings) {
      json["findings"].push_back({{"claim", f.claim}, {"measured", f.measured}, {"holds", f.holds}});
    }
    json["tables"] = nlohmann::ordered_json::object();
    for (Table const& table : report.tables) {
      json["tables"][table.name] = to_json(table);
    }
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}\n\n", study.claim);
    for (Table const& table : report.tables) {
      fmt::print("{}\n", to_text(table));
    }
    for (Finding const& f : report.findings) {
      fmt::print("{}  {}: {}\n", f.holds ? "holds" : "FAILS", f.claim, f.measured);
    }
    fmt::print("results in {}\n", out.string());
  }
  return holds ? 0 : 1;
}

}  // namespace g27
