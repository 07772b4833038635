#pragma once
/// Inner loops of interpolation between overset grids, one table per instruction set.
#include <array>
#include <cstddef>

namespace g27 {

inline constexpr double fit_softening = 0.1;   ///< of the weights 1/(r^2 + softening)
inline constexpr std::size_t fit_padding = 8;  ///< donors, and lists of them, that a kernel may read or write beyond

/// Donors from the first to before the last.
struct DonorRange {
  std::size_t first = 0, last = 0;
};

/// Which of the donors are within a radius of a cube: kept[0 .. ends[ranges - 1]), by ranges.
struct NearCubeArguments {
  std::size_t ranges = 0;
  DonorRange const* range = nullptr;
  double const *x = nullptr, *y = nullptr, *z = nullptr;  ///< places of the donors, in cells
  std::array<double, 3> middle{};
  std::array<std::array<double, 3>, 3> axes{};  ///< of the cube, of length 1
  double half = 0, limit = 0;                   ///< half its width; square of the radius
  int* kept = nullptr;                          ///< room for all, and padding
  std::size_t* ends = nullptr;                  ///< [range]: of those kept
};

/// A weighted linear or quadratic fit at a point, in passes between which the caller finds its coefficients.
struct FitArguments {
  std::size_t ranges = 0;
  DonorRange const* range = nullptr;
  double const *x = nullptr, *y = nullptr, *z = nullptr;  ///< places of the donors, in cells
  double const* const* q = nullptr;                       ///< [donor] -> its fields
  double const* energy = nullptr;                         ///< [donor], of those that weigh by mass
  std::array<double, 3> at{};                             ///< the point
  double limit = 0;                                       ///< square of the donors' radius
  // out of the first pass, with room for all donors and padding: numbers of those near, their weights and where they
  // are from the point; how many, sum of the weights, first and second moments about the point
  int* near = nullptr;
  double *weight = nullptr, *rx = nullptr, *ry = nullptr, *rz = nullptr;
  std::size_t count = 0;
  double sum = 0;
  std::array<double, 3> first{};
  std::array<double, 6> second{};  ///< xx yy zz xy xz yz
  // of a quadratic fit, by the same six products: their moments with x, y and z; then what is left of each beside its
  // own linear fit constant + linear.r [donor], and the moments of that with one another
  std::array<std::array<double, 3>, 6> third{};
  std::array<double, 6> constant{};
  std::array<std::array<double, 3>, 6> linear{};
  std::array<double*, 6> bend{};
  std::array<std::array<double, 6>, 6> fourth{};
  // into the last: shares are weight (level + slope.r), with + curvature.bend of a quadratic fit, over their sum
  double level = 0;
  std::array<double, 3> slope{};
  std::array<double, 6> curvature{};
  double *out = nullptr, *low = nullptr, *high = nullptr;  ///< [field], also the donors' range
  double mass = 0, mean_energy = 0;  ///< sums of the shares of field 0 and of it times the energy, where it weighs
};

/// out = sum of w q over eight rows, within their range: round-off would not let a uniform state stay uniform.
struct EightArguments {
  std::array<double const*, 8> q;
  std::array<double, 8> w;
  double* out;
};

struct FitKernels {
  void (*near_cube)(NearCubeArguments&);
  void (*moments)(FitArguments&);
  void (*third)(FitArguments&);
  void (*fourth)(FitArguments&);
  /// Of the gas's fields, which weigh by field 0, the density; of the solid's.
  std::array<void (*)(FitArguments&), 2> combine;
  void (*combine_quadratic)(FitArguments&);                    ///< of the solid's fields
  std::array<void (*)(EightArguments const&), 2> multilinear;  ///< of the gas's fields, of the solid's
};

/// Those of the instruction set that gas_kernels() chose.
FitKernels const& fit_kernels() noexcept;

}  // namespace g27
