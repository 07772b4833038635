/// Gas with bodies in it, as a run on a grid advances it.
#include <fmt/format.h>

#include <algorithm>

#include "fsi/surface/gap.hpp"
#include "studies/driver/body_history.hpp"
#include "studies/driver/body_ledger.hpp"
#include "studies/driver/body_output.hpp"
#include "studies/driver/grid_mesh.hpp"
#include "studies/driver/grid_simulate.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

OversetSetup setup_of(SceneRun const& run) {
  GridRun const& plan = *run.grid;
  OversetSetup out;
  out.gas = plan.setup;
  for (SceneBody const& body : plan.bodies) out.bodies.push_back(body.setup);
  GridSchemeOptions const& o = plan.setup.options;
  out.solid_options.predictor = out.local.predictor = o.predictor;
  out.solid_options.monotonicity = out.local.monotonicity = o.monotonicity;
  out.solid_options.transverse = o.transverse;
  out.solid_options.threads = o.threads;
  out.local.riemann = o.riemann;
  out.closure = plan.closure, out.remeshing.on = plan.remeshing;
  out.cfl = plan.cfl, out.solid_options.cfl = plan.body_cfl;
  return out;
}

class BodyMesh : public GridMesh {
 public:
  explicit BodyMesh(SceneRun const& run) : run_(run), setup_(setup_of(run)), empty_(make_grid(run)) {}

  [[nodiscard]] GasGrid const& gas() const override { return solver_ ? solver_->gas() : *empty_; }
  [[nodiscard]] double time() const override { return solver_ ? solver_->time() : 0.0; }
  [[nodiscard]] double stable_dt() const override { return solver_->stable_dt(); }
  [[nodiscard]] std::string trouble() const override { return trouble_; }

  void start(std::function<GasDensities(Int3 const& cell)> const& cells,
             std::function<GasPoint(Vec3 const& x)> const& point, double time) override {
    OversetSetup setup = setup_;
    setup.gas_cells = cells, setup.start = time;
    try {
      solver_.emplace(std::move(setup), point);
    } catch (std::invalid_argument const& flaw) {
      throw InputError(run_.name, "body", flaw.what(), "correct the scene");
    }
    empty_.reset();
    gas_start_ = gas_integrals(*solver_);
    ledgers_.clear();
    for (auto const& body : solver_->bodies()) ledgers_.push_back(ledger_of(integrals(*body)));
  }

  void resume(GridRestart const& from) override {
    solver_.emplace(setup_, OversetState{from.overset});
    empty_.reset();
    ledgers_ = from.bodies;
    gas_start_.mass = from.ledger.mass.initial, gas_start_.energy = from.ledger.energy.initial;
    for (std::size_t d = 0; d < 3; ++d) gas_start_.momentum[d] = from.ledger.momentum[d].initial;
  }

  GridStepReport step(double t_end) override {
    GridStepReport const report = solver_->step(t_end);
    look_for_trouble(report);
    return report;
  }

  [[nodiscard]] double bytes() const override {
    double sum = static_cast<double>(gas().bytes());
    for (auto const& body : solver_->bodies()) sum += bytes_of(*body);
    return sum;
  }
  [[nodiscard]] std::unique_ptr<GridView> view() const override { return std::make_unique<BodyFieldView>(*solver_); }
  [[nodiscard]] std::pair<double, double> totals() const override {
    GasIntegrals const now = gas_integrals(*solver_);
    return {now.mass, now.energy};
  }

  using GridMesh::complete;
  void complete(std::vector<double>& row) override {
    std::vector<BodyIntegrals> held;
    std::vector<Vec3> start;
    for (std::size_t n = 0; n < ledgers_.size(); ++n) {
      held.push_back(integrals(*solver_->bodies()[n]));
      note_scale(held.back(), ledgers_[n]);
      auto const& p = ledgers_[n].momentum;
      start.push_back({p[0].initial, p[1].initial, p[2].initial});
    }
    add_body_row(run_, *solver_, held, start, row);
  }
  void complete(GridSnapshot& shot) const override { add_bodies(run_, *solver_, shot); }

  void capture_totals(GridRestart const& before, bool resumed, GridRestart& now) const override {
    GridMesh::capture_totals(before, resumed, now);
    GasIntegrals const gas = gas_integrals(*solver_);
    now.bodies = ledgers_;
    now.ledger.mass.initial = gas_start_.mass, now.ledger.mass.current = gas.mass;
    now.ledger.energy.initial = gas_start_.energy, now.ledger.energy.current = gas.energy;
    now.ledger.energy.from_source = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      LedgerEntry& p = now.ledger.momentum[d];
      p.initial = gas_start_.momentum[d], p.current = gas.momentum[d], p.from_source = 0;
    }
    for (std::size_t n = 0; n < now.bodies.size(); ++n) {
      ContentLedger& body = now.bodies[n];
      set_current(integrals(*solver_->bodies()[n]), solver_->momenta()[n], body);
      now.ledger.energy.from_source -= body.energy.from_source;
      for (std::size_t d = 0; d < 3; ++d) now.ledger.momentum[d].from_source -= body.momentum[d].from_source;
    }
    OversetCounters const& c = solver_->counters();
    now.problems = {.solved = static_cast<double>(c.problems),
                    .first_order = static_cast<double>(c.first_order),
                    .kept = static_cast<double>(c.failed),
                    .skipped = static_cast<double>(c.skipped),
                    .renewed = static_cast<double>(c.renewed),
                    .untangled = static_cast<double>(c.untangled),
                    .tangled = static_cast<double>(c.tangled),
                    .local_s = c.seconds_local,
                    .gas_s = c.seconds_gas,
                    .bodies_s = c.seconds_solid,
                    .geometry_s = c.seconds_geometry,
                    .interpolation_s = c.seconds_fill};
  }
  void capture_state(GridRestart& now) const override { now.overset = solver_->state().arrays; }

 private:
  /// Bodies that leave their boxes, come too near to each other, or whose own grids failed.
  void look_for_trouble(GridStepReport const& report) {
    auto const& bodies = solver_->bodies();
    auto const& named = run_.grid->bodies;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      if (report.status != StepStatus::ok && bodies[n]->grid.time() < gas().time()) {
        auto const& c = report.cell;
        trouble_ = fmt::format("{} in cell ({}, {}, {}) of the grid of body '{}'", step_status_text(report.status),
                               c[0], c[1], c[2], named[n].name);
        return;
      }
      BodySetup const& setup = bodies[n]->setup;
      for (Vec3 const& x : bodies[n]->surface.vertices) {
        for (std::size_t a = 0; a < 3; ++a) {
          if (x[a] >= setup.lower[a] && x[a] <= setup.upper[a]) continue;
          trouble_ = fmt::format(
              "body '{}' has left its box, at {} = {:.6g} m of {:.6g} m to {:.6g} m; enlarge {}.extent (and the "
              "domain)",
              named[n].name, ray_names()[a], x[a], setup.lower[a], setup.upper[a], named[n].key);
          return;
        }
      }
      double const least = body_gap_cells * gas().widths()[0];
      for (std::size_t m = 0; m < n; ++m) {
        if (gap_between(bodies[m]->surface, bodies[n]->surface, least) >= least) continue;
        trouble_ = fmt::format(
            "bodies '{}' and '{}' are within a cell of the gas of each other: contact of bodies is not there; end the "
            "run sooner (time.end) or take smaller cells (domain.cells)",
            named[m].name, named[n].name);
        return;
      }
    }
  }

  SceneRun const& run_;
  OversetSetup setup_;
  std::optional<GasGrid> empty_;  ///< before the start
  std::optional<OversetSolver> solver_;
  GasIntegrals gas_start_;
  std::vector<ContentLedger> ledgers_;
  std::string trouble_;
};

}  // namespace

std::unique_ptr<GridMesh> make_body_mesh(SceneRun const& run) { return std::make_unique<BodyMesh>(run); }

}  // namespace g27
