/// Norms, observed order and grid convergence index on data whose answers are known in closed form.
#include "tests/catch.hpp"
#include "verification/measure/gci.hpp"
#include "verification/measure/norms.hpp"
#include "verification/measure/order.hpp"

using namespace g27;

TEST_CASE("norms weigh cells by their measure", "[measure]") {
  std::vector<double> const value{1, 2, 5}, reference{1, 3, 3}, measure{1, 2, 1};
  Norms const n = norms(value, reference, measure);
  CHECK(n.l1 == Approx((2 * 1 + 1 * 2) / 4.0));
  CHECK(n.l2 == Approx(std::sqrt((2 * 1 + 1 * 4) / 4.0)));
  CHECK(n.linf == 2);
  CHECK_THROWS_AS(norms(value, reference, std::vector<double>{1}), std::invalid_argument);
  std::vector<double> const broken{1, std::nan(""), 3};
  CHECK(std::isnan(norms(broken, reference, measure).l1));
  CHECK(std::isnan(norms(broken, reference, measure).linf));
}

TEST_CASE("total variation and overshoot", "[measure]") {
  std::vector<double> const step{0, 0, 2, 2}, wiggle{0, -.1, 2.3, 2};
  CHECK(total_variation(step) == 2);
  CHECK(total_variation(step, true) == 4);
  CHECK(tv_excess(wiggle, step) == Approx((.1 + 2.4 + .3) / 2 - 1));
  CHECK(overshoot(wiggle, step) == Approx(.3 / 2));
  CHECK(overshoot(step, step) == 0);
  std::vector<double> const flat{4, 4}, noise{4, 4.4};
  CHECK(tv_excess(noise, flat) == Approx(.1));
  CHECK(overshoot(noise, flat) == Approx(.1));
}

TEST_CASE("the fitted order of an exact power is that power", "[measure]") {
  std::vector<double> h, error;
  for (int n : {20, 30, 60, 100, 200}) {
    h.push_back(1.0 / n);
    error.push_back(0.7 * std::pow(1.0 / n, 1.9));
  }
  OrderFit const fit = fit_order(h, error);
  CHECK(fit.order == Approx(1.9).epsilon(1e-12));  // round-off
  CHECK(fit.constant == Approx(0.7).epsilon(1e-11));
  CHECK(fit.half_width < 1e-10);
  CHECK(fit.between.back() == Approx(1.9).epsilon(1e-12));
  CHECK(fit.is(2, .11));
  CHECK_FALSE(fit.is(2, .09));
  CHECK_FALSE(fit.is(1.8, .09));  // two-sided
}

TEST_CASE("the confidence interval is that of the textbook", "[measure]") {
  // ln h = 0 -1 -2 -3, residuals +d -d -d +d about slope 2: they are orthogonal to line and constant, so the slope is 2
  // and its variance d^2 * 4/(n - 2)/sum (x - mean)^2 = 2 d^2/5; Student's t for 2 degrees of freedom is 4.302653.
  double const d = 0.05;
  std::vector<double> h, error;
  for (int i = 0; i < 4; ++i) {
    h.push_back(std::exp(-i));
    error.push_back(std::exp(-2.0 * i + (i == 0 || i == 3 ? d : -d)));
  }
  OrderFit const fit = fit_order(h, error);
  CHECK(fit.order == Approx(2).epsilon(1e-12));
  CHECK(fit.half_width == Approx(4.302652730 * d * std::sqrt(0.4)).epsilon(1e-8));
}

TEST_CASE("an order is not fitted to too little", "[measure]") {
  std::vector<double> const three{1, .5, .25}, four{1, .5, .25, .125}, zero{1, .5, 0, .1}, same{1, .5, .5, .1};
  CHECK_THROWS_AS(fit_order(three, three), std::invalid_argument);
  CHECK_THROWS_AS(fit_order(four, zero), std::invalid_argument);
  CHECK_THROWS_AS(fit_order(same, four), std::invalid_argument);
  CHECK_THROWS_AS(fit_order(four, three), std::invalid_argument);
}

TEST_CASE("three grids give back order and limit of a power law", "[measure]") {
  auto f = [](double h) { return 3 - 0.4 * std::pow(h, 1.7); };
  for (double r32 : {2.0, 1.5, 3.0}) {
    double const h = 0.1, r21 = 2;
    GridConvergence const g = grid_convergence(f(h), f(r21 * h), f(r21 * r32 * h), r21, r32, 2);
    CHECK(g.behaviour == Convergence::monotone);
    CHECK(g.order == Approx(1.7).epsilon(1e-9));
    CHECK(g.richardson == Approx(3).epsilon(1e-10));
    CHECK(g.band == Approx(3 * (3 - f(h))).epsilon(1e-8));  // 15 % off the formal order: the wide safety factor
    CHECK(grid_convergence(f(h), f(r21 * h), f(r21 * r32 * h), r21, r32, 1.7).band ==
          Approx(1.25 * (3 - f(h))).epsilon(1e-8));
  }
}

TEST_CASE("Roache's worked example", "[measure]") {
  // Roache 1998, 5.9 (also NPARC Alliance tutorial): .97050 .96854 .96178, ratio 2: order 1.786170, extrapolated
  // .97130, band .103083 % of the fine value with the factor 1.25 for order 1.786170.
  GridConvergence const g = grid_convergence(.97050, .96854, .96178, 2, 2, 1.786170);
  CHECK(g.order == Approx(1.786170).epsilon(1e-6));
  CHECK(g.richardson == Approx(.97130).margin(5e-6));
  CHECK(g.band / .97050 == Approx(.00103083).epsilon(1e-4));
}

TEST_CASE("oscillating and diverging figures get a band but no order", "[measure]") {
  GridConvergence const o = grid_convergence(1.0, 1.1, 0.8, 2, 2, 2);
  CHECK(o.behaviour == Convergence::oscillatory);
  CHECK(o.order == 0);
  CHECK(o.richardson == 1.0);
  CHECK(o.band == Approx(3 * .3));
  CHECK(grid_convergence(1.0, 1.3, 1.4, 2, 2, 2).behaviour == Convergence::divergent);
  CHECK(grid_convergence(1.0, 1.0, 1.4, 2, 2, 2).behaviour == Convergence::exact);
  CHECK_THROWS_AS(grid_convergence(1, 2, 3, 1, 2, 2), std::invalid_argument);
}
