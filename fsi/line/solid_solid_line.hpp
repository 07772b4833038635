#pragma once
/// Two lines of solids bonded end to end: two meshes that share one moving node. Both sides trace to it in the middle
/// of the step, riemann/contact/solid_solid.hpp gives velocity and traction, and both take these as their boundary:
/// momentum and energy of both together change at the outer ends alone. Each line has its own material, mesh and
/// scheme.
#include "scheme/step/solid_line.hpp"

namespace g27 {

class SolidSolidLine {
 public:
  /// The last face of `left` is the first of `right`; both boundaries there are contacts. Throws std::invalid_argument
  /// for a setup that makes no sense.
  SolidSolidLine(SolidLineSetup left, SolidLineSetup right);

  /// One step of both, not beyond t_end; on failure the state is that before the step. `cell` counts on from left to
  /// right.
  StepReport step(double t_end);

  /// Both sides, to set their states at t = 0 and to read them.
  [[nodiscard]] SolidLine& left() noexcept { return left_; }
  [[nodiscard]] SolidLine& right() noexcept { return right_; }
  [[nodiscard]] SolidLine const& left() const noexcept { return left_; }
  [[nodiscard]] SolidLine const& right() const noexcept { return right_; }
  [[nodiscard]] double time() const noexcept { return left_.time(); }
  /// Position of the bonded face [m].
  [[nodiscard]] double position() const noexcept { return right_.faces().front(); }
  /// Velocity and traction on it during the last step.
  [[nodiscard]] BondedContact const& contact() const noexcept { return contact_; }
  /// Steps redone with half the time step.
  [[nodiscard]] std::uint64_t retried() const noexcept { return retried_; }

 private:
  SolidLine left_, right_;
  BondedContact contact_;
  std::uint64_t retried_ = 0;
};

}  // namespace g27
