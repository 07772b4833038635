#pragma once
/// Reading the arguments of an oracle.
#include <optional>
#include <string>
#include <vector>

#include "verification/exact/eos.hpp"
#include "verification/exact/oracle.hpp"

namespace g27 {

/// Fallback of an argument that may stay away.
inline constexpr char const* not_given = "none";

/// False for an argument left at `not_given`.
bool given(OracleArguments const& arguments, std::string const& key);
/// The argument as a number; throws OracleError.
double number(OracleArguments const& arguments, std::string const& key);
/// As number(), but throws OracleError unless it is above 0.
double positive_number(OracleArguments const& arguments, std::string const& key);
/// A list "0,0.5,1" or "0:1:101" (first:last:count); throws OracleError.
std::vector<double> numbers(OracleArguments const& arguments, std::string const& key);
/// One of `words`; throws OracleError.
std::string word(OracleArguments const& arguments, std::string const& key, std::vector<std::string> const& words);

/// Where and when to sample a self-similar solution.
struct Samples {
  std::vector<double> x;  ///< as given
  double t, x0;           ///< x0: 0 where the oracle has none
  [[nodiscard]] double speed(double position) const { return (position - x0) / t; }
};
/// Nothing where neither x nor t is given; throws OracleError where one is missing.
std::optional<Samples> samples_argument(OracleArguments const& arguments);

/// The parameters of all laws, each with `suffix` appended; `eos` falls back to `fallback`.
std::vector<OracleParameter> eos_parameters(std::string const& suffix = "", std::string const& fallback = "ideal");
/// Throws OracleError for a parameter that is given, with `suffix`, though `law` has none of that name; `own`: those of
/// a law that only solids have.
void refuse_other_laws(OracleArguments const& arguments, std::string const& suffix, std::string const& law,
                       std::vector<std::string> const& own = {});
/// The law named by `eos` + suffix. A parameter not given is taken from `other_suffix`, when there is one and its law
/// is the same; gamma falls back to 1.4 for the ideal gas. Throws OracleError for a parameter that is
/// missing, or that the law has not.
ExactEos eos_argument(OracleArguments const& arguments, std::string const& suffix = "",
                      std::string const& other_suffix = "");

/// Symmetry exponent 0, 1 or 2 of "planar", "cylindrical" or "spherical".
int symmetry_argument(OracleArguments const& arguments);
OracleParameter symmetry_parameter(std::string const& fallback);

}  // namespace g27
