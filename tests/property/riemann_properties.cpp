// Properties of the exact Riemann solver over every ordered pair of equations of state, and of HLLC.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "riemann/eos/registry.hpp"
#include "riemann/gas/exact.hpp"
#include "riemann/gas/hllc.hpp"
#include "tests/catch.hpp"

using namespace g27;

namespace {

// Parameters away from the defaults.
IdealGas other(IdealGas) { return {5.0 / 3.0}; }
StiffenedGas other(StiffenedGas) { return {7.15, 3e8}; }
Jwl other(Jwl) { return {3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630.0}; }
MieGruneisen other(MieGruneisen) { return {8930.0, 3940.0, 1.489, 1.99}; }

class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * unit_(random_); }
  double decades(double low, double high) { return low * std::pow(high / low, unit_(random_)); }
  GasState<> state(IdealGas const&) { return {decades(1e-2, 1e2), 0.0, decades(1e3, 1e8)}; }
  GasState<> state(StiffenedGas const& e) { return {decades(1e2, 2e3), 0.0, e.p_inf * (decades(1e-2, 1e2) - 1.0)}; }
  GasState<> state(Jwl const& e) {
    double const rho = e.rho0 * decades(1e-3, 1.5);
    return {rho, 0.0, e.cold_pressure(rho) + decades(1e5, 1e11)};
  }
  GasState<> state(MieGruneisen const& e) {
    double const rho = e.rho0 * between(0.6, 1.8);
    return {rho, 0.0, e.cold_pressure(rho) + e.rho0 * e.c0 * e.c0 * decades(1e-3, 1.0)};
  }

 private:
  std::mt19937_64 random_{27};
  std::uniform_real_distribution<double> unit_;
};

template <class E>
double sound_speed(E const& eos, double rho, double p) {
  return std::sqrt(eos.bulk_modulus(rho, p) / rho);
}

template <class L, class R>
struct Problem {
  L eos_l;
  R eos_r;
  GasState<> left, right;
  double scale;  ///< of velocity: c_l + c_r + |du|
  [[nodiscard]] RiemannStar<> star() const { return exact_star(eos_l, eos_r, left, right, true); }
  [[nodiscard]] FaceSolution<> face() const { return exact_face(eos_l, eos_r, left, right, true); }
};

/// `check(problem)` on random problems between L and every law, both sets of parameters, from strong impact to vacuum.
template <class L, class F>
void over_pairs(int count, F check) {
  EosList::for_each([&]<class R>() {
    Draw draw;
    for (int i = 0; i < count; ++i) {
      L const l = i % 2 ? other(L{}) : L{};
      R const r = i % 3 ? R{} : other(R{});
      GasState<> left = draw.state(l), right = draw.state(r);
      double const c = sound_speed(l, left.rho, left.p) + sound_speed(r, right.rho, right.p);
      double const du = i % 4 == 0 ? 0.0 : c * draw.between(-4.0, 4.0), frame = c * draw.between(-1.0, 1.0);
      left.u = frame - 0.5 * du;
      right.u = frame + 0.5 * du;
      check(Problem<L, R>{l, r, left, right, c + std::fabs(du)});
    }
  });
}

/// Energy and velocity along the isentrope from k to the density rho: de = p/rho d(ln rho), du = c d(ln rho).
template <class E>
struct Expansion {
  double p, du;
};
template <class E>
Expansion<E> expand(E const& eos, GasState<> const& k, double rho) {
  struct Context {
    E const* eos;
    double rho, e_scale, u_scale;
  } context{&eos, k.rho, eos.bulk_modulus(k.rho, k.p) / k.rho, sound_speed(eos, k.rho, k.p)};
  auto const rate = [](double x, double const y[], double dydx[], void* data) {
    Context const& c = *static_cast<Context*>(data);
    double const density = c.rho * std::exp(x), p = c.eos->pressure(density, y[0] * c.e_scale);
    dydx[0] = p / density / c.e_scale;
    dydx[1] = std::sqrt(std::max(c.eos->bulk_modulus(density, p), 0.0) / density) / c.u_scale;
    return int{GSL_SUCCESS};
  };
  gsl_odeiv2_system system{rate, nullptr, 2, &context};
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, -1e-3, 1e-13, 1e-13);
  std::array<double, 2> y{eos.energy(k.rho, k.p) / context.e_scale, 0.0};
  double x = 0.0;
  int const status = gsl_odeiv2_driver_apply(driver, &x, std::log(rho / k.rho), y.data());
  gsl_odeiv2_driver_free(driver);
  REQUIRE(status == GSL_SUCCESS);
  return {eos.pressure(rho, y[0] * context.e_scale), y[1] * context.u_scale};
}

/// One wave in the frame in which it runs to the left.
template <class E>
void check_shock(E const& eos, GasState<> const& k, double rho, double u, double p, double front, double scale) {
  double const flux = k.rho * (k.u - front), dv = 1.0 / k.rho - 1.0 / rho;
  // round-off of each condition's own terms; the densities near a limit of compression cost two digits
  CHECK(std::fabs(rho * (u - front) - flux) <= 1e-11 * (k.rho + rho) * (scale + std::fabs(front)));
  CHECK(std::fabs(p - k.p - flux * (k.u - u)) <= 1e-11 * (std::fabs(p) + std::fabs(k.p) + k.rho * scale * scale));
  double const e = eos.energy(rho, p), e_k = eos.energy(k.rho, k.p);
  double const terms = std::fabs(e) + std::fabs(e_k) + eos.bulk_modulus(rho, p) / rho;
  CHECK(std::fabs(e - e_k - 0.5 * (p + k.p) * dv) <= 1e-11 * terms);
  // Lax: supersonic ahead, subsonic behind, which for a convex law is growth of entropy
  if (p - k.p > 1e-5 * eos.bulk_modulus(k.rho, k.p)) {
    CHECK(k.u - front > sound_speed(eos, k.rho, k.p));
    CHECK(u - front < sound_speed(eos, rho, p));
  }
}
template <class E>
void check_fan(E const& eos, GasState<> const& k, double rho, double u, double p, double scale) {
  if (rho < 1e-4 * k.rho) {
    return;  // the energy no longer carries the pressure in double precision
  }
  Expansion<E> const x = expand(eos, k, rho);
  double const K = eos.bulk_modulus(k.rho, k.p) + std::fabs(eos.vacuum_pressure());
  CHECK(std::fabs(x.p - p) <= 1e-10 * K);  // 1e-13 a step of the integration, some hundred steps
  CHECK(std::fabs(k.u - u - x.du) <= 1e-10 * scale);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("equal states are left alone", "[riemann]", AnyEos) {
  Draw draw;
  for (TestType const& eos : {TestType{}, other(TestType{})}) {
    for (int i = 0; i < 200; ++i) {
      GasState<> k = draw.state(eos);
      double const c = sound_speed(eos, k.rho, k.p), K = eos.bulk_modulus(k.rho, k.p);
      k.u = c * draw.between(-3.0, 3.0);
      auto const s = exact_face(eos, eos, k, k, true);
      CHECK(s.converged);
      CHECK(std::fabs(s.face.u - k.u) <= 1e-14 * (c + std::fabs(k.u)));
      CHECK(std::fabs(s.face.rho - k.rho) <= 1e-13 * k.rho);
      // p = p_vac + m rounds with p_vac
      CHECK(std::fabs(s.face.p - k.p) <= 1e-13 * (K + std::fabs(eos.vacuum_pressure())));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("mirror: x -> -x swaps the sides", "[riemann][symmetry]", AnyEos) {
  over_pairs<TestType>(100, [](auto const& q) {
    auto const a = q.face(), b = exact_face(q.eos_r, q.eos_l, mirror(q.right), mirror(q.left), true);
    if (std::fabs(a.u_star) > 1e-12 * q.scale) {  // which side of the contact the face is on must be certain
      CHECK(a.face.rho == Approx(b.face.rho).epsilon(1e-12));
      CHECK(std::fabs(a.face.u + b.face.u) <= 1e-13 * q.scale);
      CHECK(a.face.p == Approx(b.face.p).epsilon(1e-12));
    }
    CHECK(std::fabs(a.u_star + b.u_star) <= 1e-13 * q.scale);  // the same operations, swapped
  });
}

TEMPLATE_LIST_TEST_CASE("Galilean: a moving frame shifts velocities alone", "[riemann][symmetry]", AnyEos) {
  over_pairs<TestType>(100, [](auto const& q) {
    double const shift = 2.7 * q.scale;
    auto const a = q.star();
    auto moved = q;
    moved.left.u += shift;
    moved.right.u += shift;
    auto const b = moved.star();
    // the shift rounds du by eps (|u| + shift)
    CHECK(std::fabs(b.u - shift - a.u) <=
          3e-15 * (shift + std::fabs(q.left.u) + std::fabs(q.right.u)) + 1e-14 * q.scale);
    CHECK(a.vacuum == b.vacuum);
    CHECK(std::fabs(b.head_l - shift - a.head_l) <= 1e-11 * q.scale);
    CHECK(std::fabs(b.head_r - shift - a.head_r) <= 1e-11 * q.scale);
  });
}

TEMPLATE_LIST_TEST_CASE("waves obey the jump conditions or the isentrope, and waves are in order", "[riemann]",
                        AnyEos) {
  int shocks = 0, fans = 0;
  over_pairs<TestType>(60, [&](auto const& q) {
    auto const s = q.star();
    REQUIRE(s.converged);
    CHECK(s.residual <= exact_tolerance);
    CHECK(s.head_l <= s.tail_l);
    CHECK(s.tail_l <= s.u_l + 1e-14 * q.scale);
    CHECK(s.u_l <= s.u_r);
    CHECK(s.u_r <= s.tail_r + 1e-14 * q.scale);
    CHECK(s.tail_r <= s.head_r);
    shocks += s.shock_l + s.shock_r;
    fans += !s.shock_l + !s.shock_r;
    if (s.shock_l) {
      check_shock(q.eos_l, q.left, s.rho_l, s.u_l, s.p, s.head_l, q.scale);
    } else {
      check_fan(q.eos_l, q.left, s.rho_l, s.u_l, s.p, q.scale);
    }
    if (s.shock_r) {
      check_shock(q.eos_r, mirror(q.right), s.rho_r, -s.u_r, s.p, -s.head_r, q.scale);
    } else {
      check_fan(q.eos_r, mirror(q.right), s.rho_r, -s.u_r, s.p, q.scale);
    }
  });
  CHECK(shocks > 100);
  CHECK(fans > 100);
}

TEMPLATE_LIST_TEST_CASE("weak waves of both families obey jump^2 = dp dv", "[riemann]", AnyEos) {
  Draw draw;
  for (TestType const& eos : {TestType{}, other(TestType{})}) {
    for (int i = 0; i < 100; ++i) {
      GasState<> const k = draw.state(eos);
      double const K = eos.bulk_modulus(k.rho, k.p);
      WaveCurve<double, TestType> curve(eos, k);
      for (double const x : {-0.9 * weak_wave, 0.9 * weak_wave}) {  // inside the series
        double const q = curve.excess() + x * K;
        auto const point = curve.at(q, true);
        double const dp = q - curve.excess(), dv = 1.0 / k.rho - 1.0 / point.rho;
        // exact for a shock, third order in x for a rarefaction; dv keeps 1e-10 of itself, dp eps q/(x K)
        CHECK(point.jump * point.jump == Approx(dp * dv).epsilon(1e-8));
        CHECK(point.rate == Approx(point.jump / dp).epsilon(2e-6 * eos.fundamental_derivative(k.rho, k.p)));
      }
    }
  }
}

TEMPLATE_LIST_TEST_CASE("the face in a fan is sonic and on the fan's isentrope", "[riemann]", AnyEos) {
  int sonic = 0;
  over_pairs<TestType>(60, [&](auto q) {
    auto const before = q.star();
    if (before.shock_l || !(before.tail_l - before.head_l > 1e-3 * q.scale)) {
      return;
    }
    // the frame in which the middle of the left fan stands on the face
    double const w = 0.5 * (before.head_l + before.tail_l);
    q.left.u -= w;
    q.right.u -= w;
    GasState<> const s = q.face().face;
    CHECK(std::fabs(s.u - sound_speed(q.eos_l, s.rho, s.p)) <= 1e-10 * q.scale);
    check_fan(q.eos_l, q.left, s.rho, s.u, s.p, q.scale);
    ++sonic;
  });
  CHECK(sonic > 20);
}

TEMPLATE_LIST_TEST_CASE("a vacuum opens when the gases part faster than they can expand", "[riemann][vacuum]", AnyEos) {
  over_pairs<TestType>(60, [](auto q) {
    exact::Problem<double, decltype(q.eos_l), decltype(q.eos_r)> p(q.eos_l, q.eos_r, q.left, q.right);
    double const escape =
        -p.at_vacuum(p.curve_l, p.offset_l, true).jump - p.at_vacuum(p.curve_r, p.offset_r, true).jump;
    double const speed = std::fabs(escape) + q.scale;
    auto const part = [&](double du) {
      q.left.u = -0.5 * du;
      q.right.u = 0.5 * du;
      return q.star();
    };
    auto const s = part(escape + 1e-3 * speed), t = part(escape - 1e-3 * speed);
    CHECK(s.vacuum);
    CHECK(s.u_r - s.u_l == Approx(1e-3 * speed).epsilon(1e-9));
    CHECK(s.p == std::max(q.eos_l.vacuum_pressure(), q.eos_r.vacuum_pressure()));
    CHECK(std::min(s.rho_l, s.rho_r) == 0.0);
    CHECK(s.converged);
    CHECK(t.converged);
    CHECK_FALSE(t.vacuum);
    CHECK(t.p >= s.p);
    CHECK(t.rho_l > 0.0);
    CHECK(t.rho_r > 0.0);
    // the face within the vacuum holds nothing
    double const middle = 0.5 * (s.u_l + s.u_r);
    (void)part(escape + 1e-3 * speed);
    q.left.u -= middle;
    q.right.u -= middle;
    CHECK(q.face().face.rho == 0.0);
  });
}

TEMPLATE_LIST_TEST_CASE("a lane does not depend on its neighbours", "[riemann][simd]", AnyEos) {
  using R = TestType;
  Draw draw;
  R const eos = other(R{});
  for (int batch = 0; batch < 100; ++batch) {
    std::array<GasState<>, width<Simd>> left, right;
    GasState<Simd> l{}, r{};
    for (std::size_t j = 0; j < width<Simd>; ++j) {
      left[j] = draw.state(eos);
      right[j] = draw.state(eos);
      double const c = sound_speed(eos, left[j].rho, left[j].p) + sound_speed(eos, right[j].rho, right[j].p);
      left[j].u = c * draw.between(-3.0, 3.0);
      right[j].u = c * draw.between(-3.0, 3.0);
      l.rho[j] = left[j].rho, l.u[j] = left[j].u, l.p[j] = left[j].p;
      r.rho[j] = right[j].rho, r.u[j] = right[j].u, r.p[j] = right[j].p;
    }
    auto const s = exact_face(eos, eos, l, r, Mask<Simd>(true));
    auto const flux = hllc_flux(eos, l, r);
    for (std::size_t j = 0; j < width<Simd>; ++j) {
      auto const one = exact_face(eos, eos, left[j], right[j], true);
      // the same operations in the same order: bit for bit on one instruction set
      CHECK(lane(s.face.rho, j) == one.face.rho);
      CHECK(lane(s.face.u, j) == one.face.u);
      CHECK(lane(s.face.p, j) == one.face.p);
      CHECK(lane(s.p_star, j) == one.p_star);
      CHECK(lane(flux.energy, j) == hllc_flux(eos, left[j], right[j]).energy);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("HLLC is consistent, mirrors, and holds a contact exactly", "[riemann][hllc]", AnyEos) {
  Draw draw;
  TestType const eos = other(TestType{});
  for (int i = 0; i < 200; ++i) {
    GasState<> l = draw.state(eos), r = draw.state(eos);
    double const c = sound_speed(eos, l.rho, l.p) + sound_speed(eos, r.rho, r.p);
    l.u = c * draw.between(-2.0, 2.0);
    r.u = c * draw.between(-2.0, 2.0);
    auto const exact_flux = physical_flux(eos, l), same = hllc_flux(eos, l, l);
    double const mass = l.rho * c, momentum = l.rho * c * c + std::fabs(l.p), energy = momentum * c;
    CHECK(std::fabs(same.mass - exact_flux.mass) <= 1e-12 * mass);
    CHECK(std::fabs(same.momentum - exact_flux.momentum) <= 1e-12 * momentum);
    CHECK(std::fabs(same.energy - exact_flux.energy) <= 1e-11 * (energy + std::fabs(exact_flux.energy)));
    auto const a = hllc_flux(eos, l, r), b = hllc_flux(eos, mirror(r), mirror(l));
    CHECK(a.mass == Approx(-b.mass).epsilon(1e-10).margin(1e-12 * (l.rho + r.rho) * c));
    CHECK(a.momentum == Approx(b.momentum).epsilon(1e-10));
    // a contact at rest: the two densities at one pressure
    double const p = std::max(l.p, r.p);
    if (eos.pressure_margin(l.rho, p) > 0.0 && eos.pressure_margin(r.rho, p) > 0.0) {
      auto const rest = hllc_flux(eos, GasState<>{l.rho, 0.0, p}, GasState<>{r.rho, 0.0, p});
      CHECK(rest.mass == 0.0);
      CHECK(rest.momentum == p);
      CHECK(rest.energy == 0.0);
    }
  }
}
