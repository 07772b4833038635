#pragma once
/// Compares what the runs of a scene gave with what the scene expects.
#include <map>
#include <string>
#include <vector>

#include "studies/driver/run_record.hpp"
#include "studies/driver/table.hpp"

namespace g27 {

struct Judgement {
  Expectation expected;
  std::string scheme;
  std::optional<double> measured;  ///< SI; empty: the run never got there
  bool judged = false;             ///< false: shown for comparison only
  [[nodiscard]] bool holds() const {
    return measured && *measured >= expected.value - expected.tolerance &&
           *measured <= expected.value + expected.tolerance;
  }
};

/// One judgement an expectation and scheme, in the scene's order. `records` by run name.
std::vector<Judgement> judge(Scene const& scene, std::map<std::string, RunRecord> const& records);

/// Rows: variant, quantity, expected, tolerance, one column a scheme, verdict.
Table verdict_table(Scene const& scene, std::vector<Judgement> const& judgements);

}  // namespace g27
