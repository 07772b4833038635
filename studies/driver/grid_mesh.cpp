#include "studies/driver/grid_mesh.hpp"

#include "scheme/grid/cell_place.hpp"
#include "studies/driver/grid_simulate.hpp"

namespace g27 {
namespace {

/// Gas alone.
class GasMesh : public GridMesh {
 public:
  explicit GasMesh(SceneRun const& run) : grid_(make_grid(run)) {}

  [[nodiscard]] GasGrid const& gas() const override { return grid_; }
  void start(std::function<GasDensities(Int3 const& cell)> const& cells,
             std::function<GasPoint(Vec3 const& x)> const& /*point*/, double time) override {
    grid_.set_cells(cells, time);
  }
  void resume(GridRestart const& from) override {
    Int3 const n = grid_.cells();
    grid_.set_cells(
        [&](Int3 const& c) -> GasDensities {
          auto const& q = from.averages;
          std::size_t const i = cell_number(n, c);
          return {q[0][i], {q[1][i], q[2][i], q[3][i]}, q[4][i]};
        },
        from.time);
  }
  GridStepReport step(double t_end) override { return grid_.step(t_end); }
  void capture_state(GridRestart& now) const override {
    Int3 const n = grid_.cells();
    for (auto& field : now.averages) field.resize(cells_in(n));
    for_each_cell(n, [&](Int3 const& cell) {
      GasDensities const q = grid_.solid(cell) ? GasDensities{} : grid_.average(cell);
      double const values[] = {q.mass, q.momentum[0], q.momentum[1], q.momentum[2], q.energy};
      for (std::size_t f = 0; f < 5; ++f) now.averages[f][cell_number(n, cell)] = values[f];
    });
  }

 private:
  GasGrid grid_;
};

}  // namespace

std::pair<double, double> GridMesh::totals() const {
  GridLedger const ledger = gas().ledger();
  return {ledger.mass.current, ledger.energy.current};
}

void GridMesh::capture_totals(GridRestart const& before, bool resumed, GridRestart& now) const {
  now.time = time();
  GridCounters const& c = gas().counters();
  GridCounters total = before.counters;
  total.steps += c.steps, total.faces += c.faces, total.cell_updates += c.cell_updates, total.switched += c.switched;
  total.linear_star += c.linear_star, total.repaired += c.repaired, total.floored += c.floored;
  total.retried += c.retried, total.cured += c.cured, total.cells_skipped += c.cells_skipped;
  now.counters = total;
  GridLedger const ledger = gas().ledger();
  now.ledger = resumed ? before.ledger : ledger;
  if (resumed) {
    add(now.ledger.mass, ledger.mass);
    add(now.ledger.energy, ledger.energy);
    for (std::size_t d = 0; d < 3; ++d) {
      add(now.ledger.momentum[d], ledger.momentum[d]);
    }
  }
}

std::unique_ptr<GridMesh> make_mesh(SceneRun const& run) {
  return run.grid->bodies.empty() ? std::make_unique<GasMesh>(run) : make_body_mesh(run);
}

}  // namespace g27
