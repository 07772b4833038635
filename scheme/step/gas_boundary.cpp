#include "scheme/step/gas_boundary.hpp"

#include <cmath>

#include "scheme/step/gauss.hpp"

namespace g27 {

namespace {

constexpr double extended_change = 0.5;  ///< of density and margin, that the gas beyond a contact may have more or less

void set_inflow(GasLineSetup const& setup, GasBoundary const& b, double x0, double x1, double t, GasCells& cells,
                std::ptrdiff_t ghost) {
  GasState<> mean{0, 0, 0};
  auto const gauss = gauss_points(2);
  for (std::size_t k = 0; k < 2; ++k) {
    GasState<> const s = b.state(0.5 * (x0 + x1) + 0.5 * (x1 - x0) * gauss[k].x, t);
    mean = {mean.rho + 0.5 * s.rho, mean.u + 0.5 * s.u, mean.p + 0.5 * s.p};
  }
  cells.rho[ghost] = mean.rho, cells.u[ghost] = mean.u, cells.p[ghost] = mean.p;
  std::visit(
      [&](auto const& eos) {
        cells.K[ghost] = eos.bulk_modulus(mean.rho, mean.p);
        cells.margin[ghost] = eos.pressure_margin(mean.rho, mean.p);
      },
      setup.eos);
}

/// The gas beyond a contact, as if it went on: linear, or uniform where that takes away half of the density or most of
/// the pressure's margin.
void extend(GasLineSetup const& setup, Line const& line, GasCells& cells, std::ptrdiff_t ghost, std::ptrdiff_t edge,
            std::ptrdiff_t next) {
  double const by = 2.0 * line.h[edge] / (line.h[edge] + line.h[next]);
  GasState<> const a = cells.state(edge), b = cells.state(next);
  GasState<> const s{a.rho + by * (a.rho - b.rho), a.u + by * (a.u - b.u), a.p + by * (a.p - b.p)};
  cells.copy_primitives(ghost, cells, edge);
  if (!(std::fabs(s.rho - a.rho) <= extended_change * a.rho)) return;
  std::visit(
      [&](auto const& eos) {
        double const margin = eos.pressure_margin(s.rho, s.p);
        if (!(margin > (1.0 - extended_change) * cells.margin[edge])) return;
        cells.rho[ghost] = s.rho, cells.u[ghost] = s.u, cells.p[ghost] = s.p;
        cells.K[ghost] = eos.bulk_modulus(s.rho, s.p), cells.margin[ghost] = margin;
      },
      setup.eos);
}

/// ghost[k] lies k cells beyond the boundary, inner[k] k cells inside it, partner[k] where a periodic line continues.
struct Side {
  GasBoundary const& boundary;
  std::ptrdiff_t ghost[2], inner[2], partner[2];
  double edge, outward;  ///< position of the boundary, +1 or -1
};

void fill_side(GasLineSetup const& setup, Line const& line, Side const& side, double t, GasCells& cells) {
  using Kind = GasBoundary::Kind;
  double x = side.edge;
  for (int k = 0; k < 2; ++k) {
    std::ptrdiff_t const g = side.ghost[k];
    double const far = x + side.outward * line.h[g];
    switch (side.boundary.kind) {
      case Kind::periodic:
        cells.copy_primitives(g, cells, side.partner[k]);
        break;
      case Kind::outflow:
        cells.copy_primitives(g, cells, side.inner[0]);
        break;
      case Kind::wall:
      case Kind::piston:
        cells.copy_primitives(g, cells, side.inner[k]);
        cells.u[g] = 2.0 * boundary_speed(side.boundary, t) - cells.u[g];
        break;
      case Kind::inflow:
        set_inflow(setup, side.boundary, std::min(x, far), std::max(x, far), t, cells, g);
        break;
      case Kind::contact:
        extend(setup, line, cells, g, side.inner[0], side.inner[1]);
        break;
    }
    x = far;
  }
}

}  // namespace

void fill_ghosts(GasLineSetup const& setup, Line const& line, double t, GasCells& cells) {
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(line.cells());
  fill_side(setup, line, {setup.left, {-1, -2}, {0, 1}, {n - 1, n - 2}, line.x.front(), -1.0}, t, cells);
  fill_side(setup, line, {setup.right, {n, n + 1}, {n - 1, n - 2}, {0, 1}, line.x.back(), 1.0}, t, cells);
}

void fill_mean_ghosts(GasLineSetup const& setup, Line const& line, GasCells const& cells, Padded& u, Padded& p,
                      Padded& dK_dp) {
  using Kind = GasBoundary::Kind;
  std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(line.cells());
  auto const side = [&](GasBoundary const& boundary, std::ptrdiff_t ghost, std::ptrdiff_t inner, std::ptrdiff_t first,
                        std::ptrdiff_t partner) {
    dK_dp[ghost] = dK_dp[boundary.kind == Kind::periodic ? partner : first];
    switch (boundary.kind) {
      case Kind::periodic:
        u[ghost] = u[partner], p[ghost] = p[partner];
        break;
      case Kind::outflow:
        u[ghost] = u[first], p[ghost] = p[first];
        break;
      // what the image's velocity adds to the inner cell's is twice the wall's speed, for the averages as well
      case Kind::wall:
      case Kind::piston:
        u[ghost] = cells.u[ghost] + cells.u[inner] - u[inner], p[ghost] = p[inner];
        break;
      case Kind::inflow:
        u[ghost] = cells.u[ghost], p[ghost] = cells.p[ghost];
        break;
      // averages differ from the values of averages by the same as in the cell beside the contact
      case Kind::contact:
        u[ghost] = cells.u[ghost] + u[first] - cells.u[first], p[ghost] = cells.p[ghost] + p[first] - cells.p[first];
        break;
    }
  };
  for (std::ptrdiff_t k = 0; k < 2; ++k) {
    side(setup.left, -1 - k, k, 0, n - 1 - k);
    side(setup.right, n + k, n - 1 - k, n - 1, k);
  }
}

}  // namespace g27
