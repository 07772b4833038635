#include "verification/cases/solid_media.hpp"

#include <cmath>
#include <stdexcept>

namespace g27 {

SolidMedium solid_medium(std::string const& name, bool plastic) {
  auto const with = [&](auto const& eos, auto const& law, double rho0, double mu, double Y, double H) {
    SolidMedium m{.scheme = {.eos = eos, .mu = mu},
                  .exact = {.law = law, .mu = mu},
                  .rho0 = rho0,
                  .bulk = bulk_modulus(law, rho0, 0.0),
                  .sound = 0};
    if (plastic) m.scheme.Y0 = m.exact.yield = Y, m.scheme.H = m.exact.hardening = H;
    m.sound = std::sqrt((m.bulk + 4.0 / 3 * mu) / rho0);
    return m;
  };
  if (name == "steel") return with(BulkModulus{7800, 175e9}, LinearBulkLaw{175e9, 7800}, 7800, 80.77e9, 0.34e9, 0.24e9);
  if (name == "copper")
    return with(BulkModulus{8930, 130e9}, LinearBulkLaw{130e9, 8930}, 8930, 117e9 / 2.7, 0.4e9, 0.1e9);
  if (name == "aluminium") {
    return with(MieGruneisen{2785, 5328, 1.338, 2.0}, MieGruneisenLaw{2785, 5328, 1.338, 2.0}, 2785, 27.6e9, 0.3e9,
                0.0);
  }
  if (name == "beryllium") {
    return with(MieGruneisen{1845, 7998, 1.124, 1.1}, MieGruneisenLaw{1845, 7998, 1.124, 1.1}, 1845, 151e9, 0.33e9,
                0.0);
  }
  throw std::invalid_argument("solid '" + name + "': one of steel aluminium beryllium copper");
}

std::vector<std::string> solid_media() { return {"steel", "aluminium"}; }

SolidPoint solid_state(SolidMedium const& m, double rho, Vector3 const& u, double p, Tensor6 const& S, double ep) {
  SolidPoint s{.rho = rho, .u = u, .S = S, .ep = ep};
  s.e = energy(m.exact.law, rho, p);
  s.p = pressure(m.exact.law, rho, s.e);
  return s;
}

}  // namespace g27
