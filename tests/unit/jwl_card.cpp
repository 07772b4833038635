/// Cards of JWL explosives: the printed set of TNT-RDX, every way to leave out three of its numbers, contradictions.
#include "verification/exact/jwl_card.hpp"
#include "tests/catch.hpp"
#include "verification/exact/numerics.hpp"
#include "verification/exact/taylor_wave.hpp"

using namespace g27;

namespace {

PartialJwlCard tnt_rdx() {
  PartialJwlCard card;
  card[JwlCard::A] = 708.6056e9, card[JwlCard::B] = 13.16457e9, card[JwlCard::C] = 1.058238e9;
  card[JwlCard::R1] = 4.94, card[JwlCard::R2] = 1.35, card[JwlCard::omega] = 0.28, card[JwlCard::rho0] = 1650;
  return card;
}

}  // namespace

TEST_CASE("the coefficients of TNT-RDX close on round figures", "[oracle][detonation]") {
  auto const card = complete(tnt_rdx()).card.value;
  CHECK(card[JwlCard::p_CJ] == Approx(23.7e9).epsilon(1e-6));  // the printed coefficients have seven digits
  CHECK(card[JwlCard::E0] == Approx(8.2e9).epsilon(1e-6));
  // the same wave as found by a scan for the tangent
  ChapmanJouguet const wave = chapman_jouguet_of_isentrope(JwlLaw{}, 1.058238e9);
  CHECK(card[JwlCard::D] == Approx(wave.D).epsilon(1e-10));
  CHECK(card[JwlCard::V_CJ] == Approx(1650 / wave.state.rho).epsilon(1e-9));
}

TEST_CASE("any seven numbers of a card give the other three", "[oracle][detonation]") {
  auto const whole = complete(tnt_rdx()).card.value;
  int found = 0, ambiguous = 0;
  for (std::size_t a = 0; a < JwlCard::V_CJ; ++a) {
    for (std::size_t b = a + 1; b < JwlCard::V_CJ; ++b) {
      for (std::size_t c = b + 1; c < JwlCard::V_CJ; ++c) {
        PartialJwlCard known;
        for (std::size_t i = 0; i < known.size(); ++i) {
          if (i != a && i != b && i != c) known[i] = whole[i];
        }
        INFO(JwlCard::names[a] << " " << JwlCard::names[b] << " " << JwlCard::names[c]);
        if (!known[JwlCard::rho0] && !known[JwlCard::D]) {
          CHECK_THROWS_AS(complete(known), NumericsError);
          continue;
        }
        try {
          auto const card = complete(known).card.value;
          ++found;
          // round-off of seven numbers, magnified by the conditioning of fits to three exponents
          for (std::size_t i = 0; i < card.size(); ++i) CHECK(card[i] == Approx(whole[i]).epsilon(1e-5));
        } catch (NumericsError const& error) {
          ++ambiguous;
          CHECK(std::string(error.what()).find("two cards") != std::string::npos);
        }
      }
    }
  }
  CHECK(found >= 5 * ambiguous);
  CHECK(found + ambiguous == 112);  // of 120 choices 8 lack both rho0 and D
}

TEST_CASE("numbers beyond seven are compared, not believed", "[oracle][detonation]") {
  PartialJwlCard card = tnt_rdx();
  card[JwlCard::D] = 7586.9, card[JwlCard::p_CJ] = 30e9;
  auto const checks = complete(card).checks;
  REQUIRE(checks.size() == 2);
  for (auto const& check : checks) {
    if (check.entry == JwlCard::D) CHECK(check.given == Approx(check.computed).epsilon(1e-6));
    if (check.entry == JwlCard::p_CJ) CHECK(check.computed == Approx(23.7e9).epsilon(1e-6));
  }
  card[JwlCard::A].reset(), card[JwlCard::B].reset(), card[JwlCard::C].reset(), card[JwlCard::D].reset();
  CHECK_THROWS_AS(complete(card), NumericsError);  // five numbers
}
