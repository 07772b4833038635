#pragma once
/// A body: its surface, its Cartesian grid unless it is rigid, and at every triangle the local grid that moves with it.
#include <functional>
#include <memory>

#include "fsi/ale/model_problem.hpp"
#include "fsi/overset/body_spin.hpp"
#include "fsi/overset/donors.hpp"
#include "fsi/overset/rigid_body.hpp"
#include "scheme/step/gas_grid.hpp"
#include "scheme/step/solid_grid.hpp"

namespace g27 {

/// CFL number of the waves of bodies, at most (study stability-solid).
inline constexpr double largest_body_cfl = 1.4;
inline constexpr double largest_parabolic_body_cfl = 1.3;  ///< that of order 3

struct BodySetup {
  TriangleSurface surface;  ///< closed, or open where walls of the domain cut the body: clip_surface
  AnySolid material{};
  double cell = 1;                                 ///< width of the cells of its grid [m]
  Vec3 lower{0, 0, 0}, upper{1, 1, 1};             ///< box that the body stays in [m]
  std::function<SolidPoint(Vec3 const&)> initial;  ///< state at the start
  std::optional<RigidSetup> rigid{};               ///< instead of material and initial state
  Clamps clamps{};                                 ///< sides of the domain that hold it, among walls that cut it
};

/// Sides of the domain that are walls all over: they may cut bodies.
Mirrors walls_of(GasGridSetup const& gas);

/// The box that a body stays in ends at the planes that cut it.
BodySetup bounded(BodySetup setup, Mirrors const& cut);

/// The cells of its grid: the box and a margin; beyond planes that cut the body images. Of a rigid one some that
/// nothing uses.
WindowBox solid_window(BodySetup const& setup, Mirrors const& cut = {});

/// What is known at a triangle between steps.
struct TriangleState {
  Frame frame;
  Vec3 centre{0, 0, 0};  ///< [m]
  double area = 0;       ///< [m^2]
  std::array<GasFields, core_layers> gas{};
  std::array<SolidFields, core_layers> solid{};
  Vec3 velocity{0, 0, 0};          ///< of the contact [m/s]
  double pressure = 0;             ///< at the contact [Pa]
  Vec3 at_start{0, 0, 0};          ///< outward normal at the start
  std::array<Vec3, 2> gradient{};  ///< of the solid's velocity along the frame's a and b [1/s]
};

/// Centre of a core cell of a triangle's local grid; `width` of its cells along the normal: > 0 in the gas, < 0 in the
/// solid [m].
inline Vec3 core_centre(TriangleState const& t, std::size_t layer, double width) noexcept {
  return t.centre + ((static_cast<double>(layer) + 0.5) * width) * t.frame.n;
}

/// One medium's cells around a body.
template <class Fields>
struct Region {
  CellKinds kinds;
  std::vector<Fields> states;  ///< by the window's index; of valid cells
  Donors<Fields> donors;

  Region(WindowBox const& box, bool inside, typename Donors<Fields>::Law const& law, Literal const& literal)
      : kinds(box, inside), states(kinds.count()), donors(kinds, states, law, literal) {}
  /// After states of cells have changed: those of their images, and the donors.
  void update(int threads) {
    for (ImageCell const& i : kinds.images())
      states[i.cell] = reflected(states[i.of], i.image, kinds.box().mirrors.clamps);
    donors.update(threads);
  }
  Region(Region const&) = delete;
  Region& operator=(Region const&) = delete;
};

struct Body {
  TriangleSurface surface;
  Cut cut;
  BodySetup setup;
  Literal literal;
  std::vector<std::vector<int>> around;  ///< [vertex]: triangles
  std::vector<TriangleState> triangles;
  SolidGrid grid;
  Region<SolidFields> solid;
  Region<GasFields> gas;
  SolidFields background{};        ///< of cells that are not of the body
  GasFields ambient{};             ///< of gas cells that are not of the gas
  std::optional<RigidBody> rigid;  ///< without states, cells and waves of a solid: its triangles are walls

  Body(BodySetup setup, GasGrid const& gas_grid, SolidSchemeOptions const& options, Literal const& literal = {});

  /// Triangles around the vertices, after the surface has been given other ones.
  void connect();
  /// Frames, centres and areas by the vertices.
  void place_triangles();
  /// What model problems are made from, of one thread in one step.
  struct Nearby {
    explicit Nearby(Body const& body) : gas(body.gas.donors), solid(body.solid.donors), spin(spin_of(body)) {}
    Donors<GasFields>::Around gas;
    Donors<SolidFields>::Around solid;
    Vec3 spin;  ///< of the body
  };
  /// Numbers of all triangles, such that those which follow each other are close and read the same cells and cores.
  [[nodiscard]] std::vector<std::size_t> neighbours_in_turn() const;
  /// Cells of the model problem of a triangle, from time-n data alone.
  [[nodiscard]] ModelStencil stencil(std::size_t triangle, Nearby& nearby) const;
  /// In-plane gradient of the solid's velocity of that stencil, for the vertices.
  [[nodiscard]] std::array<Vec3, 2> velocity_gradient(std::size_t triangle, ModelStencil const& s) const;
  /// Vertices by the velocities of the triangles around them, and by `growth` [m] along their normals.
  void move_vertices(double dt, double growth);
};

}  // namespace g27
