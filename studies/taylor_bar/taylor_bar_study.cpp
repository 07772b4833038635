/// A copper rod that strikes a rigid wall: length and foot against published codes, by grids.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "studies/driver/lookup.hpp"
#include "studies/driver/machine_threads.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"

namespace g27 {
namespace {

constexpr double radius_mm = 3.2, rod_mm = 32.4;

/// Foulk, Ostien, Talamini, Tupek, Crane, Mota, Veilleux, Int. J. Numer. Meth. Eng. 122 (2021) 3845, section 4.4, the
/// same constants and wall: converged radius of the foot at 80 us. Length and earlier radii: runs of that problem by
/// the code Carina, which converge with it (its benchmark taylor, composite tetrahedra in Sierra/SM). Simo 1992 and
/// Zienkiewicz et al. 1998 have 7.12 and 7.11 mm.
struct Published {
  double time, foot_mm, length_mm;  ///< [s]; a length of 0: not given
};
std::vector<Published> const published{{12e-6, 5.45, 0}, {20e-6, 6.25, 0}, {80e-6, 7.22, 21.42}};
constexpr double lowest_foot_mm = 7.11;
constexpr double most_length = 0.02, most_foot = 0.05;  ///< deviation on the finest grid

/// Linear between steps.
double at(std::vector<double> const& time, std::vector<double> const& value, double t) {
  std::size_t const n = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  if (n == 0 || n == time.size()) return n == 0 ? value.front() : value.back();
  double const part = (t - time[n - 1]) / (time[n] - time[n - 1]);
  return value[n - 1] + part * (value[n] - value[n - 1]);
}

StudyReport run(StudyContext const& context) {
  Case const chosen = find_by_name(all_cases(), "taylor-bar", "taylor-bar");
  Table grids{.name = "grids",
              .title = "foot and length by grids",
              .columns = {{"cells", "1"},
                          {"triangles", "1"},
                          {"foot_12us", "1"},
                          {"foot_20us", "1"},
                          {"foot", "1"},
                          {"length", "1"},
                          {"plastic_strain", "1"},
                          {"mass_change", "1"},
                          {"shortest_edge", "cells"},
                          {"longest_edge", "cells"},
                          {"reached", "s"},
                          {"wall", "s"}},
              .rows = {},
              .facts = {}};
  Table history{.name = "history",
                .title = "foot and length in time",
                .columns = {{"cells", "1"}, {"time", "s"}, {"foot", "1"}, {"length", "1"}},
                .rows = {},
                .facts = {}};
  std::vector<int> const radii{3, 4};
  double foot = 0, length = 0, reached = 0;
  for (std::size_t n = 0; n < radii.size(); ++n) {
    CaseOptions o;
    o.cells = radii[n], o.threads = threads_or_all(0);
    o.progress = [&](double done) {
      context.progress((static_cast<double>(n) + done) / static_cast<double>(radii.size()),
                       fmt::format("{} cells a radius", radii[n]));
    };
    CaseResult const r = chosen.run(o);
    auto const &time = r.profile.at("time"), &feet = r.profile.at("foot"), &lengths = r.profile.at("length");
    foot = r.facts.at("foot"), length = r.facts.at("length"), reached = r.time;
    grids.rows.push_back({static_cast<long>(radii[n]), static_cast<long>(r.facts.at("triangles")),
                          at(time, feet, published[0].time), at(time, feet, published[1].time), foot, length,
                          r.facts.at("largest_plastic_strain"), r.facts.at("mass_change"),
                          r.facts.at("shortest_edge_in_cells"), r.facts.at("longest_edge_in_cells"), reached,
                          r.wall_s});
    for (double t = 0; t <= reached; t += 1e-6) {
      history.rows.push_back({static_cast<long>(radii[n]), t, at(time, feet, t), at(time, lengths, t)});
    }
  }
  Table reference{.name = "published",
                  .title = "published, converged",
                  .columns = {{"time", "s"}, {"foot", "1"}, {"length", "1"}},
                  .rows = {},
                  .facts = {}};
  for (Published const& p : published) reference.rows.push_back({p.time, p.foot_mm / radius_mm, p.length_mm / rod_mm});
  double const foot_mm = foot * radius_mm, length_mm = length * rod_mm;
  double const low = lowest_foot_mm * (1 - most_foot), high = published.back().foot_mm * (1 + most_foot);
  double const off = length_mm / published.back().length_mm - 1;
  return {
      {grids, history, reference},
      {{fmt::format("the run reaches {:g} us", 1e6 * published.back().time), fmt::format("{:.3g} us", 1e6 * reached),
        reached >= published.back().time * (1 - 1e-9)},
       {fmt::format("length within {:g} % of {:g} mm", 100 * most_length, published.back().length_mm),
        fmt::format("{:.2f} mm, {:+.2f} %", length_mm, 100 * off), std::fabs(off) <= most_length},
       {fmt::format("foot within {:g} % of {:g} to {:g} mm", 100 * most_foot, lowest_foot_mm, published.back().foot_mm),
        fmt::format("{:.2f} mm", foot_mm), foot_mm >= low && foot_mm <= high}}};
}

}  // namespace

Study taylor_bar_study() {
  return {"taylor-bar", "a copper rod that strikes a rigid wall ends as long and as wide as published codes find it",
          run};
}

}  // namespace g27
