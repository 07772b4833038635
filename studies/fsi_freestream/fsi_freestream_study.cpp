/// Bodies that a uniform stream carries along: deviation from it after 500 steps.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

struct Row {
  std::string body;
  double shape, speed, gap;
};

std::vector<Row> rows() {
  std::vector<Row> out;
  double shape = 0;
  for (char const* body : {"cube", "sphere", "tetrahedron"}) {
    for (double speed : {0.0, 500.0}) out.push_back({body, shape, speed, 1});
    shape += 1;
  }
  for (double gap : {0.25, 0.5, 1.0, 2.0, 3.0}) out.push_back({"two cubes", 3, 500, gap});
  return out;
}

constexpr int cells = 32, steps = 500;  ///< along the domain's edge: a cube's edge has 8
constexpr double most = 1e-12;

StudyReport run(StudyContext const& context) {
  Case const chosen = find_by_name(all_cases(), "freestream-bodies", "fsi-freestream");
  Table table{.name = "deviation",
              .title = fmt::format("largest deviation from the stream in {} steps, relative", steps),
              .columns = {{"body", "1"},
                          {"speed", "m/s"},
                          {"gap", "cells"},
                          {"triangles", "1"},
                          {"travelled", "cells"},
                          {"gas", "1"},
                          {"solid", "1"},
                          {"surface", "1"},
                          {"volume_change", "1"},
                          {"wall", "s"}},
              .rows = {},
              .facts = {}};
  double worst = 0;
  std::string where;
  auto const all = rows();
  for (std::size_t n = 0; n < all.size(); ++n) {
    Row const& row = all[n];
    CaseOptions o;
    o.cells = cells, o.threads = threads_or_all(0);
    o.values = {{"body", row.shape}, {"speed", row.speed}, {"gap", row.gap}, {"steps", steps}};
    std::string const what = fmt::format("{} at {:g} m/s", row.body, row.speed);
    double const total = static_cast<double>(all.size());
    o.progress = [&](double done) { context.progress((static_cast<double>(n) + done) / total, what); };
    CaseResult const r = chosen.run(o);
    auto const fact = [&](char const* name) { return r.facts.at(name); };
    double const here = std::max({fact("deviation_gas"), fact("deviation_solid"), fact("deviation_surface")});
    if (!(here <= worst)) worst = here, where = fmt::format("{}, gap {:g}", what, row.gap);
    table.rows.push_back({row.body, row.speed, row.shape == 3 ? row.gap : 0.0, static_cast<long>(fact("triangles")),
                          fact("cells_travelled"), fact("deviation_gas"), fact("deviation_solid"),
                          fact("deviation_surface"), fact("volume_change"), r.wall_s});
  }
  return {{table},
          {{fmt::format("every deviation <= {:g}", most), fmt::format("largest {:.2g} ({})", worst, where),
            worst <= most}}};
}

}  // namespace

Study fsi_freestream_study() {
  return {"fsi-freestream", "a uniform stream that carries bodies along stays uniform, whatever their shape and gap",
          run};
}

}  // namespace g27
