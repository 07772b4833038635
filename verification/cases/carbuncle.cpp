#include "verification/cases/carbuncle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "verification/cases/grid_probe.hpp"
#include "verification/exact/oblique_shock.hpp"

namespace g27 {

namespace {

std::vector<CaseParameter> const parameters{{"mach", 10, "1", "Mach number of the shock", 1.01, 1000},
                                            {"noise", 1e-6, "1", "amplitude of the noise, relative", 0, 0.1},
                                            {"steps", 2000, "1", "time steps", 1, 1e7, true}};

/// A number in [-1, 1] that depends on the key alone: splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
double noise_of(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9;
  key = (key ^ (key >> 27)) * 0x94d049bb133111eb;
  key ^= key >> 31;
  return std::ldexp(static_cast<double>(key >> 11), -52) - 1;
}

/// The cell's number, from where it is.
std::uint64_t key_of(Vec3 const& centre, Vec3 const& widths, int dimensions) {
  std::uint64_t key = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
    key = 100'003 * key + static_cast<std::uint64_t>(std::llround(centre[d] / widths[d] - 0.5));
  return key;
}

}  // namespace

Case carbuncle_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 2 ? 80 : 64;
  auto const run = [=](CaseOptions const& options) {
    double const mach = value_of(parameters, options, "mach"), amplitude = value_of(parameters, options, "noise");
    // ahead c = 1
    NormalShock const shock = normal_shock(1.4, mach);
    GasPoint const ahead{1.4, {mach, 0, 0}, 1.0};
    GasPoint const behind{1.4 * shock.density_ratio, {mach / shock.density_ratio, 0, 0}, shock.pressure_ratio};
    double const c_behind = std::sqrt(1.4 * behind.p / behind.rho), width = dimensions == 2 ? 1.0 : 0.5;
    GridProblem grid{.eos = IdealGas{1.4},
                     .dimensions = dimensions,
                     .upper = {2, width, width},
                     .steps = std::lround(value_of(parameters, options, "steps"))};
    make_periodic(grid);
    grid.sides[0] = inflow_side([=](Vec3 const&, double) { return ahead; });
    grid.sides[1] = inflow_side([=](Vec3 const&, double) { return behind; });
    grid.initial = [=, eos = grid.eos](Vec3 const& x, Vec3 const& h) {
      GasPoint s = x[0] < 1 ? ahead : behind;
      double const c = x[0] < 1 ? 1.0 : c_behind;
      std::uint64_t const key = 8 * key_of(x, h, dimensions);
      s.rho *= 1 + amplitude * noise_of(key), s.p *= 1 + amplitude * noise_of(key + 1);
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        s.u[d] += c * amplitude * noise_of(key + 2 + d);
      return densities_of(eos, s);
    };
    grid.measure = [=](GasGrid const& done, CaseResult& r) {
      double across = 0;
      for (auto const which : {GasGrid::Field::velocity_y, GasGrid::Field::velocity_z}) {
        if (which == GasGrid::Field::velocity_z && dimensions < 3) continue;
        GridProbe const v(done, which);
        across = std::max({across, v.most(), -v.least()});
      }
      r.facts["transverse_velocity"] = across / c_behind;
      GridProbe const rho(done, GasGrid::Field::density);
      r.facts["density_most"] = rho.most() / behind.rho;
    };
    return run_problem(name, cells, grid, options);
  };
  return {.name = name,
          .title = "steady plane shock, aligned with the grid, with noise: velocity along it after some steps",
          .source =
              "Quirk, Int. J. Numer. Meth. Fluids 18 (1994) 555; Dumbser, Moschetta and Gressier, "
              "J. Comput. Phys. 197 (2004) 647",
          .dimensions = dimensions,
          .default_cells = cells,
          .has_reference = false,
          .meshes = grid_meshes(),
          .parameters = parameters,
          .run = run};
}

}  // namespace g27
