#pragma once
/// Faces of a row of solid cells: amplitudes traced to their feet, the linearised Riemann problem, fluxes.
///
/// Everything is in deviations from the face's mean state, so that a uniform state passes through without round-off.
#include "riemann/solid/linearised.hpp"
#include "riemann/solid/tangent.hpp"
#include "scheme/kernel/lane_sum.hpp"
#include "scheme/kernel/solid_kernels.hpp"
#include "scheme/predictor/solid_slope.hpp"

namespace g27 {

/// The fields of solid_cell in the frame of an axis.
struct SolidFrameRows {
  double const* row[solid_cell::fields];
  G27_INLINE SolidFrameRows(FieldRows const& q, int axis, int count) noexcept {
    for (int k = 0; k < count; ++k) row[k] = q[k];
    for (int k = 0; k < 3; ++k) row[solid_cell::u + k] = q[solid_cell::u + (axis + k) % 3];
    for (int k = 0; k < 6; ++k) row[solid_cell::S + k] = q[solid_cell::S + frame_component(axis, k)];
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE V at(int field, std::ptrdiff_t i) const noexcept {
    return load<V>(row[field] + i);
  }
  template <Lane V>
  [[nodiscard]] G27_INLINE SolidState<V> state(std::ptrdiff_t i) const noexcept {
    SolidState<V> q;
    q.rho = at<V>(solid_cell::rho, i), q.p = at<V>(solid_cell::p, i), q.e = at<V>(solid_cell::e, i);
    q.ep = at<V>(solid_cell::ep, i);
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA { q.u[k] = at<V>(solid_cell::u + k, i); });
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { q.S[k] = at<V>(solid_cell::S + k, i); });
    return q;
  }
};

/// Rows of a face's fluxes, its components back along x, y, z.
struct SolidFluxRows {
  double* row[solid_face::fields];
  G27_INLINE SolidFluxRows(FieldRows const& q, int axis) noexcept {
    for (int k = 0; k < solid_face::fields; ++k) row[k] = q[k];
    for (int k = 0; k < 3; ++k) row[solid_face::momentum + k] = q[solid_face::momentum + (axis + k) % 3];
    for (int k = 0; k < 3; ++k) row[solid_face::u + k] = q[solid_face::u + (axis + k) % 3];
    for (int k = 0; k < 6; ++k) row[solid_face::S + k] = q[solid_face::S + frame_component(axis, k)];
  }
  template <Lane V>
  G27_INLINE void put(std::ptrdiff_t f, SolidFace<V> const& q) const noexcept {
    V const m = q.rho * q.u[0];
    V kinetic(0.0), power(0.0);
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      kinetic += 0.5 * q.u[k] * q.u[k], power += q.s[k] * q.u[k];
      store(row[solid_face::momentum + k] + f, V(m * q.u[k] - q.s[k]));
      store(row[solid_face::u + k] + f, q.u[k]);
    });
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { store(row[solid_face::S + k] + f, q.S[k]); });
    store(row[solid_face::mass] + f, m), store(row[solid_face::ep] + f, q.ep);
    store(row[solid_face::energy] + f, V(m * (q.e + kinetic) - power));
  }
};

/// Loads around a face: interval 0, 1, 2 lies between cells z a, a b, b y; differences are over its length.
template <class Cells, Lane V>
struct SolidStencil {
  SolidFrameRows const& q;
  SolidFrameRows const *left, *right;  ///< half-step terms; null: none
  std::ptrdiff_t f, stride;
  double nu;  ///< dt/h, h the distance of the centres beside the face
  Cells cells;

  [[nodiscard]] G27_INLINE V difference(int field, int interval) const noexcept {
    std::ptrdiff_t const at = f + (interval - 1) * stride;
    return cells.gradient(V(q.template at<V>(field, at + stride) - q.template at<V>(field, at)), interval);
  }
  [[nodiscard]] G27_INLINE Triple<V> velocity(int interval) const noexcept {
    return {{difference(solid_cell::u, interval), difference(solid_cell::u + 1, interval),
             difference(solid_cell::u + 2, interval)}};
  }
  [[nodiscard]] G27_INLINE Triple<V> traction(int interval) const noexcept {
    return {{difference(solid_cell::S, interval) - difference(solid_cell::p, interval),
             difference(solid_cell::S + 3, interval), difference(solid_cell::S + 4, interval)}};
  }
};

/// rho, e, S22, S33, S23, ep: what rides with the velocity, as rows of solid_cell in the frame.
inline constexpr int solid_carried[6] = {solid_cell::rho,   solid_cell::e,     solid_cell::S + 1,
                                         solid_cell::S + 2, solid_cell::S + 5, solid_cell::ep};

template <Lane V>
G27_INLINE void carried_changes(PathChange<V> const& c, V rho, V (&out)[6]) noexcept {
  out[0] = -rho * c.g1, out[1] = c.e, out[2] = c.S22, out[3] = c.S33, out[4] = c.S23, out[5] = c.ep;
}

/// The face between cells a and b, families `w` frozen at their mean `m`. `tangent`: the terms' plastic part is added,
/// from S:D of each cell. `exempt`: smooth extrema are left alone.
/// Out of line: a function of a thousand instructions.
template <class Slope, class W, class Cells, Lane V>
[[gnu::noinline]] SolidFace<V> solid_face_state(Slope const slopes, W const& w, SolidState<V> const& m,
                                                SolidStencil<Cells, V> const& s, Mask<V> exempt, V& switched) noexcept {
  V const zero(0.0), half(0.5);
  Cells const& cells = s.cells;
  FrozenSolid<V> const& at = w.at;
  Triple<V> const u1 = w.project(s.velocity(1)), s1 = w.project(s.traction(1));
  Triple<V> u0{}, s0{}, u2{}, s2{};
  if constexpr (!Slope::first_order) {
    u0 = w.project(s.velocity(0)), s0 = w.project(s.traction(0));
    u2 = w.project(s.velocity(2)), s2 = w.project(s.traction(2));
  }
  Mask<V> keep(true);
  bool const single = slopes.one_switch();
  if (single) {
    auto const normal = [&](int i) G27_INLINE_LAMBDA { return s.traction(i)[0]; };
    keep = Slope::monotone(V(normal(0)), V(normal(1)), V(normal(2)));
    switched = select(keep, switched, V(1.0));
  }

  // half-step terms, as amplitudes
  Triple<V> tu_l{{zero, zero, zero}}, ts_l = tu_l, tu_r = tu_l, ts_r = tu_l;
  SolidState<V> t_l{}, t_r{};
  bool const terms = s.left != nullptr;
  if (terms) {
    t_l = s.left->template state<V>(s.f), t_r = s.right->template state<V>(s.f);
    if constexpr (W::plastic) {
      auto const flow = [&](SolidState<V>& t, SolidFrameRows const& rows) G27_INLINE_LAMBDA {
        V const work = rows.template at<V>(solid_cell::work, s.f), by = w.kap * work;
        unrolled<6>([&](auto k) G27_INLINE_LAMBDA { t.S[k] -= by * at.S[k]; });
        t.ep += max(by, 0.0) * w.q * (1.0 / (3.0 * at.mu));
      };
      flow(t_l, *s.left), flow(t_r, *s.right);
    }
    tu_l = w.project(t_l.velocity()), ts_l = w.project(t_l.traction());
    tu_r = w.project(t_r.velocity()), ts_r = w.project(t_r.traction());
  }

  // amplitudes that arrive from both sides
  V const speed = cells.relative(m.u[0]), d_u = s.difference(solid_cell::u, 1);
  Arrivals<V> arrive;
  unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
    V const z = w.z[k], c = w.lambda[k] * w.inv_z[k];
    V d_c(0.0);
    if constexpr (Slope::third_order) {
      d_c = -0.5 * c * s.difference(solid_cell::rho, 1) / at.rho;
      if constexpr (k == 0) {
        V const d_M = s.difference(solid_cell::K, 1) - at.f * s.difference(solid_cell::S, 1);
        d_c += 0.5 * c * d_M * w.inv_lambda[0];
      }
    }
    auto const arrival = [&](auto sign) G27_INLINE_LAMBDA {  // 1: A, speed u - c; -1: B, speed u + c
      constexpr double g = sign;
      V const lambda = speed - g * c, x = Slope::swept(lambda, V(d_u - g * d_c), s.nu);
      Mask<V> const forward = lambda >= 0.0;
      V const B = z * u1[k] + g * s1[k];
      V slope = zero;
      if constexpr (!Slope::first_order) {
        slope = slopes.template slope<false>(cells, V(z * u0[k] + g * s0[k]), B, V(z * u2[k] + g * s2[k]), x, forward,
                                             w.lambda[k], exempt, switched);
        if (single) slope = select(keep, B, zero);
      }
      V const e = half * (cells.beyond(forward, x) * slope - cells.own(forward, B));
      V a = select(forward, e, -e);
      if (terms) a += select(forward, V(z * tu_l[k] + g * ts_l[k]), V(z * tu_r[k] + g * ts_r[k]));
      return a;
    };
    arrive.A[k] = arrival(std::integral_constant<int, 1>{}), arrive.B[k] = arrival(std::integral_constant<int, -1>{});
  });
  Meeting<V> meeting = meet(w, arrive);

  // what rides with the velocity, from the side it comes from; from both where it stands
  V const x = Slope::swept(speed, d_u, s.nu);
  Mask<V> const forward = speed > 0.0, stands = speed == 0.0;
  unrolled<2>([&](auto j) G27_INLINE_LAMBDA {
    // a family of zero modulus rides as well
    constexpr int k = j + 1;
    Mask<V> const still = w.z[k] == 0.0;
    if (any(still)) {
      V const slope = Slope::first_order ? zero : select(keep, u1[k], zero);
      V const e = half * (cells.beyond(forward, x) * slope - cells.own(forward, u1[k]));
      V const from = select(stands, zero, select(forward, e, -e));
      V const t = select(stands, half * (tu_l[k] + tu_r[k]), select(forward, tu_l[k], tu_r[k]));
      meeting.U[k] = select(still, from + t, meeting.U[k]);
    }
  });
  V jump[3][6]{};
  auto const invariants = [&](int i, Triple<V> const& ds) G27_INLINE_LAMBDA {
    V change[6];
    carried_changes(w.path(ds), at.rho, change);
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { jump[i][k] = s.difference(solid_carried[k], i) - change[k]; });
  };
  if constexpr (!Slope::first_order) invariants(1, s1);
  if (!Slope::first_order && !single) invariants(0, s0), invariants(2, s2);
  V const scale[6] = {at.rho, V(w.lambda[0] / at.rho), w.lambda[0], w.lambda[0], w.lambda[0], V(1.0)};
  auto const from_side = [&](Mask<V> go) G27_INLINE_LAMBDA {
    V const sign = select(go, half, -half);
    V foot[6];
    V const* const term_l[6] = {&t_l.rho, &t_l.e, &t_l.S[1], &t_l.S[2], &t_l.S[5], &t_l.ep};
    V const* const term_r[6] = {&t_r.rho, &t_r.e, &t_r.S[1], &t_r.S[2], &t_r.S[5], &t_r.ep};
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA {
      int const field = solid_carried[k];
      foot[k] = select(go, s.q.template at<V>(field, s.f), s.q.template at<V>(field, s.f + s.stride));
      if (terms) foot[k] += select(go, *term_l[k], *term_r[k]);
      if constexpr (!Slope::first_order) {
        V slope = select(keep, jump[1][k], zero);
        if (!single) {
          slope =
              slopes.template slope<true>(cells, jump[0][k], jump[1][k], jump[2][k], x, go, scale[k], exempt, switched);
        }
        foot[k] += sign * (cells.beyond(go, x) * slope);
      }
    });
    Triple<V> ds;
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA {
      ds[k] = meeting.T[k] + sign * cells.own(go, s1[k]);
      if (terms) ds[k] -= select(go, ts_l[k], ts_r[k]);
    });
    SolidState<V> q{};
    q.rho = foot[0], q.e = foot[1], q.S[1] = foot[2], q.S[2] = foot[3], q.S[5] = foot[4], q.ep = foot[5];
    return carry(q, w.path(ds), m.velocity() + w.unproject(meeting.U), m.traction() + w.unproject(meeting.T));
  };
  SolidFace<V> face = from_side(forward || stands);
  if (any(stands)) {
    SolidFace<V> const other = from_side(Mask<V>(false));
    auto const mean = [&](V& a, V const& b) G27_INLINE_LAMBDA { a = select(stands, half * (a + b), a); };
    mean(face.rho, other.rho), mean(face.e, other.e), mean(face.ep, other.ep);
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { mean(face.S[k], other.S[k]); });
  }
  return face;
}

/// Mean of the two cells, and the coefficients frozen there.
template <class Cells, Lane V>
G27_INLINE SolidState<V> mean_state(Cells const& cells, SolidState<V> const& a, SolidState<V> const& b) noexcept {
  SolidState<V> m;
  m.rho = cells.mean(a.rho, b.rho), m.p = cells.mean(a.p, b.p), m.e = cells.mean(a.e, b.e);
  m.ep = cells.mean(a.ep, b.ep);
  unrolled<3>([&](auto k) G27_INLINE_LAMBDA { m.u[k] = cells.mean(a.u[k], b.u[k]); });
  unrolled<6>([&](auto k) G27_INLINE_LAMBDA { m.S[k] = cells.mean(a.S[k], b.S[k]); });
  return m;
}
template <Lane V>
G27_INLINE FrozenSolid<V> frozen(SolidState<V> const& m, V K, V f, double mu) noexcept {
  FrozenSolid<V> at{m.rho, K, f, m.p, {}, mu};
  unrolled<6>([&](auto k) G27_INLINE_LAMBDA { at.S[k] = m.S[k]; });
  return at;
}

inline constexpr double yield_share = 0.998;  ///< of Y^2, from which a cell counts as yielding

/// Faces between two yielding cells that load further: Sn.du/h + mean of S:D across the face's axes > 0.
template <class Cells, Lane V>
G27_INLINE Mask<V> loads_plastically(Strength const& y, SolidState<V> const& a, SolidState<V> const& b, V q2_a, V q2_b,
                                     SolidState<V> const& m, SolidStencil<Cells, V> const& s) noexcept {
  V const Y_a = y.Y0 + y.H * a.ep, Y_b = y.Y0 + y.H * b.ep;
  Mask<V> const both = q2_a > yield_share * Y_a * Y_a && q2_b > yield_share * Y_b * Y_b;
  if (!any(both)) return both;
  // work in half a step, as the terms have it
  V work = (0.5 * s.nu) * (m.S[0] * (b.u[0] - a.u[0]) + m.S[3] * (b.u[1] - a.u[1]) + m.S[4] * (b.u[2] - a.u[2]));
  if (s.left != nullptr) {
    work += 0.5 * (s.left->template at<V>(solid_cell::work, s.f) + s.right->template at<V>(solid_cell::work, s.f));
  }
  return both && work > 0.0;
}

/// What a face leaves, and what happened on it.
template <Lane V>
struct SolidFaceResult {
  SolidFace<V> face{};
  V switched{0.0};         ///< 1 where the switch acted
  Mask<V> tangent{false};  ///< where it took the tangent modulus
};

/// The face between cells a and b.
template <class Slope, class Cells, Lane V>
G27_INLINE SolidFaceResult<V> solid_face_between(Slope const slopes, SolidFaceArguments const& g,
                                                 SolidStencil<Cells, V> const& s) noexcept {
  SolidFrameRows const& q = s.q;
  std::ptrdiff_t const f = s.f;
  SolidState<V> const a = q.state<V>(f), b = q.state<V>(f + g.stride), m = mean_state(s.cells, a, b);
  auto const mean = [&](int field)
                        G27_INLINE_LAMBDA { return s.cells.mean(q.at<V>(field, f), q.at<V>(field, f + g.stride)); };
  FrozenSolid<V> const at = frozen(m, V(mean(solid_cell::K)), V(mean(solid_cell::f)), g.strength.mu);
  SolidFaceResult<V> r;
  Mask<V> exempt(true);
  Mask<V>& loaded = r.tangent;
  if (g.plastic) {
    V const q2_a = mises_squared(a.S), q2_b = mises_squared(b.S), Y = g.strength.Y0 + g.strength.H * max(a.ep, b.ep);
    exempt = max(q2_a, q2_b) <= 0.25 * Y * Y;
    if (g.tangent) loaded = loads_plastically(g.strength, a, b, q2_a, q2_b, m, s);
  }
  SolidFace<V> yielding{};
  V switched_yielding(0.0);
  if (any(loaded)) {
    yielding = solid_face_state(slopes, TangentWaves<V>(at, g.strength), m, s, exempt, switched_yielding);
    loaded = loaded && yielding.rho > 0.2 * a.rho;
  }
  if (!all(loaded)) r.face = solid_face_state(slopes, ElasticWaves<V>(at), m, s, exempt, r.switched);
  if (any(loaded)) {
    auto const take = [&](V& to, V const& from) G27_INLINE_LAMBDA { to = select(loaded, from, to); };
    take(r.switched, switched_yielding), take(r.face.rho, yielding.rho), take(r.face.e, yielding.e);
    take(r.face.ep, yielding.ep);
    unrolled<3>([&](auto k) G27_INLINE_LAMBDA { take(r.face.u[k], yielding.u[k]), take(r.face.s[k], yielding.s[k]); });
    unrolled<6>([&](auto k) G27_INLINE_LAMBDA { take(r.face.S[k], yielding.S[k]); });
  }
  return r;
}

template <class Slope, Lane V>
void solid_faces(SolidFaceArguments& g) noexcept {
  SolidFrameRows const q(g.cells, g.axis, solid_cell::fields);
  bool const terms = g.left.data != nullptr;
  SolidFrameRows const left(terms ? g.left : g.cells, g.axis, solid_cell::terms);
  SolidFrameRows const right(terms ? g.right : g.cells, g.axis, solid_cell::terms);
  SolidFluxRows const out(g.out, g.axis);
  SolidStencil<EqualCells, V> s{q, terms ? &left : nullptr, terms ? &right : nullptr, 0, g.stride, g.dt / g.h, {}};
  Slope const slopes{g.monotonicity, g.two_way};
  LaneSum<V> count, tangents;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(g.faces);
  for (std::ptrdiff_t f = 0; f < n; f += static_cast<std::ptrdiff_t>(width<V>)) {
    s.f = f;
    SolidFaceResult<V> const r = solid_face_between(slopes, g, s);
    if (any(r.tangent)) tangents.add(select(r.tangent, V(1.0), V(0.0)), n - f);
    if (any(r.switched > 0.0)) count.add(r.switched, n - f);
    out.put(f, r.face);
  }
  g.switched = count.total(), g.tangents = tangents.total();
}

}  // namespace g27
