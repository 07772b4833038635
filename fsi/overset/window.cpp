#include "fsi/overset/window.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fsi/surface/gap.hpp"
#include "scheme/grid/cell_place.hpp"

namespace g27 {

namespace {

/// Distance of a cell's centre from the surface, in cells, within which the cores have what it stands for: that of the
/// second layer's centre, 1.5, and a bit, so that round-off does not decide where a surface lies along the grid; of
/// solids all of that layer. With 1.6 a plate that has moved by a third of a cell gains .5 % of its impulse, with 2
/// less than .02 %; in gas the wider gap between cells and cores would smear a shock that stands in it.
constexpr double reach_of_cores_in_gas = 1.6, reach_of_cores_in_solids = 2;
constexpr int beside = 2;  ///< cells beyond the surfaces' box that cores reach
/// Cells along each axis from one that the scheme updates that count as resolved. With 1 a yielding cube of 8 cells in
/// a blast lacks 12 % of its momentum instead of 6 %, and a tetrahedron gains 1.4 % of spin in a quarter turn.
constexpr int around_deep = 2;

}  // namespace

bool crosses_line(std::array<Vec3, 3> const& t, double y, double z, double& x) noexcept {
  // The side of the point (y, z) of an edge, by the edge's ends in one order: both triangles at it compute the same.
  auto const side = [&](Vec3 const& p, Vec3 const& q) {
    bool const turned = p[1] > q[1] || (p[1] == q[1] && p[2] > q[2]);
    Vec3 const &a = turned ? q : p, &b = turned ? p : q;
    bool const left = (b[1] - a[1]) * (z - a[2]) - (b[2] - a[2]) * (y - a[1]) > 0;
    return turned ? !left : left;
  };
  bool const s = side(t[0], t[1]);
  if (side(t[1], t[2]) != s || side(t[2], t[0]) != s) return false;
  Vec3 const n = cross(t[1] - t[0], t[2] - t[0]);
  if (n[0] == 0) return false;
  x = t[0][0] - (n[1] * (y - t[0][1]) + n[2] * (z - t[0][2])) / n[0];
  return true;
}

bool touches_cube(std::array<Vec3, 3> const& triangle, Vec3 const& centre, double half) noexcept {
  Vec3 const a = triangle[0] - centre, b = triangle[1] - centre, c = triangle[2] - centre;
  auto const apart = [&](Vec3 const& axis, double radius) {
    double const p = dot(a, axis), q = dot(b, axis), r = dot(c, axis);
    return std::max({-std::max({p, q, r}), std::min({p, q, r})}) > radius;
  };
  for (std::size_t d = 0; d < 3; ++d) {
    if (std::max({-std::max({a[d], b[d], c[d]}), std::min({a[d], b[d], c[d]})}) > half) return false;
  }
  auto const reach = [&](Vec3 const& axis) {
    return half * (std::fabs(axis[0]) + std::fabs(axis[1]) + std::fabs(axis[2]));
  };
  std::array<Vec3, 3> const edges{b - a, c - b, a - c};
  Vec3 const n = cross(edges[0], edges[1]);
  if (std::fabs(dot(n, a)) > reach(n)) return false;
  for (Vec3 const& e : edges) {
    for (Vec3 const& axis : {Vec3{0, -e[2], e[1]}, Vec3{e[2], 0, -e[0]}, Vec3{-e[1], e[0], 0}}) {
      if (apart(axis, reach(axis))) return false;
    }
  }
  return true;
}

CellKinds::CellKinds(WindowBox const& box, bool inside) : box_(box), inside_(inside) {
  std::size_t const n = cells_in(box.size);
  kinds_.assign(n, CellKind::foreign), before_ = kinds_, fringe_.assign(n, 0);
  column_start_.resize(column(0, columns_in_cell * box.size[2]) + 1);
  is_image_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    Int3 of = cell(i);
    Image image{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a) {
      int const at = of[a] + box.first[a], last = box.grid[a] - 1;
      image[a] = at < 0 ? -1 : at > last ? 1 : 0;
      if (image[a] != 0) of[a] = (at < 0 ? -1 - at : 2 * last + 1 - at) - box.first[a];
    }
    if (image == Image{0, 0, 0}) continue;
    is_image_[i] = 1, images_.push_back({i, static_cast<std::size_t>(index(of)), image});
  }
}

Int3 CellKinds::cell(std::size_t i) const noexcept {
  std::size_t const nx = static_cast<std::size_t>(box_.size[0]), ny = static_cast<std::size_t>(box_.size[1]);
  return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / (nx * ny))};
}

Vec3 CellKinds::centre(Int3 const& cell) const noexcept {
  Vec3 x{};
  for (std::size_t a = 0; a < 3; ++a) x[a] = box_.lower[a] + (box_.first[a] + cell[a] + 0.5) * box_.h;
  return x;
}

Int3 CellKinds::cell_of(Vec3 const& x) const noexcept {
  Int3 cell{};
  for (std::size_t a = 0; a < 3; ++a) {
    cell[a] = interval((x[a] - box_.lower[a]) / box_.h, box_.first[a], box_.size[a]);
  }
  return cell;
}

void CellKinds::classify(std::span<TriangleSurface const* const> surfaces) {
  surfaces_.assign(surfaces.begin(), surfaces.end());
  std::swap(before_, kinds_);
  std::fill(kinds_.begin(), kinds_.end(), CellKind::foreign);
  sheets_.clear(), lids_.clear();
  near_first_ = box_.size, near_last_ = {-1, -1, -1};
  for (TriangleSurface const* s : surfaces_) {
    auto const [lower, upper] = bounding_box(*s);
    Int3 const first = cell_of(lower), last = cell_of(upper);
    for (std::size_t a = 0; a < 3; ++a) {
      near_first_[a] = std::max(0, std::min(near_first_[a], first[a] - beside));
      near_last_[a] = std::min(box_.size[a] - 1, std::max(near_last_[a], last[a] + beside));
    }
    double area = 0;  // of the lid that is missing, along its inward normal
    for (std::size_t t = 0; t < s->size(); ++t) area += s->area_vector(t)[0];
    lids_.push_back(area > 0 ? box_.mirrors.lower[0] : box_.mirrors.upper[0]);
  }
  mark_cut(), mark_sides();
  reflect_kinds();
  mark_depth(), leave_to_cores();
  reflect_kinds();
  if (inside_) mark_resolved();
}

CellBlock CellKinds::near(int more) const noexcept {
  CellBlock block{near_first_, near_last_};
  for (std::size_t a = 0; a < 3; ++a) {
    block.first[a] = std::max(0, block.first[a] - more);
    block.last[a] = std::min(box_.size[a] - 1, block.last[a] + more);
  }
  return block;
}

void CellKinds::reflect_kinds() {
  for (ImageCell const& i : images_) kinds_[i.cell] = kinds_[i.of], fringe_[i.cell] = fringe_[i.of];
}

void CellKinds::mark_cut() {
  double const half = 0.5 * box_.h;
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    TriangleSurface const& surface = *surfaces_[s];
    for (std::size_t t = 0; t < surface.size(); ++t) {
      auto const corners = surface.corners(t);
      Vec3 low = corners[0], high = corners[0];
      for (Vec3 const& c : corners) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], c[a]), high[a] = std::max(high[a], c[a]);
      }
      std::array<bool, 3> beside{};
      for (std::size_t a = 0; a < 3; ++a) {
        double const from = box_.lower[a] + box_.first[a] * box_.h, to = from + box_.size[a] * box_.h;
        beside[a] = high[a] < from || low[a] > to;
      }
      if (beside[1] || beside[2]) continue;
      // lines along x cross a body whether or not the window holds all of it
      sheets_.push_back({low[1], high[1], low[2], high[2], corners, static_cast<int>(s)});
      if (beside[0]) continue;
      Int3 const c0 = cell_of(low), c1 = cell_of(high);
      for (int k = c0[2]; k <= c1[2]; ++k) {
        for (int j = c0[1]; j <= c1[1]; ++j) {
          for (int i = c0[0]; i <= c1[0]; ++i) {
            CellKind& kind = kinds_[static_cast<std::size_t>(index({i, j, k}))];
            if (kind != CellKind::cut && touches_cube(corners, centre({i, j, k}), half)) kind = CellKind::cut;
          }
        }
      }
    }
  }
  std::fill(column_start_.begin(), column_start_.end(), 0);
  for (Sheet const& sheet : sheets_) for_each_column(sheet, [&](std::size_t c) { ++column_start_[c + 1]; });
  std::partial_sum(column_start_.begin(), column_start_.end(), column_start_.begin());
  std::vector<std::size_t> next = column_start_;
  over_.resize(column_start_.back());
  for (std::size_t n = 0; n < sheets_.size(); ++n)
    for_each_column(sheets_[n], [&](std::size_t c) { over_[next[c]++] = static_cast<int>(n); });
}

template <class F>
void CellKinds::for_each_crossing(double y, double z, F const& f) const {
  std::size_t const over = column(column_along(1, y), column_along(2, z));
  int surface = 0;
  bool open = false;
  auto const close = [&] {
    if (open) f(lids_[static_cast<std::size_t>(surface)]);
    open = false;
  };
  for (std::size_t n = column_start_[over]; n < column_start_[over + 1]; ++n) {
    Sheet const& sheet = sheets_[static_cast<std::size_t>(over_[n])];
    double where = 0;
    if (!sheet.over(y, z) || !crosses_line(sheet.corners, y, z, where)) continue;
    if (sheet.surface != surface) close();
    surface = sheet.surface, open = !open, f(where);
  }
  close();
}

void CellKinds::crossings(double y, double z, std::vector<double>& x) const {
  x.clear();
  for_each_crossing(y, z, [&](double where) { x.push_back(where); });
  std::sort(x.begin(), x.end());
}

void CellKinds::mark_sides() {
  std::vector<double> crossed;
  // what is inside is near; what is outside is everywhere
  Int3 const first = inside_ ? near_first_ : Int3{0, 0, 0};
  Int3 const last = inside_ ? near_last_ : Int3{box_.size[0] - 1, box_.size[1] - 1, box_.size[2] - 1};
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      Vec3 const c = centre({0, j, k});
      crossings(c[1], c[2], crossed);
      std::size_t passed = 0;
      for (int i = first[0]; i <= last[0]; ++i) {
        double const x = centre({i, j, k})[0];
        while (passed < crossed.size() && crossed[passed] < x) ++passed;
        CellKind& kind = kinds_[static_cast<std::size_t>(index({i, j, k}))];
        if (kind != CellKind::cut && (passed % 2 == 1) == inside_) kind = CellKind::deep;
      }
    }
  }
}

void CellKinds::mark_depth() {
  std::fill(fringe_.begin(), fringe_.end(), 0);
  auto const mark = [&](Int3 const& c) {
    std::size_t const i = static_cast<std::size_t>(index(c));
    if (valid(i)) return;
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          Int3 const o{c[0] + dx, c[1] + dy, c[2] + dz};
          if (!holds(o)) continue;
          CellKind& kind = kinds_[static_cast<std::size_t>(index(o))];
          if (kind < CellKind::shallow) continue;
          kind = CellKind::shallow, fringe_[i] = 1;
        }
      }
    }
  };
  for (int k = near_first_[2]; k <= near_last_[2]; ++k) {
    for (int j = near_first_[1]; j <= near_last_[1]; ++j) {
      for (int i = near_first_[0]; i <= near_last_[0]; ++i) mark({i, j, k});
    }
  }
}

/// Where a cell and a core stand for the same gas or solid, and both are stepped, they drift apart: nothing but the
/// cell between them and the contact couples them.
void CellKinds::leave_to_cores() {
  double const reach = (inside_ ? reach_of_cores_in_solids : reach_of_cores_in_gas) * box_.h;
  for (TriangleSurface const* s : surfaces_) {
    for (std::size_t t = 0; t < s->size(); ++t) {
      auto const corners = s->corners(t);
      Vec3 low = corners[0], high = corners[0];
      for (Vec3 const& c : corners) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], c[a]), high[a] = std::max(high[a], c[a]);
      }
      Vec3 const more{reach, reach, reach};
      Int3 const c0 = cell_of(low - more), c1 = cell_of(high + more);
      for (int k = c0[2]; k <= c1[2]; ++k) {
        for (int j = c0[1]; j <= c1[1]; ++j) {
          for (int i = c0[0]; i <= c1[0]; ++i) {
            CellKind& kind = kinds_[static_cast<std::size_t>(index({i, j, k}))];
            if (kind == CellKind::deep && distance(centre({i, j, k}), corners) < reach) kind = CellKind::shallow;
          }
        }
      }
    }
  }
}

void CellKinds::mark_resolved() {
  resolved_.assign(count(), 0);
  for_each_near(cells_around, [&](std::size_t i) {
    if (kinds_[i] != CellKind::deep) return;
    Int3 const c = cell(i);
    Int3 first{}, last{};
    for (std::size_t a = 0; a < 3; ++a)
      first[a] = std::max(0, c[a] - around_deep), last[a] = std::min(box_.size[a] - 1, c[a] + around_deep);
    for (int k = first[2]; k <= last[2]; ++k) {
      for (int j = first[1]; j <= last[1]; ++j)
        std::fill_n(resolved_.begin() + index({first[0], j, k}), last[0] - first[0] + 1, 1);
    }
  });
}

bool CellKinds::in_medium(Vec3 const& point) const noexcept {
  Vec3 const x = box_.mirrors.within(point);
  Int3 const c = cell_of(x);
  std::size_t const i = static_cast<std::size_t>(index(c));
  if (kinds_[i] != CellKind::cut) return valid(i);
  bool odd = false;
  for_each_crossing(x[1], x[2], [&](double where) { odd = odd != (where > x[0]); });
  return odd == inside_;
}

}  // namespace g27
