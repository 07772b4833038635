#pragma once
/// The inner loops of the solid scheme as tables of functions, one table per instruction set. Rows run along x; lanes
/// beyond a row's end are computed up to the next multiple of the vector width.
#include <array>
#include <cstddef>

#include "riemann/solid/boundary.hpp"
#include "riemann/solid/material.hpp"
#include "riemann/strength/von_mises.hpp"
#include "scheme/step/gas_options.hpp"

namespace g27 {

/// A row of several fields: field f of lane i at data[f * stride + i].
struct FieldRows {
  double* data = nullptr;
  std::ptrdiff_t stride = 0;
  [[nodiscard]] double* operator[](int field) const noexcept { return data + field * stride; }
  [[nodiscard]] FieldRows from(std::ptrdiff_t lane) const noexcept { return {data + lane, stride}; }
};

/// Fields of a cell: the state, then what the law makes of it. `terms`: half-step increments of the state, and of S:D.
namespace solid_cell {
inline constexpr int rho = 0, u = 1, p = 4, e = 5, S = 6, ep = 12, state = 13, K = 13, f = 14, fields = 15;
inline constexpr int work = 13, terms = 14;
}  // namespace solid_cell
/// Conserved densities: mass, momentum, energy, rho S, rho ep.
namespace solid_conserved {
inline constexpr int mass = 0, momentum = 1, energy = 4, S = 5, ep = 11, fields = 12;
}
/// Rows of a face: fluxes of mass, momentum and energy; S, ep and the velocity on it.
namespace solid_face {
inline constexpr int mass = 0, momentum = 1, energy = 4, S = 5, ep = 11, u = 12, fields = 15;
}

/// Faces of a row: predictor, Riemann problem, fluxes.
struct SolidFaceArguments {
  std::size_t faces;
  std::ptrdiff_t stride;  ///< between the cells on both sides of a face
  int axis;
  FieldRows cells;        ///< at the left cell of the first face
  FieldRows left, right;  ///< half-step terms of the left and of the right cells, by the face; null: none
  double dt, h;
  Strength strength;
  bool plastic, tangent;
  Switch monotonicity;
  bool two_way = false;  ///< of the graded switch, solid_slope.hpp
  FieldRows out;
  double switched, tangents;  ///< out: faces on which the switch acted; that took the tangent modulus
};

/// Faces of a row that bound the body.
struct SolidBoundaryArguments {
  std::size_t faces;
  std::ptrdiff_t inward;  ///< from a cell to the next one away from the boundary
  int axis;
  double side;  ///< 1: the body lies below the face, -1: above
  SolidFaceCondition kind;
  FieldRows given;  ///< three rows: velocity or traction, along x, y, z
  FieldRows cells;  ///< at the cell beside the first face
  FieldRows terms;  ///< of those cells; null: none
  double dt, h;
  Strength strength;
  bool plastic, tangent;
  Predictor predictor;
  bool limited;
  FieldRows out;
};

/// Half-step transverse terms of a row of cells, T_a = -(dt/2) sum over the other axes b of A_b W_b, central slopes.
struct SolidTransverseArguments {
  std::size_t cells;
  FieldRows cell;
  std::array<std::ptrdiff_t, 3> stride;     ///< to the next cell along each axis
  std::array<double, 3> quarter_dt_over_h;  ///< dt/(4 h); 0 along axes that are not there
  double mu;
  std::array<FieldRows, 3> term;  ///< out, for the faces across each axis; null where not wanted
};

/// The corrector of a row of cells: fluxes, Jaumann terms from the face velocities, return to the yield surface.
struct SolidCorrectArguments {
  std::size_t cells;
  FieldRows now, next, source;            ///< conserved averages; what a source adds to them in the step, null: nothing
  std::array<FieldRows, 3> lower, upper;  ///< faces below and above the cells along each axis; null: not swept
  std::array<double, 3> lambda;           ///< dt/h
  Strength strength;
  bool plastic, midpoint;
  double yielded, plastic_work;  ///< in and out: cells returned; sum of the work's density [J/m^3]
};

struct SolidPrimitiveArguments {
  std::size_t cells;
  void const* eos;
  FieldRows conserved, cell;
};

/// What a new state is worth.
struct SolidFinishArguments {
  std::size_t cells;
  void const* eos;
  double mu;
  FieldRows conserved;
  double const* rho_old;
  std::array<double, 3> inv_h;  ///< 0 along axes that are not there
  double least, rate;  ///< in and out: least of rho/rho_old, -1 where the state is no state; largest sum of (|u|+a)/h
};

struct SolidEosKernels {
  void (*primitive)(SolidPrimitiveArguments const&);
  void (*finish)(SolidFinishArguments&);
};

struct SolidLoops {
  std::size_t width;
  void (*boundary)(SolidBoundaryArguments&);
  void (*transverse)(SolidTransverseArguments const&);
  void (*correct)(SolidCorrectArguments&);
};

struct SolidKernels {
  char const* isa;
  SolidLoops const* loops;
  std::array<void (*)(SolidFaceArguments&), 3> faces;  ///< [Predictor]
  std::array<SolidEosKernels const*, std::variant_size_v<AnySolidEos>> eos;
};

/// Those of the instruction set that gas_kernels() chose.
SolidKernels const& solid_kernels() noexcept;

}  // namespace g27
