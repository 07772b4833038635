#pragma once
/// The known word closest to a mistyped one.
#include <string>
#include <string_view>
#include <vector>

namespace g27 {

/// Number of insertions, deletions, substitutions and swaps of neighbours between two words (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Closest of `known` (case ignored); empty when none is close enough to be a likely slip.
std::string nearest_key(std::string_view word, std::vector<std::string> const& known);

/// "did you mean 'x'?" or "known: a, b, c".
std::string suggestion(std::string_view word, std::vector<std::string> const& known);

}  // namespace g27
