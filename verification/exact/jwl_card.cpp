#include "verification/exact/jwl_card.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

using Card = JwlCard;

/// Relative residuals of the four equations.
void residuals(std::array<double, Card::count> const& q, double* out) {
  double const V = q[Card::V_CJ], J = q[Card::rho0] * q[Card::D] * q[Card::D], p = q[Card::p_CJ];
  double const a = q[Card::A] * std::exp(-q[Card::R1] * V), b = q[Card::B] * std::exp(-q[Card::R2] * V),
               c = q[Card::C] * std::pow(V, -1 - q[Card::omega]);
  out[0] = (a + b + c) / p - 1;
  out[1] = J * (1 - V) / p - 1;
  out[2] = (q[Card::R1] * a + q[Card::R2] * b + (1 + q[Card::omega]) * c / V) / J - 1;
  out[3] = (a / q[Card::R1] + b / q[Card::R2] + c * V / q[Card::omega] - p * (1 - V) / 2) / q[Card::E0] - 1;
}

/// A start for the iteration: with V and the exponents fixed the equations are linear in A, B, C, rho0 D^2 and E0.
std::optional<std::array<double, Card::count>> start_at(double V, PartialJwlCard const& known) {
  std::array<double, Card::count> q{};
  constexpr std::array usual{std::pair{Card::R1, 4.5}, std::pair{Card::R2, 1.2}, std::pair{Card::omega, 0.35}};
  for (std::size_t i = 0; i < known.size(); ++i) q[i] = known[i].value_or(0);
  for (auto const& [entry, value] : usual) q[entry] = known[entry].value_or(value);
  q[Card::V_CJ] = V;
  std::optional<double> J;
  if (known[Card::rho0] && known[Card::D]) J = q[Card::rho0] * q[Card::D] * q[Card::D];
  if (!J && known[Card::p_CJ]) J = q[Card::p_CJ] / (1 - V);

  double const a = std::exp(-q[Card::R1] * V), b = std::exp(-q[Card::R2] * V), c = std::pow(V, -1 - q[Card::omega]);
  Eigen::Matrix<double, 3, 5> rows;                                           // columns: A, B, C, J, E0
  rows << a, b, c, V - 1, 0,                                                  //
      q[Card::R1] * a, q[Card::R2] * b, (1 + q[Card::omega]) * c / V, -1, 0,  //
      a / q[Card::R1], b / q[Card::R2], c * V / q[Card::omega], -(1 - V) * (1 - V) / 2, -1;
  std::array<std::optional<double>, 5> const terms{known[Card::A], known[Card::B], known[Card::C], J, known[Card::E0]};
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  std::vector<int> unknown;
  for (int i = 0; i < 5; ++i) {
    if (terms[static_cast<std::size_t>(i)])
      right -= rows.col(i) * *terms[static_cast<std::size_t>(i)];
    else
      unknown.push_back(i);
  }
  std::array<double, 5> solved{};
  for (std::size_t i = 0; i < 5; ++i) solved[i] = terms[i].value_or(0);
  if (!unknown.empty()) {
    Eigen::MatrixXd left(3, unknown.size());
    for (std::size_t i = 0; i < unknown.size(); ++i) left.col(static_cast<int>(i)) = rows.col(unknown[i]);
    Eigen::VectorXd const x = left.colPivHouseholderQr().solve(right);
    for (std::size_t i = 0; i < unknown.size(); ++i)
      solved[static_cast<std::size_t>(unknown[i])] = x[static_cast<int>(i)];
  }
  q[Card::A] = solved[0], q[Card::B] = solved[1], q[Card::C] = solved[2], q[Card::E0] = solved[4];
  if (!known[Card::p_CJ]) q[Card::p_CJ] = solved[3] * (1 - V);
  if (!known[Card::D]) q[Card::D] = std::sqrt(solved[3] / q[Card::rho0]);
  if (!known[Card::rho0]) q[Card::rho0] = solved[3] / (q[Card::D] * q[Card::D]);
  bool const good = std::all_of(q.begin(), q.end(), [](double x) { return std::isfinite(x) && x > 0; });
  return good ? std::optional(q) : std::nullopt;
}

/// Root by the logarithms of the unknowns, which keeps them positive; V by ln(1/V - 1), which keeps it below 1.
std::optional<JwlCard> refine(std::array<double, Card::count> start, std::vector<std::size_t> const& unknown) {
  auto const put = [&](double const* x) {
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      start[unknown[i]] = unknown[i] == Card::V_CJ ? 1 / (1 + std::exp(x[i])) : std::exp(x[i]);
    }
  };
  std::vector<double> x;
  for (std::size_t const i : unknown) x.push_back(i == Card::V_CJ ? std::log(1 / start[i] - 1) : std::log(start[i]));
  auto const root = find_roots(
      [&](double const* at, double* out) {
        put(at);
        residuals(start, out);
      },
      x);
  if (!root) return std::nullopt;
  put(root->data());
  return JwlCard{start};
}

}  // namespace

CompletedJwlCard complete(PartialJwlCard const& all) {
  PartialJwlCard known = all;
  if (!known[Card::rho0] && !known[Card::D])
    throw NumericsError("rho0 and D are both missing: the equations hold rho0 D^2 alone");
  auto const count = [&] {
    return static_cast<std::size_t>(
        std::count_if(known.begin(), known.end(), [](auto const& x) { return x.has_value(); }));
  };
  if (count() < Card::needed)
    throw NumericsError("a card needs " + std::to_string(Card::needed) + " of its ten numbers, " +
                        std::to_string(count()) + " are given");
  CompletedJwlCard out;
  for (Card::Entry const extra : {Card::E0, Card::p_CJ, Card::D, Card::C}) {
    bool const free = extra != Card::D || known[Card::rho0].has_value();
    if (count() > Card::needed && known[extra] && free) {
      out.checks.push_back({extra, *known[extra], 0});
      known[extra].reset();
    }
  }
  std::vector<std::size_t> unknown{Card::V_CJ};
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!known[i]) unknown.push_back(i);
  }
  std::vector<double> ratios;
  for (int i = 1; i < 50; ++i) ratios.push_back(0.02 * i);
  if (known[Card::rho0] && known[Card::D] && known[Card::p_CJ])
    ratios.push_back(1 - *known[Card::p_CJ] / (*known[Card::rho0] * *known[Card::D] * *known[Card::D]));
  std::vector<JwlCard> found;
  for (double const V : ratios) {
    auto const start = V > 0 ? start_at(V, known) : std::nullopt;
    auto const card = start ? refine(*start, unknown) : std::nullopt;
    if (!card) continue;
    bool const same = std::any_of(found.begin(), found.end(), [&](JwlCard const& other) {
      return std::fabs(other.value[Card::V_CJ] / card->value[Card::V_CJ] - 1) < 1e-6;
    });
    if (!same) found.push_back(*card);
  }
  if (found.empty()) throw NumericsError("no Chapman-Jouguet wave follows from these numbers");
  if (found.size() > 1)
    throw NumericsError(
        "two cards follow from these numbers, with V_CJ = " + std::to_string(found[0].value[Card::V_CJ]) + " and " +
        std::to_string(found[1].value[Card::V_CJ]) + ": give one number more, or another one");
  out.card = found[0];
  for (JwlCardCheck& check : out.checks) check.computed = out.card.value[check.entry];
  return out;
}

}  // namespace g27
