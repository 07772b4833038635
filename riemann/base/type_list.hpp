#pragma once
/// A list of types and what is derived from it.
#include <cstddef>
#include <variant>

namespace g27 {

template <class... T>
struct TypeList {
  static constexpr std::size_t size = sizeof...(T);
  using Variant = std::variant<T...>;

  /// Calls f.template operator()<T>() for each type, in order.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f.template operator()<T>(), ...);
  }
};

}  // namespace g27
