#include "verification/exact/solid.hpp"

#include <gsl/gsl_integration.h>

#include <memory>
#include <vector>

namespace g27 {
namespace {

struct FreeRule {
  void operator()(gsl_integration_glfixed_table* rule) const { gsl_integration_glfixed_table_free(rule); }
};
using Rule = std::unique_ptr<gsl_integration_glfixed_table, FreeRule>;
Rule gauss_rule(int points) { return Rule(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(points))); }

struct Node {
  double x, weight;
};
std::vector<Node> nodes(gsl_integration_glfixed_table const* rule, double a, double b) {
  std::vector<Node> out(rule->n);
  for (std::size_t i = 0; i < out.size(); ++i) gsl_integration_glfixed_point(a, b, i, &out[i].x, &out[i].weight, rule);
  return out;
}

void add(SolidDensities& sum, double weight, SolidDensities const& d) {
  sum.mass += weight * d.mass;
  sum.energy += weight * d.energy;
  sum.rho_ep += weight * d.rho_ep;
  for (std::size_t c = 0; c < 3; ++c) sum.momentum[c] += weight * d.momentum[c];
  for (std::size_t c = 0; c < 6; ++c) sum.rho_S[c] += weight * d.rho_S[c];
}

}  // namespace

SolidPoint elastic_rate(SolidMaterial const& material, SolidPoint const& s, double const (&L)[3][3]) {
  double const divergence = L[0][0] + L[1][1] + L[2][2];
  SolidPoint out;
  out.rho = -s.rho * divergence;
  double power = 0;  // of the deviator
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      power += s.S[tensor_place[i][j]] * L[i][j];
      if (j < i) continue;
      double rate = material.mu * (L[i][j] + L[j][i] - (i == j ? 2.0 / 3 * divergence : 0));
      for (std::size_t k = 0; k < 3; ++k)  // W S - S W
        rate += ((L[i][k] - L[k][i]) * s.S[tensor_place[k][j]] - s.S[tensor_place[i][k]] * (L[k][j] - L[j][k])) / 2;
      out.S[tensor_place[i][j]] = rate;
    }
  }
  out.e = (power - s.p * divergence) / s.rho;
  // along the isentrope p falls by K div u; what the deviator's power adds to e raises it at constant density
  out.p = -bulk_modulus(material.law, s.rho, s.p) * divergence + gruneisen(material.law, s.rho) * power;
  return out;
}

SolidDensities densities(SolidPoint const& s) {
  SolidDensities out;
  out.mass = s.rho;
  double kinetic = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    out.momentum[i] = s.rho * s.u[i];
    kinetic += s.u[i] * s.u[i] / 2;
  }
  out.energy = s.rho * (s.e + kinetic);
  for (std::size_t c = 0; c < 6; ++c) out.rho_S[c] = s.rho * s.S[c];
  out.rho_ep = s.rho * s.ep;
  return out;
}

SolidDensities solid_average(std::function<SolidPoint(double x)> const& state, double x0, double x1,
                             std::span<double const> breaks, int points) {
  Rule const rule = gauss_rule(points);
  std::vector<double> edges{x0};
  for (double const b : breaks)
    if (b > x0 && b < x1) edges.push_back(b);
  edges.push_back(x1);
  SolidDensities sum;
  for (std::size_t piece = 0; piece + 1 < edges.size(); ++piece) {
    for (Node const& node : nodes(rule.get(), edges[piece], edges[piece + 1]))
      add(sum, node.weight / (x1 - x0), densities(state(node.x)));
  }
  return sum;
}

SolidDensities solid_average(std::function<SolidPoint(Vector3 const& x)> const& state, Vector3 const& centre,
                             Vector3 const& widths, int points) {
  Rule const rule = gauss_rule(points);
  std::array<std::vector<Node>, 3> axis;
  for (std::size_t a = 0; a < 3; ++a) {
    axis[a] = {{centre[a], 1}};
    if (!(widths[a] > 0)) continue;
    axis[a] = nodes(rule.get(), centre[a] - widths[a] / 2, centre[a] + widths[a] / 2);
    for (Node& node : axis[a]) node.weight /= widths[a];
  }
  SolidDensities sum;
  for (Node const& z : axis[2])
    for (Node const& y : axis[1])
      for (Node const& x : axis[0]) add(sum, x.weight * y.weight * z.weight, densities(state({x.x, y.x, z.x})));
  return sum;
}

Tensor6 turned(double const (&R)[3][3], Tensor6 const& T) {
  Tensor6 out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) out[tensor_place[i][j]] += R[i][k] * T[tensor_place[k][l]] * R[j][l];
      }
    }
  }
  return out;
}

}  // namespace g27
