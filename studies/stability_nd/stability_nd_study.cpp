/// Largest stable CFL number in two and three dimensions, for each form of the transverse half-step term: predicted
/// from the amplification matrices of Fourier modes, and measured on noise.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include "scheme/step/gas_grid.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/media.hpp"
#include "verification/exact/von_neumann.hpp"

namespace g27 {
namespace {

constexpr double noise_amplitude = 1e-8, resolution = 0.01, highest = 1.2, recommended = 0.8;
constexpr double allowed_growth = 1.02;  ///< of the noise's energy in the second half
constexpr double allowed_peak = 2.0;     ///< of the noise's energy over the initial one, ever
constexpr std::array machs{0.0, 0.5, 1.0, 3.0};

struct Row {
  int dimensions;
  Predictor predictor;
  Transverse transverse;
  bool max_rule;
};

std::string name_of(Transverse t) {
  return t == Transverse::own_cell ? "own cell" : t == Transverse::averaged ? "averaged" : "none";
}

StabilityModel model_of(Row const& row) {
  return {.dimensions = row.dimensions,
          .predictor = row.predictor == Predictor::godunov  ? ModelPredictor::first_order
                       : row.predictor == Predictor::linear ? ModelPredictor::linear
                                                            : ModelPredictor::parabolic,
          .transverse = row.transverse == Transverse::own_cell   ? ModelTransverse::own_cell
                        : row.transverse == Transverse::averaged ? ModelTransverse::averaged
                                                                 : ModelTransverse::none,
          .max_rule = row.max_rule};
}

/// Energy of the deviations in the symmetrised variables: what a stable scheme does not let grow for long.
double noise_energy(GasGrid const& grid, GasPoint const& base, double c) {
  double energy = 0;
  Int3 const n = grid.cells();
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        GasPoint const s = grid.primitive({i, j, k});
        double const p = (s.p - base.p) / (base.rho * c * c), S = s.rho / base.rho - 1.0 - p;
        energy += p * p + S * S;
        for (std::size_t a = 0; a < 3; ++a) energy += (s.u[a] - base.u[a]) * (s.u[a] - base.u[a]) / (c * c);
      }
    }
  }
  return energy;
}

bool stable(Row const& row, double cfl) {
  Medium const m = medium("ideal");
  int const n = row.dimensions == 3 ? 12 : 24, steps = row.dimensions == 3 ? 200 : 400;
  for (double const mach : machs) {
    for (int direction = 0; direction < (mach > 0 ? 3 : 1); ++direction) {
      std::array<Vec3, 3> const along{{{1, 0, 0}, {1, 1, row.dimensions == 3 ? 1.0 : 0.0}, {1, 0.5, 0}}};
      Vec3 const& d = along[static_cast<std::size_t>(direction)];
      double const length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      GasPoint const base{
          m.base.rho,
          {mach * m.sound * d[0] / length, mach * m.sound * d[1] / length, mach * m.sound * d[2] / length},
          m.base.p};
      GasGridSetup setup{.eos = m.eos, .cells = {n, n, row.dimensions == 3 ? n : 1}};
      for (GridBoundary& b : setup.sides) b.kind = GridBoundary::Kind::periodic;
      setup.options.predictor = row.predictor, setup.options.monotonicity = Switch::off;
      setup.options.transverse = row.transverse, setup.options.max_rule = row.max_rule, setup.options.cfl = cfl;
      GasGrid grid(setup);
      std::mt19937_64 generator(11);
      std::uniform_real_distribution<double> uniform(-noise_amplitude, noise_amplitude);
      grid.set_state(
          [&](Vec3 const&) {
            GasPoint s = base;
            s.rho *= 1.0 + uniform(generator), s.p += base.rho * m.sound * m.sound * uniform(generator);
            for (int a = 0; a < row.dimensions; ++a) s.u[static_cast<std::size_t>(a)] += m.sound * uniform(generator);
            return s;
          },
          1);
      double const start = noise_energy(grid, base, m.sound);
      double half = 0;
      for (int k = 0; k < steps; ++k) {
        if (k == steps / 2) half = noise_energy(grid, base, m.sound);
        if (grid.step(1e30).status != StepStatus::ok) return false;
        if (k % 10 == 9 && !(noise_energy(grid, base, m.sound) <= allowed_peak * start)) return false;
      }
      if (!(noise_energy(grid, base, m.sound) <= allowed_growth * half)) return false;
    }
  }
  return true;
}

double measured_limit(Row const& row) {
  if (stable(row, highest)) return highest;
  double low = 0, high = highest;
  while (high - low > resolution) {
    double const middle = 0.5 * (low + high);
    (stable(row, middle) ? low : high) = middle;
  }
  return low;
}

StudyReport run(StudyContext const& context) {
  Table table{
      .name = "limits",
      .title = "largest stable CFL number: predicted for Fourier modes, measured on noise",
      .columns = {{"dimensions", "1"},
                  {"scheme", "1"},
                  {"transverse", "1"},
                  {"rule", "1"},
                  {"predicted", "1"},
                  {"measured", "1"}},
      .rows = {},
      .facts = {{"amplitude of the noise", noise_amplitude}, {"resolution", resolution}, {"highest tried", highest}}};
  std::vector<Row> rows;
  for (int d : {2, 3}) {
    for (bool max_rule : {false, true}) {
      rows.push_back({d, Predictor::godunov, Transverse::none, max_rule});
      for (Predictor p : {Predictor::linear, Predictor::parabolic}) {
        for (Transverse t : {Transverse::own_cell, Transverse::averaged, Transverse::none})
          rows.push_back({d, p, t, max_rule});
      }
    }
  }
  std::vector<Finding> findings;
  double worst = 0, least = highest;
  std::string where, at_least;
  double done = 0;
  bool worse = true;
  std::string ablations;
  for (Row const& row : rows) {
    std::string const scheme = row.predictor == Predictor::godunov  ? "godunov"
                               : row.predictor == Predictor::linear ? "linear"
                                                                    : "parabolic";
    std::string const term = row.predictor == Predictor::godunov ? "-" : name_of(row.transverse);
    std::string const label = fmt::format("{}D {} {} {}", row.dimensions, scheme, term, row.max_rule ? "max" : "sum");
    if (context.progress) context.progress(done / static_cast<double>(rows.size()), label);
    double const predicted = stability_limit(model_of(row), machs.data(), static_cast<int>(machs.size()), highest,
                                             resolution, row.dimensions == 3 ? 6 : 12);
    double const measured = measured_limit(row);
    table.rows.push_back({static_cast<long>(row.dimensions), scheme, term, std::string(row.max_rule ? "max" : "sum"),
                          predicted, measured});
    if (row.transverse == Transverse::own_cell && !row.max_rule && measured < least) least = measured, at_least = label;
    if (std::fabs(predicted - measured) > worst && row.transverse != Transverse::none)
      worst = std::fabs(predicted - measured), where = label;
    if (row.transverse == Transverse::none && row.predictor != Predictor::godunov) {
      worse = worse && measured < 0.5;
      ablations += fmt::format("{} {:.2f}; ", label, measured);
    }
    done += 1;
  }
  findings.push_back({"each side's own term, sum rule, 2D and 3D: stable at CFL 0.8 and beyond",
                      fmt::format("least limit {:.2f} ({})", least, at_least), least >= recommended});
  findings.push_back({"prediction and measurement agree to 0.1", fmt::format("{:.2f} apart at most ({})", worst, where),
                      worst <= 0.1});
  findings.push_back({"without the transverse term the second-order predictors are not usable", ablations, worse});
  return {{table}, findings};
}

}  // namespace

Study stability_nd_study() {
  return {"stability-nd",
          "with each side's own transverse term CFL 0.8 of the sum rule is stable in two and three dimensions, as "
          "predicted",
          run};
}

}  // namespace g27
