#pragma once
/// The inner loops of the gas scheme as tables of functions, one table per instruction set, chosen once at start.
/// Arguments are plain pointers, so that nothing that depends on an instruction set crosses this interface.
#include <array>
#include <cstddef>

#include "riemann/eos/registry.hpp"
#include "scheme/kernel/grid_kernels.hpp"
#include "scheme/step/gas_options.hpp"

namespace g27 {

/// Every predictor with its ablations; `--order` and `--switch` choose among them.
enum class PredictorKernel {
  godunov,
  linear_off,
  linear_literal,
  linear_binary,
  linear_graded,
  linear_single_foot,  ///< graded switch off, density at the acoustic feet
  linear_cell_feet,    ///< OG (3.10), switch off
  parabolic_off,
  parabolic_on,
  muscl,
  count
};

/// Predictors that need the averages of the primitives and fluxes averaged over the step.
constexpr bool is_third_order(PredictorKernel p) noexcept {
  return p == PredictorKernel::parabolic_on || p == PredictorKernel::parabolic_off;
}

/// The kernel of a scheme. Throws std::invalid_argument for choices that do not go together.
PredictorKernel predictor_kernel(Predictor predictor, Switch monotonicity, FootPoints feet, bool single_foot);

/// Fluxes of weak faces straight from the predictor, for laws with rho e = p per_pressure + at_zero: the star state and
/// its change need not be stored where a whole vector is weak. Fixed meshes only; MUSCL does not give them.
struct FluxesAtOnce {
  double per_pressure = 0, at_zero = 0;
  bool keep_states = false;                                        ///< store them all the same
  double *mass = nullptr, *momentum = nullptr, *energy = nullptr;  ///< out, faces; null: not wanted
};

/// Arrays are indexed by the face: cell arrays so that [-stride], [0] | [stride], [2 stride] are the cells around face
/// 0: stride 1 for the faces of a row, the distance of two rows for the faces between them. Widths and mesh factors
/// keep a stride of 1: where the rows lie across the faces they are the same for all.
/// Loads and stores run over to the next multiple of the vector width.
struct PredictArguments {
  std::size_t faces;
  std::ptrdiff_t stride;          ///< between the cells on both sides of a face
  bool own_increments;            ///< each side takes the increment of its own cell, instead of a mean along its path
  double const *rho, *u, *p, *K;  ///< cells, K = rho c^2
  double const* dK_dp;            ///< cells, dK/dp along the isentrope; predictors beyond second order
  double const *h, *inv_pair, *inv_triple;   ///< cells; inv_pair[j] = 1/(h[j] + h[j+1])
  double const* w;                           ///< faces
  double const *inc_rho, *inc_u, *inc_p;     ///< half-step increments of the cells on the left; null: none
  double const *next_rho, *next_u, *next_p;  ///< and of the cells on the right
  double const *foot_shift, *foot_factor;    ///< faces; OG (3.10) only
  double dt, exponent;
  bool linear_star;  ///< false: every face goes to the solver
  /// out, faces: the states of the Riemann problem, the star state, the number of switched fields
  double *l_rho, *l_u, *l_p, *r_rho, *r_u, *r_p, *s_rho, *s_u, *s_p, *switched;
  /// out, faces: change of the face state over dt/sqrt(12), for fluxes averaged over the step; zero where not smooth.
  /// Null: not wanted
  double *d_rho, *d_u, *d_p;
  double* strong;  ///< out: 1 where the Riemann problem is to be solved, else 0
  FluxesAtOnce at_once{};
};

/// Counts over a chunk of faces.
struct CountArguments {
  std::size_t faces;
  double const *switched, *strong;      ///< from the predictor
  double* map;                          ///< faces: one more where the switch acted
  double faces_switched, faces_strong;  ///< out
};

struct SolveArguments {
  std::size_t faces;
  std::ptrdiff_t stride;  ///< between the cells on both sides of a face
  void const* eos;
  double const *rho, *u, *p, *margin;  ///< cells: what a face falls back to
  double const* w;                     ///< faces
  bool lagrangian;                     ///< the face moves with the contact: no mass flux
  double *l_rho, *l_u, *l_p, *r_rho, *r_u, *r_p, *s_rho, *s_u, *s_p, *strong;  ///< from the predictor
  double *f_mass, *f_momentum, *f_energy;  ///< out, faces: fluxes per area through the moving face
  double *face_p, *face_u;                 ///< out, faces
  double const *d_rho, *d_u, *d_p;         ///< from the predictor; null: none
  bool weak_done;                          ///< the fluxes of weak faces are there already
  std::size_t failures;                    ///< out: problems that did not converge
};

struct PrimitiveArguments {
  std::size_t cells;
  void const* eos;
  double const *mass, *momentum, *energy;  ///< conserved averages
  double *rho, *u, *p, *K, *margin;        ///< out
};

/// Averages of the primitive variables from the primitives of the averages; [-1] and [cells] are read as well.
struct AverageArguments {
  std::size_t cells;
  void const* eos;
  double const *rho, *u, *p, *K;  ///< primitives of the averaged conserved variables
  double const* h;                ///< widths
  double* dK_dp;                  ///< out: along the isentrope, 2 G - 1 with the fundamental derivative G
  double *u_mean, *p_mean;        ///< out: the primitives' averages, to third order where they are smooth
};

/// Corrector: measure_new q_new = measure q - dt (area_r F_r - area_l F_l) + sources, then primitives.
struct UpdateArguments {
  std::size_t cells;
  void const* eos;
  double const *mass, *momentum, *energy;                 ///< cells
  double const *f_mass, *f_momentum, *f_energy, *face_p;  ///< faces [cells + 1]
  double const* area;                                     ///< faces; null: planar
  double const *measure, *inv_measure_new;                ///< cells; null: planar, fixed and uniform with `lambda`
  double const *src_mass, *src_momentum, *src_energy;     ///< cells, times dt times new measure; null: none
  double const* inv_h;                                    ///< cells; null: uniform with `inv_width`
  double dt, lambda, inv_width;                           ///< lambda = dt/h of a uniform fixed mesh, inv_width = 1/h
  double const *rho_old, *margin_old;                     ///< cells
  double *mass_new, *momentum_new, *energy_new;           ///< out
  double *rho, *u, *p, *K, *margin;                       ///< out: primitives of the new state
  double worst;  ///< out: least of rho/rho_old and margin/margin_old; NaN counts as -1
  double rate;   ///< out: largest (|u| + c)/h of the new state [1/s]
};

/// What depends on the equation of state.
struct EosKernels {
  using Solve = void (*)(SolveArguments&);
  using Primitive = void (*)(PrimitiveArguments const&);
  using Update = void (*)(UpdateArguments&);
  using Average = void (*)(AverageArguments const&);
  std::array<Solve, 3> solve;  ///< [RiemannSolver]
  Primitive primitive;
  Update update;
  Average average;
  /// Of a law with rho e = p first + second: the two; {0, 0}: it is none.
  std::array<double, 2> (*energy_line)(void const* eos);
  GridEosKernels grid;  ///< two and three dimensions
};

struct GasKernels {
  using Predict = void (*)(PredictArguments const&);
  using PredictRow = std::array<Predict, 2>;  ///< [uniform fixed mesh]
  using PredictTable = std::array<PredictRow, static_cast<std::size_t>(PredictorKernel::count)>;

  /// The predictors of one instruction set, and the number of lanes of its vectors.
  struct Predictors {
    std::size_t width;
    PredictTable table;
    void (*count)(CountArguments&);
    GridLoops grid;  ///< two and three dimensions
  };

  char const* isa;
  Predictors const* predict;
  std::array<EosKernels const*, std::variant_size_v<AnyEos>> eos;  ///< [index of the law in AnyEos]
};

/// Tables that this machine can run, the best last.
std::array<GasKernels const*, 8> const& runnable_gas_kernels() noexcept;
/// The best table, or the one that the environment variable G27_ISA names. Throws std::runtime_error without any.
GasKernels const& gas_kernels();

}  // namespace g27
