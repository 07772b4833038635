#include <cmath>
#include <cstdio>
#include <string>

#include "verification/exact/arguments.hpp"
#include "verification/exact/jwl_card.hpp"

namespace g27 {
namespace {

OracleRecord solve(OracleArguments const& arguments) {
  PartialJwlCard known;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (given(arguments, JwlCard::names[i])) known[i] = positive_number(arguments, JwlCard::names[i]);
  }
  constexpr double lightest = 50;  // kg/m^3: below, it was meant in g/cm^3
  if (known[JwlCard::rho0].value_or(lightest) < lightest) {
    char text[80];
    std::snprintf(text, sizeof text, "%g kg/m^3 is no density of an explosive", *known[JwlCard::rho0]);
    throw OracleError{"rho0", text, "give it in kg/m^3: 1 g/cm^3 is 1000 kg/m^3"};
  }
  double const tolerance = positive_number(arguments, "tolerance");
  std::string missing;
  std::size_t count = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i]) ++count;
    if (!known[i]) missing += std::string(missing.empty() ? "" : ", ") + JwlCard::names[i];
  }
  if (count < JwlCard::needed) {
    throw OracleError{
        "card", std::to_string(count) + " of its ten numbers are given, it needs " + std::to_string(JwlCard::needed),
        std::to_string(JwlCard::needed - count) + " more of " + missing};
  }
  CompletedJwlCard const done = complete(known);
  double worst = 0;
  for (JwlCardCheck const& check : done.checks) {
    double const off = check.given / check.computed - 1;
    worst = std::max(worst, std::fabs(off));
    if (std::fabs(off) <= tolerance) continue;
    char text[160];
    std::snprintf(text, sizeof text, "is %.7g, but the other numbers give %.7g (%+.3g %%)", check.given, check.computed,
                  100 * off);
    throw OracleError{JwlCard::names[check.entry], text, "correct one of them, or leave it out"};
  }
  OracleRecord out;
  for (auto const entry : {JwlCard::V_CJ, JwlCard::p_CJ, JwlCard::E0, JwlCard::D, JwlCard::A, JwlCard::B, JwlCard::C,
                           JwlCard::R1, JwlCard::R2, JwlCard::omega, JwlCard::rho0})
    out.emplace_back(JwlCard::names[entry], done.card.value[entry]);
  out.emplace_back("largest_deviation", worst);
  return out;
}

}  // namespace

Oracle jwl_card_oracle() {
  return {
      .name = "jwl-card",
      .summary = "completes a card of a JWL explosive from seven of its ten numbers and checks the others",
      .source = "Lee, Hornig and Kury, UCRL-50422 (1968); Fickett and Davis, Detonation (1979), 2A",
      .parameters = {{"A", not_given, "Pa", "first coefficient"},
                     {"B", not_given, "Pa", "second coefficient"},
                     {"C", not_given, "Pa", "third coefficient, of the isentrope through the CJ state"},
                     {"R1", not_given, "1", "first exponent"},
                     {"R2", not_given, "1", "second exponent"},
                     {"omega", not_given, "1", "Grueneisen coefficient"},
                     {"rho0", not_given, "kg/m^3", "density of the explosive"},
                     {"D", not_given, "m/s", "detonation speed"},
                     {"p_CJ", not_given, "Pa", "Chapman-Jouguet pressure"},
                     {"E0", not_given, "J/m^3", "energy released per initial volume"},
                     {"tolerance", "0.01", "1", "relative deviation up to which a number beyond seven is confirmed"}},
      .evaluate = solve};
}

}  // namespace g27
