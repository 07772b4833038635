#pragma once
/// The groups of a run's file that lines and grids have in common.
#include <filesystem>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/run_record.hpp"

namespace g27 {

/// "/state/0003"
std::string state_path(std::size_t index);

/// /run, with who ran, how far and how long.
void write_heading(Hdf5Writer& out, Scene const& scene, SceneRun const& run, RunRecord const& record);
/// /history
void write_history(Hdf5Writer& out, History const& history);
void read_history(Hdf5Reader const& in, History& history);
/// /ledger/NAME
void write_ledger(Hdf5Writer& out, std::string const& name, LedgerEntry const& entry);
LedgerEntry read_ledger(Hdf5Reader const& in, std::string const& name);
/// /counters
void write_counters(Hdf5Writer& out, GasCounters const& counters);
void read_counters(Hdf5Reader const& in, GasCounters& counters);
/// /provenance
void write_provenance(Hdf5Writer& out, Scene const& scene, SceneRun const& run, int threads);
/// Throws InputError when the file belongs to another scene, other overrides or another run.
void check_identity(Hdf5Reader const& in, std::filesystem::path const& file, Scene const& scene, SceneRun const& run);

}  // namespace g27
