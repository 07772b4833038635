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
  double mach;  ///< of the shock; 0: driven by gas at rest, of a hundred times the pressure of that at the back
  double degrees;
  int cells;  ///< across the plate
  double crossings, width;
  int order = 2;
};

/// Plates at an angle are as wide as it takes that no wave from their edges comes to the triangles in the middle.
constexpr double rest = 0, strong = 3, weak = 1.05, irrational = 22.918311805;
std::vector<Row> const rows{{rest, 0, 3, 2.6, 9, 3},   {rest, 30, 3, 2.6, 9, 3},
                            {rest, 45, 3, 2.6, 9, 3},  {rest, 0, 10, 2.6, 9, 3},
                            {rest, 15, 10, 2.6, 9, 3}, {rest, irrational, 10, 2.6, 9, 3},
                            {rest, 30, 10, 2.6, 9, 3}, {rest, 45, 10, 2.6, 9, 3},
                            {rest, 30, 20, 2.6, 9, 3}, {rest, 30, 3, 2.6, 9},
                            {rest, 0, 10, 2.6, 9},     {rest, 30, 10, 2.6, 9},
                            {rest, 45, 10, 2.6, 9},    {strong, 0, 3, 12, 8},
                            {strong, 0, 6, 12, 8},     {strong, 0, 10, 12, 8},
                            {strong, 0, 20, 12, 8},    {strong, 30, 3, 3.6, 9},
                            {strong, 15, 10, 3.6, 9},  {strong, irrational, 10, 3.6, 9},
                            {strong, 30, 10, 3.6, 9},  {strong, 45, 10, 3.6, 9},
                            {weak, 45, 10, 3.6, 9}};
constexpr int thick = 10, thin = 3;  ///< cells
constexpr double most_position = 5e-3, most_position_thin = 2e-2, most_momentum = 3e-3, most_pressure = 5e-2,
                 most_push = 5e-3;

/// Largest errors of the plates of one kind.
struct Worst {
  double position = 0, position_thin = 0, momentum = 0, pressure = 0, push = 0;
};

StudyReport run(StudyContext const& context) {
  Case const plate = find_by_name(all_cases(), "struck-plate", "fsi-slab");
  Table table{
      .name = "plates",
      .title =
          "Plates that gas drives (mach 0) or a shock meets: errors at the end over the exact values; rest of the gas "
          "over the impulse",
      .columns = {{"mach", "1"},
                  {"angle", "deg"},
                  {"cells", "1"},
                  {"order", "1"},
                  {"moved", "cells"},
                  {"front", "1"},
                  {"back", "1"},
                  {"momentum_less_impulse", "1"},
                  {"pressure", "1"},
                  {"push", "1"},
                  {"gas_momentum_rest", "1"},
                  {"triangles", "1"},
                  {"wall", "s"}},
      .rows = {},
      .facts = {}};
  Hdf5Writer histories;
  Worst driven, by_linear, struck;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    Row const& row = rows[n];
    CaseOptions o;
    o.cells = row.cells, o.threads = threads_or_all(0), o.predictor = static_cast<Predictor>(row.order - 1);
    o.values = {{"angle", row.degrees * std::numbers::pi / 180}, {"crossings", row.crossings}, {"width", row.width}};
    bool const at_rest = row.mach == rest;
    if (at_rest) {
      o.values.insert({{"drive", 100}, {"density", 10}, {"stiffness", 250}});
    } else {
      o.values["mach"] = row.mach;
    }
    std::string const what =
        fmt::format("{}, {:.3g} degrees, {} cells, order {}", at_rest ? "driven" : fmt::format("Mach {:g}", row.mach),
                    row.degrees, row.cells, row.order);
    o.progress = [&](double done) {
      context.progress((static_cast<double>(n) + done) / static_cast<double>(rows.size()), what);
    };
    CaseResult const r = plate.run(o);
    auto const fact = [&](char const* name) { return r.facts.at(name); };
    double const at_contact = fact("contact_pressure") / fact("exact_pressure") - 1;
    table.rows.push_back({row.mach, row.degrees, long{row.cells}, long{row.order}, fact("displacement_in_cells"),
                          fact("front_error"), fact("back_error"), fact("momentum_less_impulse"), at_contact,
                          fact("push_error"), fact("gas_momentum_rest_over_impulse"),
                          static_cast<long>(fact("triangles")), r.wall_s});
    Worst& worst = !at_rest ? struck : row.order == 3 ? driven : by_linear;
    auto const grow = [](double& most, double error) { most = std::max(most, std::fabs(error)); };
    for (char const* face : {"front_error", "back_error"}) {
      if (row.cells >= thick) grow(worst.position, fact(face));
      if (row.cells == thin) grow(worst.position_thin, fact(face));
    }
    grow(worst.pressure, at_contact);
    if (row.cells >= thick) grow(worst.momentum, fact("momentum_less_impulse")), grow(worst.push, fact("push_error"));
    for (char const* quantity : {"time", "pressure", "exact_pressure", "front", "exact_front", "momentum", "impulse"})
      histories.write(fmt::format("/{}/{}", what, quantity), r.profile.at(quantity), "1");
  }
  histories.save(context.out / "histories.h5");
  std::vector<Finding> findings;
  auto const judge = [&](std::string const& claim, double measured, double bound) {
    findings.push_back(
        {fmt::format("{} within {:g}", claim, bound), fmt::format("{:.2g}", measured), measured <= bound});
  };
  for (auto const& [kind, worst] :
       {std::pair{"driven by gas, order 3", driven}, std::pair{"driven by gas, order 2", by_linear},
        std::pair{"struck by a shock, order 2", struck}}) {
    judge(fmt::format("{}, both faces, {} cells and more: position over displacement", kind, thick), worst.position,
          most_position);
    judge(fmt::format("{}, both faces, {} cells: position over displacement", kind, thin), worst.position_thin,
          most_position_thin);
    judge(fmt::format("{}, {} cells and more: momentum over impulse", kind, thick), worst.momentum, most_momentum);
    judge(fmt::format("{}: pressure at the contact at every angle", kind), worst.pressure, most_pressure);
    judge(fmt::format("{}: push of that pressure, {} cells and more", kind, thick), worst.push, most_push);
  }
  return {{table}, std::move(findings)};
}

}  // namespace

Study fsi_slab_study() {
  return {"fsi-slab",
          "a plate that gas drives or a shock meets moves as the exact waves have it, at any angle to the grid", run};
}

}  // namespace g27
