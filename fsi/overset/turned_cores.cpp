#include "fsi/overset/turned_cores.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

namespace {

/// Of a cell, along each axis: a core stays between its neighbours. Normals turn by less than .01 in a step of a body
/// that spins at a twentieth of its sound speed.
constexpr double farthest = 0.5;

double lesser(double left, double right) noexcept {
  if (!(left * right > 0)) return 0;
  return std::fabs(left) < std::fabs(right) ? left : right;
}

template <class Fields>
std::array<Fields, 2> slopes_of(Frame const& frame, std::array<std::array<Fields, 3>, 3> const& q) noexcept {
  std::array<Fields, 2> slope{};
  for (std::size_t f = 0; f < q[1][1].size(); ++f) {
    slope[0][f] = lesser(q[1][1][f] - q[0][1][f], q[2][1][f] - q[1][1][f]);
    slope[1][f] = lesser(q[1][1][f] - q[1][0][f], q[1][2][f] - q[1][1][f]);
  }
  return {out_of_frame(frame, slope[0]), out_of_frame(frame, slope[1])};
}

}  // namespace

CoreSlopes core_slopes(Frame const& frame, ModelStencil const& s) noexcept {
  CoreSlopes out{};
  for (std::size_t k = 0; k < core_layers; ++k) {
    out.gas[k] = slopes_of(frame, s.gas[k]), out.solid[k] = slopes_of(frame, s.solid_smooth[k]);
  }
  return out;
}

std::vector<TrianglePlace> places_of(Body const& body) {
  std::vector<TrianglePlace> out;
  out.reserve(body.triangles.size());
  for (TriangleState const& t : body.triangles) out.push_back({t.frame, t.centre});
  return out;
}

void turn_cores(Body& body, std::vector<TrianglePlace> const& from, std::vector<CoreSlopes> const& slopes, double dt) {
  double const h_gas = body.gas.kinds.box().h, h = body.setup.cell;
  for (std::size_t n = 0; n < body.triangles.size(); ++n) {
    TriangleState& t = body.triangles[n];
    Frame const& frame = from[n].frame;
    Vec3 const beyond_contact = t.centre - from[n].centre - dt * t.velocity;
    auto const shift = [&](auto& q, auto const& slope, std::size_t k, double width) {
      double const depth = (static_cast<double>(k) + 0.5) * width;
      Vec3 const way = (1 / std::fabs(width)) * (beyond_contact + depth * (t.frame.n - frame.n));
      double const a = std::clamp(dot(way, frame.a), -farthest, farthest);
      double const b = std::clamp(dot(way, frame.b), -farthest, farthest);
      for (std::size_t f = 0; f < q.size(); ++f) q[f] += a * slope[0][f] + b * slope[1][f];
    };
    for (std::size_t k = 0; k < core_layers; ++k) {
      shift(t.gas[k], slopes[n].gas[k], k, h_gas);
      if (!body.rigid) shift(t.solid[k], slopes[n].solid[k], k, -h);
    }
  }
}

}  // namespace g27
