#pragma once
/// The surface of a body is mended where it has been stretched or crushed; new triangles take over the states of those
/// whose place they have.
#include "fsi/overset/body.hpp"
#include "fsi/surface/local_remesh.hpp"

namespace g27 {

/// Limits in cells of the body's grid.
struct Remeshing {
  bool on = true;
  double shortest = 0.4, longest = 1.7;  ///< edges
};

/// Nothing if no edge and no triangle is beyond the limits. A new triangle's state is the mean over the old ones in
/// its place, each continued to its centre by the slopes along the surface and kept within the range of what is
/// around it; velocities may leave it by one range.
LocalRemeshCounts remesh(Body& body, Remeshing const& options);

}  // namespace g27
