/// [[charge]]: detonated at its centre, from the exact self-similar wave at breakout; or lit, by programmed burn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "fsi/surface/vec3.hpp"
#include "riemann/eos/factory.hpp"
#include "studies/driver/scene_grid_parts.hpp"
#include "verification/exact/taylor_wave.hpp"

namespace g27 {
namespace {

constexpr Dimension energy_density{"energy per volume", "8.2 GJ/m3", dimension::pressure.exponents};

constexpr double standard_pressure = 1e5;  ///< Pa, of the unburnt explosive, unless told

std::vector<std::string> charge_keys(int dimensions, bool lit) {
  std::vector<std::string> keys{"material", "radius", "density", "energy", "start"};
  if (dimensions > 1) keys.push_back("center");
  if (lit) keys.push_back("pressure");
  if (lit && dimensions > 1) keys.insert(keys.end(), {"ignition", "delay", "obstacle"});
  return keys;
}

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

/// Where a charge is lit; at its centre alone, unless told, and at once.
std::vector<IgnitionPoint> read_ignition(Section const& section, Charge const& charge, int dimensions) {
  std::vector<IgnitionPoint> points{{charge.centre}};
  if (section.has("ignition")) {
    points.clear();
    for (Vec3 const& x : section.points("ignition", dimension::length, dimensions)) points.push_back({x});
    if (points.empty()) {
      throw section.error("ignition", "holds no point", "leave it out to light the charge at its center");
    }
  }
  for (auto const& [x, time] : points) {
    if (length(x - charge.centre) > charge.radius) {
      throw section.error("ignition", fmt::format("({:g}, {:g}, {:g}) m lies outside the charge", x[0], x[1], x[2]),
                          "choose points within the radius from the center");
    }
  }
  if (!section.has("delay")) {
    return points;
  }
  std::vector<double> const delays = section.quantities("delay", dimension::time);
  if (delays.size() != points.size() || std::any_of(delays.begin(), delays.end(), [](double t) { return t < 0; })) {
    throw section.error("delay", fmt::format("is not {} times from 0 on", points.size()),
                        "give one for each point of ignition, in their order");
  }
  for (std::size_t n = 0; n < points.size(); ++n) points[n].time = delays[n];
  return points;
}

/// The unburnt explosive at rest, and the burn that releases the rest of its energy [J/m^3] behind a front from every
/// point of ignition, by Huygens.
void light(Charge& charge, AnyEos const& eos, double density, double energy, double speed) {
  Section const& section = charge.section;
  double const pressure =
      section.has("pressure") ? section.positive("pressure", dimension::pressure) : standard_pressure;
  GasState<> const rest{density, 0, pressure};  // far below the products' cold curve, where no front has passed
  double const thermal = density * std::visit([&](auto const& law) { return law.energy(density, pressure); }, eos);
  if (!(energy > thermal)) {
    throw section.error("energy", fmt::format("is not above the {:g} J/m3 of the unburnt explosive", thermal),
                        "check density, energy and the equation of state");
  }
  charge.central = charge.ignition.size() == 1 && charge.ignition[0].x == charge.centre &&
                   charge.ignition[0].time == 0 && charge.obstacles.empty();
  charge.state = [rest](double) { return rest; };
  charge.burn = {
      .energy = (energy - thermal) / density,
      .speed = speed,
      .lighting = [=, points = charge.ignition, centre = charge.centre, radius = charge.radius](Vec3 const& x) {
        if (length(x - centre) > radius) return ProgrammedBurn::no_explosive;
        double first = 1e300;
        for (auto const& [from, time] : points) first = std::min(first, time + length(x - from) / speed);
        return first;
      }};
}

Charge read_charge(Section const& given, AnyEos const& eos, Symmetry symmetry, int dimensions) {
  bool const lit = given.choice("start", {"breakout", "ignition"}, 0) == 1;
  for (char const* key : {"pressure", "ignition", "delay", "obstacle"}) {
    if (!lit && given.has(key)) {
      throw given.error(key, "is of a charge that is lit, and this one starts when it has burnt",
                        "set start = \"ignition\", or leave it out");
    }
  }
  Charge charge{.state = {}, .section = given.reopened(charge_keys(dimensions, lit))};
  Section const& section = charge.section;
  charge.radius = section.positive("radius", dimension::length);
  if (dimensions > 1) {
    charge.centre = section.point("center", dimension::length, dimensions);
  }
  double const density = section.positive("density", dimension::density);
  double const energy = section.positive("energy", energy_density);
  double speed = 0;
  try {
    auto const products = exact_law(eos);
    auto const front = chapman_jouguet(products, density, energy);
    speed = front.D;
    if (!lit) {
      auto const wave = std::make_shared<TaylorWave>(products, front, static_cast<int>(symmetry));
      charge.begin = charge.radius / speed;
      charge.state = [wave, radius = charge.radius](double x) { return wave->at(std::fabs(x) / radius); };
    }
  } catch (std::exception const& failure) {
    throw section.error("energy", fmt::format("no detonation wave follows from it: {}", failure.what()),
                        "check density, energy and the equation of state (jwl or ideal)");
  }
  if (lit) {
    charge.ignition = read_ignition(section, charge, dimensions);
    if (dimensions > 1) charge.obstacles = read_obstacles(section, charge.radius, dimensions);
    light(charge, eos, density, energy, speed);
  } else {
    check_admissible(section, eos, charge.state(0));
  }
  return charge;
}

}  // namespace

std::vector<Charge> read_charges(Section const& root, AnyEos const& eos, Symmetry symmetry, int dimensions) {
  std::vector<Charge> charges;
  for (Section const& section : root.tables("charge", charge_keys(dimensions, true))) {
    if (!charges.empty()) {
      throw section.error("", "is a second charge", "a scene holds one: the others would detonate at their own times");
    }
    charges.push_back(read_charge(section, eos, symmetry, dimensions));
  }
  return charges;
}

}  // namespace g27
