/// [[charge]]: a charge detonated at its centre, started from the exact self-similar wave at breakout.
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <memory>

#include "riemann/eos/factory.hpp"
#include "studies/driver/scene_parts.hpp"
#include "verification/exact/taylor_wave.hpp"

namespace g27 {
namespace {

constexpr Dimension energy_density{"energy per volume", "8.2 GJ/m3", dimension::pressure.exponents};

/// The same law in the exact solutions' own formulas.
ExactEos exact_law(AnyEos const& eos) {
  auto const value = eos_values(eos);
  auto const get = [&](char const* name) { return value.at(name); };
  std::string const name = eos_name(eos);
  if (name == "jwl") {
    return JwlLaw{get("A"), get("B"), get("R1"), get("R2"), get("omega"), get("rho0")};
  }
  if (name == "ideal") {
    return IdealLaw{get("gamma")};
  }
  throw std::invalid_argument(fmt::format("products of detonation cannot be '{}'", name));
}

Charge read_charge(Section const& section, AnyEos const& eos, Symmetry symmetry, int dimensions) {
  Charge charge{.radius = section.positive("radius", dimension::length), .state = {}, .section = section};
  if (dimensions > 1) {
    charge.centre = section.point("center", dimension::length, dimensions);
  }
  double const density = section.positive("density", dimension::density);
  double const energy = section.positive("energy", energy_density);
  (void)section.choice("start", {"breakout"}, 0);
  try {
    auto const products = exact_law(eos);
    auto const front = chapman_jouguet(products, density, energy);
    auto const wave = std::make_shared<TaylorWave>(products, front, static_cast<int>(symmetry));
    charge.breakout = charge.radius / front.D;
    charge.state = [wave, radius = charge.radius](double x) { return wave->at(std::fabs(x) / radius); };
  } catch (std::exception const& failure) {
    throw section.error("energy", fmt::format("no detonation wave follows from it: {}", failure.what()),
                        "check density, energy and the equation of state (jwl or ideal)");
  }
  check_admissible(section, eos, charge.state(0));
  return charge;
}

}  // namespace

std::vector<Charge> read_charges(Section const& root, AnyEos const& eos, Symmetry symmetry, int dimensions) {
  std::vector<std::string> keys{"material", "radius", "density", "energy", "start"};
  if (dimensions > 1) {
    keys.push_back("center");
  }
  std::vector<Charge> charges;
  for (Section const& section : root.tables("charge", keys)) {
    if (!charges.empty()) {
      throw section.error("", "is a second charge", "a scene holds one: the others would detonate at their own times");
    }
    charges.push_back(read_charge(section, eos, symmetry, dimensions));
  }
  return charges;
}

}  // namespace g27
