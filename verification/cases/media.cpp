#include "verification/cases/media.hpp"

#include <stdexcept>

namespace g27 {

namespace {

Medium with_sound(AnyEos const& eos, ExactEos const& exact, GasState<> const& base, double density_swing) {
  return {eos, exact, base, sound_speed(exact, base.rho, base.p), density_swing};
}

}  // namespace

Medium medium(std::string const& eos) {
  if (eos == "ideal") return with_sound(IdealGas{1.4}, IdealLaw{1.4}, {1.0, 0.0, 1.0 / 1.4}, 0.2);
  if (eos == "stiffened") return with_sound(StiffenedGas{4.4, 6e8}, StiffenedLaw{4.4, 6e8}, {1000.0, 0.0, 1e5}, 0.2);
  if (eos == "jwl") {
    // OG, TNT-RDX TR 8530; rho0 from the closing of its set at the CJ point
    return with_sound(Jwl{708.6056e9, 13.16457e9, 4.94, 1.35, 0.28, 1650.0},
                      JwlLaw{708.6056e9, 13.16457e9, 4.94, 1.35, 0.28, 1650.0}, {1300.0, 0.0, 5e9}, 0.05);
  }
  if (eos == "mie-gruneisen") {
    // Meyers, Dynamic Behavior of Materials (1994), table 5.1
    return with_sound(MieGruneisen{2785.0, 5328.0, 1.338, 2.0}, MieGruneisenLaw{2785.0, 5328.0, 1.338, 2.0},
                      {2900.0, 0.0, 5e9}, 0.01);
  }
  throw std::invalid_argument("equation of state '" + eos + "': one of ideal stiffened jwl mie-gruneisen");
}

std::vector<std::string> media() { return {"ideal", "stiffened", "jwl", "mie-gruneisen"}; }

}  // namespace g27
