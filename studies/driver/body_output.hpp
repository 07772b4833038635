#pragma once
/// Bodies in the files of a run: in every state /body/NAME/ with the surface (vertices, triangles, velocity, pressure)
/// and fields on the body's own grid; what the solver goes on from in /restart/overset.
#include "fsi/overset/overset_solver.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/run_record.hpp"

namespace g27 {

/// Adds the bodies to a state, with the field `gas_fraction`, the part of each cell of the gas outside of them. Cells
/// whose centre lies in a body hold 0 in the gas's fields, as those of rigid blocks.
void add_bodies(SceneRun const& run, OversetSolver const& solver, GridSnapshot& shot);

/// Bytes of a body's arrays.
double bytes_of(Body const& body);

/// Under `path`, the state's group.
void write_bodies(Hdf5Writer& out, std::string const& path, SceneRun const& run, GridSnapshot const& shot);

/// XDMF grids of the bodies at a state. `sizes`: of each surface vertices and triangles; `data`:
/// "run.state/0003.h5:/state/0003".
std::string body_xdmf(SceneRun const& run, double const* sizes, std::string const& data);

/// /restart/overset.
void write_overset(Hdf5Writer& out, GridRestart const& restart);
void read_overset(Hdf5Reader const& in, GridRestart& restart);

}  // namespace g27
