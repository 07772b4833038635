#pragma once
/// STL files, binary and ASCII, to and from surfaces. What counts is the content of a file, not the word that it starts
/// with.
#include <filesystem>
#include <string>
#include <string_view>

#include "fsi/surface/triangle_surface.hpp"

namespace g27 {

struct StlFile {
  std::vector<std::array<Vec3, 3>> facets;  ///< corners as they stand in the file, in its unit
  bool binary = false;
  int solids = 1;
  std::vector<std::string> remarks;  ///< oddities that harm nothing
};

/// Largest magnitude of a coordinate, in the file's unit.
inline constexpr double stl_coordinate_limit = 1e12;

/// bytes: the whole content of a file. Throws SurfaceError (content that is neither, truncated, coordinates that are
/// not finite or beyond the limit, no facets), naming the facet, counted from 0, or the line. Allocates no more than
/// the content justifies, whatever it claims.
StlFile parse_stl(std::string_view bytes);

/// Reads a regular file of less than 2 GiB; throws SurfaceError.
StlFile read_stl(std::filesystem::path const& file);

/// One vertex for corners with equal coordinates; triangles in the order of the facets. unit: metres of the file's.
TriangleSurface weld(std::vector<std::array<Vec3, 3>> const& facets, double unit = 1);

/// The content of a binary STL file, coordinates in `unit` [m], single precision.
std::string binary_stl(TriangleSurface const& surface, double unit = 1);

}  // namespace g27
