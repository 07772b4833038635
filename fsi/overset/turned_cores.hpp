#pragma once
/// Cores go where their triangles' normals turn.
///
/// The local grid that a step computes moves with the contact and does not turn; its triangle does. A core then lies
/// beside the place that its state is of, by (k + 1/2) h times the change of the normal, and takes the state there by
/// the slopes of its layer. Without it the second layer of a cube of 8 cells an edge is drawn inward by .37 of the
/// centripetal acceleration.
#include "fsi/overset/body.hpp"

namespace g27 {

/// In-plane slopes of the cores' states, per cell, each the lesser of those on both sides, or none where they differ in
/// sign.
struct CoreSlopes {
  template <class Fields>
  using Slopes = std::array<std::array<Fields, 2>, core_layers>;  ///< [layer][a, b]
  Slopes<GasFields> gas;
  Slopes<SolidFields> solid;
};

CoreSlopes core_slopes(Frame const& frame, ModelStencil const& s) noexcept;

struct TrianglePlace {
  Frame frame;
  Vec3 centre;
};
std::vector<TrianglePlace> places_of(Body const& body);

/// After the triangles have been placed anew. `from`: where they were at the start of the step.
void turn_cores(Body& body, std::vector<TrianglePlace> const& from, std::vector<CoreSlopes> const& slopes, double dt);

}  // namespace g27
