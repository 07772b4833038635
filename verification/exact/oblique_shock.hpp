#pragma once
/// Attached oblique shock of an ideal gas on a wedge (Anderson, Modern Compressible Flow, 3rd ed., 4.3; NACA Report
/// 1135, eqs. 128-150).
///
/// With the shock angle b and the deflection d, both from the flow upstream, and Mn = M sin b:
///   tan d = 2 cot b (Mn^2 - 1)/(M^2 (gamma + cos 2b) + 2),
///   rho2/rho1 = (gamma + 1) Mn^2/((gamma - 1) Mn^2 + 2),   p2/p1 = 1 + 2 gamma (Mn^2 - 1)/(gamma + 1).
namespace g27 {

/// Ratios behind over ahead of a normal shock, and the Mach number behind in the frame of the shock.
struct NormalShock {
  double density_ratio, pressure_ratio, mach_behind;
};
NormalShock normal_shock(double gamma, double mach);

enum class ShockBranch { weak, strong };

struct ObliqueShock {
  double gamma, mach, deflection;        ///< upstream; deflection [rad]
  double angle;                          ///< of the shock, from the flow upstream [rad]
  double density_ratio, pressure_ratio;  ///< behind over ahead
  double mach_behind;
};

/// Throws NumericsError for mach <= 1, gamma <= 1, or a deflection that is not positive or that detaches the shock.
ObliqueShock oblique_shock(double gamma, double mach, double deflection, ShockBranch branch = ShockBranch::weak);

/// The deflection [rad] by a shock at `angle` [rad], asin(1/mach) <= angle <= pi/2.
double shock_deflection(double gamma, double mach, double angle);

/// The shock angle [rad] of the largest deflection: where weak and strong shocks meet (NACA 1135, eq. 168).
double detachment_angle(double gamma, double mach);

}  // namespace g27
