#pragma once
/// Figures: one Python script each, run as a separate process.
#include <filesystem>
#include <string>
#include <vector>

namespace g27 {

/// An interpreter that has h5py and matplotlib, /usr/bin/python3 first; empty when there is none.
std::string find_python();

/// Names of the scripts in studies/figures, sorted.
std::vector<std::string> figure_names();

/// Runs studies/figures/NAME.py with `arguments`; false (and a line on stderr) when it fails.
bool draw(std::string const& name, std::vector<std::string> const& arguments);

/// Runs a program with its stdout sent to stderr, so that ours stays clean; its exit status, or -1.
int run_process(std::vector<std::string> const& command);

}  // namespace g27
