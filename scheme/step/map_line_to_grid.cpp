#include "scheme/step/map_line_to_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace g27 {
namespace {

constexpr double same = 1e-10;  ///< relative difference up to which gas counts as undisturbed

/// Sum that loses nothing to round-off over many cells (Neumaier).
struct Sum {
  double sum = 0, lost = 0;
  void add(double v) noexcept {
    double const t = sum + v;
    lost += std::fabs(sum) >= std::fabs(v) ? (sum - t) + v : (v - t) + sum;
    sum = t;
  }
  [[nodiscard]] double value() const noexcept { return sum + lost; }
};

double minmod(double a, double b) {
  if (a * b <= 0) return 0;
  return std::fabs(a) < std::fabs(b) ? a : b;
}

GasConserved<> operator-(GasConserved<> const& a, GasConserved<> const& b) {
  return {a.mass - b.mass, a.momentum - b.momentum, a.energy - b.energy};
}

/// Radius of the centroid of a shell: int r r^alpha dr / int r^alpha dr.
double centroid(Symmetry symmetry, double a, double b) {
  double const planar = 0.5 * (a + b);
  if (symmetry == Symmetry::cylindrical) return 2.0 / 3.0 * (a * a + a * b + b * b) / (a + b);
  if (symmetry == Symmetry::spherical) return 0.75 * (a + b) * (a * a + b * b) / (a * a + a * b + b * b);
  return planar;
}

double length_scale(GridBox const& box, std::size_t axis) { return box.upper[axis] - box.lower[axis]; }

/// -1: the centre is on the low side; 1: on the high one; 0: between.
int side_of(GridBox const& box, Vec3 const& centre, std::size_t axis) {
  double const slack = 1e-9 * length_scale(box, axis);
  if (std::fabs(centre[axis] - box.lower[axis]) <= slack) return -1;
  return std::fabs(centre[axis] - box.upper[axis]) <= slack ? 1 : 0;
}

/// Density and pressure margin are positive.
bool admissible(AnyEos const& eos, GasConserved<> const& q) {
  if (!(q.mass > 0)) return false;
  double const e = (q.energy - 0.5 * q.momentum * q.momentum / q.mass) / q.mass;
  return std::visit([&](auto const& law) { return law.pressure_margin(q.mass, law.pressure(q.mass, e)) > 0; }, eos);
}

int dimensions_of(GridBox const& box) { return box.cells[2] > 1 ? 3 : 2; }

}  // namespace

double disturbed_radius(GasLine const& line) {
  std::size_t const last = line.cells() - 1;
  GasConserved<> const outer = line.average(last);
  double const speed = std::sqrt(line.bulk_modulus()[last] / outer.mass);
  for (std::size_t i = last; i-- > 0;) {
    GasConserved<> const d = line.average(i) - outer;
    if (std::fabs(d.mass) > same * outer.mass || std::fabs(d.momentum) > same * outer.mass * speed ||
        std::fabs(d.energy) > same * std::fabs(outer.energy)) {
      return line.faces()[i + 1];
    }
  }
  return 0;
}

double open_angle(GridBox const& box, Vec3 const& centre) {
  int const dimensions = dimensions_of(box);
  double angle = (dimensions == 3 ? 4.0 : 2.0) * std::numbers::pi;
  for (int d = 0; d < dimensions; ++d) {
    if (side_of(box, centre, static_cast<std::size_t>(d)) != 0) angle *= 0.5;
  }
  return angle;
}

LineToGrid::LineToGrid(GasLine const& line, Vec3 const& centre, GridBox const& box, int samples)
    : box_(box),
      centre_(centre),
      widths_{1, 1, 1},
      dimensions_(dimensions_of(box)),
      samples_(samples),
      faces_(line.faces().begin(), line.faces().end()),
      radius_(disturbed_radius(line)) {
  Symmetry const symmetry = line.setup().symmetry;
  if (symmetry != (dimensions_ == 3 ? Symmetry::spherical : Symmetry::cylindrical) || faces_.front() != 0) {
    throw std::invalid_argument("a spherical line from its centre fills three dimensions, a cylindrical one two");
  }
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_); ++d) {
    widths_[d] = length_scale(box, d) / box.cells[d];
    int const side = side_of(box, centre, d);
    double const room_low = side < 0 ? 1e300 : centre[d] - box.lower[d];
    double const room_high = side > 0 ? 1e300 : box.upper[d] - centre[d];
    if (std::min(room_low, room_high) < radius_) {
      throw std::invalid_argument("the wave on the line has passed a side of the grid");
    }
  }

  GasConserved<> const outer = line.average(line.cells() - 1);
  outside_ = {outer.mass, {0, 0, 0}, outer.energy};
  auto const count =
      static_cast<std::size_t>(std::upper_bound(faces_.begin(), faces_.end(), radius_ * (1 - 1e-14)) - faces_.begin());
  shells_.resize(radius_ > 0 ? count : 0);
  for (std::size_t i = 0; i < shells_.size(); ++i) {
    shells_[i].centroid = centroid(symmetry, faces_[i], faces_[i + 1]);
    shells_[i].mean = line.average(i) - GasConserved<>{outer.mass, 0.0, outer.energy};
  }
  GasConserved<> radial{0, 0, 0};  // integrals per radian or steradian
  for (std::size_t i = 0; i < shells_.size(); ++i) {
    Shell& s = shells_[i];
    double const m = line.measure(i);
    radial = {radial.mass + m * s.mean.mass, radial.momentum + m * s.mean.momentum, radial.energy + m * s.mean.energy};
    // Seen across the centre, scalars are even and the radial momentum is odd.
    Shell before = i > 0 ? shells_[i - 1] : Shell{.centroid = -s.centroid, .mean = s.mean, .slope = {}};
    if (i == 0) before.mean.momentum = -s.mean.momentum;
    Shell after{.centroid = centroid(symmetry, faces_[i + 1], faces_[std::min(i + 2, faces_.size() - 1)])};
    if (i + 1 < shells_.size()) after = shells_[i + 1];
    auto const slope = [&](double GasConserved<>::*q) {
      return minmod((s.mean.*q - before.mean.*q) / (s.centroid - before.centroid),
                    after.centroid > s.centroid ? (after.mean.*q - s.mean.*q) / (after.centroid - s.centroid) : 0.0);
    };
    s.slope = {slope(&GasConserved<>::mass), slope(&GasConserved<>::momentum), slope(&GasConserved<>::energy)};
    // Each within its neighbours' range, the three together may still make no state of the gas: then a constant does.
    for (double const r : {faces_[i], faces_[i + 1]}) {
      double const dr = r - s.centroid;
      GasConserved<> const end{outer.mass + s.mean.mass + s.slope.mass * dr, s.mean.momentum + s.slope.momentum * dr,
                               outer.energy + s.mean.energy + s.slope.energy * dr};
      if (!admissible(line.setup().eos, end)) s.slope = {0, 0, 0};
    }
  }

  // Exact integrals over the open angle: of a scalar, of the components of a radial vector.
  double const angle = open_angle(box, centre);
  GasDensities exact{angle * radial.mass, {0, 0, 0}, angle * radial.energy};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_); ++d) {
    // half of the directions have a mean cosine of 1/2 (sphere) or 2/pi (circle) to the axis; all of them have none
    double const cosine = dimensions_ == 3 ? 0.5 : 2.0 / std::numbers::pi;
    exact.momentum[d] = -side_of(box, centre, d) * cosine * angle * radial.momentum;
  }
  double const cell_volume = widths_[0] * widths_[1] * widths_[2];
  double box_volume = cell_volume * box.cells[0] * box.cells[1];
  if (dimensions_ == 3) box_volume *= box.cells[2];
  total_ = {outside_.mass * box_volume + exact.mass, exact.momentum, outside_.energy * box_volume + exact.energy};

  std::array<Sum, 5> sum{}, magnitude{};
  for (int k = 0; k < (dimensions_ == 3 ? box.cells[2] : 1); ++k) {
    for (int j = 0; j < box.cells[1]; ++j) {
      for (int i = 0; i < box.cells[0]; ++i) {
        bool untouched = false;
        GasDensities const q = difference({i, j, k}, untouched);
        if (untouched) continue;
        double const v[] = {q.mass, q.momentum[0], q.momentum[1], q.momentum[2], q.energy};
        for (std::size_t f = 0; f < 5; ++f)
          sum[f].add(v[f] * cell_volume), magnitude[f].add(std::fabs(v[f]) * cell_volume);
      }
    }
  }
  double const want[] = {exact.mass, exact.momentum[0], exact.momentum[1], exact.momentum[2], exact.energy};
  double gain[5];
  for (std::size_t f = 0; f < 5; ++f) {
    gain[f] = magnitude[f].value() > 0 ? (want[f] - sum[f].value()) / magnitude[f].value() : 0.0;
    missing_ = std::max(missing_, std::fabs(gain[f]));
  }
  share_ = {gain[0], {gain[1], gain[2], gain[3]}, gain[4]};
}

bool LineToGrid::beyond(Vec3 const& lower) const {
  double squared = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions_); ++d) {
    double const gap = std::max({0.0, lower[d] - centre_[d], centre_[d] - lower[d] - widths_[d]});
    squared += gap * gap;
  }
  return squared >= radius_ * radius_;
}

/// Mean over the points of a cell of what the gas holds beyond the gas outside.
GasDensities LineToGrid::sampled(Vec3 const& lower) const {
  GasDensities sum;
  int const planes = dimensions_ == 3 ? samples_ : 1;
  for (int k = 0; k < planes; ++k) {
    double const z = dimensions_ == 3 ? lower[2] + (k + 0.5) / samples_ * widths_[2] - centre_[2] : 0.0;
    for (int j = 0; j < samples_; ++j) {
      double const y = lower[1] + (j + 0.5) / samples_ * widths_[1] - centre_[1];
      for (int i = 0; i < samples_; ++i) {
        double const x = lower[0] + (i + 0.5) / samples_ * widths_[0] - centre_[0];
        double const r = std::sqrt(x * x + y * y + z * z);
        if (r >= radius_) continue;
        auto const face =
            std::upper_bound(faces_.begin(), faces_.begin() + static_cast<std::ptrdiff_t>(shells_.size()), r);
        Shell const& s = shells_[static_cast<std::size_t>(face - faces_.begin()) - 1];
        double const dr = r - s.centroid;
        sum.mass += s.mean.mass + s.slope.mass * dr;
        sum.energy += s.mean.energy + s.slope.energy * dr;
        double const over_r = r > 0 ? (s.mean.momentum + s.slope.momentum * dr) / r : 0.0;
        sum.momentum[0] += over_r * x, sum.momentum[1] += over_r * y, sum.momentum[2] += over_r * z;
      }
    }
  }
  double const share = 1.0 / (planes * samples_ * samples_);
  return {sum.mass * share,
          {sum.momentum[0] * share, sum.momentum[1] * share, sum.momentum[2] * share},
          sum.energy * share};
}

GasDensities LineToGrid::difference(Int3 const& cell, bool& outside) const {
  Vec3 lower{};
  for (std::size_t d = 0; d < 3; ++d) lower[d] = box_.lower[d] + cell[d] * widths_[d];
  outside = beyond(lower);
  return outside ? GasDensities{} : sampled(lower);
}

GasDensities LineToGrid::operator()(Int3 const& cell) const {
  bool untouched = false;
  GasDensities const q = difference(cell, untouched);
  if (untouched) return outside_;
  auto const corrected = [](double v, double gain) { return v + gain * std::fabs(v); };
  GasDensities out{
      outside_.mass + corrected(q.mass, share_.mass), {}, outside_.energy + corrected(q.energy, share_.energy)};
  for (std::size_t d = 0; d < 3; ++d) out.momentum[d] = corrected(q.momentum[d], share_.momentum[d]);
  return out;
}

}  // namespace g27
