#pragma once
/// Storage of the model problems that are solved together: a row of one cell holds that cell of every problem.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fsi/ale/model_problem.hpp"

namespace g27 {

inline constexpr std::size_t model_lanes = ModelProblems::lanes;
inline constexpr std::ptrdiff_t lane_stride = static_cast<std::ptrdiff_t>(model_lanes);

/// Rows of `fields` fields.
template <std::size_t fields>
struct alignas(64) LaneRows {
  double q[fields][model_lanes] = {};
  double* operator[](std::size_t field) noexcept { return q[field]; }
  double const* operator[](std::size_t field) const noexcept { return q[field]; }
};

/// A block of 3x3x3 cells, with a layer around it that kernels may read.
template <std::size_t fields>
struct alignas(64) LaneBlock {
  static constexpr std::ptrdiff_t side = 5, volume = side * side * side * lane_stride;
  static constexpr std::array<std::ptrdiff_t, 3> stride{side * side * lane_stride, side* lane_stride, lane_stride};
  double q[fields][static_cast<std::size_t>(volume)];

  explicit LaneBlock(double value = 1) {
    for (auto& field : q) {
      for (double& x : field) x = value;
    }
  }
  static constexpr std::ptrdiff_t index(int i, int j, int k) noexcept {
    return (i + 1) * stride[0] + (j + 1) * stride[1] + (k + 1) * stride[2];
  }
  double* at(std::size_t field, int i, int j, int k) noexcept { return q[field] + index(i, j, k); }
  double const* at(std::size_t field, int i, int j, int k) const noexcept { return q[field] + index(i, j, k); }
};

/// The four cells z, a | b, y around a face.
template <std::size_t fields>
struct alignas(64) LaneStencil {
  double q[fields][4][model_lanes];
};

/// Differences of a field across a face and across the interval beside it on the side where one more cell is known;
/// both from the far cell towards the face and beyond.
struct KnownDifferences {
  double far, face;
};
template <std::size_t fields>
KnownDifferences differences(LaneBlock<fields> const& block, std::size_t field, int axis, std::array<int, 3> cell,
                             bool far_left, std::size_t lane) noexcept {
  std::ptrdiff_t const s = LaneBlock<fields>::stride[static_cast<std::size_t>(axis)];
  double const* const q = block.at(field, cell[0], cell[1], cell[2]) + lane;
  if (far_left) return {q[0] - q[-s], q[s] - q[0]};
  return {q[s] - q[2 * s], q[0] - q[s]};
}

/// That of the two cells beside a face, the left one given, beyond which one more is known: mirror images have each
/// other's.
inline std::array<int, 3> known_side(int axis, std::array<int, 3> cell, bool far_left) noexcept {
  if (!far_left) ++cell[static_cast<std::size_t>(axis)];
  return cell;
}

/// How far a switch acts on differences that bend: not at all up to half of `quiet`, in full from it on.
inline double loudness(double far, double face, double quiet) noexcept {
  return std::clamp(2 * std::fabs(face - far) / quiet - 1, 0.0, 1.0);
}

/// How far the switch may be left out where one far cell is not known: 1 where the difference across the face is -3/2
/// or 1/3 of the far one or more, or their bend is quiet; 0 where it is loud, from -1/2 to 1/6. By degrees, so that
/// round-off does not choose: that happens at -1, the tip that a core is where cells beside it are interpolated across
/// a shock. A struck plate of 10 cells is .24 and -.17 % off so, and -.35 and -.76 % without.
inline double plainness(double far, double face, double quiet) noexcept {
  double const loud = loudness(far, face, quiet);
  if (loud == 0) return 1;
  double const part = face / far, turning = std::min(part + 1.5, 2 - 6 * part);
  return turning > 0 ? 1 - std::min(turning, loud) : 1;
}

/// Cells of the stencil of a face from the block, the left one at (i, j, k). Beyond the block a difference is taken
/// for that on the other side, so that the monotonicity switch sees what is known.
/// `free`: how far the switch is to see nothing on the face of each lane, 0 to 1.
template <std::size_t fields>
void gather(LaneBlock<fields> const& block, int axis, std::array<int, 3> cell, bool far_left, bool far_right,
            double const* free, LaneStencil<fields>& to) noexcept {
  std::ptrdiff_t const at = LaneBlock<fields>::index(cell[0], cell[1], cell[2]);
  std::ptrdiff_t const s = LaneBlock<fields>::stride[static_cast<std::size_t>(axis)];
  for (std::size_t f = 0; f < fields; ++f) {
    double const* const q = block.q[f] + at;
    for (std::size_t i = 0; i < model_lanes; ++i) {
      std::ptrdiff_t const n = static_cast<std::ptrdiff_t>(i);
      double const a = q[n], b = q[n + s];
      double const z = far_left ? q[n - s] : a - (q[n + 2 * s] - b);
      double const y = far_right ? q[n + 2 * s] : b + (a - q[n - s]);
      to.q[f][0][i] = z + free[i] * (a - (b - a) - z), to.q[f][1][i] = a;
      to.q[f][2][i] = b, to.q[f][3][i] = y + free[i] * (b + (b - a) - y);
    }
  }
}

}  // namespace g27
