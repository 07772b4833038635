#pragma once
/// HDF5 files through the C API, every return checked.
///
/// The file is built in memory and reaches the disk in one atomic write: a failing disk is reported with its reason and
/// never leaves half a file.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "studies/driver/atomic_file.hpp"

namespace g27 {

/// Whether a file is there and of this kind.
bool is_hdf5(std::filesystem::path const& file);

/// A file to be written. Paths are absolute within it ("/state/0000/density"); groups are made as needed.
class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(Hdf5Writer const&) = delete;
  Hdf5Writer& operator=(Hdf5Writer const&) = delete;

  /// Row-major data of `shape` (empty: one dimension); `unit` goes to the attribute `units`.
  void write(std::string const& path, std::span<double const> data, std::string const& unit,
             std::vector<std::uint64_t> shape = {});
  void write_integers(std::string const& path, std::span<int const> data, std::vector<std::uint64_t> shape);
  void write_text(std::string const& path, std::string const& text);
  void write_texts(std::string const& path, std::vector<std::string> const& texts);
  void attribute(std::string const& path, std::string const& name, double value);
  void attribute(std::string const& path, std::string const& name, std::string const& value);
  void group(std::string const& path);
  /// `path` stands for `path` of another file, named from this one's folder.
  void external(std::string const& path, std::string const& file);

  /// Writes the file. Throws OutputError.
  void save(std::filesystem::path const& file);

 private:
  std::int64_t file_;
};

/// A file to be read; throws OutputError when it is missing, damaged or lacks what is asked.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(std::filesystem::path const& file);
  ~Hdf5Reader();
  Hdf5Reader(Hdf5Reader const&) = delete;
  Hdf5Reader& operator=(Hdf5Reader const&) = delete;

  [[nodiscard]] bool has(std::string const& path) const;
  [[nodiscard]] bool is_group(std::string const& path) const;
  [[nodiscard]] std::vector<double> read(std::string const& path) const;
  [[nodiscard]] std::vector<std::uint64_t> shape(std::string const& path) const;
  [[nodiscard]] std::string read_text(std::string const& path) const;
  [[nodiscard]] std::string text_attribute(std::string const& path, std::string const& name) const;
  [[nodiscard]] double number_attribute(std::string const& path, std::string const& name) const;
  /// Reads all that the group holds, in the files it links to as well; throws OutputError where a checksum is wrong.
  void verify(std::string const& group = "/") const;
  /// Names in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names(std::string const& group) const;

 private:
  std::string name_;
  std::int64_t file_;
};

}  // namespace g27
