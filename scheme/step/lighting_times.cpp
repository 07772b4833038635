#include "scheme/step/lighting_times.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "scheme/grid/cell_place.hpp"
#include "scheme/step/programmed_burn.hpp"

namespace g27 {

namespace {

constexpr double unlit = std::numeric_limits<double>::infinity();
constexpr double slip = 0.02;                  ///< length of a ray on which an obstacle may be missed, in cells
constexpr double worth = 1e-4;                 ///< least gain for which a way is tried, in cells
constexpr int halvings = 10;                   ///< by which a way is pulled tight
constexpr double golden = 0.3819660112501051;  ///< (3 - sqrt(5))/2

double distance(Vec3 const& a, Vec3 const& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

Vec3 between(Vec3 const& a, Vec3 const& b, double part) {
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

/// Where rays start: a point of ignition, or a bend.
using Origin = IgnitionPoint;

class Marching {
 public:
  explicit Marching(LightingSetup const& setup)
      : s_(setup),
        origins_(setup.ignition),
        h_(cell_widths(s_.lower, s_.upper, s_.cells)),
        swept_(swept_axes(s_.cells)) {
    double width = 1e300;
    for (std::size_t a = 0; a < 3; ++a) {
      size_[a] = s_.last[a] - s_.first[a];
      if (swept_[a]) width = std::min(width, h_[a]);
    }
    slip_ = slip * width, worth_ = worth * width / s_.speed;
  }

  std::vector<double> times() {
    light_directly();
    start_at_shadows();
    while (!queue_.empty()) {
      auto const [time, cell] = queue_.top();
      queue_.pop();
      if (time == time_[cell_number(size_, cell)]) hand_on(cell);
    }
    return std::move(time_);
  }

 private:
  [[nodiscard]] Vec3 centre(Int3 const& cell) const {
    return cell_centre(s_.lower, h_, swept_, {s_.first[0] + cell[0], s_.first[1] + cell[1], s_.first[2] + cell[2]});
  }
  [[nodiscard]] double arrival(Origin const& from, Vec3 const& x) const {
    return from.time + distance(from.x, x) / s_.speed;
  }

  /// The point of a ray that is closest to an obstacle, or deepest in it, by golden sections: the distance is convex.
  struct Closest {
    double part = 0, distance = 0;
  };
  /// `enough`: no closer than tells whether the obstacle is on the ray.
  [[nodiscard]] Closest closest(Obstacle const& obstacle, Vec3 const& a, Vec3 const& b, bool enough) const {
    double const length = distance(a, b);
    double low = 0, high = 1, part = 0.5, least = obstacle(between(a, b, part));
    while (length * (high - low) > slip_) {
      if (enough && (least < 0 || least >= length * std::max(part - low, high - part))) break;
      bool const left = part - low > high - part;  // the longer side
      double const other = part + golden * (left ? low - part : high - part);
      double const there = obstacle(between(a, b, other));
      bool const closer = there < least;
      (closer == left ? high : low) = closer ? part : other;
      if (closer) part = other, least = there;
    }
    return {part, least};
  }
  [[nodiscard]] bool clear(Vec3 const& a, Vec3 const& b) const {
    return std::all_of(s_.obstacles.begin(), s_.obstacles.end(),
                       [&](Obstacle const& o) { return closest(o, a, b, true).distance >= 0; });
  }
  [[nodiscard]] bool covered(Vec3 const& x) const {
    return std::any_of(s_.obstacles.begin(), s_.obstacles.end(), [&](Obstacle const& o) { return o(x) < 0; });
  }

  void light_directly() {
    time_.assign(cells_in(size_), ProgrammedBurn::no_explosive);
    from_.assign(time_.size(), -1);
    for_each_cell(size_, [&](Int3 const& cell) {
      Vec3 const x = centre(cell);
      if (!s_.explosive(x) || covered(x)) return;
      std::size_t const c = cell_number(size_, cell);
      time_[c] = unlit;
      for (std::size_t o = 0; o < origins_.size(); ++o) {
        double const time = arrival(origins_[o], x);
        if (time < time_[c] && clear(origins_[o].x, x)) time_[c] = time, from_[c] = static_cast<int>(o);
      }
    });
  }

  void start_at_shadows() {
    for_each_cell(size_, [&](Int3 const& cell) {
      std::size_t const c = cell_number(size_, cell);
      if (from_[c] < 0) return;
      bool border = false;
      each_neighbour(cell, [&](Int3 const&, std::size_t n) { border = border || from_[n] != from_[c]; });
      if (border) queue_.push({time_[c], cell});
    });
  }

  /// Calls f(cell, number) with the explosive cells around one.
  template <class F>
  void each_neighbour(Int3 const& cell, F const& f) const {
    for_each_cell({3, 3, 3}, [&](Int3 const& step) {
      Int3 const to{cell[0] + step[0] - 1, cell[1] + step[1] - 1, cell[2] + step[2] - 1};
      bool inside = to != cell;
      for (std::size_t a = 0; a < 3; ++a) inside = inside && to[a] >= 0 && to[a] < size_[a];
      if (!inside) return;
      std::size_t const number = cell_number(size_, to);
      if (time_[number] != ProgrammedBurn::no_explosive) f(to, number);
    });
  }

  /// Where the way from `from` over x bends to `to`, pulled tight towards where the straight one is blocked.
  [[nodiscard]] Origin bend(Origin const& from, Vec3 const& x, Vec3 const& to) const {
    Closest deepest{0.5, 0};
    for (Obstacle const& o : s_.obstacles) {
      Closest const here = closest(o, from.x, to, false);
      if (here.distance < deepest.distance) deepest = here;
    }
    Vec3 at = x;
    for (Vec3 const& towards : {between(from.x, to, deepest.part), from.x, to}) {
      Vec3 const start = at;
      double part = 0, step = 1;
      for (int n = 0; n < halvings; ++n) {
        step *= 0.5;
        Vec3 const next = between(start, towards, part + step);
        if (clear(from.x, next) && clear(next, to)) part += step, at = next;
      }
    }
    return {at, arrival(from, at)};
  }

  /// Neighbours take the cell's origin, or a bend near the cell, where the front comes sooner from there.
  void hand_on(Int3 const& cell) {
    std::size_t const c = cell_number(size_, cell);
    int const own = from_[c];
    Origin const from = origins_[static_cast<std::size_t>(own)];
    Vec3 const x = centre(cell);
    std::vector<Origin> bends;           // the one that is tight for the first neighbour behind, and the cell's centre
    std::array<int, 2> numbers{-1, -1};  // of those taken
    each_neighbour(cell, [&](Int3 const& to, std::size_t n) {
      if (from_[n] == own) return;
      Vec3 const target = centre(to);
      auto const take = [&](double time, int origin) {
        time_[n] = time, from_[n] = origin;
        queue_.push({time, to});
      };
      double const direct = arrival(from, target);
      if (!(direct < time_[n] - worth_)) return;
      if (clear(from.x, target)) return take(direct, own);
      if (bends.empty()) bends = {bend(from, x, target), {x, time_[c]}};
      for (std::size_t b = 0; b < bends.size(); ++b) {
        double const time = arrival(bends[b], target);
        if (!(time < time_[n]) || !clear(bends[b].x, target)) continue;
        if (numbers[b] < 0) numbers[b] = static_cast<int>(origins_.size()), origins_.push_back(bends[b]);
        take(time, numbers[b]);
      }
    });
  }

  using Entry = std::pair<double, Int3>;

  LightingSetup const& s_;
  std::vector<Origin> origins_;
  Vec3 h_;
  std::array<bool, 3> swept_;
  Int3 size_{1, 1, 1};
  double slip_ = 0, worth_ = 0;  ///< [m], [s]
  std::vector<int> from_;        ///< origin of the ray that lights a cell, -1: none
  std::vector<double> time_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;  ///< the soonest first
};

}  // namespace

LightingTimes::LightingTimes(LightingSetup const& setup)
    : lower_(setup.lower),
      h_(cell_widths(setup.lower, setup.upper, setup.cells)),
      cells_(setup.cells),
      first_(setup.first),
      size_{setup.last[0] - first_[0], setup.last[1] - first_[1], setup.last[2] - first_[2]},
      times_(Marching(setup).times()) {}

double LightingTimes::operator()(Vec3 const& x) const {
  Int3 cell{0, 0, 0};
  for (std::size_t a = 0; a < 3; ++a) {
    if (cells_[a] == 1) continue;
    int at = static_cast<int>(std::floor((x[a] - lower_[a]) / h_[a]));
    if (at < 0) at = -1 - at;
    if (at >= cells_[a]) at = 2 * cells_[a] - 1 - at;
    cell[a] = at - first_[a];
    if (cell[a] < 0 || cell[a] >= size_[a]) return ProgrammedBurn::no_explosive;
  }
  return times_[cell_number(size_, cell)];
}

}  // namespace g27
