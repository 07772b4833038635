#pragma once
/// A table of a scene being read: every getter checks type, unit, dimension and finiteness, and names file, key, place
/// and remedy when it throws InputError. Unknown keys are found when the section is opened.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "studies/driver/document.hpp"
#include "studies/driver/input_error.hpp"
#include "studies/driver/units.hpp"

namespace g27 {

/// What one reading of a scene shares: the file's name and the bare numbers that were taken as SI.
struct Reading {
  std::string file;
  std::vector<std::string> bare_numbers;  ///< "domain.extent.0 = 1.5 (length, m)"

  void note_bare(std::string const& key, double value, Dimension const& dimension);
};

class Section {
 public:
  /// `node` must be a table with keys among `known`.
  Section(Reading& reading, Node const& node, std::string path, std::vector<std::string> known);

  [[nodiscard]] bool has(std::string const& key) const { return node_->find(key) != nullptr; }
  [[nodiscard]] Node const& need(std::string const& key, std::string const& example) const;

  [[nodiscard]] double quantity(std::string const& key, Dimension const& dimension) const;
  [[nodiscard]] double quantity(std::string const& key, Dimension const& dimension, double fallback) const;
  /// > 0
  [[nodiscard]] double positive(std::string const& key, Dimension const& dimension) const;
  [[nodiscard]] long integer(std::string const& key, long least, long most) const;
  /// `number` whole numbers, one an axis; 1 along the axes beyond.
  [[nodiscard]] std::array<int, 3> counts(std::string const& key, std::size_t number, long least, long most) const;
  /// true or "on", false or "off".
  [[nodiscard]] bool flag(std::string const& key, bool fallback) const;
  [[nodiscard]] std::string text(std::string const& key) const;
  [[nodiscard]] std::string text(std::string const& key, std::string const& fallback) const;
  /// One of `options`; returns its index. A missing key is `fallback`.
  [[nodiscard]] std::size_t choice(std::string const& key, std::vector<std::string> const& options,
                                   std::size_t fallback) const;
  [[nodiscard]] std::vector<double> quantities(std::string const& key, Dimension const& dimension) const;
  /// As many entries as the mesh has dimensions, the others 0.
  [[nodiscard]] std::array<double, 3> point(std::string const& key, Dimension const& dimension, int dimensions) const;
  /// Points [[x, y, z], ...], as many entries as the mesh has dimensions, the others 0.
  [[nodiscard]] std::vector<std::array<double, 3>> points(std::string const& key, Dimension const& dimension,
                                                          int dimensions) const;
  /// Intervals [[a, b], ...], one an axis.
  [[nodiscard]] std::vector<std::array<double, 2>> intervals(std::string const& key, Dimension const& dimension) const;
  /// The interval [a, b], a < b.
  [[nodiscard]] std::array<double, 2> interval(std::string const& key, Dimension const& dimension) const;
  [[nodiscard]] Section table(std::string const& key, std::vector<std::string> known) const;
  /// Entries of [[key]]; none when absent.
  [[nodiscard]] std::vector<Section> tables(std::string const& key, std::vector<std::string> const& known) const;

  /// Reads a node that is not a direct entry: an element of a list. `key` is its name for messages.
  [[nodiscard]] double quantity_of(Node const& node, std::string const& key, Dimension const& dimension) const;
  [[nodiscard]] std::vector<double> quantities_of(Node const& node, std::string const& key,
                                                  Dimension const& dimension) const;
  [[nodiscard]] std::array<double, 3> point_of(Node const& node, std::string const& key, Dimension const& dimension,
                                               int dimensions) const;
  [[nodiscard]] std::array<double, 2> interval_of(Node const& node, std::string const& key,
                                                  Dimension const& dimension) const;
  /// The same table opened with other keys: once its `type` is known.
  [[nodiscard]] Section reopened(std::vector<std::string> known) const {
    return {*reading_, *node_, path_, std::move(known)};
  }
  [[nodiscard]] InputError error(std::string const& key, std::string const& what, std::string const& remedy) const;
  [[nodiscard]] std::string const& path() const noexcept { return path_; }
  [[nodiscard]] Node const& node() const noexcept { return *node_; }
  [[nodiscard]] Reading& reading() const noexcept { return *reading_; }

 private:
  /// The elements of a list of `what`, with their names for messages.
  [[nodiscard]] std::vector<std::pair<std::string, Node const*>> entries(std::string const& key,
                                                                         std::string const& example,
                                                                         std::string const& what) const;
  [[nodiscard]] std::string full(std::string const& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[nodiscard]] InputError error_at(Node const& node, std::string const& key, std::string const& what,
                                    std::string const& remedy) const;

  Reading* reading_;
  Node const* node_;
  std::string path_;
};

/// Value of `name` in a list of choices; throws through `where` with the nearest known one.
std::size_t index_of_choice(Section const& where, std::string const& key, std::string const& name,
                            std::vector<std::string> const& options);

}  // namespace g27
