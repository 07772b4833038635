#include "verification/cases/manufactured_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/cases/media.hpp"
#include "verification/mms/manufactured_nd.hpp"

namespace g27 {

namespace {

/// Travelling waves of 10 % in all variables (density in JWL products 5 %, in Mie-Grueneisen 1 %: with 10 % it would
/// lie below the cold curve), at speeds that are no characteristic of the gas. Periodic on the unit box. In two
/// dimensions nothing moves along z.
struct Waves {
  double rho0, c, p0, swing;
  int dimensions;

  template <class T>
  FlowOf<T> operator()(std::array<T, 3> const& x, T const& t) const {
    using std::cos, std::sin;
    double const k = 2.0 * std::numbers::pi, K = rho0 * c * c;
    T const s = c * t;
    T const rho = rho0 * (1.0 + swing * sin(k * (x[0] + x[1] - x[2] - 0.6 * s)));
    T const u = c * (0.3 + 0.1 * cos(k * (x[0] - x[1] + 0.4 * s)));
    T const v = c * (-0.2 + 0.1 * sin(k * (x[1] + x[2] - 0.3 * s) + 0.5));
    T const w = dimensions > 2 ? c * (0.1 + 0.1 * cos(k * (x[0] + x[2] + 0.5 * s))) : T(0.0);
    T const p = p0 + 0.1 * K * (1.1 + sin(k * (x[0] - x[1] + x[2] - 0.2 * s) + 1.0));
    return {rho, {u, v, w}, p};
  }
};

template <std::size_t D, class Law>
GridProblem manufactured(Medium const& m, Law const& law) {
  ManufacturedNd<D, Waves, Law> const fields(
      Waves{m.base.rho, m.sound, m.base.p, std::min(0.1, m.density_swing), int{D}}, law);
  GridProblem grid{.eos = m.eos, .dimensions = static_cast<int>(D), .t_end = (D == 2 ? 0.5 : 0.25) / m.sound};
  make_periodic(grid);
  grid.source = fields.grid_source();
  grid.initial = [=](Vec3 const& x, Vec3 const& h) { return fields.average(x, h, 0.0); };
  grid.reference = [=, t = grid.t_end](Vec3 const& x, Vec3 const& h) { return fields.average(x, h, t); };
  return grid;
}

}  // namespace

Case manufactured_grid_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 2 ? 64 : 24;
  return {.name = name,
          .title = "manufactured waves in all variables and directions, driven by their source terms",
          .source = "method of manufactured solutions: Roache, J. Fluids Eng. 124 (2002) 4",
          .dimensions = dimensions,
          .default_cells = cells,
          .eos = media(),
          .meshes = grid_meshes(),
          .run = [=](CaseOptions const& options) {
            Medium const m = medium(options.eos.value_or("ideal"));
            GridProblem const grid = std::visit(
                [&](auto const& law) { return dimensions == 2 ? manufactured<2>(m, law) : manufactured<3>(m, law); },
                m.exact);
            return run_problem(name, cells, grid, options);
          }};
}

}  // namespace g27
