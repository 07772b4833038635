/// What holds for every oracle of the table.
#include <set>

#include "tests/catch.hpp"
#include "verification/exact/oracle.hpp"

using namespace g27;

namespace {

/// Smallest set of arguments with which each oracle runs.
OracleArguments sufficient(std::string const& name) {
  if (name == "gas-riemann")
    return {{"rho_l", "1"}, {"u_l", "0"}, {"p_l", "1"}, {"rho_r", ".125"}, {"u_r", "0"}, {"p_r", ".1"}};
  if (name == "gas-solid") return {{"rho", "1"}, {"u", "0"}, {"p", "1e5"}};
  if (name == "jwl-card")
    return {{"A", "708.6056e9"}, {"B", "13.16457e9"}, {"C", "1.058238e9"}, {"R1", "4.94"},
            {"R2", "1.35"},      {"omega", ".28"},    {"rho0", "1650"}};
  if (name == "isentrope") return {{"rho", "1"}, {"p", "1"}, {"rho_to", "2"}};
  if (name == "taylor-wave") return {{"eos", "ideal"}, {"gamma", "3"}, {"D", "8000"}, {"rho_explosive", "1875"}};
  return {};
}

}  // namespace

TEST_CASE("every oracle is documented and runs", "[oracle]") {
  std::set<std::string> names;
  for (auto const& oracle : all_oracles()) {
    INFO(oracle.name);
    CHECK(names.insert(oracle.name).second);
    CHECK_FALSE(oracle.summary.empty());
    CHECK_FALSE(oracle.source.empty());
    std::set<std::string> keys;
    for (auto const& p : oracle.parameters) {
      INFO(p.name);
      CHECK(keys.insert(p.name).second);
      CHECK_FALSE(p.what.empty());
    }
    OracleRecord const record = evaluate(oracle, sufficient(oracle.name));
    CHECK(record.size() > 2);
    for (auto const& [key, value] : record) {
      INFO(key);
      if (auto const* number = std::get_if<double>(&value)) CHECK(std::isfinite(*number));
    }
    CHECK_THROWS_AS(evaluate(oracle, {{"no_such_key", "1"}}), OracleError);
  }
  for (char const* name : {"gas-riemann", "taylor-wave", "sedov", "noh", "simple-wave", "isentrope", "vortex",
                           "oblique-shock", "elastic-riemann", "ep-piston", "ep-riemann", "blake", "free-vibration",
                           "be-shell", "rigid-rotation", "gas-solid", "jwl-card", "superseismic", "kenamond"})
    CHECK(names.count(name) == 1);
}

TEST_CASE("inadmissible arguments are errors, not crashes", "[oracle]") {
  auto run = [](std::string const& name, OracleArguments const& extra) {
    for (auto const& oracle : all_oracles()) {
      if (oracle.name != name) continue;
      OracleArguments arguments = sufficient(name);
      for (auto const& [key, value] : extra) arguments[key] = value;
      return evaluate(oracle, arguments);
    }
    return OracleRecord{};
  };
  CHECK_THROWS_AS(run("gas-riemann", {{"p_l", "-1"}}), OracleError);  // below the vacuum
  CHECK_THROWS_AS(run("gas-riemann", {{"eos_l", "plasma"}}), OracleError);
  CHECK_THROWS_AS(run("gas-riemann", {{"gamma_l", "1"}}), OracleError);
  CHECK_THROWS_AS(run("gas-riemann", {{"x", "0:1:11"}}), OracleError);  // without t
  CHECK_THROWS_AS(run("gas-riemann", {{"x", "0:1"}, {"t", "1"}}), OracleError);
  CHECK_THROWS_AS(run("simple-wave", {{"t", "100"}}), OracleError);         // broken by then
  CHECK_THROWS_AS(run("simple-wave", {{"amplitude", "10"}}), OracleError);  // reaches a vacuum
  CHECK_THROWS_AS(run("taylor-wave", {{"E0", "1e10"}}), OracleError);       // D and E0
  CHECK_THROWS_AS(run("jwl-card", {{"D", "7000"}}), OracleError);           // 7587 by the others
  CHECK_THROWS_AS(run("sedov", {{"gamma", "8"}}), OracleError);             // hollow centre
  CHECK_THROWS_AS(run("sedov", {{"symmetry", "toroidal"}}), OracleError);
  CHECK_THROWS_AS(run("noh", {{"speed", "0"}}), OracleError);
  CHECK_THROWS_AS(run("isentrope", {{"rho_to", "1"}}), OracleError);
  CHECK_THROWS_AS(run("ep-piston", {{"eos", "mie-gruneisen"}}), OracleError);  // without its parameters
  CHECK_THROWS_AS(run("ep-piston", {{"p", "1e9"}}), OracleError);              // follows from the density
  CHECK_THROWS_AS(run("ep-piston", {{"sxx", "1e9"}}), OracleError);            // beyond the yield surface
  CHECK_THROWS_AS(run("ep-riemann", {{"x", "0"}}), OracleError);               // without t
  // of another law than the one chosen
  CHECK_THROWS_AS(run("gas-riemann", {{"A_l", "1e9"}}), OracleError);
  CHECK_THROWS_AS(run("gas-riemann", {{"c0_r", "4000"}}), OracleError);
  CHECK_THROWS_AS(run("ep-piston", {{"c0", "4000"}}), OracleError);
  CHECK_THROWS_AS(run("ep-piston", {{"strength", "elastic"}, {"yield", "1e9"}}), OracleError);
  OracleArguments const copper{{"eos", "constant-gruneisen"},
                               {"rho0", "8930"},
                               {"c0", "3940"},
                               {"s", "1.489"},
                               {"Gamma0", "2"},
                               {"mu", "48e9"},
                               {"yield", "1e9"}};
  CHECK_NOTHROW(run("ep-piston", copper));
  OracleArguments bulky = copper;
  bulky["K"] = "140e9";
  CHECK_THROWS_AS(run("ep-piston", bulky), OracleError);
  CHECK_THROWS_AS(run("ep-riemann", {{"strength_l", "brittle"}}), OracleError);
  CHECK_THROWS_AS(run("elastic-riemann", {{"mu", "0"}}), OracleError);  // no shear waves
  CHECK_THROWS_AS(run("blake", {{"r", "0.05"}}), OracleError);          // inside the cavity
  CHECK_THROWS_AS(run("blake", {{"lambda", "-20e9"}}), OracleError);    // no bulk modulus
  CHECK_THROWS_AS(run("be-shell", {{"u0", "600"}, {"stop", "0.04"}}), OracleError);
  CHECK_THROWS_AS(run("be-shell", {{"u0", "2000"}}), OracleError);  // closes
  CHECK_THROWS_AS(run("free-vibration", {{"order", "1.5"}}), OracleError);
  CHECK_THROWS_AS(run("rigid-rotation", {{"axis_z", "0"}}), OracleError);
  CHECK_THROWS_AS(run("kenamond", {{"ignition_y", "0.2"}}), OracleError);  // within the sphere
  CHECK_THROWS_AS(run("kenamond", {{"y", "0"}}), OracleError);             // as some points are
}

TEST_CASE("the right solid of an elastoplastic Riemann problem is as the left where it is not told apart", "[oracle]") {
  auto run = [](OracleArguments const& arguments) {
    for (auto const& oracle : all_oracles())
      if (oracle.name == "ep-riemann") return evaluate(oracle, arguments);
    return OracleRecord{};
  };
  auto value = [](OracleRecord const& record, std::string const& key) {
    for (auto const& [name, v] : record)
      if (name == key) return std::get<double>(v);
    throw std::runtime_error("no " + key);
  };
  // one solid against itself: the contact moves with half the speed, elastic or not
  OracleRecord const steel = run({{"u_l", "100"}}), elastic = run({{"u_l", "100"}, {"strength_l", "elastic"}});
  CHECK(value(steel, "u_star") == Approx(50).epsilon(1e-12));
  CHECK(value(elastic, "u_star") == Approx(50).epsilon(1e-12));
  CHECK(value(steel, "sigma_star") < 0.9 * value(elastic, "sigma_star"));
  CHECK(value(steel, "ep_star_r") > 1e-3);
  CHECK(value(elastic, "ep_star_r") == 0);
  OracleRecord const softer = run({{"u_l", "100"}, {"yield_r", "100e6"}});
  CHECK(value(softer, "u_star") > 50);
  CHECK(value(softer, "rho_star_l") > 7800);
}
