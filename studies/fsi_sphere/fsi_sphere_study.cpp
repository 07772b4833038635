/// Rigid bodies that gas carries and holds: a cylinder that a shock lifts off a floor, a sphere in a supersonic stream.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <vector>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

struct Row {
  char const* name;
  int cells;  ///< of the cylinder across the channel, of the sphere a radius
  Predictor predictor;
};

std::vector<Row> const rows{
    {"cylinder-lift-off", 20, Predictor::linear},  {"cylinder-lift-off", 40, Predictor::linear},
    {"cylinder-lift-off", 80, Predictor::linear},  {"cylinder-lift-off", 20, Predictor::godunov},
    {"cylinder-lift-off", 40, Predictor::godunov}, {"sphere-in-stream", 5, Predictor::linear},
    {"sphere-in-stream", 8, Predictor::linear}};
constexpr double published_x = 0.65, published_y = 0.14;  ///< of the cylinder, without a gap to the floor [m]
constexpr double most_of_published = 0.05, most_momentum = 0.03, most_nose = 0.05;

StudyReport run(StudyContext const& context) {
  Table paths{.name = "cylinder",
              .title =
                  "A cylinder that a shock of Mach 3 lifts off a floor: its centre at .1641 and .30085 s, what of "
                  "mass and momentum the gas does not account for",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"x_middle", "m"},
                          {"y_middle", "m"},
                          {"x", "m"},
                          {"y", "m"},
                          {"momentum_less_impulse", "1"},
                          {"gas_momentum_rest", "1"},
                          {"gas_mass_rest", "1"},
                          {"wall", "s"}},
              .rows = {},
              .facts = {}};
  Table spheres{
      .name = "sphere",
      .title = "A sphere held in a stream of Mach 3",
      .columns = {{"cells", "1"}, {"drag_coefficient", "1"}, {"nose_pressure_over_exact", "1"}, {"wall", "s"}},
      .rows = {},
      .facts = {}};
  Hdf5Writer histories;
  std::map<int, CaseResult> lifted;  // by cells, of the linear scheme
  double nose = 0, impulse_rest = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    Row const& row = rows[n];
    CaseOptions o;
    o.cells = row.cells, o.predictor = row.predictor, o.threads = threads_or_all(0);
    std::string const what = fmt::format("{}, {} cells", row.name, row.cells);
    o.progress = [&](double done) {
      context.progress((static_cast<double>(n) + done) / static_cast<double>(rows.size()), what);
    };
    CaseResult const r = find_by_name(all_cases(), row.name, "fsi-sphere").run(o);
    auto const fact = [&](char const* name) { return r.facts.at(name); };
    if (r.facts.contains("drag_coefficient")) {
      nose = fact("nose_pressure_over_exact");
      spheres.rows.push_back({long{row.cells}, fact("drag_coefficient"), nose, r.wall_s});
      continue;
    }
    impulse_rest = std::max(impulse_rest, fact("momentum_less_impulse"));
    paths.rows.push_back({r.scheme, long{row.cells}, fact("x_middle"), fact("y_middle"), fact("x"), fact("y"),
                          fact("momentum_less_impulse"), fact("gas_momentum_rest_over_impulse"), fact("gas_mass_rest"),
                          r.wall_s});
    for (char const* quantity : {"time", "x", "y"})
      histories.write(fmt::format("/{}, {} cells/{}", r.scheme, row.cells, quantity), r.profile.at(quantity), "SI");
    if (row.predictor == Predictor::linear) lifted[row.cells] = r;
  }
  histories.save(context.out / "histories.h5");
  auto const at_most = [](std::string const& claim, double measured, double bound) {
    return Finding{fmt::format("{} within {:g}", claim, bound), fmt::format("{:.2g}", measured), measured <= bound};
  };
  auto const fact = [&](int cells, char const* name) { return lifted.at(cells).facts.at(name); };
  auto const apart = [&](int a, int b) { return std::hypot(fact(a, "x") - fact(b, "x"), fact(a, "y") - fact(b, "y")); };
  double const ratio = apart(40, 80) / apart(20, 40);
  return {{paths, spheres},
          {at_most("cylinder: momentum less impulse", impulse_rest, 1e-15),
           {"cylinder: the end moves less from 40 to 80 cells than from 20 to 40", fmt::format("{:.2g} of it", ratio),
            ratio < 1},
           at_most("cylinder: momentum that the gas does not account for over the impulse, 80 cells",
                   std::fabs(fact(80, "gas_momentum_rest_over_impulse")), most_momentum),
           at_most("cylinder, 80 cells: x over the published one, less 1", std::fabs(fact(80, "x") / published_x - 1),
                   most_of_published),
           at_most("cylinder, 80 cells: y over the published one, less 1", std::fabs(fact(80, "y") / published_y - 1),
                   most_of_published),
           at_most("sphere: pressure at the nose over the exact one, less 1", std::fabs(nose - 1), most_nose)}};
}

}  // namespace

Study fsi_sphere_study() {
  return {
      "fsi-sphere",
      "gas carries and holds rigid bodies as it does elsewhere: a cylinder that a shock lifts, a sphere in a stream",
      run};
}

}  // namespace g27
