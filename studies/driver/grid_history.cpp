#include "studies/driver/grid_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace g27 {
namespace {

void add(GasPoint& sum, double weight, GasPoint const& s) {
  sum.rho += weight * s.rho, sum.p += weight * s.p;
  for (std::size_t d = 0; d < 3; ++d) {
    sum.u[d] += weight * s.u[d];
  }
}

int dimensions_of(GasGridSetup const& box) { return box.cells[2] > 1 ? 3 : 2; }

/// Rays of a grid: x, y, (z), diagonal, as indices of ray_names().
std::vector<std::size_t> rays(int dimensions) {
  return dimensions == 3 ? std::vector<std::size_t>{0, 1, 2, 3} : std::vector<std::size_t>{0, 1, 3};
}

}  // namespace

std::vector<HistoryColumn> grid_columns(OutputPlan const& plan, int dimensions) {
  std::vector<HistoryColumn> out{{"time", "s", {}},        {"dt", "s", {}},           {"max_pressure", "Pa", {}},
                                 {"total_mass", "kg", {}}, {"total_energy", "J", {}}, {"active_share", "1", {}},
                                 {"stored_share", "1", {}}};
  if (plan.threshold > 0) {
    for (std::size_t const ray : rays(dimensions)) {
      out.push_back({"shock/" + ray_names()[ray], "m", {}});
    }
  }
  for (Probe const& probe : plan.probes) {
    std::string const name = "probe/" + probe.name + "/";
    out.push_back({name + "density", "kg/m3", {}});
    out.push_back({name + "speed", "m/s", {}});
    for (int d = 0; d < dimensions; ++d) {
      out.push_back({name + "velocity_" + ray_names()[static_cast<std::size_t>(d)], "m/s", {}});
    }
    out.push_back({name + "pressure", "Pa", {}});
  }
  return out;
}

GasPoint GridFieldView::at(Vec3 const& x) const {
  Int3 const cells = grid_->cells();
  Vec3 const first = grid_->centre({0, 0, 0}), widths = grid_->widths();
  Vec3 const& corner = grid_->setup().lower;
  Int3 home{0, 0, 0}, low{0, 0, 0};
  Vec3 f{0, 0, 0};
  std::size_t const axes = cells[2] > 1 ? 3 : 2;
  for (std::size_t d = 0; d < axes; ++d) {
    home[d] = std::clamp(static_cast<int>(std::floor((x[d] - corner[d]) / widths[d])), 0, cells[d] - 1);
    double const s = std::clamp((x[d] - first[d]) / widths[d], 0.0, cells[d] - 1.0);
    low[d] = std::min(static_cast<int>(s), std::max(cells[d] - 2, 0));
    f[d] = s - low[d];
  }
  GasPoint out;
  for (int corner_index = 0; corner_index < (axes == 3 ? 8 : 4); ++corner_index) {
    Int3 cell = low;
    double weight = 1;
    for (std::size_t d = 0; d < axes; ++d) {
      int const up = corner_index >> d & 1;
      cell[d] += up;
      weight *= up != 0 ? f[d] : 1 - f[d];
    }
    if (weight == 0) {
      continue;
    }
    if (grid_->solid(cell)) {
      return grid_->solid(home) ? GasPoint{0, {0, 0, 0}, 0} : grid_->primitive(home);
    }
    add(out, weight, grid_->primitive(cell));
  }
  return out;
}

double GridFieldView::max_pressure() const {
  auto const p = grid_->field(GasGrid::Field::pressure);
  return *std::max_element(p.begin(), p.end());
}

GasPoint LineFieldView::at(Vec3 const& x) const {
  Vec3 from{0, 0, 0};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_); ++d) {
    from[d] = x[d] - centre_[d];
  }
  double const r = std::hypot(from[0], from[1], from[2]);
  double const u = line_sample(*line_, line_->velocity(), r), over_r = r > 0 ? u / r : 0.0;
  return {line_sample(*line_, line_->density(), r),
          {over_r * from[0], over_r * from[1], over_r * from[2]},
          line_sample(*line_, line_->pressure(), r)};
}

double LineFieldView::max_pressure() const {
  return *std::max_element(line_->pressure().begin(), line_->pressure().end());
}

double shock_radius(GridView const& view, GasGridSetup const& box, Vec3 const& origin, std::size_t ray,
                    double threshold) {
  std::size_t const axes = static_cast<std::size_t>(dimensions_of(box));
  Vec3 direction{0, 0, 0};
  double squared = 0, width = 1e300;
  for (std::size_t d = 0; d < axes; ++d) {
    bool const upwards = box.upper[d] - origin[d] >= origin[d] - box.lower[d];
    direction[d] = ray == d || ray == 3 ? (upwards ? 1.0 : -1.0) : 0.0;
    squared += direction[d] * direction[d];
    width = std::min(width, (box.upper[d] - box.lower[d]) / box.cells[d]);
  }
  double reach = 1e300;
  for (std::size_t d = 0; d < axes; ++d) {
    direction[d] /= std::sqrt(squared);
    double const room = direction[d] > 0 ? box.upper[d] - origin[d] : origin[d] - box.lower[d];
    if (direction[d] != 0) {
      reach = std::min(reach, room / std::fabs(direction[d]));
    }
  }
  int const steps = static_cast<int>(std::ceil(reach / (0.5 * width)));
  double outer = 0;
  for (int i = steps; i >= 0; --i) {
    double const r = reach * i / std::max(steps, 1);
    Vec3 x = origin;
    for (std::size_t d = 0; d < axes; ++d) {
      x[d] += r * direction[d];
    }
    double const p = view.at(x).p;
    if (p > threshold) {
      return i == steps ? r : r + reach / steps * (p - threshold) / (p - outer);
    }
    outer = std::isfinite(p) ? p : outer;  // within a body there is no pressure
  }
  return none;
}

std::vector<double> grid_row(GridView const& view, GridRun const& run, OutputPlan const& plan,
                             GridRowFacts const& facts) {
  std::vector<double> row{facts.time,         facts.dt,           view.max_pressure(), facts.total_mass,
                          facts.total_energy, facts.active_share, facts.stored_share};
  int const dimensions = dimensions_of(run.setup);
  if (plan.threshold > 0) {
    for (std::size_t const ray : rays(dimensions)) {
      row.push_back(shock_radius(view, run.setup, plan.origin, ray, plan.threshold));
    }
  }
  for (Probe const& probe : plan.probes) {
    GasPoint const s = view.at(probe.position);
    row.push_back(s.rho);
    row.push_back(std::hypot(s.u[0], s.u[1], s.u[2]));
    row.insert(row.end(), s.u.begin(), s.u.begin() + dimensions);
    row.push_back(s.p);
  }
  return row;
}

}  // namespace g27
