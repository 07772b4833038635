#include "fsi/overset/remeshing.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

namespace {

constexpr double softening = 0.1;   ///< of the weights 1/(r^2 + softening), r in cells
constexpr double same_side = 0.7;   ///< least cosine between the normals of triangles between which slopes are taken
constexpr double least_det = 0.02;  ///< of the square of the moments' sum, for a slope

namespace gas = gas_field;
namespace solid = solid_field_of;

/// All that is known at a triangle, as numbers.
constexpr std::size_t core_numbers = gas::count + solid::count;
constexpr std::size_t velocity_at = core_layers * core_numbers, numbers = velocity_at + 3 + 1 + 6;
using Numbers = std::array<double, numbers>;

Numbers numbers_of(TriangleState const& t) noexcept {
  Numbers q{};
  double* to = q.data();
  for (std::size_t k = 0; k < core_layers; ++k) {
    to = std::copy(t.gas[k].begin(), t.gas[k].end(), to);
    to = std::copy(t.solid[k].begin(), t.solid[k].end(), to);
  }
  to = std::copy(t.velocity.begin(), t.velocity.end(), to);
  *to++ = t.pressure;
  for (Vec3 const& g : t.gradient) to = std::copy(g.begin(), g.end(), to);
  return q;
}

void set_numbers(TriangleState& t, Numbers const& q) noexcept {
  double const* from = q.data();
  auto const take = [&](auto& to) { std::copy(from, from + to.size(), to.begin()), from += to.size(); };
  for (std::size_t k = 0; k < core_layers; ++k) take(t.gas[k]), take(t.solid[k]);
  take(t.velocity);
  t.pressure = *from++;
  for (Vec3& g : t.gradient) take(g);
}

/// Whether a number is a velocity's component, or its slope.
bool is_velocity(std::size_t f) noexcept {
  if (f >= velocity_at) return f != velocity_at + 3;
  std::size_t const in_layer = f % core_numbers, c = in_layer < gas::count ? in_layer : in_layer - gas::count;
  return c >= 1 && c <= 3;
}

/// A triangle's numbers with their slopes along its two axes, and the range of those around it.
struct Known {
  Numbers q, a{}, b{}, low, high;
};

class OldSurface {
 public:
  explicit OldSurface(Body const& body)
      : body_(body), known_(body.triangles.size()), there_(body.triangles.size(), 0) {}

  Known const& at(int triangle) {
    std::size_t const t = static_cast<std::size_t>(triangle);
    if (there_[t] == 0) known_[t] = find(triangle), there_[t] = 1;
    return known_[t];
  }

 private:
  [[nodiscard]] Known find(int triangle) const {
    TriangleState const& t = body_.triangles[static_cast<std::size_t>(triangle)];
    std::vector<int> near;
    for (int v : body_.surface.triangles[static_cast<std::size_t>(triangle)]) {
      for (int n : body_.around[static_cast<std::size_t>(v)]) near.push_back(n);
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    Known k{};
    k.q = k.low = k.high = numbers_of(t);
    Numbers mx{}, my{};
    double xx = 0, xy = 0, yy = 0;
    for (int n : near) {
      TriangleState const& o = body_.triangles[static_cast<std::size_t>(n)];
      if (n == triangle || dot(o.frame.n, t.frame.n) < same_side) continue;
      Vec3 const r = (1 / body_.setup.cell) * (o.centre - t.centre);
      double const x = dot(r, t.frame.a), y = dot(r, t.frame.b), w = 1 / (dot(r, r) + softening);
      xx += w * x * x, xy += w * x * y, yy += w * y * y;
      Numbers const q = numbers_of(o);
      for (std::size_t f = 0; f < numbers; ++f) {
        double const d = w * (q[f] - k.q[f]);
        mx[f] += x * d, my[f] += y * d;
        k.low[f] = std::min(k.low[f], q[f]), k.high[f] = std::max(k.high[f], q[f]);
      }
    }
    double const det = xx * yy - xy * xy;
    if (det > least_det * (xx + yy) * (xx + yy)) {
      double const scale = 1 / (det * body_.setup.cell);
      for (std::size_t f = 0; f < numbers; ++f) {
        k.a[f] = scale * (yy * mx[f] - xy * my[f]), k.b[f] = scale * (xx * my[f] - xy * mx[f]);
      }
    }
    return k;
  }

  Body const& body_;
  std::vector<Known> known_;
  std::vector<char> there_;
};

bool same_place(TriangleSurface const& a, std::size_t s, TriangleSurface const& b, std::size_t t) noexcept {
  return a.corners(s) == b.corners(t);
}

}  // namespace

LocalRemeshCounts remesh(Body& body, Remeshing const& options) {
  double const h = body.setup.cell;
  LocalRemeshOptions const limits{.shortest = options.shortest * h, .longest = options.longest * h};
  if (!options.on || !needs_remeshing(body.surface, limits)) return {};
  LocalRemesh changed = local_remesh(body.surface, limits);
  if (changed.counts.refused > 0) return changed.counts;
  OldSurface old(body);
  std::vector<TriangleState> triangles(changed.surface.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::vector<int> const& parents = changed.parents[t];
    std::size_t const first = static_cast<std::size_t>(parents[0]);
    triangles[t] = body.triangles[first];
    if (parents.size() == 1 && same_place(changed.surface, t, body.surface, first)) continue;
    Vec3 const x = changed.surface.centre(t);
    Numbers sum{}, low = old.at(parents[0]).low, high = old.at(parents[0]).high;
    for (int p : parents) {
      Known const& k = old.at(p);
      TriangleState const& from = body.triangles[static_cast<std::size_t>(p)];
      Vec3 const r = x - from.centre;
      double const a = dot(r, from.frame.a), b = dot(r, from.frame.b), w = 1.0 / static_cast<double>(parents.size());
      for (std::size_t f = 0; f < numbers; ++f) {
        sum[f] += w * (k.q[f] + a * k.a[f] + b * k.b[f]);
        low[f] = std::min(low[f], k.low[f]), high[f] = std::max(high[f], k.high[f]);
      }
    }
    for (std::size_t f = 0; f < numbers; ++f) {
      double const more = is_velocity(f) ? high[f] - low[f] : 0.0;
      sum[f] = std::clamp(sum[f], low[f] - more, high[f] + more);
    }
    set_numbers(triangles[t], sum);
  }
  body.surface = std::move(changed.surface), body.triangles = std::move(triangles);
  body.cut = find_cut(body.surface, body.cut.mirrors, 1e-3 * h);
  body.connect(), body.place_triangles();
  return changed.counts;
}

}  // namespace g27
