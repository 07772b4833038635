#pragma once
/// A card of a JWL explosive: its coefficients and its Chapman-Jouguet wave are tied by four equations, so that seven
/// of the ten numbers that handbooks print give the others.
///
/// On the isentrope p = A exp(-R1 V) + B exp(-R2 V) + C V^-(1 + omega), V = rho0/rho, with the energy
/// E = A/R1 exp(-R1 V) + B/R2 exp(-R2 V) + C/omega V^-omega per initial volume, at the CJ state:
/// p = p_CJ, p_CJ = rho0 D^2 (1 - V), -dp/dV = rho0 D^2, E = E0 + p_CJ (1 - V)/2
/// (Lee, Hornig and Kury, UCRL-50422, 1968).
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace g27 {

struct JwlCard {
  enum Entry : std::size_t { A, B, C, R1, R2, omega, rho0, D, p_CJ, E0, V_CJ, count };
  std::array<double, count> value{};  ///< SI; V_CJ = rho0/rho of the products

  static constexpr std::size_t equations = 4;
  static constexpr std::size_t needed = count - equations;  ///< numbers that give the others
  static constexpr std::array<char const*, count> names{"A",    "B", "C",    "R1", "R2",  "omega",
                                                        "rho0", "D", "p_CJ", "E0", "V_CJ"};
};

/// Which entries are known. V_CJ never is.
using PartialJwlCard = std::array<std::optional<double>, JwlCard::V_CJ>;

/// A printed number that the others contradict or confirm.
struct JwlCardCheck {
  JwlCard::Entry entry;
  double given, computed;
};

struct CompletedJwlCard {
  JwlCard card;
  std::vector<JwlCardCheck> checks;  ///< of what is given beyond seven numbers
};

/// Throws NumericsError where fewer than seven numbers are given, where they do not define a card (rho0 and D enter the
/// equations by rho0 D^2 alone), where no CJ wave follows from them, or more than one.
CompletedJwlCard complete(PartialJwlCard const& known);

}  // namespace g27
