#pragma once
/// Inside of GasLine: its arrays, and the stages of a step in the order in which they run. gas_line.cpp has the state
/// and the interface, gas_step.cpp the step's control, gas_faces.cpp predictor and Riemann problems, gas_corrector.cpp
/// the corrector and its repairs.
#include <cmath>
#include <utility>
#include <vector>

#include "scheme/kernel/gas_kernels.hpp"
#include "scheme/step/accumulator.hpp"
#include "scheme/step/gas_boundary.hpp"
#include "scheme/step/gas_fields.hpp"
#include "scheme/step/gas_line.hpp"

namespace g27 {

inline constexpr std::size_t face_chunk = 256;  ///< faces handled at a time: their arrays stay in the first cache
inline constexpr std::size_t parallel_threshold = 8192;  ///< cells below which threads cost more than they bring
inline constexpr double repair_share = 1e-3;             ///< least rho and margin a step may leave, over the old ones

struct GasLine::Impl {
  GasLineSetup setup;
  GasKernels const& kernels = gas_kernels();
  PredictorKernel predictor;
  EosKernels const& law;
  std::size_t n;
  void const* eos;
  double exponent = 1.0;
  bool moving, curved, plain, cell_feet;
  Line line;
  GasCells now, next;
  GasFaces faces, other_faces;   ///< `other_faces`: as the cell on the right sees them, with the points of OG (3.10)
  Padded u_mean, p_mean, dK_dp;  ///< averages of u and p, and dK/dp, for predictors beyond second order
  Padded inc_rho, inc_u, inc_p, src_mass, src_momentum, src_energy;
  std::vector<double> unburnt, unburnt_next;  ///< fractions of the cells now and after the step; empty: no burn
  std::vector<char> unburnt_faces;            ///< their stencil holds unburnt explosive
  std::vector<double> switch_counts;
  std::vector<char> redone;
  std::vector<FaceProblems> problems;  ///< one a thread
  FaceProblems wall_problems[2]{FaceProblems(16), FaceProblems(16)};
  MirrorRow mirror_row;
  double time = 0, rate = 0, largest_density = 0;
  LineContacts contacts;                        ///< of the step that is tried
  double attempted_dt = 0, attempted_rate = 0;  ///< of the state in `next`
  GasCounters counters;
  Accumulators initial, boundary, source, floor;
  GasConserved<> scale{0, 0, 0};

  explicit Impl(GasLineSetup s);
  /// Number of cells of a setup that makes sense; throws std::invalid_argument otherwise.
  static std::size_t checked_cells(GasLineSetup const& s);

  [[nodiscard]] std::ptrdiff_t cells() const noexcept { return static_cast<std::ptrdiff_t>(n); }

  /// Primitive variables of `count` cells from their averages.
  void primitives(GasCells& c, std::ptrdiff_t begin, std::size_t count) const noexcept;

  /// Total energy per volume [J/m^3].
  [[nodiscard]] double energy_density(GasState<> const& s) const noexcept;

  /// Takes the averages in `now` as the state at t: counters, ledger and signal rate start here.
  void start(double t);

  /// Adds the integrals of the conserved densities; of their magnitudes too, where asked.
  void add_totals(Accumulators& a, GasConserved<>* magnitude) const noexcept;

  /// Largest signal speed over width; with the mesh's own speed when `relative`.
  [[nodiscard]] double signal_rate(GasCells const& c, bool relative) const noexcept;

  /// Face speeds for a step from `time`; the contact's own speed comes later for Lagrangian faces.
  void set_face_speeds(double dt);

  /// Walls stand, pistons move, whatever the mesh does.
  void fix_boundary_speed(GasBoundary const& b, std::ptrdiff_t f, double dt) noexcept;

  /// Speed of an end of the line in the middle of a step from `time`.
  [[nodiscard]] double end_speed(LineEnd end, double dt) const;

  /// The part alpha u/r of a cell's divergence, as the flow through its two faces less the slope of u: from the mean
  /// velocities on the faces, since u/r of the cell itself is unstable in the centre of a sphere above CFL 0.7.
  [[nodiscard]] double geometric_divergence(std::ptrdiff_t i) const noexcept;

  /// Averages of the primitives from the primitives of the averages, with their ghosts.
  void set_averages_of_primitives();

  /// Half-step increments of geometry (alpha rho u / r, alpha K u / r) and of manufactured sources.
  bool set_increments(double dt);

  /// How a run over faces is made.
  struct FaceRun {
    PredictorKernel predictor;
    bool increments, linear_star;
    double dt;
    int side = 0;          ///< OG (3.10): for the cell on the left (0) or on the right (1)
    bool at_once = false;  ///< fluxes of weak faces come with their prediction
    RiemannSolver riemann = RiemannSolver::fast;
    bool unburnt = false;  ///< of faces beside unburnt explosive; other runs leave those out
  };

  /// Predictor on the faces [f, f + count).
  void predict(FaceRun const& run, std::ptrdiff_t f, std::size_t count, FaceProblems& b,
               FluxesAtOnce const& at_once) const noexcept;

  /// The same for rows given by their arrays.
  void predict_row(FaceRun const& run, std::size_t count, PredictorRow const& row, FaceProblems& b,
                   FluxesAtOnce const& at_once) const noexcept;

  /// Predictor on face f alone, seen in the mirror: the gas on its right becomes the left state.
  void predict_mirrored(FaceRun const& run, std::ptrdiff_t f, FaceProblems& b) noexcept;

  /// Riemann problems and fluxes of the predicted faces [f, f + count), written to out at `to`. Returns failures.
  std::size_t solve(FaceRun const& run, std::ptrdiff_t f, std::size_t count, FaceProblems& b, GasFaces& out,
                    std::ptrdiff_t to) const noexcept;

  /// A wall's Riemann problem: the gas beside it against its own image in the moving wall.
  void image_in_wall(FaceRun run, std::ptrdiff_t f, bool wall_on_left, FaceProblems& b, std::size_t at) noexcept;

  /// Predictor and Riemann problems of the faces [begin, begin + count), written to out at `to`. Returns failures.
  std::size_t run_faces(FaceRun const& run, std::ptrdiff_t begin, std::size_t count, FaceProblems& b, GasFaces& out,
                        std::ptrdiff_t to) noexcept;

  /// The face of a contact is solved elsewhere: here its problem is that of one state.
  void leave_to_contact(std::ptrdiff_t cell, FaceProblems& b, std::size_t at) const noexcept;

  /// The face of a contact takes the pressure and the velocity found.
  static void seal_contact(GasFaces& out, std::ptrdiff_t f, Contact const& c) noexcept;

  /// Nothing passes a wall but its push and its work: exactly, not to round-off.
  static void seal(GasFaces& out, std::ptrdiff_t f, double w) noexcept;

  /// Every face of the line, in chunks, on the threads asked for. Returns failures.
  std::size_t all_faces(FaceRun const& run, GasFaces& out);

  /// Corrects the cells [begin, begin + count) into `out` at `to`; returns {worst share, signal rate}.
  std::pair<double, double> correct(double dt, std::ptrdiff_t begin, std::size_t count, GasCells& out,
                                    std::ptrdiff_t to) const noexcept;

  /// The corrector with two fluxes a face, OG (3.10): not conservative.
  std::pair<double, double> correct_with_cell_feet(double dt);

  /// Manufactured sources of the step, integrated over the cells and the step.
  void set_sources(double dt);

  // gas_line_burn.cpp
  [[nodiscard]] bool burns() const noexcept { return !unburnt.empty(); }
  /// Unburnt fractions before the step, and the faces beside them.
  void find_unburnt();
  /// Faces beside unburnt explosive have no Riemann problem in other runs.
  void leave_unburnt(std::ptrdiff_t begin, std::size_t count, FaceProblems& b) const noexcept;
  /// Faces beside unburnt explosive, and what is released.
  void burn(FaceRun const& run, double dt);
  /// How they are run: at first order, and by HLLC, since unburnt explosive has no pressure margin, without which there
  /// is no exact solution beside a vacuum.
  [[nodiscard]] static FaceRun beside_unburnt(FaceRun run) noexcept;
  /// Energy that a cell releases in the step, given the flows of mass through its faces, into src_energy.
  void release(std::ptrdiff_t i, double dt) noexcept;

  /// The new state of a cell has less than `share` of its density or pressure margin left, or is not finite.
  [[nodiscard]] bool bad(std::ptrdiff_t i, double share) const noexcept;

  [[nodiscard]] static FaceRun at_first_order(FaceRun run) noexcept;

  /// A posteriori: the faces of cells that lost nearly all of their density or pressure are redone at first order and
  /// their neighbours corrected again, until none is left or nothing more can be redone.
  void repair(FaceRun const& run, double dt);

  /// Raises what is still not admissible to the vacuum floor; false where that does not help either.
  bool floor_vacuum();

  /// The first cell that is not admissible.
  [[nodiscard]] std::size_t first_bad() const noexcept;

  /// Time step by the CFL condition times `shrink`, with the face speeds that go with it.
  double choose_dt(double t_end, double shrink);

  /// Ghosts and averages of the state, from which a step starts.
  void prepare();

  /// The state of the gas that the outgoing characteristic brings to an end, half of a step of dt on.
  [[nodiscard]] GasState<> trace(LineEnd end, double dt);

  /// One attempt at a step of dt with the face speeds set, counters restored where it fails. `last`: whatever signal
  /// speeds it leaves.
  StepReport attempt(double dt, bool last);

  /// A step, halved and tried again as long as it fails.
  StepReport step(double t_end);

  /// One attempt: everything up to the new state in `next`.
  bool try_step(double dt, double& new_rate);

  /// The corrector on every cell; returns {worst share, signal rate}.
  std::pair<double, double> correct_all(double dt);

  /// The new state becomes the state; boundary fluxes and sources go to the ledger.
  void accept();
};

}  // namespace g27
