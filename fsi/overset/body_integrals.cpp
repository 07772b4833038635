#include "fsi/overset/body_integrals.hpp"

#include <cmath>

#include "fsi/overset/cut_cells.hpp"

namespace g27 {

namespace {

/// Integral over a triangle of the product of two linear functions with these values at its corners, over its area.
double mean_product(Vec3 const& f, Vec3 const& g) noexcept {
  double const sum = (f[0] + f[1] + f[2]) * (g[0] + g[1] + g[2]);
  return (sum + dot(f, g)) / 12;
}

/// The same of three.
double mean_product(Vec3 const& f, Vec3 const& g, Vec3 const& h) noexcept {
  double const F = f[0] + f[1] + f[2], G = g[0] + g[1] + g[2], H = h[0] + h[1] + h[2];
  double const corners = f[0] * g[0] * h[0] + f[1] * g[1] * h[1] + f[2] * g[2] * h[2];
  return (F * G * H + F * dot(g, h) + G * dot(f, h) + H * dot(f, g) + 2 * corners) / 60;
}

}  // namespace

Enclosed enclosed(Body const& body) { return enclosed(body.surface, body.cut.mirrors); }

Enclosed enclosed(TriangleSurface const& surface, Mirrors const& m) {
  // By the divergence of x_k F along an axis k that at most one plane cuts, with x_k = 0 there: then neither that
  // plane's part of the boundary counts nor those of planes across other axes.
  std::size_t axis = 0;
  while (axis < 2 && m.low[axis] && m.high[axis]) ++axis;
  BoundingBox const box = bounding_box(surface);
  Vec3 origin = 0.5 * (box.lower + box.upper);
  if (m.across(axis)) origin[axis] = m.low[axis] ? m.lower[axis] : m.upper[axis];
  Enclosed out;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    auto const corners = surface.corners(t);
    double const area = surface.area_vector(t)[axis];
    std::array<Vec3, 3> x;  // [axis][corner]
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t c = 0; c < 3; ++c) x[a][c] = corners[c][a] - origin[a];
    }
    out.volume += area / 3 * (x[axis][0] + x[axis][1] + x[axis][2]);
    for (std::size_t a = 0; a < 3; ++a) out.centroid[a] += (a == axis ? 0.5 : 1.0) * area * mean_product(x[axis], x[a]);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = a; b < 3; ++b) {
        double const along = 1 + (a == axis ? 1 : 0) + (b == axis ? 1 : 0);
        out.moments[tensor_place[a][b]] += area / along * mean_product(x[axis], x[a], x[b]);
      }
    }
  }
  out.centroid = (1 / out.volume) * out.centroid;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b)
      out.moments[tensor_place[a][b]] -= out.volume * out.centroid[a] * out.centroid[b];
  }
  out.centroid = out.centroid + origin;
  return out;
}

namespace {

BodyIntegrals integrals_of(RigidBody const& rigid, double volume) {
  BodyIntegrals out{.volume = volume, .mass = rigid.mass(), .centre = rigid.state.centre};
  out.momentum = rigid.state.momentum, out.angular = rigid.state.angular, out.inertia = rigid.moments();
  out.energy = out.kinetic = rigid.kinetic_energy();
  return out;
}

}  // namespace

BodyIntegrals integrals(Body const& body, int rays) {
  if (body.rigid) return integrals_of(*body.rigid, enclosed(body).volume);
  namespace f = solid_field_of;
  CellKinds const& kinds = body.solid.kinds;
  auto const parts = parts_within(kinds, rays);
  double const cell = std::pow(kinds.box().h, 3);
  BodyIntegrals out;
  out.volume = enclosed(body).volume;
  double all = 0, cut = 0;
  for (CellPart const& part : parts) {
    all += part.share;
    if (!kinds.valid(part.cell)) cut += part.share;
  }
  double const scale = cut > 0 ? 1 + (out.volume / cell - all) / cut : 1.0;
  struct Piece {
    double mass;
    Vec3 x, u;
  };
  std::vector<Piece> pieces;
  Vec3 first{0, 0, 0};
  for (CellPart const& part : parts) {
    std::size_t const i = part.cell;
    bool const whole = kinds.valid(i);
    Vec3 const x = whole ? kinds.centre(kinds.cell(i)) : (1 / part.share) * part.moment;
    SolidFields const q =
        whole ? body.solid.states[i] : body.solid.donors.at(x, Donors<SolidFields>::From::valid, body.background);
    double const m = cell * q[f::rho] * (whole ? 1.0 : scale * part.share);
    Vec3 const u = velocity_of(q);
    pieces.push_back({m, x, u});
    out.mass += m, out.momentum = out.momentum + m * u, first = first + m * x;
    double const K =
        std::visit([&](auto const& eos) { return eos.bulk_modulus(q[f::rho], q[f::p]); }, body.setup.material.eos);
    double squares = 0;
    for (std::size_t c = 0; c < 6; ++c) squares += (c < 3 ? 1 : 2) * q[f::S + c] * q[f::S + c];
    double const shear = body.setup.material.mu > 0 ? squares / (4 * body.setup.material.mu) : 0.0;
    out.strain += m / q[f::rho] * (0.5 * q[f::p] * q[f::p] / K + shear);
    out.kinetic += 0.5 * m * dot(u, u), out.energy += m * (q[f::e] + 0.5 * dot(u, u));
  }
  out.centre = (1 / out.mass) * first;
  for (Piece const& p : pieces) {
    Vec3 const r = p.x - out.centre;
    out.angular = out.angular + p.mass * cross(r, p.u);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = a; b < 3; ++b) out.inertia[tensor_place[a][b]] += p.mass * r[a] * r[b];
    }
  }
  return out;
}

}  // namespace g27
