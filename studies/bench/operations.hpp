#pragma once
/// Floating-point operations of a cell update as they are executed, by count_operations/count_operations.py: AVX2
/// kernels, the waves of box_waves.hpp on 16^3 cells, the work on ghosts among them (up to 4 % less on 24^3, ideal
/// gas). A fused multiply-add is two; comparisons and selections are none. Lanes whose branch is not taken count where
/// others take it.
#include <stdexcept>
#include <string>

namespace g27 {

struct CountedOperations {
  char const *scheme, *law;
  double elastic, yielding = 0;  ///< a cell and step; of gas: the first
};

inline constexpr CountedOperations gas_counts[]{
    {"godunov", "ideal", 340}, {"modified", "ideal", 1249}, {"parabolic", "ideal", 2115}, {"muscl-hllc", "ideal", 799},
    {"godunov", "jwl", 1195},  {"modified", "jwl", 2112},   {"parabolic", "jwl", 3548},   {"muscl-hllc", "jwl", 2609}};
inline constexpr CountedOperations solid_counts[]{
    {"godunov", "linear", 1375, 3755},         {"modified", "linear", 3392, 6774},
    {"parabolic", "linear", 4334, 8195},       {"godunov", "mie-gruneisen", 1720, 3579},
    {"modified", "mie-gruneisen", 3727, 6748}, {"parabolic", "mie-gruneisen", 4675, 8207}};

template <class Counts>
CountedOperations const& counted(Counts const& counts, std::string const& scheme, std::string const& law) {
  for (CountedOperations const& c : counts) {
    if (scheme == c.scheme && law == c.law) return c;
  }
  throw std::logic_error("operations of " + scheme + ", " + law + " are not counted");
}

inline double gas_operations(std::string const& scheme, std::string const& law) {
  return counted(gas_counts, scheme, law).elastic;
}
inline double solid_operations(std::string const& scheme, std::string const& law, bool yields) {
  CountedOperations const& c = counted(solid_counts, scheme, law);
  return yields ? c.yielding : c.elastic;
}

}  // namespace g27
