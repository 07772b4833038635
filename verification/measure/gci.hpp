#pragma once
/// Grid convergence index: what a figure computed on three grids is worth.
/// Roache, Verification and Validation in Computational Science and Engineering (1998), 5.9-5.10; for unequal
/// refinement ratios Celik et al., J. Fluids Eng. 130 (2008) 078001.
namespace g27 {

enum class Convergence {
  monotone,     ///< successive differences of one sign, decreasing
  oscillatory,  ///< of opposite signs, decreasing: no order is observed
  divergent,    ///< not decreasing
  exact         ///< the finest two agree to round-off
};

struct GridConvergence {
  Convergence behaviour = Convergence::exact;
  double order = 0;       ///< observed; 0 unless monotone
  double used_order = 0;  ///< observed, limited to [0.5, formal order]
  double richardson = 0;  ///< extrapolated value; unless monotone, the value on the finest grid
  double band = 0;        ///< half width around the value on the finest grid, in the unit of the value
};

/// A figure on three grids: `fine` with cell size h, `medium` with ratio_21 h, `coarse` with ratio_21 ratio_32 h.
/// The safety factor is 1.25 where the observed order is within 10 % of the formal one, else 3 (Roache). Without
/// monotone convergence the band is 3 times the largest difference on the three grids. Throws std::invalid_argument
/// unless both ratios exceed 1 and the formal order is positive.
GridConvergence grid_convergence(double fine, double medium, double coarse, double ratio_21, double ratio_32,
                                 double formal_order);

}  // namespace g27
