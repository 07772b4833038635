#include "fsi/overset/body_integrals.hpp"

#include <cmath>

#include "fsi/overset/cut_cells.hpp"

namespace g27 {

BodyIntegrals integrals(Body const& body, int rays) {
  namespace f = solid_field_of;
  CellKinds const& kinds = body.solid.kinds;
  auto const parts = parts_within(kinds, rays);
  double const cell = std::pow(kinds.box().h, 3);
  BodyIntegrals out;
  out.volume = mass_properties(body.surface).volume;
  double all = 0, cut = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    all += parts[i].share;
    if (!kinds.valid(i)) cut += parts[i].share;
  }
  double const scale = cut > 0 ? 1 + (out.volume / cell - all) / cut : 1.0;
  struct Piece {
    double mass;
    Vec3 x, u;
  };
  std::vector<Piece> pieces;
  Vec3 first{0, 0, 0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!(parts[i].share > 0)) continue;
    bool const whole = kinds.valid(i);
    Vec3 const x = whole ? kinds.centre(kinds.cell(i)) : (1 / parts[i].share) * parts[i].moment;
    SolidFields const q =
        whole ? body.solid.states[i] : body.solid.donors.at(x, Donors<SolidFields>::From::valid, body.background);
    double const m = cell * q[f::rho] * (whole ? 1.0 : scale * parts[i].share);
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
