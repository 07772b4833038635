#include "scheme/step/gas_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "scheme/step/gas_line_impl.hpp"
#include "scheme/step/gauss.hpp"

namespace g27 {

GasLine::Impl::Impl(GasLineSetup s)
    : setup(std::move(s)),
      predictor(predictor_kernel(setup.options.predictor, setup.options.monotonicity, setup.options.feet,
                                 setup.options.single_foot)),
      law(*kernels.eos[setup.eos.index()]),
      n(checked_cells(setup)),
      eos(std::visit([](auto const& e) -> void const* { return &e; }, setup.eos)),
      exponent(std::visit([](auto const& e) { return e.isentropic_exponent(); }, setup.eos)),
      moving(setup.motion.kind != MeshMotion::Kind::fixed),
      curved(setup.symmetry != Symmetry::planar),
      plain(false),
      cell_feet(predictor == PredictorKernel::linear_cell_feet),
      line(setup.faces, setup.symmetry, setup.left.kind == GasBoundary::Kind::periodic, !moving),
      now(n + 2),
      next(n + 2),
      faces(n + 1),
      other_faces(cell_feet ? n + 1 : 0),
      u_mean(is_third_order(predictor) ? n + 2 : 0),
      p_mean(is_third_order(predictor) ? n + 2 : 0),
      dK_dp(is_third_order(predictor) ? n + 2 : 0),
      inc_rho(n + 2),
      inc_u(n + 2),
      inc_p(n + 2),
      src_mass(n),
      src_momentum(n),
      src_energy(n),
      switch_counts(n + 1, 0.0),
      redone(n + 1, 0) {
  plain = line.uniform() && !curved && !setup.source.mean && !cell_feet && !setup.burn.there();
  problems.assign(static_cast<std::size_t>(std::max(1, setup.options.threads)), FaceProblems(face_chunk + 16));
  if (cell_feet) line.set_cell_feet(setup.options.feet == FootPoints::printed_3_10);
}

std::size_t GasLine::Impl::checked_cells(GasLineSetup const& s) {
  if (s.faces.size() < 4) throw std::invalid_argument("a line needs at least 3 cells");
  for (std::size_t f = 1; f < s.faces.size(); ++f) {
    if (!(s.faces[f] > s.faces[f - 1])) throw std::invalid_argument("face positions must increase");
  }
  if (s.symmetry != Symmetry::planar && s.faces.front() < 0) {
    throw std::invalid_argument("curved symmetry needs positions >= 0");
  }
  if (s.burn.there() && (s.source.mean || s.options.feet != FootPoints::conservative)) {
    throw std::invalid_argument("a burn goes with conservative feet and without other sources");
  }
  using Kind = GasBoundary::Kind;
  if ((s.left.kind == Kind::periodic) != (s.right.kind == Kind::periodic)) {
    throw std::invalid_argument("a periodic boundary needs its partner");
  }
  MeshMotion::Kind const motion = s.motion.kind;
  if ((s.left.kind == Kind::contact || s.right.kind == Kind::contact) && motion != MeshMotion::Kind::stretched &&
      motion != MeshMotion::Kind::lagrangian) {
    throw std::invalid_argument("a contact moves, and needs a mesh that does: stretched or lagrangian");
  }
  return s.faces.size() - 1;
}

void GasLine::Impl::primitives(GasCells& c, std::ptrdiff_t begin, std::size_t count) const noexcept {
  law.primitive({.cells = count,
                 .eos = eos,
                 .mass = c.mass.data() + begin,
                 .momentum = c.momentum.data() + begin,
                 .energy = c.energy.data() + begin,
                 .rho = c.rho.data() + begin,
                 .u = c.u.data() + begin,
                 .p = c.p.data() + begin,
                 .K = c.K.data() + begin,
                 .margin = c.margin.data() + begin});
}

double GasLine::Impl::energy_density(GasState<> const& s) const noexcept {
  return s.rho * std::visit([&](auto const& e) { return e.energy(s.rho, s.p); }, setup.eos) + 0.5 * s.rho * s.u * s.u;
}

void GasLine::Impl::start(double t) {
  primitives(now, 0, n);
  time = t;
  counters = {};
  initial = boundary = source = floor = {};
  scale = {0, 0, 0};
  add_totals(initial, &scale);
  rate = signal_rate(now, false);
  largest_density = 0;
  for (std::ptrdiff_t i = 0; i < cells(); ++i) largest_density = std::max(largest_density, now.rho[i]);
}

void GasLine::Impl::add_totals(Accumulators& a, GasConserved<>* magnitude) const noexcept {
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const v = line.measure[i];
    GasConserved<> const q = now.average(i);
    a.add(v * q.mass, v * q.momentum, v * q.energy);
    if (magnitude != nullptr) {
      magnitude->mass += v * std::fabs(q.mass);
      magnitude->momentum += v * (std::fabs(q.momentum) + std::sqrt(now.K[i] * now.rho[i]));
      magnitude->energy += v * (std::fabs(q.energy) + now.K[i]);
    }
  }
}

double GasLine::Impl::signal_rate(GasCells const& c, bool relative) const noexcept {
  double most = 0;
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const sound = std::sqrt(c.K[i] * (1.0 / c.rho[i]));  // as after a step, bit by bit
    double speed = std::fabs(c.u[i]);
    if (relative) speed = std::max(std::fabs(c.u[i] - line.w[i]), std::fabs(c.u[i] - line.w[i + 1]));
    double const r = (speed + sound) * line.inv_h[i];
    if (!(r <= most)) most = r;  // a NaN stays
  }
  return most;
}

GasLine::GasLine(GasLineSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
GasLine::~GasLine() = default;
GasLine::GasLine(GasLine&&) noexcept = default;
GasLine& GasLine::operator=(GasLine&&) noexcept = default;

void GasLine::set_state(std::function<GasState<>(double x)> const& state, int points) {
  std::vector<GasConserved<>> averages(impl_->n);
  for (std::size_t i = 0; i < impl_->n; ++i) {
    averages[i] = cell_average(impl_->setup.symmetry, impl_->line.x[i], impl_->line.x[i + 1], points,
                               [&](double x) -> GasConserved<> {
                                 GasState<> const s = state(x);
                                 return {s.rho, s.rho * s.u, impl_->energy_density(s)};
                               });
  }
  set_averages(averages);
}

void GasLine::set_averages(std::span<GasConserved<> const> averages, double time) {
  if (averages.size() != impl_->n) throw std::invalid_argument("one average a cell is needed");
  for (std::size_t i = 0; i < impl_->n; ++i) {
    std::ptrdiff_t const k = static_cast<std::ptrdiff_t>(i);
    impl_->now.mass[k] = averages[i].mass;
    impl_->now.momentum[k] = averages[i].momentum;
    impl_->now.energy[k] = averages[i].energy;
  }
  impl_->start(time);
}

StepReport GasLine::step(double t_end) { return impl_->step(t_end); }
double GasLine::next_dt(double t_end, double shrink) {
  Impl& m = *impl_;
  m.prepare();
  // until it is known a contact moves as the gas beside it
  m.contacts = {.left = {.u = m.now.u[0]}, .right = {.u = m.now.u[m.cells() - 1]}};
  return m.choose_dt(t_end, shrink);
}
GasState<> GasLine::trace(LineEnd end, double dt) { return impl_->trace(end, dt); }
StepReport GasLine::attempt(double dt, LineContacts const& contacts) {
  impl_->contacts = contacts;
  impl_->set_face_speeds(dt);
  return impl_->attempt(dt, false);
}
void GasLine::accept() { impl_->accept(); }
std::size_t GasLine::cells() const noexcept { return impl_->n; }
double GasLine::time() const noexcept { return impl_->time; }
double GasLine::stable_dt() const noexcept { return impl_->setup.options.cfl / impl_->rate; }
std::span<double const> GasLine::faces() const noexcept { return impl_->line.x; }
std::span<double const> GasLine::density() const noexcept { return {impl_->now.rho.data(), impl_->n}; }
std::span<double const> GasLine::velocity() const noexcept { return {impl_->now.u.data(), impl_->n}; }
std::span<double const> GasLine::pressure() const noexcept { return {impl_->now.p.data(), impl_->n}; }
std::span<double const> GasLine::bulk_modulus() const noexcept { return {impl_->now.K.data(), impl_->n}; }
GasConserved<> GasLine::average(std::size_t cell) const noexcept {
  return impl_->now.average(static_cast<std::ptrdiff_t>(cell));
}
double GasLine::measure(std::size_t cell) const noexcept {
  return impl_->line.measure[static_cast<std::ptrdiff_t>(cell)];
}
std::span<double const> GasLine::switch_map() const noexcept { return impl_->switch_counts; }

GasState<> GasLine::left_face() const noexcept {
  GasFaces const& f = impl_->faces;
  return {impl_->now.rho[0], f.u[0], f.p[0]};
}
GasState<> GasLine::right_face() const noexcept {
  GasFaces const& f = impl_->faces;
  std::ptrdiff_t const last = impl_->cells();
  return {impl_->now.rho[last - 1], f.u[last], f.p[last]};
}
GasCounters const& GasLine::counters() const noexcept { return impl_->counters; }

GasLedger GasLine::ledger() const noexcept {
  Accumulators total;
  GasConserved<> magnitude{0, 0, 0};
  impl_->add_totals(total, &magnitude);
  auto const entry = [](Accumulator const& start, Accumulator const& end, Accumulator const& through,
                        Accumulator const& source, Accumulator const& floor, double scale) {
    return LedgerEntry{.initial = start.value(),
                       .current = end.value(),
                       .through_boundary = through.value(),
                       .from_source = source.value(),
                       .from_floor = floor.value(),
                       .scale = scale};
  };
  Impl const& m = *impl_;
  return {entry(m.initial.mass, total.mass, m.boundary.mass, m.source.mass, m.floor.mass,
                std::max(m.scale.mass, magnitude.mass)),
          entry(m.initial.momentum, total.momentum, m.boundary.momentum, m.source.momentum, m.floor.momentum,
                std::max(m.scale.momentum, magnitude.momentum)),
          entry(m.initial.energy, total.energy, m.boundary.energy, m.source.energy, m.floor.energy,
                std::max(m.scale.energy, magnitude.energy))};
}

GasLineSetup const& GasLine::setup() const noexcept { return impl_->setup; }

}  // namespace g27
