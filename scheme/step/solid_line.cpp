#include "scheme/step/solid_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scheme/step/gauss.hpp"
#include "scheme/step/solid_line_impl.hpp"

namespace g27 {

SolidVector SolidParcel::densities(double v) const noexcept {
  double const inv = 1.0 / v, rho = mass * inv;
  return {rho,        momentum[0] * inv, momentum[1] * inv, momentum[2] * inv, energy * inv, rho * S[0],
          rho * S[1], rho * S[2],        rho * S[3],        rho * S[4],        rho * S[5],   rho * ep};
}

SolidLineSetup SolidLine::Impl::checked(SolidLineSetup s) {
  using Kind = SolidBoundary::Kind;
  if (s.faces.size() < 5) throw std::invalid_argument("a line of a solid needs at least 4 cells");
  for (std::size_t f = 1; f < s.faces.size(); ++f) {
    if (!(s.faces[f] > s.faces[f - 1])) throw std::invalid_argument("face positions must increase");
  }
  if (s.symmetry != Symmetry::planar && s.faces.front() < 0) {
    throw std::invalid_argument("curved symmetry needs positions >= 0");
  }
  for (SolidBoundary const* b : {&s.left, &s.right}) {
    if (b->kind == Kind::periodic || b->kind == Kind::outflow || b->kind == Kind::inflow) {
      throw std::invalid_argument(
          "cells that move with the material are bounded by symmetry, wall, fixed, traction, free or contact");
    }
  }
  if (s.symmetry != Symmetry::planar && s.faces.front() == 0 && s.left.kind != Kind::symmetry) {
    throw std::invalid_argument("a line that begins at the centre is symmetric there");
  }
  if (!(s.material.mu >= 0)) throw std::invalid_argument("the shear modulus is not negative");
  if (s.options.predictor == Predictor::muscl) throw std::invalid_argument("solids have no MUSCL-Hancock predictor");
  if (!(s.options.cfl > 0)) s.options.cfl = s.material.plastic() ? plastic_cfl : elastic_cfl;
  return s;
}

SolidLine::Impl::Impl(SolidLineSetup s)
    : setup(checked(std::move(s))),
      n(setup.faces.size() - 1),
      law(*solid_kernels().eos[setup.material.eos.index()]),
      eos(std::visit([](auto const& e) -> void const* { return &e; }, setup.material.eos)),
      strength{setup.material.mu, setup.material.Y0, setup.material.H},
      plastic(setup.material.plastic()),
      hoops(static_cast<int>(setup.symmetry)),
      line(setup.faces, setup.symmetry, false, false),
      now(n),
      next(n),
      faces(n + 1),
      speeds(n + 1, 0.0),
      conserved(solid_conserved::fields, n + 4, 1.0),
      cell(solid_cell::fields, n + 4),
      new_cell(solid_cell::fields, n + 4),
      term(solid_cell::terms, n + 4) {}

void SolidLine::Impl::primitives(std::vector<SolidParcel> const& parcels, std::vector<double> const& x, RowBlock& to) {
  FieldRows const q = conserved.rows();
  for (std::size_t k = 0; k < n; ++k) {
    SolidVector const v = parcels[k].densities(measure_between(setup.symmetry, x[k], x[k + 1]));
    for (std::size_t d = 0; d < v.size(); ++d) q[static_cast<int>(d)][k] = v[d];
  }
  law.primitive({.cells = n, .eos = eos, .conserved = q, .cell = to.rows()});
}

double SolidLine::Impl::signal_rate(RowBlock& rows, std::vector<double> const& x, std::size_t& bad) {
  namespace at = solid_cell;
  FieldRows const q = rows.rows(), old = cell.rows();
  double most = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double const rho = q[at::rho][k], stiff = q[at::K][k] + 4.0 / 3.0 * strength.mu, f = q[at::f][k];
    double const M = stiff - f * q[at::S][k];
    double const softest = stiff - f * std::max({q[at::S][k], q[at::S + 1][k], q[at::S + 2][k]});
    double const r = std::sqrt(M / rho) / (x[k + 1] - x[k]);
    if (!(softest > 0 && rho > least_density_share * old[at::rho][k] && r < 1e300 && std::isfinite(q[at::u][k]))) {
      bad = k;
      return -1;
    }
    most = std::max(most, r);
  }
  return most;
}

void SolidLine::Impl::start() {
  time = 0;
  counters = {};
  initial = boundary = source = {};
  plastic_work = {};
  scale = {};
  primitives(now, line.x, cell);
  add_totals(initial, scale);
  std::size_t bad = 0;
  rate = signal_rate(cell, line.x, bad);
  if (!(rate > 0)) throw std::invalid_argument("cell " + std::to_string(bad) + " is no state of the material");
}

void SolidLine::Impl::add_totals(std::array<Accumulator, 5>& total, std::array<double, 5>& magnitude) {
  namespace at = solid_cell;
  FieldRows const q = cell.rows();
  for (std::size_t k = 0; k < n; ++k) {
    SolidParcel const& p = now[k];
    double const M = q[at::K][k] + 4.0 / 3.0 * strength.mu, volume = line.measure[static_cast<std::ptrdiff_t>(k)];
    total[0].add(p.mass), total[4].add(p.energy);
    magnitude[0] += p.mass, magnitude[4] += std::fabs(p.energy) + volume * M;
    for (std::size_t c = 0; c < 3; ++c) {
      total[1 + c].add(p.momentum[c]);
      magnitude[1 + c] += std::fabs(p.momentum[c]) + p.mass * std::sqrt(M / q[at::rho][k]);
    }
  }
}

SolidLine::SolidLine(SolidLineSetup setup) : impl_(std::make_unique<Impl>(std::move(setup))) {}
SolidLine::~SolidLine() = default;
SolidLine::SolidLine(SolidLine&&) noexcept = default;
SolidLine& SolidLine::operator=(SolidLine&&) noexcept = default;

void SolidLine::set_state(std::function<SolidPoint(double x)> const& state, int points) {
  auto const& eos = impl_->setup.material.eos;
  set_averages([&](double x0, double x1) {
    SolidVector sum{};
    double const measure = cell_quadrature(impl_->setup.symmetry, x0, x1, points, [&](double x, double weight) {
      SolidVector const q = conserved_of(eos, state(x));
      for (std::size_t d = 0; d < q.size(); ++d) sum[d] += weight * q[d];
    });
    for (double& v : sum) v /= measure;
    return densities_of(sum);
  });
}

void SolidLine::set_averages(std::function<SolidDensities(double x0, double x1)> const& mean) {
  Impl& m = *impl_;
  for (std::size_t k = 0; k < m.n; ++k) {
    SolidDensities const q = mean(m.line.x[k], m.line.x[k + 1]);
    double const v = m.line.measure[static_cast<std::ptrdiff_t>(k)];
    SolidParcel& p = m.now[k];
    p.mass = v * q.mass, p.energy = v * q.energy, p.ep = q.rho_ep / q.mass;
    for (std::size_t c = 0; c < 3; ++c) p.momentum[c] = v * q.momentum[c];
    for (std::size_t c = 0; c < 6; ++c) p.S[c] = q.rho_S[c] / q.mass;
  }
  m.start();
}

StepReport SolidLine::step(double t_end) { return impl_->step(t_end); }
double SolidLine::next_dt(double t_end, double shrink) const { return impl_->choose_dt(t_end, shrink); }
SolidTrace SolidLine::trace(LineEnd end, double dt) { return impl_->trace(end, dt); }
BondedSide SolidLine::bonded_side(LineEnd end, double dt) { return impl_->bonded_side(end, dt); }
StepReport SolidLine::attempt(double dt, SolidContacts const& contacts) {
  impl_->contacts = contacts;
  return impl_->attempt(dt, false);
}
void SolidLine::accept() { impl_->accept(); }
std::size_t SolidLine::cells() const noexcept { return impl_->n; }
double SolidLine::time() const noexcept { return impl_->time; }
std::vector<double> const& SolidLine::faces() const noexcept { return impl_->line.x; }
std::vector<double> const& SolidLine::face_speeds() const noexcept { return impl_->speeds; }
double SolidLine::measure(std::size_t cell) const noexcept {
  return impl_->line.measure[static_cast<std::ptrdiff_t>(cell)];
}
SolidDensities SolidLine::average(std::size_t cell) const noexcept {
  return densities_of(impl_->now[cell].densities(measure(cell)));
}
SolidPoint SolidLine::primitive(std::size_t cell) const noexcept {
  return primitive_of(impl_->setup.material.eos, vector_of(average(cell)));
}

std::vector<double> SolidLine::field(SolidGrid::Field which) const {
  std::vector<double> out(cells());
  for (std::size_t k = 0; k < out.size(); ++k) {
    SolidPoint const s = primitive(k);
    out[k] = solid_field(which, s, internal_energy(vector_of(average(k))));
  }
  return out;
}

double SolidLine::kinetic_energy() const noexcept {
  double sum = 0;
  for (SolidParcel const& p : impl_->now) {
    for (double q : p.momentum) sum += 0.5 * q * q / p.mass;
  }
  return sum;
}

SolidCounters const& SolidLine::counters() const noexcept { return impl_->counters; }

SolidLedger SolidLine::ledger() const {
  Impl& m = *impl_;
  std::array<Accumulator, 5> total{};
  std::array<double, 5> magnitude{};
  m.add_totals(total, magnitude);
  return solid_ledger(m.initial, total, m.boundary, m.source, m.scale, magnitude, m.plastic_work);
}

SolidLineSetup const& SolidLine::setup() const noexcept { return impl_->setup; }

}  // namespace g27
