#include "studies/driver/scene.hpp"

namespace g27 {

std::vector<std::string> const& predictor_names() {
  static std::vector<std::string> const names{"godunov", "linear", "parabolic", "muscl"};
  return names;
}
std::vector<std::string> const& switch_names() {
  static std::vector<std::string> const names{"off", "literal", "binary", "graded"};
  return names;
}
std::vector<std::string> const& riemann_names() {
  static std::vector<std::string> const names{"fast", "exact", "hllc"};
  return names;
}
std::vector<std::string> const& feet_names() {
  static std::vector<std::string> const names{"conservative", "corrected-3.10", "printed-3.10"};
  return names;
}
std::vector<std::string> const& symmetry_names() {
  static std::vector<std::string> const names{"planar", "cylindrical", "spherical"};
  return names;
}

std::vector<std::string> const& transverse_names() {
  static std::vector<std::string> const names{"own-cell", "averaged", "none"};
  return names;
}
std::vector<std::string> const& side_names() {
  static std::vector<std::string> const names{"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
  return names;
}
std::vector<std::string> const& ray_names() {
  static std::vector<std::string> const names{"x", "y", "z", "diagonal"};
  return names;
}

std::vector<std::string> const& face_names() {
  static std::vector<std::string> const names{"-x", "+x", "-y", "+y", "-z", "+z"};
  return names;
}

std::size_t SceneRun::cells() const {
  if (!grid) {
    return setup.faces.size() - 1;
  }
  std::size_t count = 1;
  for (int const n : grid->setup.cells) {
    count *= static_cast<std::size_t>(n);
  }
  return count;
}

void SceneRun::set_threads(int threads) {
  setup.options.threads = threads;
  if (grid) {
    grid->setup.options.threads = threads;
  }
}

}  // namespace g27
