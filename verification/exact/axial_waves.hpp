#pragma once
/// Self-similar waves of uniaxial strain that run into a uniform elastoplastic solid: elastic and plastic shocks by the
/// Hugoniot relation, elastic and plastic fans by CVODE.
///
/// With x = ln(rho/rho_0), Q = -(3/2) Sxx grows by 2 mu dx while |Q| < Y and by 2 mu H/(3 mu + H) dx beyond, where
/// |Q| = Y = Y0 + H ep: on a path without turning, S and ep are functions of the density alone, across shocks too
/// (hypoelastic in the logarithmic strain; Udaykumar, Tran, Belk and Vanden, J. Comput. Phys. 186 (2003) 136). With
/// sigma = p - Sxx:
///   shock  [u]^2 = [sigma][-v],  [e] = (sigma_0 + sigma)[-v]/2,  m^2 = [sigma]/[-v],  v = 1/rho;
///   fan    d rho = d sigma/a^2,  du = d sigma/(rho a),  de = sigma d rho/rho^2,
///          rho a^2 = K - f Sxx + (4/3) mu (elastic) or (4/3) mu H/(3 mu + H) (plastic), K = rho c^2.
/// A shock beyond the elastic limit splits in two as long as its second part is the slower (Wilkins 1964).
#include <vector>

#include "verification/exact/solid.hpp"

namespace g27 {

enum class Direction { left = -1, right = 1 };

class AxialWaves {
 public:
  struct Wave {
    bool shock = false, plastic = false;
    double head = 0, tail = 0;  ///< speeds [m/s]; equal in a shock
    SolidPoint ahead, behind;
  };

  /// Waves that leave the compressive stress sigma = p - Sxx behind them. `ahead` may be stressed, with Syy = Szz and
  /// no shear. Throws NumericsError for a state beyond its yield surface or outside the law.
  AxialWaves(SolidMaterial const& material, SolidPoint const& ahead, double sigma, Direction direction);

  /// In the order in which they pass: the fastest first.
  [[nodiscard]] std::vector<Wave> const& waves() const { return waves_; }
  [[nodiscard]] SolidPoint const& behind() const { return behind_; }
  /// State on the ray x/t = xi.
  [[nodiscard]] SolidPoint at(double xi) const;
  /// Speeds where the state jumps or bends, in increasing order.
  [[nodiscard]] std::vector<double> speeds() const;
  /// As "elastic shock, plastic fan"; "none" without a jump.
  [[nodiscard]] std::string pattern() const;
  /// Largest gap of the jump conditions of mass, momentum and energy, and between sigma and p(rho, e) - Sxx along the
  /// fans; relative to rho a^2 and a.
  [[nodiscard]] double residual() const;
  /// Axial sound speed of the state ahead.
  [[nodiscard]] double sound_speed() const { return a0_; }

 private:
  /// In the frame in which the waves run to the right.
  struct State {
    double sigma, rho, u, e;
  };
  struct Strength {
    double Q, ep;
  };
  struct Piece {
    bool shock, plastic;
    double head, tail;
    State ahead, behind;
    std::vector<State> nodes;  ///< of a fan, equidistant in sigma
  };
  [[nodiscard]] Strength strength(double rho) const;
  [[nodiscard]] double stiffness(State const& s, bool plastic) const;  ///< rho a^2
  [[nodiscard]] State fan_slope(State const& s, bool plastic) const;   ///< by sigma
  [[nodiscard]] SolidPoint point(State const& s) const;
  [[nodiscard]] State shocked_at_density(State const& s, double rho) const;
  [[nodiscard]] State shocked(State const& s, double sigma) const;
  void add_shock(State const& ahead, State const& behind, bool plastic);
  void add_fan(State const& ahead, State const& behind, bool plastic);
  [[nodiscard]] State expanded(State const& s, double sigma, bool plastic, std::vector<State>* nodes) const;
  [[nodiscard]] State expanded_to_density(State const& s, double rho, bool plastic) const;
  [[nodiscard]] State in_fan(Piece const& fan, double ray) const;
  void compress(State const& start, double sigma);
  void expand(State const& start, double sigma);

  SolidMaterial material_;
  double sign_;
  double rho0_, Q0_, ep0_, Y0_;               ///< of the state ahead
  double compressed_limit_, expanded_limit_;  ///< strains ln(rho/rho0) of the elastic range
  double a0_ = 0;
  std::vector<Piece> pieces_;
  std::vector<Wave> waves_;
  SolidPoint behind_;
};

/// Waves in front of a piston of velocity `u` that moves off at t = 0, on the left of what runs to the right.
AxialWaves axial_piston(SolidMaterial const& material, SolidPoint const& ahead, double u, Direction direction);

/// A state of uniaxial strain: Sxx, Syy = Szz = -Sxx/2, and the energy of (rho, p).
SolidPoint axial_state(SolidMaterial const& material, double rho, double u, double p, double sxx = 0, double ep = 0);

}  // namespace g27
