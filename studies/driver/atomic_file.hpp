#pragma once
/// Files that are either complete or untouched.
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

namespace g27 {

/// A result could not be written or read back: disk full, no permission, damaged file. Exit status 1, unless what asked
/// for it knows better.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Makes a folder for results, and those above it. Throws InputError (--out) where it cannot be.
void make_output_folder(std::filesystem::path const& folder);

/// Writes `bytes` to a temporary name beside `file`, flushes it to disk and renames it. Whatever goes wrong, or if the
/// process dies, `file` keeps its previous content. Throws OutputError with the system's reason.
void write_atomically(std::filesystem::path const& file, std::span<std::byte const> bytes);
void write_atomically(std::filesystem::path const& file, std::string_view text);

}  // namespace g27
