#include "verification/cases/standing_plate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace g27 {

namespace {

/// Parts of the sides and of the upper end along the profile, and strips along z.
struct Parts {
  int up, over, strips;
};

Parts parts_of(StandingPlate const& plate) {
  double const edge = 4.0 / 3 * plate.cell;
  auto const parts = [&](double length) { return std::max(1, static_cast<int>(std::lround(length / edge))); };
  return {parts(plate.height), std::max(2, parts(plate.thickness)), parts(plate.width)};
}

}  // namespace

TriangleSurface surface_of(StandingPlate const& plate) {
  double const t = plate.thickness, L = plate.height;
  auto const [up, over, strips] = parts_of(plate);
  // from the wall up, over and down to it
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i < up; ++i) profile.push_back({0, L * i / up});
  for (int i = 0; i < over; ++i) profile.push_back({t * i / over, L});
  for (int i = up; i >= 0; --i) profile.push_back({t, L * i / up});
  TriangleSurface s;
  for (auto const& [x, y] : profile) {
    for (int k = 0; k <= strips; ++k) s.vertices.push_back({x, y, plate.width * k / strips});
  }
  for (int i = 0; i + 1 < static_cast<int>(profile.size()); ++i) {
    for (int k = 0; k < strips; ++k) {
      int const a = i * (strips + 1) + k, b = a + strips + 1;
      // diagonals by turns, so that neither direction is preferred
      if ((i + k) % 2 == 0) {
        s.triangles.push_back({a, a + 1, b}), s.triangles.push_back({a + 1, b + 1, b});
      } else {
        s.triangles.push_back({a, a + 1, b + 1}), s.triangles.push_back({a, b + 1, b});
      }
    }
  }
  return s;
}

AnySolid elastic_material(double density, double young, double poisson) {
  return {.eos = BulkModulus{density, young / (3 * (1 - 2 * poisson))}, .mu = 0.5 * young / (1 + poisson)};
}

BodySetup body_of(StandingPlate const& plate, AnySolid const& material, double pressure, double room) {
  BodySetup body{.surface = surface_of(plate), .material = material, .cell = plate.cell, .initial = {}};
  BulkModulus const eos = std::get<BulkModulus>(material.eos);
  SolidPoint const rest{.rho = eos.rho0 * (1 + pressure / eos.K0), .p = pressure};
  body.initial = [=](Vec3 const&) { return rest; };
  body.lower = {-room, 0, 0}, body.upper = {plate.thickness + room, plate.height + 0.5 * room, plate.width};
  body.clamps.low[1] = true;
  return body;
}

double tip_displacement(TriangleSurface const& now, StandingPlate const& plate) {
  auto const [up, over, strips] = parts_of(plate);
  auto const first = now.vertices.begin() + static_cast<std::ptrdiff_t>(up) * (strips + 1);
  auto const last = first + static_cast<std::ptrdiff_t>(over + 1) * (strips + 1);
  double const sum = std::accumulate(first, last, 0.0, [](double s, Vec3 const& x) { return s + x[0]; });
  return sum / static_cast<double>(last - first) - 0.5 * plate.thickness;
}

}  // namespace g27
