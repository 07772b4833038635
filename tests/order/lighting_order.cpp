/// Errors of lighting times around obstacles, and their order.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "scheme/grid/cell_place.hpp"
#include "scheme/step/lighting_times.hpp"
#include "scheme/step/programmed_burn.hpp"
#include "tests/catch.hpp"
#include "verification/exact/kenamond.hpp"
#include "verification/measure/order.hpp"

using namespace g27;

namespace {

/// Over the cells that no ray reaches from the point of ignition, in cells of time.
struct Errors {
  double mean = 0, largest = 0, least = 0;
};

/// On n cells along each side of a cube, or a square, about the origin, of 2 m.
template <class Exact>
Errors errors(int n, int dimensions, Obstacle const& obstacle, Vec3 const& ignition, Exact const& exact) {
  LightingSetup setup{.lower = {-1, -1, -1}, .upper = {1, 1, 1}, .cells = {n, n, dimensions == 3 ? n : 1}};
  if (dimensions == 2) setup.lower[2] = 0;
  setup.last = setup.cells;
  setup.explosive = [](Vec3 const&) { return true; };
  setup.obstacles = {obstacle}, setup.ignition = {{ignition}}, setup.speed = 3.0;
  LightingTimes const times(setup);
  Vec3 const h = cell_widths(setup.lower, setup.upper, setup.cells);
  Errors out{.least = 1e300};
  std::size_t count = 0;
  for_each_cell(setup.cells, [&](Int3 const& cell) {
    Vec3 const x = cell_centre(setup.lower, h, swept_axes(setup.cells), cell);
    double const t = times.all()[cell_number(setup.cells, cell)];
    if (t == ProgrammedBurn::no_explosive) return;
    double const straight = std::hypot(x[0] - ignition[0], x[1] - ignition[1], x[2] - ignition[2]);
    double const error = t * setup.speed - exact(x);
    out.least = std::min(out.least, error / h[0]);
    if (!(exact(x) > straight * (1 + 1e-9))) return;
    ++count, out.mean += std::fabs(error) / h[0], out.largest = std::max(out.largest, error / h[0]);
  });
  out.mean /= static_cast<double>(count);
  return out;
}

OrderFit fit(std::vector<int> const& grids, std::vector<Errors> const& errors) {
  std::vector<double> h, e;
  for (std::size_t i = 0; i < grids.size(); ++i) h.push_back(2.0 / grids[i]), e.push_back(errors[i].mean * h.back());
  return fit_order(h, e);
}

}  // namespace

TEST_CASE("lighting times around a sphere are Kenamond's", "[order]") {
  for (int const dimensions : {2, 3}) {
    bool const space = dimensions == 3;
    Kenamond const problem{
        .radius = 0.3, .centre = {0.05, -0.03, space ? 0.07 : 0.0}, .ignition = {-0.85, 0.11, space ? 0.04 : 0.0}};
    Obstacle const sphere = [&](Vec3 const& x) {
      Vec3 const& c = problem.centre;
      return std::hypot(x[0] - c[0], x[1] - c[1], x[2] - c[2]) - problem.radius;
    };
    std::vector<int> const grids =
        space ? std::vector<int>{20, 30, 45, 68, 100} : std::vector<int>{20, 40, 80, 160, 320};
    std::vector<Errors> found;
    for (int const n : grids) {
      found.push_back(errors(n, dimensions, sphere, problem.ignition, [&](Vec3 const& x) { return problem.time(x); }));
      UNSCOPED_INFO(dimensions << "D, " << n << ": " << found.back().mean << ' ' << found.back().largest);
    }
    for (Errors const& e : found) {
      CHECK(e.mean < 0.01);
      CHECK(e.largest < 0.2);
      CHECK(e.least > -1e-9);  // a way around a sphere is never too short
    }
    if (!space) {
      CHECK(found.back().mean < 1.5 * 4.4e-4);
      continue;
    }
    // Bends that lie beside the plane of the way cost second order, those where ways from all sides meet the first; in
    // the plane what is left, thousandths of a cell, has no order.
    OrderFit const order = fit(grids, found);
    UNSCOPED_INFO("order " << order.order << " +- " << order.half_width);
    CHECK(order.is(1.8, 0.2));
    CHECK(found.back().mean < 1.2 * 1.75e-3);
  }
}

// A front goes over a straight edge as on the two half-planes unfolded: exact in three dimensions.
TEST_CASE("lighting times around an edge are those of the edge unfolded", "[order]") {
  Vec3 const ignition{-0.72, -0.61, -0.83};
  for (int const dimensions : {2, 3}) {
    Vec3 from = ignition;
    if (dimensions == 2) from[2] = 0;
    Obstacle const block = [](Vec3 const& x) { return std::max(-x[0], x[1]); };  // x > 0, y < 0
    auto const exact = [&](Vec3 const& x) {
      bool const behind = x[0] > 0 && from[0] * x[1] > from[1] * x[0];
      double const plane =
          behind ? std::hypot(from[0], from[1]) + std::hypot(x[0], x[1]) : std::hypot(x[0] - from[0], x[1] - from[1]);
      return std::hypot(plane, x[2] - from[2]);
    };
    for (int const n : {20, 30, 46, 68, 100}) {
      Errors const found = errors(n, dimensions, block, from, exact);
      INFO(dimensions << "D, " << n << ": " << found.mean << ' ' << found.largest << ' ' << found.least);
      CHECK(found.mean < 0.003);
      CHECK(found.largest < 0.1);
      // rays may miss an edge by up to a fiftieth of a cell of their length, and turn there
      CHECK(found.least > -0.01);
    }
  }
}
