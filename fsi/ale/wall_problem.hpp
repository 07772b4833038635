#pragma once
/// The model problem of a triangle of a rigid body: 3x3x3 cells of gas against a wall whose motion is given.
#include <memory>
#include <span>

#include "fsi/ale/model_problem.hpp"

namespace g27 {

class WallProblems {
 public:
  static constexpr std::size_t lanes = ModelProblems::lanes;

  /// Width of the cells [m].
  WallProblems(AnyEos const& gas, double width, ModelOptions options);
  ~WallProblems();
  WallProblems(WallProblems&&) noexcept;

  /// A step of dt [s] of at most `lanes` problems. Of a stencil the gas counts and the velocity before the step, of a
  /// result all but the solid.
  /// in  wall: velocity of the wall over the step, along the frame's axes [m/s]
  void solve(std::span<ModelStencil const> stencils, std::span<Vec3 const> wall, double dt,
             std::span<ModelResult> results);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace g27
