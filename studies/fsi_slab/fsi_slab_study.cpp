/// A plane shock meets an elastic plate at several angles to the grid: motion, momentum and pressure against the exact
/// waves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

struct Row {
  double degrees;
  int cells;  ///< across the plate
  double crossings, width, mach = 3;
};

/// Plates at an angle are as wide as it takes that no wave from their edges comes to the triangles in the middle.
std::vector<Row> const rows{{0, 3, 12, 8},  {0, 6, 12, 8},       {0, 10, 12, 8},           {0, 20, 12, 8},
                            {30, 3, 4, 9},  {15, 10, 4, 9},      {22.918311805, 10, 4, 9}, {30, 10, 4, 9},
                            {45, 10, 4, 9}, {45, 10, 4, 9, 1.05}};
constexpr int thick = 10, thin = 3;  ///< cells
constexpr double most_position = 5e-3, most_position_thin = 2e-2, most_momentum = 3e-3, most_pressure = 5e-2,
                 most_push = 5e-3;

StudyReport run(StudyContext const& context) {
  Case const plate = find_by_name(all_cases(), "struck-plate", "fsi-slab");
  Table table{
      .name = "plates",
      .title = "A shock meets a plate: errors at the end over the exact values; rest of the gas over the impulse",
      .columns = {{"angle", "deg"},
                  {"cells", "1"},
                  {"mach", "1"},
                  {"moved", "cells"},
                  {"front", "1"},
                  {"back", "1"},
                  {"momentum_over_impulse", "1"},
                  {"pressure", "1"},
                  {"push", "1"},
                  {"gas_momentum_rest", "1"},
                  {"triangles", "1"},
                  {"wall", "s"}},
      .rows = {},
      .facts = {}};
  Hdf5Writer histories;
  double position = 0, position_thin = 0, momentum = 0, pressure = 0, push = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    Row const& row = rows[n];
    CaseOptions o;
    o.cells = row.cells, o.threads = threads_or_all(0);
    o.values = {{"angle", row.degrees * std::numbers::pi / 180},
                {"crossings", row.crossings},
                {"width", row.width},
                {"mach", row.mach}};
    std::string const what = fmt::format("Mach {:g}, {:.3g} degrees, {} cells", row.mach, row.degrees, row.cells);
    o.progress = [&](double done) {
      context.progress((static_cast<double>(n) + done) / static_cast<double>(rows.size()), what);
    };
    CaseResult const r = plate.run(o);
    auto const fact = [&](char const* name) { return r.facts.at(name); };
    double const at_contact = fact("contact_pressure") / fact("exact_pressure") - 1;
    table.rows.push_back({row.degrees, long{row.cells}, row.mach, fact("displacement_in_cells"), fact("front_error"),
                          fact("back_error"), fact("momentum_over_impulse"), at_contact, fact("push_error"),
                          fact("gas_momentum_rest_over_impulse"), static_cast<long>(fact("triangles")), r.wall_s});
    double const worst = std::max(std::fabs(fact("front_error")), std::fabs(fact("back_error")));
    if (row.cells >= thick) position = std::max(position, worst);
    if (row.cells == thin) position_thin = std::max(position_thin, worst);
    momentum = std::max(momentum, std::fabs(fact("momentum_over_impulse")));
    pressure = std::max(pressure, std::fabs(at_contact));
    if (row.cells >= thick) push = std::max(push, std::fabs(fact("push_error")));
    for (char const* quantity : {"time", "pressure", "exact_pressure", "front", "exact_front", "momentum", "impulse"})
      histories.write(fmt::format("/{}/{}", what, quantity), r.profile.at(quantity), "1");
  }
  histories.save(context.out / "histories.h5");
  auto const at_most = [](std::string const& claim, double measured, double bound) {
    return Finding{fmt::format("{} within {:g}", claim, bound), fmt::format("{:.2g}", measured), measured <= bound};
  };
  return {{table},
          {at_most(fmt::format("both faces, {} cells and more: position over displacement", thick), position,
                   most_position),
           at_most(fmt::format("both faces, {} cells: position over displacement", thin), position_thin,
                   most_position_thin),
           at_most("momentum over impulse at every angle", momentum, most_momentum),
           at_most("pressure at the contact over the exact one at every angle", pressure, most_pressure),
           at_most(fmt::format("push of that pressure since the arrival, {} cells and more", thick), push, most_push)}};
}

}  // namespace

Study fsi_slab_study() {
  return {"fsi-slab", "a plate that a shock meets moves as the exact waves have it, at any angle to the grid", run};
}

}  // namespace g27
