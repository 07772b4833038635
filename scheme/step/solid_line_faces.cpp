/// Faces of a solid line: ghost cells, half-step terms of curved symmetry, predictor and Riemann problems.
#include <algorithm>
#include <cmath>

#include "scheme/kernel/solid_boundary_loop.hpp"
#include "scheme/kernel/solid_transverse_loop.hpp"
#include "scheme/step/solid_boundary.hpp"
#include "scheme/step/solid_line_impl.hpp"

namespace g27 {

namespace {

constexpr double extrapolated_share = 0.5;  ///< of the density, that an extrapolation may take off or add

/// The cell at `to` becomes the mirror image of that at `from`.
void mirror(FieldRows const& row, int fields, std::ptrdiff_t to, std::ptrdiff_t from) noexcept {
  for (int d = 0; d < fields; ++d) row[d][to] = row[d][from];
  for (int d : {solid_cell::u, solid_cell::S + 3, solid_cell::S + 4}) row[d][to] = -row[d][to];
}

/// Whether the four cells around face f have one state.
bool uniform_around(FieldRows const& row, std::ptrdiff_t f) noexcept {
  for (int d = 0; d < solid_cell::state; ++d) {
    double const* const v = row[d] + f;
    if (v[-2] != v[-1] || v[-1] != v[0] || v[0] != v[1]) return false;
  }
  return true;
}

}  // namespace

void SolidLine::Impl::all_faces(double dt) {
  switched = tangents = 0;
  fill_ghosts();
  set_terms(dt);
  switch (setup.options.predictor) {
    case Predictor::godunov:
      inner_faces<Predictor::godunov>(dt);
      break;
    case Predictor::parabolic:
      inner_faces<Predictor::parabolic>(dt);
      break;
    default:
      inner_faces<Predictor::linear>(dt);
  }
  for (bool low : {true, false}) boundary_face(low, dt);
}

void SolidLine::Impl::fill_ghosts() {
  FieldRows const row = cell.rows();
  for (bool low : {true, false}) {
    std::ptrdiff_t const edge = low ? 0 : cells() - 1, inward = low ? 1 : -1;
    if ((low ? setup.left : setup.right).kind == SolidBoundary::Kind::symmetry) {
      for (std::ptrdiff_t k = 0; k < line_ghosts; ++k)
        mirror(row, solid_cell::fields, edge - (k + 1) * inward, edge + k * inward);
      continue;
    }
    // linear; the ghost is as wide as its neighbour
    double const by = 2.0 * line.h[edge] / (line.h[edge] + line.h[edge + inward]);
    double const* const rho = row[solid_cell::rho];
    double const share = std::fabs(by * (rho[edge] - rho[edge + inward])) <= extrapolated_share * rho[edge] ? by : 0.0;
    for (int d = 0; d < solid_cell::fields; ++d)
      row[d][edge - inward] = row[d][edge] + share * (row[d][edge] - row[d][edge + inward]);
    double& ep = row[solid_cell::ep][edge - inward];
    ep = std::max(ep, 0.0);
  }
}

/// Half a step of what curvature adds: the hoop strain rates u/r, and the push of the hoop stress.
void SolidLine::Impl::set_terms(double dt) {
  namespace at = solid_cell;
  if (hoops == 0) return;
  FieldRows const q = cell.rows(), to = term.rows();
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double here[at::state];
    for (int d = 0; d < at::state; ++d) here[d] = q[d][i];
    std::size_t const k = static_cast<std::size_t>(i);
    double const strain = 0.5 * dt / centroid_between(line.symmetry, line.x[k], line.x[k + 1]);
    double const inv_rho = 1.0 / here[at::rho];
    for (int d = 0; d < at::terms; ++d) to[d][i] = 0.0;
    auto const add = [&](auto axis) {
      double d[at::state]{};
      d[at::u + axis] = strain * here[at::u];
      SolidRateTerm<double> const r = rate_of<axis>(strength.mu, here, d, q[at::K][i], q[at::f][i], inv_rho);
      for (int c = 0; c < at::state; ++c) to[c][i] -= r.q[c];
      to[at::work][i] += r.work;
      to[at::u][i] += strain * (here[at::S] - here[at::S + axis]) * inv_rho;
    };
    add(std::integral_constant<int, 1>{});
    if (hoops == 2) add(std::integral_constant<int, 2>{});
  }
  for (bool low : {true, false}) {
    if ((low ? setup.left : setup.right).kind != SolidBoundary::Kind::symmetry) continue;
    std::ptrdiff_t const edge = low ? 0 : cells() - 1;
    mirror(to, at::terms, low ? -1 : cells(), edge);
  }
}

template <Predictor predictor>
void SolidLine::Impl::inner_faces(double dt) {
  FieldRows const row = cell.rows(), terms = term.rows();
  SolidFaceArguments const g{.faces = 1,
                             .stride = 1,
                             .axis = 0,
                             .cells = row,
                             .left = {},
                             .right = {},
                             .dt = dt,
                             .h = 0,
                             .strength = strength,
                             .plastic = plastic,
                             .tangent = setup.options.tangent,
                             .monotonicity = setup.options.monotonicity,
                             .out = {},
                             .switched = 0,
                             .tangents = 0};
  SolidFrameRows const q(row, 0, solid_cell::fields), left(terms, 0, solid_cell::terms),
      right(terms.from(1), 0, solid_cell::terms);
  SolidSlope<predictor> const slopes{setup.options.monotonicity};
  std::ptrdiff_t const first = setup.left.kind == SolidBoundary::Kind::symmetry ? 0 : 1;
  std::ptrdiff_t const last = setup.right.kind == SolidBoundary::Kind::symmetry ? cells() : cells() - 1;
  for (std::ptrdiff_t f = first; f <= last; ++f) {
    // all differences vanish: the face has the state of its cells
    if (hoops == 0 && uniform_around(row, f)) {
      SolidState<double> const a = q.state<double>(f);
      face(f) = {.rho = a.rho, .e = a.e, .ep = a.ep, .u = a.velocity(), .s = a.traction(), .S = {}};
      std::copy(std::begin(a.S), std::end(a.S), face(f).S);
      continue;
    }
    RidingCells const around(&line.h[f - 2]);
    SolidStencil<RidingCells, double> const s{
        q, hoops > 0 ? &left : nullptr, hoops > 0 ? &right : nullptr, f - 1, 1, dt * around.inv_length, around};
    SolidFaceResult<double> const r = solid_face_between(slopes, g, s);
    face(f) = r.face;
    switched += r.switched, tangents += r.tangent ? 1.0 : 0.0;
  }
  if (first == 0) face(0).u[0] = 0.0;
  if (last == cells()) face(last).u[0] = 0.0;
}

RidingCells SolidLine::Impl::cells_at_end(bool low) const {
  std::ptrdiff_t const edge = low ? 0 : cells() - 1, inward = low ? 1 : -1;
  // z a b: away from the boundary to it
  double const h[4]{line.h[edge + 2 * inward], line.h[edge + inward], line.h[edge], line.h[edge]};
  return RidingCells(h);
}

SolidBoundaryArguments SolidLine::Impl::boundary_arguments(bool low, double dt, RidingCells const& around) {
  return {.faces = 1,
          .inward = low ? 1 : -1,
          .axis = 0,
          .side = low ? -1.0 : 1.0,
          .kind = condition_of((low ? setup.left : setup.right).kind),
          .given = {},
          .cells = cell.rows(),
          .terms = {},
          .dt = dt,
          .h = 1.0 / around.inv_length,
          .strength = strength,
          .plastic = plastic,
          .tangent = setup.options.tangent,
          .predictor = setup.options.predictor,
          .limited = setup.options.monotonicity != Switch::off,
          .out = {}};
}

void SolidLine::Impl::boundary_face(bool low, double dt) {
  SolidBoundary const& b = low ? setup.left : setup.right;
  if (b.kind == SolidBoundary::Kind::symmetry) return;
  bool const shared = b.kind == SolidBoundary::Kind::contact;
  auto const& met = low ? contacts.left : contacts.right;
  SolidFace<double>& f = face(low ? 0 : cells());
  if (auto const* const bonded = shared ? std::get_if<BondedContact>(&met) : nullptr) {
    f = bonded_face(low, dt, *bonded);
    return;
  }
  RidingCells const around = cells_at_end(low);
  SolidBoundaryArguments const g = boundary_arguments(low, dt, around);
  Vec3 value = given_value(b, 0, {low ? line.x.front() : line.x.back(), 0, 0}, time, dt);
  if (shared) value = {-std::get<Contact>(met).p, 0, 0};
  SolidFrameRows const q(g.cells, 0, solid_cell::fields), terms(term.rows(), 0, solid_cell::terms);
  f = solid_boundary_face<RidingCells, double>(g, around, q, hoops > 0 ? &terms : nullptr, low ? 0 : cells() - 1,
                                               {{value[0], value[1], value[2]}});
  // the contact's velocity is the surface's at this pressure; from its own solver, so that both media have the same
  if (shared) f.u[0] = std::get<Contact>(met).u;
}

}  // namespace g27
