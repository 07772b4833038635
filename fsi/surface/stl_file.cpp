#include "fsi/surface/stl_file.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <numeric>

namespace g27 {
namespace {

constexpr std::size_t header_bytes = 80, prefix_bytes = 84, facet_bytes = 50;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

std::string lower_case(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// A word of the file, fit for a message.
std::string quoted(std::string_view word) {
  std::string out = "'";
  for (char const c : word.substr(0, 24)) out += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  return out + (word.size() > 24 ? "...'" : "'");
}

void check_coordinate(double x, std::size_t facet) {
  if (!std::isfinite(x)) {
    throw SurfaceError("facet " + std::to_string(facet) + " has a coordinate that is not a finite number",
                       "export the surface anew");
  }
  if (std::fabs(x) > stl_coordinate_limit) {
    throw SurfaceError("facet " + std::to_string(facet) + " has a coordinate beyond 1e12",
                       "move its stray corner, or scale the surface");
  }
}

/// Counts facets whose stated normal contradicts the order of their corners.
class NormalCheck {
 public:
  void add(Vec3 const& stated, std::array<Vec3, 3> const& c) {
    if (dot(stated, cross(c[1] - c[0], c[2] - c[0])) < 0) ++against_;
  }
  void report(StlFile& file) const {
    if (against_ > 0) {
      file.remarks.push_back(std::to_string(against_) + " of " + std::to_string(file.facets.size()) +
                             " facets state a normal against the order of their corners; the order counts");
    }
  }

 private:
  std::size_t against_ = 0;
};

std::uint32_t claimed_facets(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes, sizeof count);
  return count;
}

StlFile parse_binary(std::string_view bytes) {
  std::size_t const claimed = claimed_facets(bytes), present = (bytes.size() - prefix_bytes) / facet_bytes;
  if (claimed > present) {
    throw SurfaceError("is truncated, or no STL file: it claims " + std::to_string(claimed) + " facets and holds " +
                           std::to_string(present),
                       "export or copy it anew");
  }
  StlFile out{.facets = {}, .binary = true, .solids = 1, .remarks = {}};
  out.facets.reserve(claimed);
  NormalCheck normals;
  for (std::size_t f = 0; f < claimed; ++f) {
    std::array<float, 12> values{};
    std::memcpy(values.data(), bytes.data() + prefix_bytes + f * facet_bytes, sizeof values);
    std::array<Vec3, 3> facet{};
    for (std::size_t i = 0; i < 9; ++i) {
      auto const x = static_cast<double>(values[3 + i]);
      check_coordinate(x, f);
      facet[i / 3][i % 3] = x;
    }
    out.facets.push_back(facet);
    normals.add({values[0], values[1], values[2]}, facet);
  }
  if (std::size_t const used = prefix_bytes + claimed * facet_bytes; used < bytes.size()) {
    out.remarks.push_back(std::to_string(bytes.size() - used) + " bytes after the " + std::to_string(claimed) +
                          " facets that the file claims are ignored");
  }
  normals.report(out);
  return out;
}

/// Words of a text, with the line they stand in.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// Empty at the end.
  std::string_view next() {
    std::size_t n = 0;
    for (; n < rest_.size() && is_space(rest_[n]); ++n) line_ += rest_[n] == '\n';
    rest_.remove_prefix(n);
    for (n = 0; n < rest_.size() && !is_space(rest_[n]);) ++n;
    std::string_view const word = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return word;
  }
  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

  [[noreturn]] void fail(std::string_view word, std::string const& expected) const {
    std::string const place = "line " + std::to_string(line_) + ": ";
    if (word.empty()) {
      throw SurfaceError(place + "is truncated: it ends where " + expected + " is expected", "export or copy it anew");
    }
    throw SurfaceError(place + quoted(word) + " stands where " + expected + " is expected", "export the surface anew");
  }
  void expect(char const* wanted) {
    if (auto const word = next(); lower_case(word) != wanted) fail(word, wanted);
  }
  double number() {
    std::string_view const word = next();
    std::string_view const digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range) return std::strtod(std::string(digits).c_str(), nullptr);
    if (error != std::errc{} || end != digits.data() + digits.size()) fail(word, "a number");
    return value;
  }
  Vec3 vector() {
    double const x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::string_view rest_;
  int line_ = 1;
};

StlFile parse_ascii(std::string_view text) {
  StlFile out{.facets = {}, .binary = false, .solids = 0, .remarks = {}};
  NormalCheck normals;
  bool inside = false;
  for (Words words(text);;) {
    std::string_view const word = words.next();
    std::string const key = lower_case(word);
    if (word.empty()) {
      if (inside) out.remarks.emplace_back("the last endsolid is missing");
      break;
    }
    if (!inside && key == "solid") {
      inside = true;
      ++out.solids;
      words.skip_line();
    } else if (inside && key == "endsolid") {
      inside = false;
      words.skip_line();
    } else if (inside && key == "facet") {
      words.expect("normal");
      Vec3 const normal = words.vector();
      words.expect("outer");
      words.expect("loop");
      std::array<Vec3, 3> facet{};
      for (Vec3& corner : facet) {
        words.expect("vertex");
        corner = words.vector();
        for (double const x : corner) check_coordinate(x, out.facets.size());
      }
      words.expect("endloop");
      words.expect("endfacet");
      out.facets.push_back(facet);
      normals.add(normal, facet);
    } else {
      words.fail(word, inside ? "facet or endsolid" : "solid");
    }
  }
  normals.report(out);
  return out;
}

}  // namespace

StlFile parse_stl(std::string_view bytes) {
  if (bytes.empty()) {
    throw SurfaceError("is empty", "export or copy it anew");
  }
  std::string_view const text = bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  std::string const start = lower_case(text.substr(0, 1024));
  bool const exact =
      bytes.size() >= prefix_bytes && bytes.size() == prefix_bytes + facet_bytes * std::size_t{claimed_facets(bytes)};
  // The number of facets of any binary file below 838 MB has a zero byte, a number made up may have 0xFF; text has
  // neither, unless it is damaged.
  bool const is_text = bytes.find_first_of(std::string_view("\0\xFF", 2)) == std::string_view::npos ||
                       (start.find("facet") != std::string::npos && start.find("vertex") != std::string::npos);
  StlFile file;
  if (exact) {
    file = parse_binary(bytes);
  } else if (is_text) {
    file = parse_ascii(text);
  } else if (bytes.size() >= prefix_bytes) {
    file = parse_binary(bytes);
  } else {
    throw SurfaceError("has " + std::to_string(bytes.size()) + " bytes, fewer than the head of a binary STL file",
                       "export or copy it anew");
  }
  if (file.facets.empty()) {
    throw SurfaceError("holds no facet", "export the surface anew");
  }
  return file;
}

StlFile read_stl(std::filesystem::path const& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw SurfaceError("there is no such file", "check the path");
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    throw SurfaceError("is not a file", "give the path of an STL file");
  }
  auto const size = std::filesystem::file_size(file, error);
  if (error) {
    throw SurfaceError("cannot be read: " + error.message(), "check its permissions");
  }
  if (size >= (std::uintmax_t{1} << 31)) {
    throw SurfaceError("is larger than 2 GiB", "reduce the number of its facets");
  }
  std::string bytes(size, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in || !in.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw SurfaceError("cannot be read", "check its permissions");
  }
  return parse_stl(bytes);
}

TriangleSurface weld(std::vector<std::array<Vec3, 3>> const& facets, double unit) {
  auto corner = [&](std::size_t i) -> Vec3 const& { return facets[i / 3][i % 3]; };
  std::vector<std::size_t> order(3 * facets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return corner(a) != corner(b) ? corner(a) < corner(b) : a < b; });
  // The first of equal corners stands for all, and vertices follow in the order of their first corners.
  std::vector<std::size_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    first[order[i]] = i > 0 && corner(order[i]) == corner(order[i - 1]) ? first[order[i - 1]] : order[i];
  }
  TriangleSurface out;
  out.triangles.resize(facets.size());
  std::vector<int> vertex(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (first[i] == i) {
      vertex[i] = static_cast<int>(out.vertices.size());
      out.vertices.push_back(unit * corner(i));
    }
    out.triangles[i / 3][i % 3] = vertex[first[i]];
  }
  return out;
}

std::string binary_stl(TriangleSurface const& surface, double unit) {
  std::string out("binary STL of godunov27");
  out.resize(prefix_bytes + facet_bytes * surface.size());
  auto const count = static_cast<std::uint32_t>(surface.size());
  std::memcpy(out.data() + header_bytes, &count, sizeof count);
  for (std::size_t t = 0; t < surface.size(); ++t) {
    Vec3 const n = surface.area_vector(t);
    double const norm = length(n);
    std::array<float, 12> values{};
    for (std::size_t d = 0; d < 3; ++d) {
      values[d] = static_cast<float>(norm > 0 ? n[d] / norm : 0);
      for (std::size_t c = 0; c < 3; ++c) {
        values[3 + 3 * c + d] = static_cast<float>(surface.at(surface.triangles[t][c])[d] / unit);
      }
    }
    std::memcpy(out.data() + prefix_bytes + facet_bytes * t, values.data(), sizeof values);
  }
  return out;
}

}  // namespace g27
