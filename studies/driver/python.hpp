#pragma once
/// Figures: one Python script each, run as a separate process.
#include <filesystem>
#include <string>
#include <vector>

namespace g27 {

/// A signal that stopped a script, or a run within a study; the program ends with 128 + it.
struct Interrupted {
  int signal;
};

/// An interpreter that has h5py and matplotlib, /usr/bin/python3 first; empty when there is none.
std::string find_python();

/// Names of the scripts in studies/figures and papers/overset_fsi, sorted; a leading underscore marks what they share.
std::vector<std::string> figure_names();
/// Throws InputError when there is none of that name.
std::filesystem::path figure_script(std::string const& name);

/// Runs the script of `name` with `arguments`, the last of which is the file to write; false (and a line on stderr)
/// when it fails. Throws Interrupted.
bool draw(std::string const& name, std::vector<std::string> const& arguments);
/// The same of a script of any name.
bool run_script(std::filesystem::path const& script, std::vector<std::string> const& arguments);

/// Runs a program with its stdout sent to stderr, so that ours stays clean; its exit status, or -1.
int run_process(std::vector<std::string> const& command);

}  // namespace g27
