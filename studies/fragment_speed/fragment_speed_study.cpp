/// The speed of a cube beside a detonating sphere, against what the spherical field alone gives a plate in its place.
#include <fmt/format.h>

#include <cmath>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"
#include "studies/driver/study.hpp"

namespace g27 {
namespace {

/// Of the cube of three-cubes-quick: mass over face, and where its near face is at the start.
constexpr double areal_mass = 7800 * 0.01;  ///< [kg/m^2]
constexpr char const* near_face = "6 cm";

/// The spherical field of the same charge, with and without a rigid wall where the near face is.
std::string field_scene() {
  return fmt::format(R"(
title = "The field of a detonating sphere, and a rigid sphere around it"
name  = "free"
[time]
end = "55 us"
cfl = 0.8
[scheme]
order = 2
[domain]
symmetry = "spherical"
extent   = ["0 cm", "40 cm"]
cell     = "0.0125 cm"
boundary = {{ left = "wall", right = "outflow" }}
[material.products]
eos = {{ type = "jwl", A = "708.6056 GPa", B = "13.16457 GPa", R1 = 4.94, R2 = 1.35, omega = 0.28, rho0 = "1.65 g/cm3" }}
[ambient]
density  = "1.2 kg/m3"
pressure = "1 bar"
[[charge]]
radius  = "5 cm"
density = "1.65 g/cm3"
energy  = "8.2 GJ/m3"
start   = "breakout"
[output]
every = "0.02 us"
probe = [{{ name = "near face", position = "{0}" }}]
[[variant]]
name   = "wall"
domain = {{ extent = ["0 cm", "{0}"], boundary = {{ right = "wall" }} }}
output = {{ probe = [] }}
)",
                     near_face);
}

/// Velocity of the plate up to each row of the history, under the pressure f(row, velocity).
template <class F>
std::vector<double> driven(std::vector<double> const& time, F const& f) {
  std::vector<double> v(time.size(), 0);
  for (std::size_t i = 1; i < time.size(); ++i) {
    v[i] = v[i - 1] + 0.5 * (f(i - 1, v[i - 1]) + f(i, v[i - 1])) * (time[i] - time[i - 1]) / areal_mass;
  }
  return v;
}

double at(std::vector<double> const& time, std::vector<double> const& value, double t) {
  std::size_t i = 1;
  while (i + 1 < time.size() && time[i] < t) ++i;
  double const part = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + part * (value[i] - value[i - 1]);
}

StudyReport run(StudyContext const& context) {
  auto const say = [&](double done, char const* what) {
    if (context.progress) context.progress(done, what);
  };
  auto const folder = context.out / "field";
  std::filesystem::create_directories(folder);
  write_atomically(folder / "scene.toml", field_scene());
  say(0, "the spherical field");
  SceneResult const field = run_whole(read_scene(folder / "scene.toml", {}), folder);
  say(0.1, "three cubes");
  SceneResult const cubes = run_whole(read_scene(find_scene("three-cubes-quick"), {}), context.out / "cubes");

  auto const& free = field.records.at("free-linear").history;
  auto const& wall = field.records.at("wall-linear").history;
  auto const& cube = cubes.records.begin()->second.history;
  auto const &free_time = free["time"], &wall_time = wall["time"], &cube_time = cube["time"];
  auto const &p = free["probe/near face/pressure"], &rho = free["probe/near face/density"],
             &u = free["probe/near face/velocity"];
  auto const flow = [&](std::size_t i, double v) { return rho[i] * (u[i] - v) * std::abs(u[i] - v); };
  auto const stagnation = driven(free_time, [&](std::size_t i, double v) { return p[i] + flow(i, v); });
  auto const dynamic = driven(free_time, flow);
  auto const& reflected = wall["right_impulse"];
  auto const& velocity = cube["body/top/velocity_z"];

  Table table{
      .name = "speeds",
      .title = "Velocity of a plate of 78 kg/m^2 at 6 cm by the spherical field, and of the cube there",
      .columns = {{"time", "us"}, {"rho w^2", "m/s"}, {"p + rho w^2", "m/s"}, {"rigid wall", "m/s"}, {"cube", "m/s"}},
      .rows = {},
      .facts = {}};
  for (double const us : {8.0, 9.0, 10.0, 12.0, 15.0, 20.0, 30.0, 40.0, 55.0}) {
    double const t = us * 1e-6;
    table.rows.push_back({us, at(free_time, dynamic, t), at(free_time, stagnation, t),
                          at(wall_time, reflected, t) / areal_mass, at(cube_time, velocity, t)});
  }
  double const least = dynamic.back(), most = reflected.back() / areal_mass, middle = stagnation.back();
  return {{table},
          {{"the cube is faster than a plate that the momentum of the free field's gas drives as it meets it",
            fmt::format("{:.0f} m/s against {:.0f} m/s", velocity.back(), least), velocity.back() > least},
           {"it is slower than a part of a rigid sphere around the charge, from which nothing escapes to the sides",
            fmt::format("{:.0f} m/s against {:.0f} m/s", velocity.back(), most), velocity.back() < most},
           {"within 25 % of a plate driven by the stagnation pressure p + rho w^2",
            fmt::format("{:.0f} m/s against {:.0f} m/s: {:+.1f} %", velocity.back(), middle,
                        100 * (velocity.back() / middle - 1)),
            std::abs(velocity.back() / middle - 1) < 0.25}}};
}

}  // namespace

Study fragment_speed_study() {
  return {"fragment-speed", "a cube beside a detonating sphere gets the speed that the sphere's field has for it", run};
}

}  // namespace g27
