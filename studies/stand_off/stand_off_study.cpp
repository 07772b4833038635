/// What a cube beside a detonating sphere is left with, by its distance from the charge.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "studies/driver/scene_reader.hpp"
#include "studies/driver/scene_run.hpp"
#include "studies/driver/study.hpp"

namespace g27 {
namespace {

constexpr std::array stand_offs{5.0, 7.5, 10.0, 15.0, 20.0, 30.0};  ///< of the near face from the charge's surface [mm]
constexpr double early = 13e-6;                                     ///< of the shape that the paper calls residual [s]

/// The scene of the cube of equal mass, with one of 1 cm on coarse cells in its place.
std::vector<std::string> settings(double stand_off) {
  auto const cm = [](double x) { return fmt::format("\"{:g} cm\"", x); };
  double const s = 0.1 * stand_off, near_face = 5 + s;
  return {
      "variant=[]",
      "expect=[]",
      "domain.cell=\"3 mm\"",
      "body.0.scale=\"1 cm\"",
      "body.0.cell=\"1.4 mm\"",
      fmt::format("body.0.center=[\"0 cm\", \"0 cm\", {}]", cm(near_face + 0.5)),
      fmt::format("body.0.extent=[[\"-2 cm\", \"2 cm\"], [\"-2 cm\", \"2 cm\"], [{}, \"14 cm\"]]", cm(near_face - 0.2)),
      fmt::format("start.one_dimensional_radius={}", cm(std::min(5 + 0.5 * s, 5.9))),  // the sides are at 6 cm
      "output.snapshots=[]"};
}

/// Distance of the faces that looked to and from the charge, means over the faces, over that at the start.
double thickness(History const& h, double time) {
  auto const far = "probe/far face/position_z", near = "probe/near face/position_z";
  return (h.at(far, time) - h.at(near, time)) / (h[far].front() - h[near].front());
}

StudyReport run(StudyContext const& context) {
  Table table{.name = "outcome",
              .title = "A steel cube of 1 cm at 55 us, by its distance from the charge",
              .columns = {{"stand_off", "mm"},
                          {"velocity", "m/s"},
                          {"thickness", "1"},
                          {"thickness_at_13_us", "1"},
                          {"crushed_by_13_us", "%"}},
              .rows = {},
              .facts = {}};
  std::vector<double> velocity, left, crushed;
  for (std::size_t n = 0; n < stand_offs.size(); ++n) {
    double const mm = stand_offs[n];
    if (context.progress) {
      context.progress(static_cast<double>(n) / stand_offs.size(), fmt::format("{:g} mm from the charge", mm));
    }
    Scene const scene = read_scene(find_scene("equal-mass-cube"), settings(mm));
    SceneResult const result = run_whole(scene, context.out / fmt::format("run-{}", n));
    History const& h = result.records.begin()->second.history;
    double const end = h["time"].back(), then = thickness(h, early);
    velocity.push_back(h["body/top/velocity_z"].back()), left.push_back(thickness(h, end));
    crushed.push_back(100 * (1 - then) / (1 - left.back()));
    table.rows.push_back({mm, velocity.back(), left.back(), then, crushed.back()});
  }
  bool const falls = std::is_sorted(velocity.rbegin(), velocity.rend());
  bool const thins = std::is_sorted(left.begin(), left.end());
  auto const nearest = std::min_element(left.begin(), left.end(),
                                        [](double a, double b) { return std::abs(a - 0.5) < std::abs(b - 0.5); });
  std::size_t const halved = static_cast<std::size_t>(nearest - left.begin());
  auto const most = std::max_element(crushed.begin(), crushed.end());
  return {
      {table},
      {{"the farther from the charge, the slower",
        fmt::format("{:.0f} to {:.0f} m/s", velocity.front(), velocity.back()), falls},
       {"and the thicker", fmt::format("{:.2f} to {:.2f}", left.front(), left.back()), thins},
       {"a distance at which the thickness is half of the first one, as the paper has it, lies among them",
        fmt::format("{:g} mm: {:.2f}", stand_offs[halved], left[halved]), left.front() <= 0.5 && left.back() >= 0.5},
       {"one at which nine tenths of that are done by 13 us, as the paper has it",
        fmt::format("at most {:.0f} %, at {:g} mm", *most,
                    stand_offs[static_cast<std::size_t>(most - crushed.begin())]),
        *most >= 90}}};
}

}  // namespace

Study stand_off_study() {
  return {"stand-off", "what the paper says of the cube tells how far from the charge it was", run};
}

}  // namespace g27
