#include "riemann/eos/factory.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace g27 {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::size_t const substitution = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substitution, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, std::vector<std::string> const& known) {
  return *std::min_element(known.begin(), known.end(), [&](std::string const& a, std::string const& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
}

template <class E>
constexpr bool in_range(EosParameter<E> const& p, double value) {
  return std::isfinite(value) && (value > p.above || (p.lowest_included && value == p.above)) && value <= p.up_to;
}

/// Calls f.operator()<E>() for the law called `name`.
template <class F>
void with_law(std::string_view name, F&& f) {
  bool found = false;
  EosList::for_each([&]<class E>() {
    if (name == E::name) {
      found = true;
      f.template operator()<E>();
    }
  });
  if (!found) {
    throw std::invalid_argument("unknown equation of state '" + std::string(name) + "'; did you mean '" +
                                nearest(name, eos_names()) + "'?");
  }
}

template <class E>
E make(std::map<std::string, double> const& given) {
  std::string const law = std::string("equation of state '") + E::name + "': ";
  std::vector<std::string> known;
  for (auto const& p : E::parameters) {
    known.emplace_back(p.name);
  }
  for (auto const& [key, value] : given) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw std::invalid_argument(law + "unknown parameter '" + key + "'; did you mean '" + nearest(key, known) + "'?");
    }
  }
  E eos{};
  for (auto const& p : E::parameters) {
    auto const entry = given.find(p.name);
    if (entry == given.end()) {
      throw std::invalid_argument(law + "parameter '" + p.name + "' is missing: " + p.what + " [" + p.unit + "]");
    }
    if (!in_range(p, entry->second)) {
      std::ostringstream text;
      text << law << p.name << " = " << entry->second << " is not in " << (p.lowest_included ? '[' : '(') << p.above
           << ", " << p.up_to << "] " << p.unit;
      throw std::invalid_argument(text.str());
    }
    eos.*p.member = entry->second;
  }
  if (char const* const flaw = eos.flaw()) {
    throw std::invalid_argument(law + flaw);
  }
  return eos;
}

}  // namespace

std::vector<std::string> eos_names() {
  std::vector<std::string> names;
  EosList::for_each([&]<class E>() { names.emplace_back(E::name); });
  return names;
}

std::string eos_title(std::string_view name) {
  std::string title;
  with_law(name, [&]<class E>() { title = E::title; });
  return title;
}

std::vector<EosParameterInfo> eos_parameters(std::string_view name) {
  std::vector<EosParameterInfo> infos;
  with_law(name, [&]<class E>() {
    E const defaults{};
    for (auto const& p : E::parameters) {
      infos.push_back({p.name, p.unit, p.what, defaults.*p.member, p.above, p.up_to, p.lowest_included});
    }
  });
  return infos;
}

AnyEos make_eos(std::string_view name, std::map<std::string, double> const& parameters) {
  AnyEos eos;
  with_law(name, [&]<class E>() { eos = make<E>(parameters); });
  return eos;
}

std::string eos_name(AnyEos const& eos) {
  return std::visit([]<class E>(E const&) { return std::string(E::name); }, eos);
}

std::map<std::string, double> eos_values(AnyEos const& eos) {
  std::map<std::string, double> values;
  std::visit(
      [&]<class E>(E const& law) {
        for (auto const& p : E::parameters) {
          values[p.name] = law.*p.member;
        }
      },
      eos);
  return values;
}

}  // namespace g27
