/// Gas beside a contact: what its outgoing characteristic brings there in the middle of a step.
#include <cmath>

#include "scheme/predictor/one_sided.hpp"
#include "scheme/step/gas_line_impl.hpp"

namespace g27 {

namespace {

constexpr double least_share = 0.2;  ///< of density and margin, that a trace keeps of its cell

}  // namespace

/// As the predictors have it inside: pressure and velocity where the outgoing characteristic starts, c dt/2 from the
/// contact (averaged over what it sweeps), entropy at the contact, with which it rides. From the line's cells alone, by
/// family: p + Z u, p - Z u and rho - p/c^2, frozen in the cell beside the contact.
GasState<> GasLine::Impl::trace(LineEnd end, double dt) {
  bool const left = end == LineEnd::left, averaged = is_third_order(predictor);
  std::ptrdiff_t const edge = left ? 0 : cells() - 1, inward = left ? 1 : -1;
  double const outward = left ? -1.0 : 1.0;
  bool const incremented = set_increments(dt);

  double const h[4]{line.h[edge + 2 * inward], line.h[edge + inward], line.h[edge], line.h[edge]};
  RidingCells const around(h);
  double const c2 = now.K[edge] / now.rho[edge], c = std::sqrt(c2), Z = now.rho[edge] * c;
  double forward[3], backward[3], entropy[3];
  for (std::ptrdiff_t k = 0; k < 3; ++k) {
    std::ptrdiff_t const i = edge + k * inward;
    double const p = (averaged ? p_mean : now.p)[i], Zu = Z * outward * (averaged ? u_mean : now.u)[i];
    forward[k] = p + Zu, backward[k] = p - Zu, entropy[k] = now.rho[i] - p / c2;
  }
  Predictor const order = setup.options.predictor;
  bool const limited = order == Predictor::muscl || setup.options.monotonicity != Switch::off;
  auto const at = [&](double const* F, double swept) {
    return one_sided(order, limited, around, F[0], F[1], F[2], swept);
  };
  double const swept = c * dt * around.inv_length, A = at(forward, swept), B = at(backward, swept);
  GasState<> s{0, outward * (A - B) / (2.0 * Z), 0.5 * (A + B)};
  s.rho = at(entropy, 0.0) + s.p / c2;
  if (incremented) s.rho += inc_rho[edge], s.u += inc_u[edge], s.p += inc_p[edge];
  double const margin = std::visit([&](auto const& e) { return e.pressure_margin(s.rho, s.p); }, setup.eos);
  bool const sound = s.rho > least_share * now.rho[edge] && margin > least_share * now.margin[edge];
  return sound ? s : now.state(edge);
}

}  // namespace g27
