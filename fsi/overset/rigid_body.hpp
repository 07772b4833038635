#pragma once
/// A body that does not deform: where it is, how it is turned, and what momentum it has.
#include <array>
#include <functional>
#include <vector>

#include "fsi/overset/mirrors.hpp"

namespace g27 {

struct RigidSetup {
  double density = 1;                     ///< [kg/m^3]
  Vec3 velocity{0, 0, 0}, spin{0, 0, 0};  ///< at the start: of its centre of mass [m/s]; [1/s]
  /// Its velocity at a time [s], whatever pushes; its spin stays. Without: the pressures move it.
  std::function<Vec3(double)> given{};
};

/// Of a body that planes of symmetry cut: the part within the domain, which moves as they let it.
class RigidBody {
 public:
  RigidBody(TriangleSurface const& surface, Cut const& cut, RigidSetup const& setup);

  struct State {
    Vec3 centre{0, 0, 0};                        ///< of mass [m]
    std::array<double, 4> rotation{1, 0, 0, 0};  ///< since the start: a unit quaternion, its real part first
    Vec3 momentum{0, 0, 0};                      ///< [N s]
    Vec3 angular{0, 0, 0};                       ///< angular momentum about the centre [N m s]
  };
  State state;

  struct Motion {
    Vec3 velocity{0, 0, 0};  ///< of the centre [m/s]
    Vec3 spin{0, 0, 0};      ///< [1/s]
  };
  Motion during_step;  ///< at the half of the step that is under way

  [[nodiscard]] double mass() const noexcept { return mass_; }
  [[nodiscard]] Motion motion() const;
  [[nodiscard]] double kinetic_energy() const;  ///< [J]
  /// Second moments of mass about the centre, xx yy zz xy xz yz [kg m^2].
  [[nodiscard]] std::array<double, 6> moments() const;
  /// A vector of the body as it is after it has turned for dt [s] at the spin that it has.
  [[nodiscard]] std::array<Vec3, 3> turn(double dt) const;

  /// What pushes on a part of the surface at the half of a step.
  struct Push {
    Vec3 arm{0, 0, 0}, normal{1, 0, 0};  ///< from the body's centre [m]; out of the body
    double force = 0;                    ///< along the normal, were it at rest [N]
    double resistance = 0;               ///< by which the force falls with its velocity along the normal [N s/m]
  };
  /// The motion at the half of a step of dt [s] from `time` on that is due to the pushes at that motion: implicit, so
  /// that it is stable for bodies that are lighter than the gas beside them. Or the motion that is given.
  [[nodiscard]] Motion half_step(std::vector<Push> const& pushes, double time, double dt) const;
  /// A step by the motion at its half; the impulse and its moment about the centre go to the momenta.
  void advance(double time, double dt, Vec3 const& impulse, Vec3 const& moment);
  [[nodiscard]] bool driven() const noexcept { return static_cast<bool>(given_); }
  /// Vertices where the body is: by its place and rotation, so that the shape is kept to round-off.
  void place(TriangleSurface& surface, Cut const& cut) const;

 private:
  std::vector<Vec3> shape_;                ///< vertices less the centre, at the start [m]
  double mass_ = 0;                        ///< [kg]
  std::array<double, 6> moments_{};        ///< at the start
  std::array<bool, 3> moves_{}, turns_{};  ///< along and about which axes the planes let it
  std::function<Vec3(double)> given_;      ///< velocity at a time
};

}  // namespace g27
