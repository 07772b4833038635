#include "verification/cases/grid_mean.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scheme/step/gauss.hpp"

namespace g27 {

namespace {

GasDensities plus(GasDensities a, double weight, GasDensities const& b) {
  a.mass += weight * b.mass, a.energy += weight * b.energy;
  for (std::size_t d = 0; d < 3; ++d) a.momentum[d] += weight * b.momentum[d];
  return a;
}

/// Weighted sum of f(x) over a tensor product of one-dimensional points (on [-1, 1], weights summing to 2).
template <class F>
GasDensities tensor_mean(int dimensions, Vec3 const& centre, Vec3 const& widths, std::span<GaussPoint const> rule,
                         F const& f) {
  GasDensities sum{};
  std::size_t const n = rule.size(), ny = dimensions > 1 ? n : 1, nz = dimensions > 2 ? n : 1;
  for (std::size_t k = 0; k < nz; ++k) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        std::array<std::size_t, 3> const at{i, j, k};
        Vec3 x = centre;
        double weight = 1;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
          x[d] += 0.5 * widths[d] * rule[at[d]].x;
          weight *= 0.5 * rule[at[d]].weight;
        }
        sum = plus(sum, weight, f(x));
      }
    }
  }
  return sum;
}

/// Five Gauss points on each half of [-1, 1].
std::array<GaussPoint, 10> two_halves() {
  auto const gauss = gauss_points(5);
  std::array<GaussPoint, 10> rule{};
  for (std::size_t i = 0; i < 5; ++i) {
    rule[i] = {0.5 * (gauss[i].x - 1), 0.5 * gauss[i].weight};
    rule[i + 5] = {0.5 * (gauss[i].x + 1), 0.5 * gauss[i].weight};
  }
  return rule;
}

std::vector<GaussPoint> midpoints(int parts) {
  std::vector<GaussPoint> rule;
  for (int i = 0; i < parts; ++i) rule.push_back({(2.0 * i + 1) / parts - 1, 2.0 / parts});
  return rule;
}

double length(Vec3 const& x) { return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

}  // namespace

GasDensities densities_of(AnyEos const& eos, GasPoint const& s) {
  double const e = std::visit([&](auto const& law) { return law.energy(s.rho, s.p); }, eos);
  double const kinetic = 0.5 * (s.u[0] * s.u[0] + s.u[1] * s.u[1] + s.u[2] * s.u[2]);
  return {s.rho, {s.rho * s.u[0], s.rho * s.u[1], s.rho * s.u[2]}, s.rho * (e + kinetic)};
}

GasPoint point_of(AnyEos const& eos, GasDensities const& q) {
  if (!(q.mass > 0)) return {};
  Vec3 const u{q.momentum[0] / q.mass, q.momentum[1] / q.mass, q.momentum[2] / q.mass};
  double const e = q.energy / q.mass - 0.5 * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  return {q.mass, u, std::visit([&](auto const& law) { return law.pressure(q.mass, e); }, eos)};
}

GridMean mean_of(AnyEos const& eos, int dimensions, std::function<GasPoint(Vec3 const& x)> state, int points) {
  auto const rule = gauss_points(points);
  return [=, state = std::move(state)](Vec3 const& centre, Vec3 const& widths) {
    return tensor_mean(dimensions, centre, widths, std::span(rule).first(static_cast<std::size_t>(points)),
                       [&](Vec3 const& x) { return densities_of(eos, state(x)); });
  };
}

GridMean plane_mean(int dimensions, Vec3 const& normal, CellMean line, Vec3 const& drift) {
  auto const rule = two_halves();
  double const drift_energy = 0.5 * (drift[0] * drift[0] + drift[1] * drift[1] + drift[2] * drift[2]);
  return [=, line = std::move(line)](Vec3 const& centre, Vec3 const& widths) {
    double s = 0;
    std::vector<double> projections;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
      s += normal[d] * centre[d];
      projections.push_back(std::fabs(normal[d]) * widths[d]);
    }
    std::sort(projections.rbegin(), projections.rend());
    double const inner = projections.front();
    projections.erase(projections.begin());
    std::erase_if(projections, [&](double w) { return w < 1e-12 * inner; });
    auto const with_drift = [&](double at) -> GasDensities {
      GasConserved<> const q = line(at - 0.5 * inner, at + 0.5 * inner);
      Vec3 momentum;
      for (std::size_t d = 0; d < 3; ++d) momentum[d] = q.momentum * normal[d] + q.mass * drift[d];
      return {q.mass, momentum, q.energy + q.mass * drift_energy};
    };
    if (projections.empty()) return with_drift(s);
    Vec3 outer{};
    std::copy(projections.begin(), projections.end(), outer.begin());
    return tensor_mean(static_cast<int>(projections.size()), {0, 0, 0}, outer, rule,
                       [&](Vec3 const& x) { return with_drift(s + x[0] + x[1] + x[2]); });
  };
}

GridMean half_space_mean(int dimensions, Vec3 const& normal, double offset, GasDensities const& below,
                         GasDensities const& above) {
  // the share that lies below is the mass of a line of density 1 there
  GridMean const share = plane_mean(dimensions, normal, [=](double a, double b) -> GasConserved<> {
    return {std::clamp((offset - a) / (b - a), 0.0, 1.0), 0, 0};
  });
  return [=](Vec3 const& centre, Vec3 const& widths) {
    double const f = share(centre, widths).mass;
    return plus(plus({}, f, below), 1 - f, above);
  };
}

GridMean radial_mean(AnyEos const& eos, int dimensions, std::function<GasState<>(double r)> state, double front) {
  auto const gauss = gauss_points(3);
  return
      [=, fine = midpoints(dimensions > 2 ? 8 : 16), state = std::move(state)](Vec3 const& centre, Vec3 const& widths) {
        Vec3 nearest{}, farthest{};
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
          nearest[d] = std::max(0.0, std::fabs(centre[d]) - 0.5 * widths[d]);
          farthest[d] = std::fabs(centre[d]) + 0.5 * widths[d];
        }
        bool const crossed = length(nearest) < front && front < length(farthest);
        Vec3 middle{};
        std::copy_n(centre.begin(), dimensions, middle.begin());
        return tensor_mean(dimensions, middle, widths,
                           crossed ? std::span<GaussPoint const>(fine) : std::span(gauss).first(3), [&](Vec3 const& x) {
                             double const r = length(x);
                             GasState<> const s = state(r);
                             double const per_r = r > 0 ? s.u / r : 0;
                             return densities_of(eos, {s.rho, {per_r * x[0], per_r * x[1], per_r * x[2]}, s.p});
                           });
      };
}

}  // namespace g27
