#include "studies/driver/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace g27 {
namespace {

struct Unit {
  std::string_view symbol;
  double si;
  Exponents exponents;
  bool prefixed;
};

constexpr std::array units{
    Unit{"m", 1, {0, 1, 0, 0, 0}, true},
    Unit{"g", 1e-3, {1, 0, 0, 0, 0}, true},
    Unit{"s", 1, {0, 0, 1, 0, 0}, true},
    Unit{"K", 1, {0, 0, 0, 1, 0}, true},
    Unit{"Pa", 1, {1, -1, -2, 0, 0}, true},
    Unit{"bar", 1e5, {1, -1, -2, 0, 0}, true},
    Unit{"atm", 101325, {1, -1, -2, 0, 0}, false},
    Unit{"J", 1, {1, 2, -2, 0, 0}, true},
    Unit{"N", 1, {1, 1, -2, 0, 0}, true},
    Unit{"W", 1, {1, 2, -3, 0, 0}, true},
    Unit{"Hz", 1, {0, 0, -1, 0, 0}, true},
    Unit{"l", 1e-3, {0, 3, 0, 0, 0}, true},
    Unit{"t", 1e3, {1, 0, 0, 0, 0}, false},
    Unit{"rad", 1, {0, 0, 0, 0, 1}, true},
    Unit{"deg", std::numbers::pi / 180, {0, 0, 0, 0, 1}, false},
    Unit{"%", 0.01, {0, 0, 0, 0, 0}, false},
};

struct Prefix {
  std::string_view symbol;
  double factor;
};
constexpr std::array prefixes{Prefix{"n", 1e-9}, Prefix{"u", 1e-6}, Prefix{"\u00b5", 1e-6}, Prefix{"\u03bc", 1e-6},
                              Prefix{"m", 1e-3}, Prefix{"c", 1e-2}, Prefix{"d", 1e-1},      Prefix{"h", 1e2},
                              Prefix{"k", 1e3},  Prefix{"M", 1e6},  Prefix{"G", 1e9},       Prefix{"T", 1e12}};

std::optional<Quantity> symbol_value(std::string_view symbol) {
  for (Unit const& unit : units) {
    if (symbol == unit.symbol) {
      return Quantity{unit.si, unit.exponents, true};
    }
  }
  for (Prefix const& prefix : prefixes) {
    for (Unit const& unit : units) {
      if (unit.prefixed && symbol.size() == prefix.symbol.size() + unit.symbol.size() &&
          symbol.starts_with(prefix.symbol) && symbol.ends_with(unit.symbol)) {
        return Quantity{prefix.factor * unit.si, unit.exponents, true};
      }
    }
  }
  return std::nullopt;
}

void multiply(Quantity& a, Quantity const& b, int power) {
  a.value *= std::pow(b.value, power);
  for (std::size_t i = 0; i < a.exponents.size(); ++i) {
    a.exponents[i] += power * b.exponents[i];
  }
}

/// Recursive descent over  product := factor (('/' | '*' | ' ') factor)*,  factor := symbol [power] | '(' product ')'.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  std::optional<Quantity> parse() {
    auto const result = product();
    return result && rest_.empty() ? result : std::nullopt;
  }

 private:
  static bool ends_symbol(char c) {
    return c == ' ' || c == '*' || c == '/' || c == '(' || c == ')' || c == '^' || c == '-' || (c >= '0' && c <= '9');
  }
  void skip_spaces() {
    while (!rest_.empty() && rest_.front() == ' ') {
      rest_.remove_prefix(1);
    }
  }

  std::optional<Quantity> product() {
    Quantity result{1, {}, true};
    int sign = 1;
    for (bool first = true;; first = false) {
      skip_spaces();
      if (!first) {
        if (rest_.empty() || rest_.front() == ')') {
          return result;
        }
        sign = rest_.front() == '/' ? -1 : 1;
        if (rest_.front() == '/' || rest_.front() == '*') {
          rest_.remove_prefix(1);
          skip_spaces();
        }
      }
      auto const next = factor();
      if (!next) {
        return std::nullopt;
      }
      multiply(result, *next, sign);
    }
  }

  std::optional<Quantity> factor() {
    std::optional<Quantity> base;
    if (rest_.starts_with('(')) {
      rest_.remove_prefix(1);
      base = product();
      if (!base || !rest_.starts_with(')')) {
        return std::nullopt;
      }
      rest_.remove_prefix(1);
    } else {
      if (rest_.starts_with('1')) {  // "1/s"
        rest_.remove_prefix(1);
        return Quantity{1, {}, true};
      }
      std::size_t n = 0;
      while (n < rest_.size() && !ends_symbol(rest_[n])) {
        ++n;
      }
      base = symbol_value(rest_.substr(0, n));
      if (!base) {
        return std::nullopt;
      }
      rest_.remove_prefix(n);
    }
    if (rest_.starts_with('^')) {
      rest_.remove_prefix(1);
    }
    int power = 1;
    auto const [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), power);
    if (error == std::errc{}) {
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    }
    if (power < -9 || power > 9) {
      return std::nullopt;
    }
    Quantity result{1, {}, true};
    multiply(result, *base, power);
    return result;
  }

  std::string_view rest_;
};

}  // namespace

std::optional<Quantity> parse_unit(std::string_view text) { return UnitParser(text).parse(); }

std::optional<Quantity> parse_quantity(std::string_view text) {
  while (text.starts_with(' ')) {
    text.remove_prefix(1);
  }
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    value = HUGE_VAL;  // "1e999": the reader reports a number that is not finite
  } else if (error != std::errc{}) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  while (text.starts_with(' ')) {
    text.remove_prefix(1);
  }
  while (text.ends_with(' ')) {
    text.remove_suffix(1);
  }
  if (text.empty()) {
    return Quantity{value, {}, false};
  }
  auto const unit = parse_unit(text);
  if (!unit) {
    return std::nullopt;
  }
  return Quantity{value * unit->value, unit->exponents, true};
}

std::optional<double> number_in(std::string_view text, std::string_view unit) {
  auto const quantity = parse_quantity(text), own = parse_unit(unit);
  if (!quantity || !quantity->has_unit) return quantity ? std::optional(quantity->value) : std::nullopt;
  if (!own || own->exponents != quantity->exponents) return std::nullopt;
  return quantity->value / own->value;
}

std::string si_unit(Exponents const& exponents) {
  constexpr std::array<std::string_view, 5> symbols{"kg", "m", "s", "K", "rad"};
  std::string out;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i] != 0) {
      out += fmt::format("{}{}{}", out.empty() ? "" : " ", symbols[i],
                         exponents[i] == 1 ? std::string{} : std::to_string(exponents[i]));
    }
  }
  return out.empty() ? "1" : out;
}

}  // namespace g27
