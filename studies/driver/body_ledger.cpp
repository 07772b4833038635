#include "studies/driver/body_ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/driver/output_parts.hpp"
#include "studies/driver/scene_run.hpp"

namespace g27 {
namespace {

/// Calls f(name, unit, entry) with every entry; angular momentum where `angular`.
template <class Ledger, class F>
void for_each_entry(Ledger&& ledger, bool angular, F const& f) {
  f("mass", "kg", ledger.mass);
  for (std::size_t d = 0; d < 3; ++d) f("momentum_" + ray_names()[d], "N s", ledger.momentum[d]);
  for (std::size_t d = 0; angular && d < 3; ++d) f("angular_momentum_" + ray_names()[d], "N m s", ledger.angular[d]);
  f("energy", "J", ledger.energy);
}

ContentLedger of_gas(GridRestart const& r) {
  return {.mass = r.ledger.mass, .energy = r.ledger.energy, .momentum = r.ledger.momentum, .angular = {}};
}

/// Whether planes of symmetry that cut a body, or clamps, hold this: they push on it, and the pressures on its surface
/// do not say how much.
bool held_by(Mirrors const& planes, std::string const& quantity) {
  if (planes.clamps.any() && quantity.find("momentum_") != std::string::npos) return true;
  for (std::size_t a = 0; a < 3; ++a) {
    std::string const axis(1, "xyz"[a]);
    if (planes.across(a) && quantity == "momentum_" + axis) return true;
    if (planes.across(a) && quantity.starts_with("angular_momentum_") && !quantity.ends_with(axis)) return true;
  }
  return false;
}

}  // namespace

ContentLedger ledger_of(BodyIntegrals const& body) {
  ContentLedger out;
  out.mass.initial = body.mass, out.energy.initial = body.energy;
  for (std::size_t d = 0; d < 3; ++d) {
    out.momentum[d].initial = body.momentum[d], out.angular[d].initial = body.angular[d];
  }
  note_scale(body, out);
  return out;
}

void note_scale(BodyIntegrals const& now, ContentLedger& ledger) {
  auto const note = [](LedgerEntry& entry, double size) { entry.scale = std::max(entry.scale, size); };
  double const about = now.inertia[0] + now.inertia[1] + now.inertia[2];
  note(ledger.mass, now.mass), note(ledger.energy, std::fabs(now.energy));
  for (LedgerEntry& entry : ledger.momentum) note(entry, std::sqrt(2 * now.mass * now.kinetic));
  for (LedgerEntry& entry : ledger.angular) note(entry, std::sqrt(2 * about * now.kinetic));
}

void set_current(BodyIntegrals const& now, BodyMomentum const& given, ContentLedger& ledger) {
  ledger.mass.current = now.mass, ledger.energy.current = now.energy, ledger.energy.from_source = given.work;
  for (std::size_t d = 0; d < 3; ++d) {
    LedgerEntry &p = ledger.momentum[d], &l = ledger.angular[d];
    p.current = now.momentum[d], p.from_source = given.linear[d] - p.initial;
    l.current = now.angular[d], l.from_source = given.angular[d] - l.initial;
  }
}

void write_body_ledgers(Hdf5Writer& out, SceneRun const& run, GridRestart const& restart) {
  if (restart.bodies.empty()) return;
  for_each_entry(of_gas(restart), false, [&](std::string const& name, char const*, LedgerEntry const& entry) {
    out.attribute("/ledger/" + name, "through_contact", entry.from_source);
  });
  for (std::size_t n = 0; n < restart.bodies.size(); ++n) {
    std::string const group = "body/" + run.grid->bodies[n].name + "/";
    for_each_entry(restart.bodies[n], true, [&](std::string const& name, char const*, LedgerEntry const& entry) {
      write_ledger(out, group + name, entry);
      out.attribute("/ledger/" + group + name, "through_contact", entry.from_source);
    });
  }
}

void read_body_ledgers(Hdf5Reader const& in, SceneRun const& run, GridRestart& restart) {
  restart.bodies.clear();
  for (SceneBody const& body : run.grid->bodies) {
    std::string const group = "body/" + body.name + "/";
    if (!in.has("/ledger/" + group + "mass")) continue;
    for_each_entry(restart.bodies.emplace_back(), true, [&](std::string const& name, char const*, LedgerEntry& entry) {
      entry = read_ledger(in, group + name);
    });
  }
}

Table body_table(Scene const& scene, SceneResult const& result) {
  Table table{.name = "bodies",
              .title = "Bodies at the end",
              .columns = {{"run", "1"},
                          {"body", "1"},
                          {"x", "m"},
                          {"y", "m"},
                          {"z", "m"},
                          {"u", "m/s"},
                          {"v", "m/s"},
                          {"w", "m/s"},
                          {"kinetic energy", "J"},
                          {"plastic strain", "%"}},
              .rows = {},
              .facts = {}};
  for (SceneRun const& run : scene.runs) {
    auto const found = result.records.find(run.name);
    if (found == result.records.end()) continue;
    History const& history = found->second.history;
    for (SceneBody const& body : run.grid->bodies) {
      auto const last = [&](std::string const& column) { return history["body/" + body.name + "/" + column].back(); };
      table.rows.push_back({run.name, body.name, last("centre_x"), last("centre_y"), last("centre_z"),
                            last("velocity_x"), last("velocity_y"), last("velocity_z"), last("kinetic_energy"),
                            100 * last("plastic_strain")});
    }
  }
  return table;
}

Table problem_table(Scene const& scene, SceneResult const& result) {
  Table table{.name = "problems",
              .title =
                  "Local problems, one at each triangle in a step (redone by Godunov's scheme; failed there too and "
                  "left as they were; of bodies at rest), cores of gas that alone would have set the time step, "
                  "vertices drawn back where a surface ran through itself, "
                  "steps after which it still did, and wall time of a step's parts",
              .columns = {{"run", "1"},
                          {"problems", "1"},
                          {"redone", "1"},
                          {"left", "1"},
                          {"at rest", "1"},
                          {"renewed", "1"},
                          {"untangled", "1"},
                          {"tangled", "1"},
                          {"local", "s"},
                          {"gas's grid", "s"},
                          {"bodies' grids", "s"},
                          {"geometry", "s"},
                          {"interpolation", "s"}},
              .rows = {},
              .facts = {}};
  for (SceneRun const& run : scene.runs) {
    auto const found = result.records.find(run.name);
    if (found == result.records.end() || run.grid->bodies.empty()) continue;
    ProblemCounts const& p = found->second.grid->restart.problems;
    table.rows.push_back({run.name, p.solved, p.first_order, p.kept, p.skipped, p.renewed, p.untangled, p.tangled,
                          p.local_s, p.gas_s, p.bodies_s, p.geometry_s, p.interpolation_s});
  }
  return table;
}

Table ledger_table(Scene const& scene, SceneResult const& result) {
  Table table{.name = "ledger",
              .title =
                  "Gas outside of the bodies, and bodies: rest is what interpolation and moving surfaces made; "
                  "nothing is said of what planes of symmetry hold",
              .columns = {{"run", "1"},
                          {"of", "1"},
                          {"quantity", "1"},
                          {"unit", "1"},
                          {"at the start", "1"},
                          {"at the end", "1"},
                          {"through sides", "1"},
                          {"through contact", "1"},
                          {"rest", "1"},
                          {"rest over scale", "%"}},
              .rows = {},
              .facts = {}};
  for (SceneRun const& run : scene.runs) {
    auto const found = result.records.find(run.name);
    if (found == result.records.end() || run.grid->bodies.empty()) continue;
    auto const add = [&](std::string const& of, ContentLedger const& ledger, Mirrors const* planes) {
      bool const body = planes != nullptr;
      for_each_entry(ledger, body, [&](std::string const& name, char const* unit, LedgerEntry const& e) {
        double const rest = e.current - e.initial - e.through_boundary - e.from_source - e.from_floor;
        Value const nothing(std::string("-"));
        bool const held = body && held_by(*planes, name);
        table.rows.push_back({run.name, of, name, unit, e.initial, e.current,
                              body ? nothing : Value(e.through_boundary), e.from_source, held ? nothing : Value(rest),
                              held ? nothing : Value(100 * e.residual())});
      });
    };
    GridRestart const& restart = found->second.grid->restart;
    add("gas", of_gas(restart), nullptr);
    for (std::size_t n = 0; n < restart.bodies.size(); ++n) {
      SceneBody const& body = run.grid->bodies[n];
      add(body.name, restart.bodies[n], &body.cut);
    }
  }
  return table;
}

}  // namespace g27
