#pragma once
/// A study: a claim, the runs that test it, a table, a figure and a verdict. One folder a study:
/// `studies/NAME/NAME_study.cpp` defines `Study NAME_study()`, `studies/NAME/README.md` states the claim,
/// `studies/figures/NAME.py` draws from the study's HDF5 file alone.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/driver/table.hpp"

namespace g27 {

/// One line of the verdict: what was asked, what was measured.
struct Finding {
  std::string claim, measured;
  bool holds = false;
};

struct StudyReport {
  std::vector<Table> tables;      ///< printed, and written as CSV and HDF5 (group = table name)
  std::vector<Finding> findings;  ///< the study holds when every finding holds
};

struct StudyContext {
  std::filesystem::path out;                                          ///< folder of this study's results
  std::function<void(double fraction, std::string const&)> progress;  ///< fraction done in [0, 1], what runs now
};

struct Study {
  std::string name, claim;
  std::function<StudyReport(StudyContext const&)> run;
};

std::vector<Study> all_studies();

}  // namespace g27
