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

}  // namespace g27
