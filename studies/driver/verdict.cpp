#include "studies/driver/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/driver/quantity.hpp"

namespace g27 {
namespace {

std::string condition(Expectation const& e) {
  std::string out;
  auto const add = [&](char const* word, std::optional<double> const& seconds) {
    if (seconds) {
      out += fmt::format(" {} {:g} us", word, *seconds * 1e6);
    }
  };
  add("at", e.time);
  add("after", e.after);
  add("over", e.window);
  if (!e.axis.empty()) {
    out += " along " + e.axis;
  }
  if (!e.body.empty()) {
    out += " of " + e.body;
  }
  return e.probe.empty() ? out : out + " at " + e.probe;
}

std::vector<std::string> schemes_of(std::vector<Judgement> const& judgements) {
  std::vector<std::string> out;
  for (auto const& j : judgements) {
    if (std::find(out.begin(), out.end(), j.scheme) == out.end()) {
      out.push_back(j.scheme);
    }
  }
  return out;
}

}  // namespace

std::vector<Judgement> judge(Scene const& scene, std::map<std::string, RunRecord> const& records) {
  std::vector<Judgement> out;
  for (Expectation const& e : scene.expect) {
    auto const quantity = std::find_if(all_quantities().begin(), all_quantities().end(),
                                       [&](HistoryQuantity const& q) { return q.name == e.quantity; });
    for (SceneRun const& run : scene.runs) {
      auto const record = records.find(run.name);
      if (run.variant != e.variant || record == records.end()) {
        continue;
      }
      bool const judged = e.judged && (e.schemes.empty() ||
                                       std::find(e.schemes.begin(), e.schemes.end(), run.scheme) != e.schemes.end());
      out.push_back({e, run.scheme, quantity->evaluate(record->second.history, run.output, e), judged});
    }
  }
  return out;
}

Table verdict_table(Scene const& scene, std::vector<Judgement> const& judgements) {
  Table table{.name = "verdict", .title = "Expected and measured", .columns = {}, .rows = {}, .facts = {}};
  auto const schemes = schemes_of(judgements);
  for (char const* name : {"run", "quantity", "unit", "expected", "tolerance"}) {
    table.columns.push_back({name, "1"});
  }
  for (auto const& scheme : schemes) {
    table.columns.push_back({scheme, "1"});
  }
  table.columns.push_back({"verdict", "1"});
  std::size_t next = 0;
  for (Expectation const& e : scene.expect) {
    std::vector<Value> row{e.variant, e.quantity + condition(e), e.unit, e.value / e.unit_si, e.tolerance / e.unit_si};
    bool holds = true, judged = false;
    for (auto const& scheme : schemes) {
      bool const here = next < judgements.size() && judgements[next].scheme == scheme &&
                        judgements[next].expected.variant == e.variant;
      if (!here) {
        row.emplace_back(std::string("-"));
        continue;
      }
      Judgement const& j = judgements[next++];
      std::string const text = j.measured ? fmt::format("{:.4g}", *j.measured / e.unit_si) : "never";
      row.emplace_back(j.judged ? (j.holds() ? text : text + " !") : "(" + text + ")");
      judged = judged || j.judged;
      holds = holds && (!j.judged || j.holds());
    }
    row.emplace_back(std::string(!judged ? "shown" : holds ? "holds" : "FAILS"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace g27
