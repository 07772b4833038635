#include "verification/cases/oblique_wave.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "verification/exact/numerics.hpp"
#include "verification/exact/simple_wave.hpp"

namespace g27 {

namespace {

/// Velocity perturbation of a periodic simple wave at one time, tabulated over its phase: Hermite cubics whose error is
/// below round-off of the state.
class Perturbation {
 public:
  Perturbation(SimpleWave const& wave, double base, double t) {
    for (int i = 0; i < nodes; ++i) w_.push_back(wave.at(static_cast<double>(i) / nodes, t).u - base);
  }
  [[nodiscard]] double at(double s) const {
    double const place = (s - std::floor(s)) * nodes;
    int const i = static_cast<int>(place);
    return hermite(place - i, 1.0 / nodes, w(i), slope(i), w(i + 1), slope(i + 1));
  }

 private:
  static constexpr int nodes = 2048;
  [[nodiscard]] double w(int i) const { return w_[static_cast<std::size_t>((i + nodes) % nodes)]; }
  [[nodiscard]] double slope(int i) const {  // differences of fourth order
    return nodes * (8 * (w(i + 1) - w(i - 1)) - (w(i + 2) - w(i - 2))) / 12;
  }
  std::vector<double> w_;
};

}  // namespace

ObliqueBox oblique_box(int dimensions) {
  if (dimensions == 2) {
    double const root = std::sqrt(5.0);
    return {{1 / root, 2 / root, 0}, {root, root / 2, 1}};
  }
  return {{1.0 / 3, 2.0 / 3, 2.0 / 3}, {3, 1.5, 1.5}};
}

ObliqueBox uneven_box() { return {{0.48, 0.6, 0.64}, {25.0 / 12, 5.0 / 3, 25.0 / 16}}; }

Case acoustic_case(std::string const& name, int dimensions) {
  int const cells = dimensions == 2 ? 128 : 48;
  auto const run = [=](CaseOptions const& options) {
    Medium const m = medium(options.eos.value_or("ideal"));
    ObliqueBox const box = oblique_box(dimensions);
    bool const frame = options.mesh.value_or("fixed") == "frame";
    double const c = frame ? 0.0 : m.sound;
    Vec3 const flow{0.3 * c, -0.1 * c, dimensions > 2 ? 0.15 * c : 0.0};
    double const across = flow[0] * box.normal[0] + flow[1] * box.normal[1] + flow[2] * box.normal[2];
    double const a = 1e-5 * m.sound, k = 2.0 * std::numbers::pi;
    auto const wave = std::make_shared<SimpleWave>(
        m.exact, GasState<>{m.base.rho, across, m.base.p}, [=](double s) { return a * std::sin(k * s); }, a);
    GridProblem grid{.eos = m.eos, .dimensions = dimensions, .upper = box.upper, .t_end = 1 / (m.sound + across)};
    make_periodic(grid);
    auto const at = [=](double t) {
      auto const perturbation = std::make_shared<Perturbation>(*wave, across, t);
      return mean_of(m.eos, dimensions, [=](Vec3 const& x) -> GasPoint {
        double const w = perturbation->at(x[0] * box.normal[0] + x[1] * box.normal[1] + x[2] * box.normal[2]);
        GasState<> const s = wave->state_of(w);
        return {s.rho, {flow[0] + w * box.normal[0], flow[1] + w * box.normal[1], flow[2] + w * box.normal[2]}, s.p};
      });
    };
    grid.initial = at(0.0), grid.reference = at(grid.t_end);
    return run_problem(name, cells, grid, options);
  };
  return {.name = name,
          .title = "oblique sound wave of amplitude 1e-5 c over one period",
          .source = "exact simple wave: Courant and Friedrichs (1948), section 40",
          .dimensions = dimensions,
          .default_cells = cells,
          .eos = media(),
          .meshes = grid_meshes(true),
          .run = run};
}

}  // namespace g27
