#pragma once
/// Numbers with units as users write them ("5 cm", "1.65 g/cm3", "3 GPa us") to and from SI.
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace g27 {

/// Exponents of kilogram, metre, second, kelvin and radian.
using Exponents = std::array<int, 5>;

struct Dimension {
  std::string_view name;     ///< "pressure"
  std::string_view example;  ///< "1 bar", for messages
  Exponents exponents;
};

namespace dimension {
inline constexpr Dimension number{"pure number", "0.8", {0, 0, 0, 0, 0}};
inline constexpr Dimension length{"length", "5 cm", {0, 1, 0, 0, 0}};
inline constexpr Dimension time{"time", "55 us", {0, 0, 1, 0, 0}};
inline constexpr Dimension velocity{"velocity", "7.5869 km/s", {0, 1, -1, 0, 0}};
inline constexpr Dimension density{"density", "1.65 g/cm3", {1, -3, 0, 0, 0}};
inline constexpr Dimension pressure{"pressure", "1 bar", {1, -1, -2, 0, 0}};
inline constexpr Dimension impulse{"impulse per area", "28 GPa us", {1, -1, -1, 0, 0}};
inline constexpr Dimension mass{"mass", "1 kg", {1, 0, 0, 0, 0}};
inline constexpr Dimension energy{"energy", "1 MJ", {1, 2, -2, 0, 0}};
inline constexpr Dimension volume{"volume", "1 cm3", {0, 3, 0, 0, 0}};
inline constexpr Dimension momentum{"momentum", "1 N s", {1, 1, -1, 0, 0}};
inline constexpr Dimension angular_momentum{"angular momentum", "1 N m s", {1, 2, -1, 0, 0}};
inline constexpr Dimension angular_velocity{"angular velocity", "100 rad/s", {0, 0, -1, 0, 1}};
inline constexpr Dimension angle{"angle", "45 deg", {0, 0, 0, 0, 1}};
}  // namespace dimension

struct Quantity {
  double value = 0;  ///< SI
  Exponents exponents{};
  bool has_unit = false;
};

/// Parses NUMBER [UNIT]; nullopt when it is neither. UNIT is a product of units with SI prefixes, `/` for the next
/// factor or a group in brackets, exponents as `m2`, `m^2` or `s-1`; `%` is 0.01.
std::optional<Quantity> parse_quantity(std::string_view text);

/// The unit alone: "g/cm3" is {1000, density}.
std::optional<Quantity> parse_unit(std::string_view text);

/// A quantity as a number of `unit`s, "3 cm" of "m" is 0.03; a bare number as it stands. nullopt when it is neither, or
/// of another dimension.
std::optional<double> number_in(std::string_view text, std::string_view unit);

/// Exponents in SI symbols: "kg m-1 s-2".
std::string si_unit(Exponents const& exponents);

}  // namespace g27
