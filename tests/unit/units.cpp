/// Units: every SI prefix and combination has the value the definition gives it; what is not a unit is refused.
#include "studies/driver/units.hpp"

#include "studies/driver/nearest_key.hpp"
#include "tests/catch.hpp"
#include "verification/cases/case.hpp"
#include "verification/exact/oracle.hpp"

using g27::parse_quantity;

TEST_CASE("quantities convert to SI", "[units]") {
  struct Known {
    char const* text;
    double si;
    g27::Exponents exponents;
  };
  // From the definitions of the units; 1e-15: one or two roundings.
  Known const known[]{{"5 cm", 0.05, {0, 1, 0, 0, 0}},
                      {"1 bar", 1e5, {1, -1, -2, 0, 0}},
                      {"175 GPa", 175e9, {1, -1, -2, 0, 0}},
                      {"1.65 g/cm3", 1650, {1, -3, 0, 0, 0}},
                      {"1.65 g/cm^3", 1650, {1, -3, 0, 0, 0}},
                      {"1.65 g cm-3", 1650, {1, -3, 0, 0, 0}},
                      {"55 us", 55e-6, {0, 0, 1, 0, 0}},
                      {"55 \u00b5s", 55e-6, {0, 0, 1, 0, 0}},
                      {"180 deg", 3.14159265358979312, {0, 0, 0, 0, 1}},
                      {"7.5869 km/s", 7586.9, {0, 1, -1, 0, 0}},
                      {"28 GPa us", 28e3, {1, -1, -1, 0, 0}},
                      {"8.2 GJ/m3", 8.2e9, {1, -1, -2, 0, 0}},
                      {"1 Mbar", 1e11, {1, -1, -2, 0, 0}},
                      {"0.8 cm/us", 8000, {0, 1, -1, 0, 0}},
                      {"2 kg/(m2 s)", 2, {1, -2, -1, 0, 0}},
                      {"3 MJ/kg", 3e6, {0, 2, -2, 0, 0}},
                      {"4 1/s", 4, {0, 0, -1, 0, 0}},
                      {"-1e-3 mm", -1e-6, {0, 1, 0, 0, 0}},
                      {"+2 ms", 2e-3, {0, 0, 1, 0, 0}},
                      {"5 %", 0.05, {0, 0, 0, 0, 0}},
                      {"3", 3, {0, 0, 0, 0, 0}}};
  for (Known const& k : known) {
    INFO(k.text);
    auto const parsed = parse_quantity(k.text);
    REQUIRE(parsed.has_value());
    CHECK(parsed->value == Approx(k.si).epsilon(1e-15).margin(0));
    CHECK(parsed->exponents == k.exponents);
  }
}

TEST_CASE("what is not a quantity is refused", "[units]") {
  for (char const* text : {"", "cm", "5 cmm", "5 cm/", "5 /s", "5 (cm", "5 cm)", "5 m 7", "5 10", "five cm", "5 cm2.5",
                           "5 m^99", "5,3 cm", "--5 cm"}) {
    INFO(text);
    CHECK_FALSE(parse_quantity(text).has_value());
  }
}

TEST_CASE("SI symbols of exponents read back as themselves", "[units]") {
  for (char const* text : {"g/cm3", "bar", "GPa us", "km/s", "deg", "J/(kg K)"}) {
    auto const unit = g27::parse_unit(text);
    REQUIRE(unit.has_value());
    auto const again = g27::parse_unit(g27::si_unit(unit->exponents));
    REQUIRE(again.has_value());
    CHECK(again->exponents == unit->exponents);
    CHECK(again->value == 1.0);
  }
}

TEST_CASE("edit distance is a metric that counts a swap once", "[units]") {
  CHECK(g27::edit_distance("cells", "cells") == 0);
  CHECK(g27::edit_distance("cels", "cells") == 1);
  CHECK(g27::edit_distance("idael", "ideal") == 1);
  CHECK(g27::edit_distance("", "abc") == 3);
  for (auto const& [a, b] : {std::pair{"muscl", "parabolic"}, {"linear", "godunov"}}) {
    CHECK(g27::edit_distance(a, b) == g27::edit_distance(b, a));
  }
  CHECK(g27::nearest_key("velocty", {"density", "velocity"}) == "velocity");
  CHECK(g27::nearest_key("zzz", {"density", "velocity"}).empty());
}

TEST_CASE("cases and exact solutions take values in any unit of their own dimension", "[units]") {
  CHECK(g27::number_in("3 cm", "m") == Approx(0.03).epsilon(1e-15));
  CHECK(g27::number_in("1.65 g/cm3", "kg/m^3") == Approx(1650).epsilon(1e-15));
  CHECK(g27::number_in("30 deg", "deg") == Approx(30).epsilon(1e-15));
  CHECK(g27::number_in("7", "deg") == 7);
  CHECK(!g27::number_in("3 cm", "s"));
  CHECK(!g27::number_in("3 cm", "1"));
  CHECK(!g27::number_in("three", "m"));
  for (auto const& c : g27::all_cases()) {
    for (auto const& p : c.parameters) {
      INFO(c.name << " " << p.name << " " << p.unit);
      CHECK(g27::parse_unit(p.unit));
    }
  }
  for (auto const& o : g27::all_oracles()) {
    for (auto const& p : o.parameters) {
      INFO(o.name << " " << p.name << " " << p.unit);
      CHECK((p.unit.empty() || g27::parse_unit(p.unit)));
    }
  }
}
