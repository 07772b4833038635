#pragma once
/// A run's file: /run, /state, /history, /map, /ledger, /counters, /provenance and /restart. The same file serves
/// figures, ParaView (through XDMF) and resuming.
#include <filesystem>

#include "studies/driver/run_record.hpp"

namespace g27 {

/// Writes the whole record atomically. Throws OutputError.
void write_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run, RunRecord const& record,
               int threads);

/// Throws as read_run() does for a file that belongs to something else; OutputError for damaged states of a grid.
void check_resumable(std::filesystem::path const& file, Scene const& scene, SceneRun const& run);

/// Reads a record back. Throws OutputError, or InputError when the file belongs to another scene or other settings.
RunRecord read_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run);

/// XDMF beside the HDF5 file: cells of a line with their fields at every snapshot, as ParaView opens them.
std::string xdmf(std::string const& hdf5_name, RunRecord const& record);

}  // namespace g27
