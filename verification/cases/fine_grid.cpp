#include "verification/cases/fine_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace g27 {

namespace {

/// Running integrals of the conserved densities at the faces of the fine grid.
struct FineGrid {
  double x0, h;
  std::vector<GasConserved<>> integral;

  [[nodiscard]] GasConserved<> to(double x) const {
    double const s = std::clamp((x - x0) / h, 0.0, static_cast<double>(integral.size() - 1));
    std::size_t const k = std::min(static_cast<std::size_t>(s), integral.size() - 2);
    double const f = s - static_cast<double>(k);
    GasConserved<> const &a = integral[k], &b = integral[k + 1];
    return {a.mass + f * (b.mass - a.mass), a.momentum + f * (b.momentum - a.momentum),
            a.energy + f * (b.energy - a.energy)};
  }
  [[nodiscard]] GasConserved<> mean(double a, double b) const {
    GasConserved<> const l = to(a), r = to(b);
    return {(r.mass - l.mass) / (b - a), (r.momentum - l.momentum) / (b - a), (r.energy - l.energy) / (b - a)};
  }
};

std::shared_ptr<FineGrid const> compute(LineProblem const& problem, int cells) {
  GasLineSetup setup{.eos = problem.eos,
                     .faces = mesh_faces("uniform", problem.x0, problem.x1, cells),
                     .left = problem.left,
                     .right = problem.right,
                     .options = {.predictor = Predictor::muscl, .riemann = RiemannSolver::hllc, .cfl = problem.cfl}};
  GasLine line(std::move(setup));
  std::vector<GasConserved<>> averages;
  for (std::size_t i = 0; i < line.cells(); ++i)
    averages.push_back(problem.initial(line.faces()[i], line.faces()[i + 1]));
  line.set_averages(averages);
  while (line.time() < problem.t_end) {
    if (line.step(problem.t_end).status != StepStatus::ok) throw std::runtime_error("the fine-grid reference failed");
  }
  auto grid = std::make_shared<FineGrid>(FineGrid{problem.x0, (problem.x1 - problem.x0) / cells, {{0, 0, 0}}});
  for (std::size_t i = 0; i < line.cells(); ++i) {
    GasConserved<> const q = line.average(i), &s = grid->integral.back();
    grid->integral.push_back(
        {s.mass + grid->h * q.mass, s.momentum + grid->h * q.momentum, s.energy + grid->h * q.energy});
  }
  return grid;
}

}  // namespace

CellMean fine_grid_reference(std::string const& name, LineProblem const& problem, int cells) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<FineGrid const>> kept;
  std::lock_guard const lock(mutex);
  auto& grid = kept[name];
  if (!grid) grid = compute(problem, cells);
  return [grid](double a, double b) { return grid->mean(a, b); };
}

}  // namespace g27
