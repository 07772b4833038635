#pragma once
/// One-dimensional gas dynamics on fixed and on moving cells, planar, cylindrical or spherical: predictor, Riemann
/// problem on every face, conservative corrector. The schemes differ in the predictor alone.
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "riemann/eos/registry.hpp"
#include "scheme/step/gas_options.hpp"
#include "scheme/step/line_contact.hpp"
#include "scheme/step/programmed_burn.hpp"

namespace g27 {

struct GasLineSetup {
  AnyEos eos{};
  std::vector<double> faces{};  ///< [cells + 1] increasing positions [m]; >= 0 in curved symmetry
  Symmetry symmetry = Symmetry::planar;
  GasBoundary left{}, right{};
  MeshMotion motion{};
  GasSource source{};
  ProgrammedBurn burn{};
  GasSchemeOptions options{};
};

enum class StepStatus { ok, inadmissible_state, mesh_tangled, time_step_vanished };

struct StepReport {
  StepStatus status = StepStatus::ok;
  std::size_t cell = 0;  ///< where it failed
  double dt = 0;         ///< step taken [s]
};

class GasLine {
 public:
  explicit GasLine(GasLineSetup setup);
  ~GasLine();
  GasLine(GasLine&&) noexcept;
  GasLine& operator=(GasLine&&) noexcept;

  /// Cell averages by Gauss quadrature (`points` a cell) of the state at (x, t = 0), weighted with the cell's measure.
  void set_state(std::function<GasState<>(double x)> const& state, int points = 5);
  /// Cell averages of the conserved densities, [cells], at time `time`.
  void set_averages(std::span<GasConserved<> const> averages, double time = 0);

  /// One step, not beyond t_end; on failure the state is that before the step.
  StepReport step(double t_end);

  // A line with a contact takes these in place of `step`: see line_contact.hpp.

  /// The step that the CFL condition allows, times `shrink`, not beyond t_end [s]; first of all in a step.
  [[nodiscard]] double next_dt(double t_end, double shrink = 1.0);
  /// Gas beside the contact at that end in the middle of a step of dt.
  [[nodiscard]] GasState<> trace(LineEnd end, double dt);
  /// A step of dt up to the new state; what is not `ok` leaves nothing to accept.
  StepReport attempt(double dt, LineContacts const& contacts);
  /// The state that the last attempt left becomes the state.
  void accept();

  [[nodiscard]] std::size_t cells() const noexcept;
  [[nodiscard]] double time() const noexcept;
  /// Time step that the CFL condition allows now [s].
  [[nodiscard]] double stable_dt() const noexcept;
  [[nodiscard]] std::span<double const> faces() const noexcept;         ///< [cells + 1], m
  [[nodiscard]] std::span<double const> density() const noexcept;       ///< [cells], kg/m^3
  [[nodiscard]] std::span<double const> velocity() const noexcept;      ///< [cells], m/s
  [[nodiscard]] std::span<double const> pressure() const noexcept;      ///< [cells], Pa
  [[nodiscard]] std::span<double const> bulk_modulus() const noexcept;  ///< [cells], rho c^2, Pa
  [[nodiscard]] GasConserved<> average(std::size_t cell) const noexcept;
  /// Measure of a cell: length [m], area per radian [m^2] or volume per steradian [m^3].
  [[nodiscard]] double measure(std::size_t cell) const noexcept;
  /// Steps in which the switch acted on the face, [cells + 1].
  [[nodiscard]] std::span<double const> switch_map() const noexcept;
  /// State on the first (left) or last (right) face during the last step.
  [[nodiscard]] GasState<> left_face() const noexcept;
  [[nodiscard]] GasState<> right_face() const noexcept;
  [[nodiscard]] GasCounters const& counters() const noexcept;
  [[nodiscard]] GasLedger ledger() const noexcept;
  [[nodiscard]] GasLineSetup const& setup() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
