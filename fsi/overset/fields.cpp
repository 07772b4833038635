#include "fsi/overset/fields.hpp"

namespace g27 {

namespace {

using Matrix = std::array<Vec3, 3>;

template <class Fields>
void turn_velocity(Matrix const& m, Fields& q) noexcept {
  Vec3 const u = velocity_of(q);
  for (std::size_t i = 0; i < 3; ++i) q[1 + i] = dot(m[i], u);
}

void turn_stress(Matrix const& m, SolidFields& q) noexcept {
  double* const S = q.data() + solid_field_of::S;
  double half[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      half[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) half[i][j] += m[i][k] * S[tensor_place[k][j]];
    }
  }
  double turned[6];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      double s = 0;
      for (std::size_t k = 0; k < 3; ++k) s += half[i][k] * m[j][k];
      turned[tensor_place[i][j]] = s;
    }
  }
  for (std::size_t c = 0; c < 6; ++c) S[c] = turned[c];
}

Matrix rows_of(Frame const& f) noexcept { return {f.n, f.a, f.b}; }
Matrix columns_of(Frame const& f) noexcept {
  return {Vec3{f.n[0], f.a[0], f.b[0]}, Vec3{f.n[1], f.a[1], f.b[1]}, Vec3{f.n[2], f.a[2], f.b[2]}};
}

}  // namespace

GasFields into_frame(Frame const& frame, GasFields const& q) noexcept {
  GasFields r = q;
  turn_velocity(rows_of(frame), r);
  return r;
}
GasFields out_of_frame(Frame const& frame, GasFields const& q) noexcept {
  GasFields r = q;
  turn_velocity(columns_of(frame), r);
  return r;
}
SolidFields into_frame(Frame const& frame, SolidFields const& q) noexcept {
  SolidFields r = q;
  turn_velocity(rows_of(frame), r), turn_stress(rows_of(frame), r);
  return r;
}
SolidFields out_of_frame(Frame const& frame, SolidFields const& q) noexcept {
  SolidFields r = q;
  turn_velocity(columns_of(frame), r), turn_stress(columns_of(frame), r);
  return r;
}

GasDensities densities_of(AnyEos const& eos, GasFields const& q) noexcept {
  double const rho = q[gas_field::rho],
               e = std::visit([&](auto const&law) { return law.energy(rho, q[gas_field::p]); }, eos);
  Vec3 const u = velocity_of(q);
  return {rho, rho * u, rho * (e + 0.5 * dot(u, u))};
}
SolidDensities densities_of(SolidFields const& q) noexcept {
  namespace f = solid_field_of;
  double const rho = q[f::rho];
  Vec3 const u = velocity_of(q);
  SolidDensities d{.mass = rho,
                   .momentum = rho * u,
                   .energy = rho * (q[f::e] + 0.5 * dot(u, u)),
                   .rho_S = {},
                   .rho_ep = rho * q[f::ep]};
  for (std::size_t c = 0; c < 6; ++c) d.rho_S[c] = rho * q[f::S + c];
  return d;
}
GasFields fields_of(AnyEos const& eos, GasDensities const& q) noexcept {
  Vec3 const u = (1 / q.mass) * q.momentum;
  double const e = q.energy / q.mass - 0.5 * dot(u, u);
  return {q.mass, u[0], u[1], u[2], std::visit([&](auto const& law) { return law.pressure(q.mass, e); }, eos)};
}
SolidFields fields_of(AnySolidEos const& eos, SolidDensities const& q) noexcept {
  namespace f = solid_field_of;
  Vec3 const u = (1 / q.mass) * q.momentum;
  double const e = q.energy / q.mass - 0.5 * dot(u, u);
  SolidFields s{q.mass, u[0], u[1], u[2], std::visit([&](auto const& law) { return law.pressure(q.mass, e); }, eos), e};
  for (std::size_t c = 0; c < 6; ++c) s[f::S + c] = q.rho_S[c] / q.mass;
  s[f::ep] = q.rho_ep / q.mass;
  return s;
}

}  // namespace g27
