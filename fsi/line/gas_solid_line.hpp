#pragma once
/// A line of gas beside a line of a solid: two meshes that share one moving node, the contact. No overlap, no
/// interpolation: both sides trace to the contact in the middle of the step, its exact Riemann problem gives pressure
/// and velocity, and both take these as their boundary. What one side loses the other gets: momentum and energy of both
/// together change at the outer ends alone.
#include "riemann/contact/contact.hpp"
#include "scheme/step/gas_line.hpp"
#include "scheme/step/solid_line.hpp"

namespace g27 {

/// How the contact is solved.
enum class ContactSolver {
  newton,      ///< riemann/contact/gas_solid.hpp
  fixed_point  ///< OG's iteration: for comparison; does not converge where the gas has the greater impedance
};

struct ContactCounters {
  std::uint64_t steps = 0, retried = 0;  ///< steps taken; tried again with half the step
  std::uint64_t iterations = 0;          ///< of the contact's solver, in the steps taken
  std::uint64_t vacua = 0;               ///< steps in which the gas did not reach the solid
  std::uint64_t yielding = 0;            ///< steps in which the contact lay on the plastic branch
};

class GasSolidLine {
 public:
  /// The gas's last face is the solid's first, or its first the solid's last; both boundaries there are contacts.
  /// Throws std::invalid_argument for a setup that makes no sense.
  GasSolidLine(GasLineSetup gas, SolidLineSetup solid, ContactSolver solver = ContactSolver::newton);

  /// One step of both, not beyond t_end; on failure the state is that before the step. `cell` counts in the gas, or
  /// from its last cell on in the solid.
  StepReport step(double t_end);

  /// Both sides, to set their states at t = 0 and to read them.
  [[nodiscard]] GasLine& gas() noexcept { return gas_; }
  [[nodiscard]] SolidLine& solid() noexcept { return solid_; }
  [[nodiscard]] GasLine const& gas() const noexcept { return gas_; }
  [[nodiscard]] SolidLine const& solid() const noexcept { return solid_; }
  [[nodiscard]] double time() const noexcept { return solid_.time(); }
  /// Position of the contact, on the solid's mesh [m].
  [[nodiscard]] double position() const noexcept;
  /// Pressure and velocity (along +x) at the contact during the last step.
  [[nodiscard]] Contact const& contact() const noexcept { return contact_; }
  [[nodiscard]] ContactCounters const& counters() const noexcept { return counters_; }

 private:
  struct Solved {
    Contact contact;
    bool converged = false, vacuum = false, yielding = false;
    int iterations = 0;
  };
  [[nodiscard]] Solved solve(double dt);

  ContactSolver solver_;
  LineEnd gas_end_, solid_end_;
  GasLine gas_;
  SolidLine solid_;
  Contact contact_;
  ContactCounters counters_;
};

}  // namespace g27
