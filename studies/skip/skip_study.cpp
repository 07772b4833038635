/// What is left out where a scene does not need it: each skip alone and all together, time saved and difference made.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "scheme/step/gas_grid.hpp"
#include "scheme/step/map_line_to_grid.hpp"
#include "studies/bench/yardsticks.hpp"
#include "studies/driver/study.hpp"

namespace g27 {
namespace {

constexpr int cells = 32;
constexpr std::array radii{0.25, 0.4, 0.55};  ///< of the front, where runs are compared [m]

struct Blast {
  char const* name;
  double radius, pressure, ambient, gamma;
};
/// The energy of Sedov's problem in a small ball, and a hot ball in still air whose pressure counts.
constexpr std::array blasts{Blast{"sedov", 0.1, 250.0, 1e-5, 1.4}, Blast{"point blast", 0.15, 40.0, 1.0, 1.4}};

double const box = 1.0;

GasGridSetup octant(Blast const& b, bool skip, bool linear_star) {
  GasGridSetup setup{.eos = IdealGas{b.gamma}, .upper = {box, box, box}, .cells = {cells, cells, cells}};
  for (std::size_t s : {0u, 2u, 4u}) setup.sides[s].kind = GridBoundary::Kind::wall;
  setup.options.skip = skip, setup.options.linear_star = linear_star, setup.options.tile = {16, 8, 8};
  return setup;
}

GasPoint ball(Blast const& b, Vec3 const& x) {
  double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  return {1.0, {0, 0, 0}, r < b.radius ? b.pressure : b.ambient};
}

GasLine line_of(Blast const& b, int n) {
  GasLineSetup setup{.eos = IdealGas{b.gamma}, .symmetry = Symmetry::spherical};
  for (int f = 0; f <= n; ++f) setup.faces.push_back(box * f / n);
  setup.left.kind = GasBoundary::Kind::wall;
  GasLine line(setup);
  line.set_state([&](double r) -> GasState<> { return {1.0, 0.0, r < b.radius ? b.pressure : b.ambient}; });
  return line;
}

/// Mean of |rho - rho_line(r)| over the box: the line is fine enough to stand for the exact solution.
double error_against(GasGrid const& grid, GasLine const& line) {
  double sum = 0;
  std::size_t count = 0;
  auto const faces = line.faces();
  Int3 const n = grid.cells();
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        Vec3 const x = grid.centre({i, j, k});
        double const r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (r > box - 0.02) continue;
        auto const at = std::upper_bound(faces.begin(), faces.end(), r) - faces.begin() - 1;
        sum += std::fabs(grid.primitive({i, j, k}).rho - line.density()[static_cast<std::size_t>(at)]);
        ++count;
      }
    }
  }
  return sum / static_cast<double>(count);
}

template <class Mesh>
double advance(Mesh& mesh, double t) {
  double const start = process_cpu_seconds();
  while (mesh.time() < t) {
    if (mesh.step(t).status != StepStatus::ok) throw std::runtime_error("skip: a step failed");
  }
  return process_cpu_seconds() - start;
}

bool same(GasGrid const& a, GasGrid const& b) {
  for (auto f : {GasGrid::Field::density, GasGrid::Field::velocity_x, GasGrid::Field::velocity_y,
                 GasGrid::Field::velocity_z, GasGrid::Field::pressure}) {
    if (a.field(f) != b.field(f)) return false;
  }
  return true;
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "skips",
              .title = "CPU time up to the instant, over that with nothing left out",
              .columns = {{"blast", "1"},
                          {"skip", "1"},
                          {"front", "m"},
                          {"time", "s"},
                          {"cpu", "s"},
                          {"factor", "1"},
                          {"updates_left_out", "1"},
                          {"cells_stored", "1"},
                          {"density_l1", "kg/m^3"},
                          {"identical", "1"}},
              .rows = {},
              .facts = {{"cells", long{cells}}}};
  bool identical = true, mapped_ok = true, star_ok = true;
  double least_factor = 1e300;
  std::string factors, mapped_text, star_text;
  double done = 0;
  for (Blast const& b : blasts) {
    GasGrid all(octant(b, true, true)), none(octant(b, false, false)), tiles(octant(b, true, false)),
        star(octant(b, false, true));
    for (GasGrid* g : {&all, &none, &tiles, &star}) g->set_state([&](Vec3 const& x) { return ball(b, x); });
    GasLine fine = line_of(b, 12 * cells), thirds = line_of(b, 3 * cells);
    std::optional<GasGrid> mapped;
    double cpu_all = 0, cpu_none = 0, cpu_tiles = 0, cpu_star = 0, cpu_mapped = 0;
    for (double radius : radii) {
      if (context.progress) context.progress(done++ / 6.0, fmt::format("{} to {:g} m", b.name, radius));
      // the instant at which the fine line's front gets there
      while (true) {
        std::size_t at = fine.cells();
        while (at > 0 && !(fine.pressure()[at - 1] > 2.0 * b.ambient)) --at;
        if (at > 0 && fine.faces()[at] >= radius) break;
        if (fine.step(1e300).status != StepStatus::ok) throw std::runtime_error("skip: the line failed");
      }
      double const t = fine.time();
      cpu_none += advance(none, t), cpu_star += advance(star, t), cpu_tiles += advance(tiles, t),
          cpu_all += advance(all, t);
      if (!mapped) {
        cpu_mapped += advance(thirds, t);
        double const start = process_cpu_seconds();
        GasGridSetup setup = octant(b, true, true);
        LineToGrid const map(thirds, {0, 0, 0}, {setup.lower, setup.upper, setup.cells});
        mapped.emplace(setup);
        mapped->set_cells([&](Int3 const& c) { return map(c); }, t);
        cpu_mapped += process_cpu_seconds() - start;
      } else {
        cpu_mapped += advance(*mapped, t);
      }
      auto const row = [&](char const* what, GasGrid const& g, double cpu, bool equal) {
        GridCounters const& n = g.counters();
        double const left_out = static_cast<double>(n.cells_skipped) /
                                std::max<double>(1.0, static_cast<double>(n.cells_skipped + n.cell_updates));
        table.rows.push_back({std::string(b.name), std::string(what), radius, t, cpu, cpu_none / cpu, left_out,
                              static_cast<double>(g.cells_stored()) / static_cast<double>(g.cell_count()),
                              error_against(g, fine), std::string(equal ? "yes" : "no")});
      };
      bool const a = same(tiles, none), c = same(all, star);
      identical = identical && a && c;
      row("nothing", none, cpu_none, true);
      row("uniform tiles", tiles, cpu_tiles, a);
      row("weak faces", star, cpu_star, false);
      row("both", all, cpu_all, c);
      row("and 1D at first", *mapped, cpu_mapped, false);
      factors += fmt::format("{} at {:g} m {:.2f}; ", b.name, radius, cpu_star / cpu_all);
      if (radius == radii[0]) least_factor = std::min(least_factor, cpu_star / cpu_all);
      double const e_grid = error_against(all, fine), e_mapped = error_against(*mapped, fine),
                   e_star = error_against(star, fine), e_none = error_against(none, fine);
      star_ok = star_ok && std::fabs(e_star / e_none - 1.0) <= 0.01;
      mapped_ok = mapped_ok && e_mapped <= 1.02 * e_grid;
      mapped_text += fmt::format("{} at {:g} m {:.3g} against {:.3g}; ", b.name, radius, e_mapped, e_grid);
      star_text += fmt::format("{} at {:g} m {:.4g} against {:.4g}; ", b.name, radius, e_star, e_none);
    }
  }
  return {
      {table},
      {{"leaving out uniform tiles changes no bit", identical ? "identical at every instant" : "DIFFERENT", identical},
       {"it saves time while the wave is small: factor > 1.2 at the first instant", factors, least_factor > 1.2},
       {"the run that starts in one dimension is at least as close to the fine line as that on the grid alone",
        mapped_text, mapped_ok},
       {"the acoustic star state on weak faces changes the density error by 1 % at most: with it against without",
        star_text, star_ok}}};
}

}  // namespace

Study skip_study() {
  return {"skip", "what a scene does not need is left out without changing a bit, or with an error that is measured",
          run};
}

}  // namespace g27
