#include "studies/driver/scene.hpp"

#include <algorithm>

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

std::vector<std::string> remarks_on(Scene const& scene) {
  std::vector<std::string> out;
  auto const add = [&](std::string const& remark) {
    if (std::find(out.begin(), out.end(), remark) == out.end()) out.push_back(remark);
  };
  for (SceneRun const& run : scene.runs) {
    for (std::size_t n = 0; run.grid && n < run.grid->bodies.size(); ++n) {
      SceneBody const& body = run.grid->bodies[n];
      for (std::string const& remark : body.remarks) add(body.key + ": " + body.file + ": " + remark);
    }
    for (std::string const& remark : run.output.remarks) add(remark);
  }
  return out;
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
