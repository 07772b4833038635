#include "verification/exact/cell_average.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace g27 {
namespace {

struct FreeRule {
  void operator()(gsl_integration_glfixed_table* rule) const { gsl_integration_glfixed_table_free(rule); }
};

gsl_integration_glfixed_table const* gauss_rule(int points) {
  static thread_local std::map<int, std::unique_ptr<gsl_integration_glfixed_table, FreeRule>> rules;
  auto& rule = rules[points];
  if (!rule) rule.reset(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(points)));
  return rule.get();
}

}  // namespace

GasConserved<> cell_average(ExactEos const& eos, std::function<GasState<>(double x)> const& state, double x0, double x1,
                            int symmetry, std::span<double const> breaks, int points) {
  auto const* rule = gauss_rule(points);
  std::vector<double> edges{x0};
  for (double const b : breaks)
    if (b > x0 && b < x1) edges.push_back(b);
  edges.push_back(x1);
  GasConserved<> sum{0, 0, 0};
  double measure = 0;
  for (std::size_t piece = 0; piece + 1 < edges.size(); ++piece) {
    for (int i = 0; i < points; ++i) {
      double x = 0, weight = 0;
      gsl_integration_glfixed_point(edges[piece], edges[piece + 1], static_cast<std::size_t>(i), &x, &weight, rule);
      weight *= std::pow(x, symmetry);
      GasState<> const s = state(x);
      sum.mass += weight * s.rho;
      sum.momentum += weight * s.rho * s.u;
      sum.energy += weight * s.rho * (energy(eos, s.rho, s.p) + s.u * s.u / 2);
      measure += weight;
    }
  }
  return {sum.mass / measure, sum.momentum / measure, sum.energy / measure};
}

}  // namespace g27
