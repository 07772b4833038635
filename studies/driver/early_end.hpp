#pragma once
/// Runs that end sooner than their scene says: what lies beyond the end is left out.
#include <filesystem>
#include <string>
#include <vector>

#include "studies/driver/document.hpp"

namespace g27 {

/// Settings that a shortened run needs: no snapshots after its end, nothing expected.
std::vector<std::string> quick_look(Document const& scene);

/// `set` ("dotted.key=value", of --set), and those settings where it makes time.end sooner than the file's: each is
/// said on stderr. Throws InputError.
std::vector<std::string> without_what_is_beyond(std::filesystem::path const& file, std::vector<std::string> const& set);

}  // namespace g27
