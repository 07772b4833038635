/// End of a solid line that is bonded to another solid: what leaves it, and its face at the contact found.
#include <algorithm>

#include "scheme/step/solid_line_end.hpp"

namespace g27 {

namespace {

template <class W>
BondedTrace bonded_trace(W const& w, Triple<double> const& out) noexcept {
  BondedTrace t;
  Triple<double> const b = w.unproject(out);
  for (std::size_t j = 0; j < 3; ++j) {
    Triple<double> unit{};
    unit[static_cast<int>(j)] = 1.0;
    Triple<double> column = w.project(unit);
    for (int k = 0; k < 3; ++k) column[k] *= w.z[k];
    column = w.unproject(column);
    for (std::size_t i = 0; i < 3; ++i) t.Z[i][j] = column[static_cast<int>(i)];
    t.b[j] = b[static_cast<int>(j)];
  }
  return t;
}

Triple<double> triple(FaceVector const& v) noexcept { return {{v[0], v[1], v[2]}}; }

}  // namespace

BondedSide SolidLine::Impl::bonded_side(LineEnd end, double dt) {
  set_terms(dt);
  End const here(*this, end == LineEnd::left, dt);
  auto const traced = [&](auto const& w) { return bonded_trace(w, here.outgoing(w).amplitude); };
  SolidState<double> const c0 = here.q.state<double>(here.edge);
  BondedSide side{.elastic = traced(ElasticWaves<double>(here.at.frozen)),
                  .S = {c0.S[0], c0.S[3], c0.S[4]},
                  .u = {c0.u[0], c0.u[1], c0.u[2]}};
  double const Y = strength.Y0 + strength.H * c0.ep;
  side.yields = plastic && setup.options.tangent && mises_squared(c0.S) > yield_share * Y * Y;
  if (!side.yields) return side;
  side.tangent = traced(TangentWaves<double>(here.at.frozen, strength));
  if (here.terms != nullptr) side.work = here.terms->at<double>(solid_cell::work, here.edge) * line.h[here.edge] / dt;
  return side;
}

SolidFace<double> SolidLine::Impl::bonded_face(bool low, double dt, BondedContact const& contact) {
  End const here(*this, low, dt);
  Triple<double> const u = triple(contact.u), s = triple(contact.s);
  auto const carried = [&](auto const& w) {
    SolidState<double> const foot = here.outgoing(w).foot;
    return carry(foot, w.path(w.project(s - foot.traction())), u, s);
  };
  bool const yields = low ? contact.plastic_above : contact.plastic_below;
  SolidFace<double> face =
      yields ? carried(TangentWaves<double>(here.at.frozen, strength)) : carried(ElasticWaves<double>(here.at.frozen));
  if (plastic) radial_return(strength, face.S, face.ep);
  return face;
}

}  // namespace g27
