#pragma once
/// Cells along a line that may move: widths, measures and face areas in planar, cylindrical and spherical symmetry.
#include <cstddef>
#include <new>
#include <vector>

#include "scheme/step/gas_options.hpp"

namespace g27 {

/// Allocates on cache lines: a SIMD vector that starts at element 0 then crosses none.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(CacheLineAllocator<U> const&) noexcept {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
  void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, line); }
  friend bool operator==(CacheLineAllocator, CacheLineAllocator) noexcept { return true; }
};

/// A vector of doubles that may be read and written a whole SIMD vector beyond both ends.
class Padded {
 public:
  static constexpr std::size_t front = 16, back = 32;
  Padded() = default;
  explicit Padded(std::size_t n, double value = 0.0) : data_(n + front + back, value) {}
  double* data() noexcept { return data_.data() + front; }
  double const* data() const noexcept { return data_.data() + front; }
  double& operator[](std::ptrdiff_t i) noexcept { return data_[static_cast<std::size_t>(i + offset)]; }
  double operator[](std::ptrdiff_t i) const noexcept { return data_[static_cast<std::size_t>(i + offset)]; }

 private:
  static constexpr std::ptrdiff_t offset = front;
  std::vector<double, CacheLineAllocator<double>> data_;
};

/// Measure between two positions: length, area per radian or volume per steradian; integral of x^alpha.
double measure_between(Symmetry symmetry, double x0, double x1) noexcept;
/// Mean position between two positions, weighted with the measure: where a linear profile has its mean.
double centroid_between(Symmetry symmetry, double x0, double x1) noexcept;
/// Area of the shell that a face sweeps between x0 and x1, over the distance: its mean area over the step, so that
/// the change of a cell's measure is exactly what its two faces sweep (geometric conservation).
double swept_area(Symmetry symmetry, double x0, double x1) noexcept;

/// Geometry of the cells at the start of a step and of the step itself; cell arrays carry two ghosts on each side.
class Line {
 public:
  Line(std::vector<double> faces, Symmetry symmetry, bool periodic, bool fixed);

  /// Start of a step: recomputes what depends on the face positions.
  void refresh();
  /// Face speeds of the step -> mean areas, new measures. False when a cell would lose more than half of its width.
  bool sweep(double dt);
  /// End of a step: the faces take their new positions.
  void advance(double dt);

  [[nodiscard]] std::size_t cells() const noexcept { return x.size() - 1; }
  [[nodiscard]] double center(std::ptrdiff_t cell) const noexcept { return center_[cell]; }
  /// Equal widths, no motion: kernels take the width as a constant.
  [[nodiscard]] bool uniform() const noexcept { return uniform_; }
  [[nodiscard]] double width() const noexcept { return h[0]; }

  std::vector<double> x, x_initial;  ///< faces [cells + 1]
  Symmetry symmetry;
  Padded h, inv_h, inv_pair, inv_triple;  ///< cells -2 .. cells + 1
  Padded w, area;                         ///< faces: speed, mean area over the step
  Padded measure, inv_measure_new;        ///< cells
  Padded foot_shift[2], foot_factor[2];   ///< faces: OG (3.10) for the cell on the left [0], on the right [1]

  /// Fills foot_shift and foot_factor; `printed` as in the paper, otherwise re-derived for cell averages.
  void set_cell_feet(bool printed);

 private:
  bool periodic_, uniform_ = false;
  Padded center_;
};

}  // namespace g27
