#include "studies/driver/grid_mesh.hpp"

#include <algorithm>

#include "studies/driver/grid_simulate.hpp"

namespace g27 {
namespace {

std::size_t index_of(Int3 const& cells, Int3 const& c) {
  auto const n = [&](std::size_t d) { return static_cast<std::size_t>(cells[d]); };
  return static_cast<std::size_t>(c[0]) +
         n(0) * (static_cast<std::size_t>(c[1]) + n(1) * static_cast<std::size_t>(c[2]));
}

void add(LedgerEntry& total, LedgerEntry const& part) {
  total.current = part.current;
  total.through_boundary += part.through_boundary;
  total.from_source += part.from_source;
  total.from_floor += part.from_floor;
  total.scale = std::max(total.scale, part.scale);
}

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
          std::size_t const i = index_of(n, c);
          return {q[0][i], {q[1][i], q[2][i], q[3][i]}, q[4][i]};
        },
        from.time);
  }
  GridStepReport step(double t_end) override { return grid_.step(t_end); }
  void capture_state(GridRestart& now) const override {
    Int3 const n = grid_.cells();
    for (auto& field : now.averages) {
      field.resize(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) * static_cast<std::size_t>(n[2]));
    }
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i) {
          std::size_t const at = index_of(n, {i, j, k});
          GasDensities const q = grid_.solid({i, j, k}) ? GasDensities{} : grid_.average({i, j, k});
          double const values[] = {q.mass, q.momentum[0], q.momentum[1], q.momentum[2], q.energy};
          for (std::size_t f = 0; f < 5; ++f) {
            now.averages[f][at] = values[f];
          }
        }
      }
    }
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
