#include "studies/driver/output_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "riemann/eos/factory.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/provenance.hpp"

namespace g27 {
namespace {

constexpr std::array counter_fields{std::pair{"steps", &GasCounters::steps},
                                    std::pair{"faces", &GasCounters::faces},
                                    std::pair{"cell_updates", &GasCounters::cell_updates},
                                    std::pair{"switched", &GasCounters::switched},
                                    std::pair{"linear_star", &GasCounters::linear_star},
                                    std::pair{"repaired", &GasCounters::repaired},
                                    std::pair{"floored", &GasCounters::floored},
                                    std::pair{"retried", &GasCounters::retried}};

constexpr std::array ledger_fields{std::pair{"initial", &LedgerEntry::initial},
                                   std::pair{"current", &LedgerEntry::current},
                                   std::pair{"through_boundary", &LedgerEntry::through_boundary},
                                   std::pair{"from_source", &LedgerEntry::from_source},
                                   std::pair{"from_floor", &LedgerEntry::from_floor},
                                   std::pair{"scale", &LedgerEntry::scale}};

/// A record can be resumed only by the same run: what determines the scene's results, and the name (variant and
/// scheme).
std::string identity(Scene const& scene, SceneRun const& run) { return run.name + "\n" + scene.digest; }

}  // namespace

std::string state_path(std::size_t index) { return fmt::format("/state/{:04}", index); }

void write_heading(Hdf5Writer& out, Scene const& scene, SceneRun const& run, RunRecord const& record) {
  out.group("/run");
  out.attribute("/run", "scene", scene.name);
  out.attribute("/run", "title", scene.title);
  out.attribute("/run", "name", run.name);
  out.attribute("/run", "variant", run.variant);
  out.attribute("/run", "scheme", run.scheme);
  out.attribute("/run", "eos", eos_name(run.eos()));
  out.attribute("/run", "complete", record.complete ? 1.0 : 0.0);
  out.attribute("/run", "wall_s", record.wall_s);
}

void write_history(Hdf5Writer& out, History const& history) {
  for (auto const& column : history.columns()) {
    out.write("/history/" + column.name, column.values, column.unit);
  }
}

void read_history(Hdf5Reader const& in, History& history) {
  for (auto& column : history.columns()) {
    column.values = in.read("/history/" + column.name);
  }
}

void write_ledger(Hdf5Writer& out, std::string const& name, LedgerEntry const& entry) {
  std::string const path = "/ledger/" + name;
  out.group(path);
  for (auto const& [field, member] : ledger_fields) {
    out.attribute(path, field, entry.*member);
  }
  out.attribute(path, "residual", entry.residual());
}

LedgerEntry read_ledger(Hdf5Reader const& in, std::string const& name) {
  LedgerEntry entry;
  for (auto const& [field, member] : ledger_fields) {
    entry.*member = in.number_attribute("/ledger/" + name, field);
  }
  return entry;
}

void write_counters(Hdf5Writer& out, GasCounters const& counters) {
  out.group("/counters");
  for (auto const& [name, member] : counter_fields) {
    out.attribute("/counters", name, static_cast<double>(counters.*member));
  }
}

void read_counters(Hdf5Reader const& in, GasCounters& counters) {
  for (auto const& [name, member] : counter_fields) {
    counters.*member = static_cast<std::uint64_t>(in.number_attribute("/counters", name));
  }
}

void write_provenance(Hdf5Writer& out, Scene const& scene, SceneRun const& run, int threads) {
  for (auto const& [name, value] : provenance(threads)) {
    out.write_text("/provenance/" + name, value);
  }
  out.write_text("/provenance/scene", scene.text);
  out.write_text("/provenance/overrides", fmt::format("{}", fmt::join(scene.overrides, "\n")));
  out.write_text("/provenance/identity", identity(scene, run));
}

void check_identity(Hdf5Reader const& in, std::filesystem::path const& file, Scene const& scene, SceneRun const& run) {
  if (in.read_text("/provenance/identity") != identity(scene, run)) {
    throw InputError(file.string(), "--resume", "was written by another scene or with other settings",
                     "restore the scene, its surfaces and --set as they were, or run without --resume");
  }
}

}  // namespace g27
