#pragma once
/// Faces of a row that bound the body: outgoing amplitudes extrapolated linearly from two cells (parabolically from
/// three), then what the boundary gives.
#include "scheme/kernel/solid_face_loop.hpp"
#include "scheme/predictor/one_sided.hpp"

namespace g27 {

/// What reaches the face: the amplitudes of the outgoing families, and the particle that lies on it.
template <Lane V>
struct Outgoing {
  Triple<V> amplitude;
  SolidState<V> foot;
};

template <class Cells, class W, Lane V>
G27_INLINE Outgoing<V> outgoing(SolidBoundaryArguments const& g, Cells const& cells, W const& w,
                                SolidFrameRows const& q, SolidFrameRows const* terms, SolidState<V> const& at_face,
                                std::ptrdiff_t f) noexcept {
  double const nu = g.dt / g.h;
  SolidState<V> const c0 = q.state<V>(f), c1 = q.state<V>(f + g.inward), c2 = q.state<V>(f + 2 * g.inward);
  Triple<V> const u[3] = {w.project(c0.velocity()), w.project(c1.velocity()), w.project(c2.velocity())};
  Triple<V> const s[3] = {w.project(c0.traction()), w.project(c1.traction()), w.project(c2.traction())};
  SolidState<V> foot = at_face;
  Triple<V> tu{}, ts{};
  if (terms != nullptr) {
    SolidState<V> t = terms->state<V>(f);
    if constexpr (W::plastic) {
      V const by = w.kap * terms->at<V>(solid_cell::work, f);
      unrolled<6>([&](auto k) G27_INLINE_LAMBDA { t.S[k] -= by * w.at.S[k]; });
      t.ep += max(by, 0.0) * w.q * (1.0 / (3.0 * w.at.mu));
    }
    tu = w.project(t.velocity()), ts = w.project(t.traction());
    foot.rho += t.rho, foot.e += t.e, foot.p += t.p, foot.ep += t.ep;
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { foot.S[k] += t.S[k]; });
  }
  Triple<V> out;
  unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
    V const z = w.z[k], swept = max(V(g.side * cells.relative(at_face.u[0]) + w.lambda[k] * w.inv_z[k]), 0.0) * nu;
    auto const F = [&](int i) G27_INLINE_LAMBDA { return V(z * u[i][k] - g.side * s[i][k]); };
    out[k] = one_sided(g.predictor, g.limited, cells, F(0), F(1), F(2), swept);
    if (terms != nullptr) out[k] += z * tu[k] - g.side * ts[k];
  });
  return {out, foot};
}

template <class Cells, class W, Lane V>
[[gnu::noinline]] SolidFace<V> boundary_state(SolidBoundaryArguments const& g, Cells const& cells, W const& w,
                                              SolidFrameRows const& q, SolidFrameRows const* terms,
                                              SolidState<V> const& at_face, std::ptrdiff_t f,
                                              Triple<V> const& given) noexcept {
  Outgoing<V> const out = outgoing(g, cells, w, q, terms, at_face, f);
  Triple<V> face_u, face_s;
  boundary_face(w, g.kind, g.side, out.amplitude, given, face_u, face_s);
  return carry(out.foot, w.path(w.project(face_s - out.foot.traction())), face_u, face_s);
}

/// The state at the face, extrapolated as far as the switch on the normal stress lets it, with rho c^2 and f there.
template <Lane V>
struct BoundaryState {
  SolidState<V> state;
  FrozenSolid<V> frozen;
};

template <class Cells, Lane V>
G27_INLINE BoundaryState<V> extrapolated_state(SolidBoundaryArguments const& g, Cells const& cells,
                                               SolidFrameRows const& q, std::ptrdiff_t f) noexcept {
  SolidState<V> const c0 = q.state<V>(f), c1 = q.state<V>(f + g.inward), c2 = q.state<V>(f + 2 * g.inward);
  V const d = cells.gradient(V(c0.traction()[0] - c1.traction()[0]), 1), zero(0.0);
  V const far = cells.gradient(V(c1.traction()[0] - c2.traction()[0]), 0);
  V share(0.5);
  if (g.predictor == Predictor::godunov)
    share = zero;
  else if (g.limited)
    share *= graded_share(far, d);
  auto const extrapolated = [&](V a, V b)
                                G27_INLINE_LAMBDA { return V(a + share * cells.own(Mask<V>(false), V(a - b))); };
  SolidState<V> s;
  s.rho = extrapolated(c0.rho, c1.rho), s.p = extrapolated(c0.p, c1.p);
  s.e = extrapolated(c0.e, c1.e), s.ep = max(extrapolated(c0.ep, c1.ep), 0.0);
  unrolled<3>([&](auto k) G27_INLINE_LAMBDA { s.u[k] = extrapolated(c0.u[k], c1.u[k]); });
  unrolled<6>([&](auto k) G27_INLINE_LAMBDA { s.S[k] = extrapolated(c0.S[k], c1.S[k]); });
  auto const at = [&](int field)
                      G27_INLINE_LAMBDA { return extrapolated(q.at<V>(field, f), q.at<V>(field, f + g.inward)); };
  return {s, frozen(s, V(at(solid_cell::K)), V(at(solid_cell::f)), g.strength.mu)};
}

/// The face of the boundary beside cell f of the rows. `terms`: half-step terms, null: none.
template <class Cells, Lane V>
G27_INLINE SolidFace<V> solid_boundary_face(SolidBoundaryArguments const& g, Cells const& cells,
                                            SolidFrameRows const& q, SolidFrameRows const* terms, std::ptrdiff_t f,
                                            Triple<V> const& given) noexcept {
  SolidState<V> const c0 = q.state<V>(f);
  auto const [at_face, frozen_at] = extrapolated_state<Cells, V>(g, cells, q, f);
  SolidFace<V> face = boundary_state(g, cells, ElasticWaves<V>(frozen_at), q, terms, at_face, f, given);
  if (g.plastic) {
    if (g.tangent) {
      V const Y = g.strength.Y0 + g.strength.H * c0.ep;
      Mask<V> loaded = mises_squared(c0.S) > yield_share * Y * Y;
      if (any(loaded)) {
        SolidFace<V> const yielding =
            boundary_state(g, cells, TangentWaves<V>(frozen_at, g.strength), q, terms, at_face, f, given);
        // loaded where S:D between the cell and the face is positive
        V work(0.0);
        if (terms != nullptr) work = terms->template at<V>(solid_cell::work, f);
        int const shear[3] = {0, 3, 4};
        V const rate = g.side * (g.dt / cells.own(Mask<V>(false), V(g.h)));
        unrolled<3>([&](auto k) G27_INLINE_LAMBDA { work += rate * c0.S[shear[k]] * (face.u[k] - c0.u[k]); });
        loaded = loaded && work > 0.0 && yielding.rho > 0.2 * c0.rho;
        auto const take = [&](V& to, V const& from) G27_INLINE_LAMBDA { to = select(loaded, from, to); };
        take(face.rho, yielding.rho), take(face.e, yielding.e), take(face.ep, yielding.ep);
        unrolled<3>([&](auto k) G27_INLINE_LAMBDA { take(face.u[k], yielding.u[k]), take(face.s[k], yielding.s[k]); });
        unrolled<6>([&](auto k) G27_INLINE_LAMBDA { take(face.S[k], yielding.S[k]); });
      }
    }
    radial_return(g.strength, face.S, face.ep);
  }
  return face;
}

template <Lane V>
void solid_boundary(SolidBoundaryArguments& g) noexcept {
  SolidFrameRows const q(g.cells, g.axis, solid_cell::fields);
  bool const terms = g.terms.data != nullptr;
  SolidFrameRows const term(terms ? g.terms : g.cells, g.axis, solid_cell::terms);
  SolidFluxRows const out(g.out, g.axis);
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces);
  for (std::ptrdiff_t f = 0; f < n; f += static_cast<std::ptrdiff_t>(width<V>)) {
    Triple<V> given;
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA { given[k] = load<V>(g.given[(g.axis + k) % 3] + f); });
    out.put(f, solid_boundary_face(g, EqualCells{}, q, terms ? &term : nullptr, f, given));
  }
}

}  // namespace g27
