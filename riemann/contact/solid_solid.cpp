#include "riemann/contact/solid_solid.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace g27 {

namespace {

/// x of A x = r, by elimination with row pivots.
FaceVector solved(std::array<FaceVector, 3> A, FaceVector r) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 3; ++i) pivot = std::fabs(A[i][k]) > std::fabs(A[pivot][k]) ? i : pivot;
    std::swap(A[k], A[pivot]), std::swap(r[k], r[pivot]);
    for (std::size_t i = k + 1; i < 3; ++i) {
      double const by = A[i][k] / A[k][k];
      for (std::size_t j = k; j < 3; ++j) A[i][j] -= by * A[k][j];
      r[i] -= by * r[k];
    }
  }
  for (std::size_t k = 3; k-- > 0;) {
    for (std::size_t j = k + 1; j < 3; ++j) r[k] -= A[k][j] * r[j];
    r[k] /= A[k][k];
  }
  return r;
}

BondedContact meeting(BondedTrace const& below, BondedTrace const& above) noexcept {
  std::array<FaceVector, 3> Z = below.Z;
  BondedContact c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) Z[i][j] += above.Z[i][j];
    c.u[i] = below.b[i] + above.b[i];
  }
  c.u = solved(Z, c.u);
  for (std::size_t i = 0; i < 3; ++i) {
    c.s[i] = -below.b[i];
    for (std::size_t j = 0; j < 3; ++j) c.s[i] += below.Z[i][j] * c.u[j];
  }
  return c;
}

bool loads(BondedSide const& solid, double side, FaceVector const& u) noexcept {
  double work = solid.work;
  for (std::size_t i = 0; i < 3; ++i) work += side * solid.S[i] * (u[i] - solid.u[i]);
  return solid.yields && work > 0.0;
}

}  // namespace

BondedContact bonded_contact(BondedSide const& below, BondedSide const& above) noexcept {
  BondedContact c = meeting(below.elastic, above.elastic);
  bool const plastic_below = loads(below, 1.0, c.u), plastic_above = loads(above, -1.0, c.u);
  if (!plastic_below && !plastic_above) return c;
  c = meeting(plastic_below ? below.tangent : below.elastic, plastic_above ? above.tangent : above.elastic);
  c.plastic_below = plastic_below, c.plastic_above = plastic_above;
  return c;
}

}  // namespace g27
