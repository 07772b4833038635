#pragma once
/// Inside of SolidLine: its arrays, and the stages of a step. solid_line.cpp has the state and the interface,
/// solid_line_step.cpp the step, solid_line_faces.cpp predictor and Riemann problems.
#include <utility>
#include <vector>

#include "riemann/state/solid.hpp"
#include "scheme/grid/line.hpp"
#include "scheme/predictor/solid_cells.hpp"
#include "scheme/step/accumulator.hpp"
#include "scheme/step/row_block.hpp"
#include "scheme/step/solid_line.hpp"
#include "scheme/step/solid_state.hpp"

namespace g27 {

inline constexpr std::ptrdiff_t line_ghosts = 2;

/// What a cell carries along: mass, momentum and total energy, S and ep of its material.
struct SolidParcel {
  double mass = 0, momentum[3]{}, energy = 0, S[6]{}, ep = 0;

  /// Conserved densities of the parcel in a cell of measure v.
  [[nodiscard]] SolidVector densities(double v) const noexcept;
};

struct SolidLine::Impl {
  SolidLineSetup setup;
  std::size_t n;
  SolidEosKernels law;
  void const* eos;
  Strength strength;
  bool plastic;
  int hoops;  ///< hoop directions: 0 planar, 1 cylindrical, 2 spherical
  Line line;
  std::vector<SolidParcel> now, next;
  std::vector<SolidFace<double>> faces;
  std::vector<double> speeds;
  RowBlock conserved, cell, new_cell, term;  ///< rows of cells -2 .. n + 1
  double time = 0, rate = 0;
  SolidContacts contacts;                       ///< of the step that is tried
  double attempted_dt = 0, attempted_rate = 0;  ///< of the state in `next`
  SolidCounters counters;
  std::array<Accumulator, 5> initial, boundary, source;
  std::array<double, 5> scale{};
  Accumulator plastic_work;
  /// Of the step that is tried.
  double switched = 0, tangents = 0, yielded = 0, work = 0, hoop_push = 0;

  explicit Impl(SolidLineSetup s);
  static SolidLineSetup checked(SolidLineSetup s);

  [[nodiscard]] std::ptrdiff_t cells() const noexcept { return static_cast<std::ptrdiff_t>(n); }
  [[nodiscard]] SolidParcel const& parcel(std::ptrdiff_t i) const noexcept { return now[static_cast<std::size_t>(i)]; }
  [[nodiscard]] SolidFace<double>& face(std::ptrdiff_t f) noexcept { return faces[static_cast<std::size_t>(f)]; }

  /// Primitive rows of parcels in cells between the faces x.
  void primitives(std::vector<SolidParcel> const& parcels, std::vector<double> const& x, RowBlock& to);
  /// Takes `now` as the state at t = 0.
  void start();
  void add_totals(std::array<Accumulator, 5>& total, std::array<double, 5>& magnitude);
  /// Largest a/h of the cells between the faces x; not finite, or negative, where a state is none. `bad`: that cell.
  [[nodiscard]] double signal_rate(RowBlock& rows, std::vector<double> const& x, std::size_t& bad);

  [[nodiscard]] double choose_dt(double t_end, double shrink) const;
  StepReport step(double t_end);
  /// One attempt at a step of dt. `last`: whatever signal speeds it leaves.
  StepReport attempt(double dt, bool last);
  bool try_step(double dt, double& new_rate, StepReport& report);
  void correct(double dt, std::vector<double> const& x_new);
  void accept();

  // solid_line_faces.cpp
  void all_faces(double dt);
  void fill_ghosts();
  void set_terms(double dt);
  template <Predictor predictor>
  void inner_faces(double dt);
  void boundary_face(bool low, double dt);
  [[nodiscard]] RidingCells cells_at_end(bool low) const;
  [[nodiscard]] SolidBoundaryArguments boundary_arguments(bool low, double dt, RidingCells const& around);

  /// solid_line_end.hpp
  struct End;

  // solid_trace.cpp
  [[nodiscard]] SolidTrace trace(LineEnd end, double dt);

  // solid_bonded.cpp
  [[nodiscard]] BondedSide bonded_side(LineEnd end, double dt);
  [[nodiscard]] SolidFace<double> bonded_face(bool low, double dt, BondedContact const& contact);
};

}  // namespace g27
