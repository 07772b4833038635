#pragma once
/// The inner loops that two and three dimensions add to those of the line, over rows of cells or of faces. Rows run
/// along x; a face between two rows is reached by the stride of its axis. Loads and stores run over to the next
/// multiple of the vector width. In two dimensions nothing along z is read.
#include <array>
#include <cstddef>

#include "riemann/eos/registry.hpp"
#include "scheme/step/gas_grid_options.hpp"

namespace g27 {

/// Pointers to one row of five fields: density or mass, three velocities or momenta, pressure or energy.
struct RowOut {
  double *first = nullptr, *vector[3]{nullptr, nullptr, nullptr}, *last = nullptr;
};
struct RowIn {
  double const *first = nullptr, *vector[3]{nullptr, nullptr, nullptr}, *last = nullptr;
  RowIn() = default;
  static RowIn of(std::array<double const*, 5> const& q) noexcept {
    RowIn r;
    r.first = q[0], r.vector[0] = q[1], r.vector[1] = q[2], r.vector[2] = q[3], r.last = q[4];
    return r;
  }
  RowIn(RowOut const& o) : first(o.first), vector{o.vector[0], o.vector[1], o.vector[2]}, last(o.last) {}
};

/// Conserved averages to primitives, with K = rho c^2 and the pressure margin.
struct GridPrimitiveArguments {
  std::size_t cells;
  void const* eos;
  RowIn conserved;
  RowOut primitive;
  double *K, *margin;  ///< out
};

/// As AverageArguments, for the three velocities; neighbours along every axis are read.
struct GridAverageArguments {
  std::size_t cells;
  void const* eos;
  RowIn primitive;
  double const* K;
  std::array<std::ptrdiff_t, 3> stride;
  double* velocity[3];  ///< out
  double *p, *dK_dp;    ///< out
};

/// Half-step terms of the transverse derivatives and, since the differences are at hand, flags of shocks.
///
/// Terms, T_x = -(dt/2)(B W_y + C W_z) and so on. Slopes are central where the
/// data are smooth, else limited (monotonized central, van Leer 1977). Where a term would leave less than a fifth of
/// the density or of the pressure margin it is zero.
struct TransverseArguments {
  std::size_t cells;
  RowIn primitive;
  double const *K, *margin;
  std::array<std::ptrdiff_t, 3> stride;
  std::array<double, 3> half_dt_over_h;
  std::array<RowOut, 3> term;  ///< out, for the faces across each axis; null where not wanted
  double* flag;                ///< out, as of ShockFlagArguments; null: not wanted
  bool any;                    ///< out
};

/// Velocities along the face, carried with the contact; adds their flux and their part of the energy's.
struct TangentialArguments {
  std::size_t faces, fields;  ///< fields: 1 or 2
  std::ptrdiff_t stride;
  double const *rho, *u, *p, *K;  ///< cells, u normal
  double const* velocity[2];      ///< cells
  double const* increment[2];     ///< of the cells on the left; null: none
  double const* next[2];          ///< of the cells on the right
  double h, dt;
  double const* f_mass;
  double *f_energy, *f_velocity[2];  ///< in and out; out
};

/// Cells in a strong shock along a grid line with waves beside it: 1, else 0 (see carbuncle_loop.hpp).
struct ShockFlagArguments {
  std::size_t cells;
  RowIn primitive;
  double const* K;
  std::array<std::ptrdiff_t, 3> stride;
  double* flag;  ///< out
  bool any;      ///< out
};

/// HLLE between the cell states on the faces with mark > 0, over the fluxes that are there.
struct HlleArguments {
  std::size_t faces;
  void const* eos;
  std::ptrdiff_t stride;
  int axis;
  RowIn primitive;
  double const* mark;  ///< faces
  RowOut flux;
};

/// to = from - lambda (upper - lower) for the fluxes of one or of two axes, in this order.
struct GridUpdateArguments {
  std::size_t cells, axes;
  RowIn from;
  std::array<RowIn, 2> lower, upper;
  std::array<double, 2> lambda;
  RowOut to;
};

/// What a new state is worth: least shares left, signal rate, and whether it differs from `like` anywhere.
struct GridFinishArguments {
  std::size_t cells;
  void const* eos;
  RowIn conserved;
  double const *rho_old, *margin_old;
  std::array<double, 3> inv_h;  ///< 0 along axes that are not there
  bool max_rule;
  double like[5];
  double worst, rate;  ///< in and out: least of rho/rho_old and margin/margin_old; largest sum of (|u| + c)/h [1/s]
  bool differs;        ///< in and out
};

/// MUSCL-Hancock edges of a row of cells, all axes at once (Toro, 3rd ed., 16.5, with van Leer's slopes).
struct GridMusclArguments {
  std::size_t cells;
  RowIn primitive;
  double const* K;
  std::array<std::ptrdiff_t, 3> stride;
  std::array<double, 3> half_dt_over_h;
  std::array<RowOut, 3> lower, upper;  ///< out: states on the lower and on the upper face of the cell along each axis
};

/// Tangential velocities from given sides, upwind by the mass flux.
struct UpwindArguments {
  std::size_t faces, fields;
  double const* left[2];
  double const* right[2];
  double const* f_mass;
  double *f_energy, *f_velocity[2];
};

/// What depends on the equation of state, by dimensions - 2.
struct GridEosKernels {
  std::array<void (*)(GridPrimitiveArguments const&), 2> primitive;
  std::array<void (*)(GridAverageArguments const&), 2> average;
  std::array<void (*)(GridFinishArguments&), 2> finish;
  std::array<void (*)(HlleArguments const&), 2> hlle;
};

/// What does not.
struct GridLoops {
  using Tangential = void (*)(TangentialArguments const&);
  std::array<void (*)(TransverseArguments&), 2> transverse;
  std::array<void (*)(ShockFlagArguments&), 2> shock_flags;
  std::array<void (*)(GridUpdateArguments const&), 2> update;
  std::array<void (*)(GridMusclArguments const&), 2> muscl;
  void (*upwind)(UpwindArguments const&);
  std::array<Tangential, 11> tangential;  ///< [PredictorKernel]
};

}  // namespace g27
