#pragma once
/// The file of a run on a grid: as a line's, but every state in a file of its own, NAME.state/0003.h5, written once;
/// /state/0003 of NAME.h5 leads there. Fields are [nz][ny][nx]. /restart is there until the run is complete.
#include <filesystem>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/run_record.hpp"

namespace g27 {

/// Of write_run() and read_run().
void write_grid_run(std::filesystem::path const& file, Scene const& scene, SceneRun const& run, RunRecord const& record,
                    int threads);
void read_grid_run(Hdf5Reader const& in, SceneRun const& run, RunRecord& record);

/// Every state that the run's file names is there, whole and of its time. Throws OutputError.
void check_states(Hdf5Reader const& in, std::filesystem::path const& file);

/// State `index` of the run whose file is `file`.
void write_grid_state(std::filesystem::path const& file, SceneRun const& run, std::size_t index,
                      GridSnapshot const& state);

/// XDMF beside the HDF5 file: uniform grids with their fields at every state, and bodies, as ParaView opens them.
std::string grid_xdmf(std::string const& run_name, SceneRun const& run, GridRecord const& record);

}  // namespace g27
