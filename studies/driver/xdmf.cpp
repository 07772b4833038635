/// XDMF 3: a collection in time of grids of one-dimensional cells, data by reference to the HDF5 file.
#include <fmt/format.h>

#include "studies/driver/output.hpp"

namespace g27 {

std::string xdmf(std::string const& hdf5_name, RunRecord const& record) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t i = 0; i < record.snapshots.size(); ++i) {
    Snapshot const& s = record.snapshots[i];
    std::string const data = fmt::format("{}:/state/{:04}", hdf5_name, i);
    // A rectilinear mesh n x 1 x 1: VTK takes its cells as lines, with one value a cell.
    out += fmt::format(
        "<Grid Name=\"state {0}\">\n<Time Value=\"{1}\"/>\n<Topology TopologyType=\"3DRectMesh\" Dimensions=\"1 1 "
        "{2}\"/>\n<Geometry GeometryType=\"VXVYVZ\">\n"
        "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"{2}\">{3}/faces</DataItem>\n"
        "<DataItem Format=\"XML\" Dimensions=\"1\">0</DataItem>\n<DataItem Format=\"XML\" "
        "Dimensions=\"1\">0</DataItem>\n"
        "</Geometry>\n",
        i, s.time, s.faces.size(), data);
    for (char const* field : {"density", "velocity", "pressure"}) {
      out += fmt::format(
          "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Cell\">\n<DataItem Format=\"HDF\" "
          "NumberType=\"Float\" Precision=\"8\" Dimensions=\"1 1 {1}\">{2}/{0}</DataItem>\n</Attribute>\n",
          field, s.density.size(), data);
    }
    out += "</Grid>\n";
  }
  return out + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace g27
