/// The cells of a triangle's model problem: its own cores, interpolated neighbours, and what stands for the body's
/// sides where a lateral cell lies outside of it.
#include <cmath>

#include "fsi/overset/body.hpp"

namespace g27 {

namespace {

namespace field = solid_field_of;

/// In-plane differences of a layer, per cell.
struct LayerSlope {
  bool known = false;
  SolidFields a{}, b{};
};

SolidFields plus(SolidFields q, double s, SolidFields const& d) noexcept {
  for (std::size_t f = 0; f < q.size(); ++f) q[f] += s * d[f];
  return q;
}

/// By least squares over the valid lateral cells.
LayerSlope slope_of(std::array<std::array<SolidFields, 3>, 3> const& q,
                    std::array<std::array<bool, 3>, 3> const& there) {
  double xx = 0, xy = 0, yy = 0;
  SolidFields mx{}, my{};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      if ((a == 1 && b == 1) || !there[a][b]) continue;
      double const x = static_cast<double>(a) - 1, y = static_cast<double>(b) - 1;
      xx += x * x, xy += x * y, yy += y * y;
      for (std::size_t f = 0; f < mx.size(); ++f) {
        double const d = q[a][b][f] - q[1][1][f];
        mx[f] += x * d, my[f] += y * d;
      }
    }
  }
  double const det = xx * yy - xy * xy;
  LayerSlope s{.known = there[1][1] && det > 0.0125 * (xx + yy) * (xx + yy) && det > 0.5, .a = {}, .b = {}};
  if (!s.known) return s;
  for (std::size_t f = 0; f < mx.size(); ++f) {
    s.a[f] = (yy * mx[f] - xy * my[f]) / det, s.b[f] = (xx * my[f] - xy * mx[f]) / det;
  }
  return s;
}

/// The stress of a ghost beyond a side with outward normal m on which the pressure acts: the mean of both cells' has
/// the traction -pressure m. s + 2 (D m^T + m D^T - (D.m) m m^T), D = -pressure m - s m.
void set_traction(SolidFields& q, Vec3 const& m, double pressure) noexcept {
  double const p = q[field::p];
  auto const stress = [&](std::size_t i, std::size_t j) {
    return q[field::S + tensor_place[i][j]] - (i == j ? p : 0.0);
  };
  Vec3 D{};
  for (std::size_t i = 0; i < 3; ++i) {
    D[i] = -pressure * m[i];
    for (std::size_t j = 0; j < 3; ++j) D[i] -= stress(i, j) * m[j];
  }
  double const along = dot(D, m);
  std::array<double, 6> changed{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      changed[tensor_place[i][j]] =
          q[field::S + tensor_place[i][j]] + 2 * (D[i] * m[j] + m[i] * D[j] - along * m[i] * m[j]);
    }
  }
  for (std::size_t c = 0; c < 6; ++c) q[field::S + c] = changed[c];
}

}  // namespace

ModelStencil Body::stencil(std::size_t triangle, Nearby& nearby) const {
  TriangleState const& t = triangles[triangle];
  Frame const& f = t.frame;
  double const h_gas = gas.kinds.box().h, h = setup.cell;
  ModelStencil s{};
  s.velocity = f.into(t.velocity);
  ModelStencil::Cells<bool> there{};
  nearby.gas.reset(t.centre + (1.5 * h_gas) * f.n, f);
  nearby.solid.reset(t.centre - (1.5 * h) * f.n, f);
  auto const place = [&](double depth, double width, std::size_t a, std::size_t b) {
    return t.centre + depth * f.n + ((static_cast<double>(a) - 1) * width) * f.a +
           ((static_cast<double>(b) - 1) * width) * f.b;
  };

  auto const is_core = [](std::size_t k, std::size_t a, std::size_t b) { return a == 1 && b == 1 && k < core_layers; };
  auto const in_layer = [&](std::size_t k, double width, std::size_t a, std::size_t b) {
    return place((static_cast<double>(k) + 0.5) * width, std::fabs(width), a, b);
  };
  auto const for_each_cell = [](auto const& visit) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) visit(k, a, b);
      }
    }
  };
  bool whole = true;  // no side of the body within the local grid
  for_each_cell([&](std::size_t k, std::size_t a, std::size_t b) {
    there[k][a][b] = (is_core(k, a, b) && k == 0) || solid.kinds.in_medium(in_layer(k, -h, a, b));
    whole = whole && there[k][a][b];
  });
  // a rim that yields and is drawn out is thin as a plate is, but flaps; what is crushed changes from cell to cell
  bool const inner = whole && (!setup.material.plastic() ||
                               (t.solid[0][field::ep] <= crushed && solid.kinds.resolved(core_centre(t, 0, -h))));
  for_each_cell([&](std::size_t k, std::size_t a, std::size_t b) {
    bool const core = is_core(k, a, b), unread = k == 2 && a != 1 && b != 1;
    Vec3 const x = in_layer(k, h_gas, a, b);
    if (core && !(literal.reinterpolated_cores && gas.kinds.in_medium(x))) {
      s.gas[k][a][b] = into_frame(f, t.gas[k]);
    } else if (unread) {
      s.gas[k][a][b] = s.gas[1][1][1];
    } else if (gas.kinds.in_medium(x)) {
      s.gas[k][a][b] = into_frame(f, nearby.gas.at(x, t.gas[0]));
    } else {
      // a mirror of the layer's centre, which is known already or (layer 2) the layer before
      GasFields q = s.gas[std::min<std::size_t>(k, core_layers - 1)][1][1];
      if (k < core_layers) q = into_frame(f, t.gas[k]);
      for (std::size_t c = 1; c < 3; ++c) q[gas_field::u + c] = 2 * s.velocity[c] - q[gas_field::u + c];
      s.gas[k][a][b] = q;
    }
    if (core && !(literal.reinterpolated_cores && there[k][a][b])) {
      s.solid[k][a][b] = into_frame(f, t.solid[k]);
    } else if (unread && whole) {
      s.solid[k][a][b] = s.solid[1][1][1];
    } else if (there[k][a][b]) {
      s.solid[k][a][b] = into_frame(f, nearby.solid.at(in_layer(k, -h, a, b), t.solid[0], inner));
    }
  });
  Vec3 const fourth = in_layer(3, h_gas, 1, 1);
  if (gas.kinds.in_medium(fourth)) {
    s.gas_fourth = into_frame(f, gas.donors.at(fourth, Donors<GasFields>::From::valid, t.gas[1]));
  }
  s.inner = inner;
  if (whole || rigid) {
    s.solid_smooth = s.solid;
    return s;
  }

  std::array<LayerSlope, 3> slope;
  for (std::size_t k = 3; k-- > 0;) {
    slope[k] = slope_of(s.solid[k], there[k]);
    if (!slope[k].known && k < 2) slope[k] = slope[k + 1];
  }
  // the triangle, or its image, whose centre is nearest: what acts on that side of the body; the mean of those that are
  // equally near, for round-off and the order of the triangles would choose among them
  struct Wall {
    Vec3 n;
    double pressure;
  };
  auto const wall_at = [&](Vec3 const& x) {
    constexpr double same = 1 + 1e-6;
    double best = 1e300, count = 0;
    Wall found{f.n, t.pressure};
    solid.donors.for_each_near(x, 2, [&](CloudPoint<SolidFields> const& point) {
      Vec3 const r = point.foot - x;
      double const away = dot(r, r);
      if (away > same * best) return;
      TriangleState const& other = triangles[static_cast<std::size_t>(point.triangle)];
      if (same * away < best) best = away, found = {{0, 0, 0}, 0}, count = 0;
      found.n = found.n + reflected(other.frame.n, point.image), found.pressure += other.pressure, count += 1;
    });
    if (count > 0) found = {(1 / length(found.n)) * found.n, found.pressure / count};
    return found;
  };
  // where the local grid does not tell how the velocity goes on, it turns with the body: fits to what is around a tip
  // would have more than that, and let the blast tear tips off
  auto const turned = [&](Vec3 const& way) { return f.into(cross(nearby.spin, way)); };
  auto const add_velocity = [](SolidFields& q, Vec3 const& u) {
    for (std::size_t c = 0; c < 3; ++c) q[field::u + c] += u[c];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    double const layer = static_cast<double>(k);
    bool const behind = k > 0 && !there[k][1][1];  // the body ends before this layer
    if (behind) {
      double const pressure = wall_at(place(-layer * h, h, 1, 1)).pressure;
      Vec3 const change = turned(-h * f.n);
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          s.solid[k][a][b] = s.solid[k - 1][a][b], s.solid_smooth[k][a][b] = s.solid_smooth[k - 1][a][b];
          add_velocity(s.solid[k][a][b], change), add_velocity(s.solid_smooth[k][a][b], change);
          if (!literal.continued_stress) set_traction(s.solid[k][a][b], {1, 0, 0}, pressure);
          s.solid_ghost[k][a][b] = true;
        }
      }
      there[k] = there[k - 1], there[k][1][1] = false;
      continue;
    }
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        SolidFields const& centre = s.solid[k][1][1];
        if (there[k][a][b]) {
          s.solid_smooth[k][a][b] = s.solid[k][a][b];
          continue;
        }
        double const x = static_cast<double>(a) - 1, y = static_cast<double>(b) - 1;
        SolidFields smooth = centre;
        if (slope[k].known) {
          smooth = plus(plus(centre, x, slope[k].a), y, slope[k].b);
        } else if (there[k][2 - a][2 - b]) {
          smooth = plus(plus(centre, 1, centre), -1, s.solid[k][2 - a][2 - b]);
        } else {
          add_velocity(smooth, turned(in_layer(k, -h, a, b) - in_layer(k, -h, 1, 1)));
        }
        SolidFields q = centre;
        Vec3 const side = place(-(layer + 0.5) * h, 0.5 * h, a, b);
        Wall const wall = wall_at(side);
        if (!literal.continued_stress) set_traction(q, f.into(wall.n), wall.pressure);
        for (std::size_t c = 0; c < 3; ++c) q[field::u + c] = smooth[field::u + c];
        s.solid[k][a][b] = q, s.solid_smooth[k][a][b] = smooth, s.solid_ghost[k][a][b] = true;
      }
    }
  }
  return s;
}

}  // namespace g27
