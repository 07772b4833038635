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
  for (char const* name :
       {"gas-riemann", "taylor-wave", "sedov", "noh", "simple-wave", "isentrope", "vortex", "oblique-shock"})
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
  CHECK_THROWS_AS(run("sedov", {{"gamma", "8"}}), OracleError);             // hollow centre
  CHECK_THROWS_AS(run("sedov", {{"symmetry", "toroidal"}}), OracleError);
  CHECK_THROWS_AS(run("noh", {{"speed", "0"}}), OracleError);
  CHECK_THROWS_AS(run("isentrope", {{"rho_to", "1"}}), OracleError);
}
