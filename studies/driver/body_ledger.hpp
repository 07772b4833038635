#pragma once
/// Mass, momentum and energy of gas and bodies: what was there, what came through the contact, what remains
/// unexplained.
#include "fsi/overset/gas_integrals.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/run_record.hpp"
#include "studies/driver/table.hpp"

namespace g27 {

struct SceneResult;

/// At the start.
ContentLedger ledger_of(BodyIntegrals const& body);
/// The magnitudes that residuals are relative to grow with the run: |momentum| by sqrt(2 M T), and alike.
void note_scale(BodyIntegrals const& now, ContentLedger& ledger);
/// What the body holds now and what the pressures on its triangles have given it.
void set_current(BodyIntegrals const& now, BodyMomentum const& given, ContentLedger& ledger);

/// /ledger/body/NAME/ mass, energy, momentum_x, ..., angular_momentum_x, ...; `through_contact` there and of the gas.
void write_body_ledgers(Hdf5Writer& out, SceneRun const& run, GridRestart const& restart);
void read_body_ledgers(Hdf5Reader const& in, SceneRun const& run, GridRestart& restart);

/// One row a body of each run: where it is at the end.
Table body_table(Scene const& scene, SceneResult const& result);

/// Model problems and the time of a step's parts, by run.
Table problem_table(Scene const& scene, SceneResult const& result);

/// One row a quantity of gas and bodies of each run. Angular momentum of the gas is left out: what its boundary takes
/// is not counted.
Table ledger_table(Scene const& scene, SceneResult const& result);

}  // namespace g27
