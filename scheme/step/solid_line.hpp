#pragma once
/// One-dimensional elastoplastic solids (Jaumann rate, von Mises, linear hardening) on cells that move with the
/// material, planar, cylindrical (plane strain) or spherical. Every face moves with the velocity its Riemann problem
/// leaves: no mass crosses it, and what rides with the velocity stands.
///
/// Predictor, Riemann problem and boundaries are those of SolidGrid (riemann/solid, scheme/kernel), on cells of any
/// widths. Then, with M the mass of a cell, A the area a face has in the mean over the step, t the hoop stress:
///   M du = dt [A s] - dt t [A],   M dE = dt [A u.s],   dS = Jaumann's rate of the strains of the step,
///   radial strain ln(h_new/h), hoop strains ln(A_new/A)/alpha, A = V/h: together the change of the volume;
/// and the return to the yield surface. Planar lines have all velocities and stresses, curved ones no shear.
#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include "riemann/contact/solid_solid.hpp"
#include "riemann/contact/solid_trace.hpp"
#include "riemann/solid/material.hpp"
#include "scheme/step/gas_line.hpp"
#include "scheme/step/solid_grid.hpp"

namespace g27 {

struct SolidLineSetup {
  AnySolid material{};
  std::vector<double> faces{};  ///< [cells + 1] increasing positions [m]; >= 0 in curved symmetry
  Symmetry symmetry = Symmetry::planar;
  /// symmetry, wall, fixed, traction, free or contact; functions take (x, 0, 0). A symmetric face stands, the others
  /// move
  SolidBoundary left{.kind = SolidBoundary::Kind::free}, right{.kind = SolidBoundary::Kind::free};
  SolidSchemeOptions options{};  ///< those that speak of threads, tiles and transverse terms are not used
};

/// What is found at the ends of a solid line that are contacts: of one that slips, or of one bonded to another solid.
/// Velocities along +x; of an end that has another boundary it is not read.
struct SolidContacts {
  std::variant<Contact, BondedContact> left{}, right{};
};

class SolidLine {
 public:
  /// Throws std::invalid_argument for a setup that makes no sense.
  explicit SolidLine(SolidLineSetup setup);
  ~SolidLine();
  SolidLine(SolidLine&&) noexcept;
  SolidLine& operator=(SolidLine&&) noexcept;

  /// Cell averages by Gauss quadrature (`points` a cell) of the state at (x, t = 0), weighted with the cell's measure.
  void set_state(std::function<SolidPoint(double x)> const& state, int points = 3);
  /// Cell averages, given by the cell's two faces.
  void set_averages(std::function<SolidDensities(double x0, double x1)> const& mean);

  /// One step, not beyond t_end; on failure the state is that before the step.
  StepReport step(double t_end);

  // A line with a contact takes these in place of `step`: see line_contact.hpp.

  /// The step that the CFL condition allows, times `shrink`, not beyond t_end [s].
  [[nodiscard]] double next_dt(double t_end, double shrink = 1.0) const;
  /// Velocity of the surface at that end over the pressure on it, in the middle of a step of dt; along the normal into
  /// the solid.
  [[nodiscard]] SolidTrace trace(LineEnd end, double dt);
  /// What leaves the solid at that end in the middle of a step of dt, for an end bonded to another solid.
  [[nodiscard]] BondedSide bonded_side(LineEnd end, double dt);
  /// A step of dt up to the new state; what is not `ok` leaves nothing to accept.
  StepReport attempt(double dt, SolidContacts const& contacts);
  /// The state that the last attempt left becomes the state.
  void accept();

  [[nodiscard]] std::size_t cells() const noexcept;
  [[nodiscard]] double time() const noexcept;
  [[nodiscard]] std::vector<double> const& faces() const noexcept;        ///< [cells + 1], m
  [[nodiscard]] std::vector<double> const& face_speeds() const noexcept;  ///< [cells + 1], of the last step, m/s
  /// Measure of a cell: length [m], area per radian [m^2] or volume per steradian [m^3].
  [[nodiscard]] double measure(std::size_t cell) const noexcept;
  [[nodiscard]] SolidDensities average(std::size_t cell) const noexcept;
  [[nodiscard]] SolidPoint primitive(std::size_t cell) const noexcept;
  [[nodiscard]] std::vector<double> field(SolidGrid::Field which) const;  ///< [cells]
  [[nodiscard]] double kinetic_energy() const noexcept;                   ///< of the cells' mean velocities [J]

  [[nodiscard]] SolidCounters const& counters() const noexcept;
  /// The energy through the boundary is the work of its tractions; a curved line's hoop stress is a source of momentum.
  /// Per radian or steradian in curved symmetry.
  [[nodiscard]] SolidLedger ledger() const;
  [[nodiscard]] SolidLineSetup const& setup() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
