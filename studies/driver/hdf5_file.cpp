#include "studies/driver/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <numeric>

namespace g27 {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// An identifier of the library, closed when it goes out of scope or, with the result checked, by close().
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle(hid_t id, Closer closer, std::string const& what) : id_(id), closer_(closer), what_(what) {
    if (id < 0) {
      throw OutputError(fmt::format("HDF5: cannot {}", what));
    }
  }
  ~Handle() {
    if (id_ >= 0) {
      closer_(id_);
    }
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  operator hid_t() const noexcept { return id_; }
  void close() {
    hid_t const id = id_;
    id_ = -1;
    if (closer_(id) < 0) {
      throw OutputError(fmt::format("HDF5: cannot finish to {}", what_));
    }
  }

 private:
  hid_t id_;
  Closer closer_;
  std::string what_;
};

void check(herr_t status, std::string const& what) {
  if (status < 0) {
    throw OutputError(fmt::format("HDF5: cannot {}", what));
  }
}

/// Link creation property: intermediate groups are made.
hid_t with_groups() {
  hid_t const properties = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(properties, 1);
  return properties;
}

/// Fixed-length UTF-8, padded with zeros.
hid_t text_type(std::size_t length) {
  hid_t const type = H5Tcopy(H5T_C_S1);
  check(H5Tset_size(type, std::max<std::size_t>(length, 1)), "size a text type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "pad a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type UTF-8");
  return type;
}

void write_attribute(hid_t object, std::string const& name, hid_t type, void const* data) {
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar");
  Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                   "create attribute " + name);
  check(H5Awrite(attribute, type, data), "write attribute " + name);
  attribute.close();
}

void write_text_attribute(hid_t object, std::string const& name, std::string const& value) {
  Handle const type(text_type(value.size()), H5Tclose, "make a text type");
  write_attribute(object, name, type, value.c_str());
}

/// Reading data that has been damaged fails, by the checksum of each chunk: slabs of the first dimension.
void set_checksums(hid_t properties, hid_t space, std::size_t size_of_one) {
  constexpr hsize_t most = hsize_t{1} << 20;  // bytes of a chunk of more than one slab
  int const rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || H5Sget_simple_extent_npoints(space) < 1) return;
  std::vector<hsize_t> chunk(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space, chunk.data(), nullptr);
  hsize_t const slab = std::accumulate(chunk.begin() + 1, chunk.end(), hsize_t{size_of_one}, std::multiplies<>{});
  chunk[0] = std::clamp<hsize_t>(most / slab, 1, chunk[0]);
  check(H5Pset_chunk(properties, rank, chunk.data()), "choose chunks");
  check(H5Pset_fletcher32(properties), "choose checksums");
}

void write_dataset(hid_t file, std::string const& path, hid_t type, hid_t space, void const* data,
                   std::string const* unit) {
  Handle const links(with_groups(), H5Pclose, "make link properties");
  Handle const layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make dataset properties");
  set_checksums(layout, space, H5Tget_size(type));
  Handle dataset(H5Dcreate2(file, path.c_str(), type, space, links, layout, H5P_DEFAULT), H5Dclose, "create " + path);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "write " + path);
  if (unit != nullptr) {
    write_text_attribute(dataset, "units", *unit);
  }
  dataset.close();
}

/// The shape must hold `size` numbers.
hid_t shape_of(std::string const& path, std::vector<std::uint64_t> const& shape, std::size_t size) {
  std::vector<hsize_t> const dims(shape.begin(), shape.end());
  if (std::accumulate(dims.begin(), dims.end(), hsize_t{1}, std::multiplies<>{}) != size) {
    throw OutputError(fmt::format("HDF5: {} does not have the shape given", path));
  }
  return H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
}

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

std::string trimmed(std::string text) {
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace

Hdf5Writer::Hdf5Writer() {
  silence();
  Handle const access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file properties");
  check(H5Pset_fapl_core(access, std::size_t{1} << 20, 0), "choose a file in memory");
  file_ = H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (file_ < 0) {
    throw OutputError("HDF5: cannot create a file in memory");
  }
}

Hdf5Writer::~Hdf5Writer() { H5Fclose(file_); }

void Hdf5Writer::write(std::string const& path, std::span<double const> data, std::string const& unit,
                       std::vector<std::uint64_t> shape) {
  if (shape.empty()) shape = {data.size()};
  Handle const space(shape_of(path, shape, data.size()), H5Sclose, "make a shape");
  write_dataset(file_, path, H5T_NATIVE_DOUBLE, space, data.data(), &unit);
}

void Hdf5Writer::write_integers(std::string const& path, std::span<int const> data, std::vector<std::uint64_t> shape) {
  Handle const space(shape_of(path, shape, data.size()), H5Sclose, "make a shape");
  write_dataset(file_, path, H5T_NATIVE_INT, space, data.data(), nullptr);
}

void Hdf5Writer::write_text(std::string const& path, std::string const& text) {
  Handle const type(text_type(text.size()), H5Tclose, "make a text type");
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar");
  write_dataset(file_, path, type, space, text.c_str(), nullptr);
}

void Hdf5Writer::write_texts(std::string const& path, std::vector<std::string> const& texts) {
  std::size_t length = 1;
  for (auto const& text : texts) {
    length = std::max(length, text.size());
  }
  std::string packed(length * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i].copy(packed.data() + i * length, length);
  }
  hsize_t const count = texts.size();
  Handle const type(text_type(length), H5Tclose, "make a text type");
  Handle const space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a shape");
  write_dataset(file_, path, type, space, packed.data(), nullptr);
}

void Hdf5Writer::attribute(std::string const& path, std::string const& name, double value) {
  Handle const object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose, "open " + path);
  write_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5Writer::attribute(std::string const& path, std::string const& name, std::string const& value) {
  Handle const object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose, "open " + path);
  write_text_attribute(object, name, value);
}

void Hdf5Writer::group(std::string const& path) {
  Handle const links(with_groups(), H5Pclose, "make link properties");
  Handle group(H5Gcreate2(file_, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "create group " + path);
  group.close();
}

void Hdf5Writer::external(std::string const& path, std::string const& file) {
  Handle const links(with_groups(), H5Pclose, "make link properties");
  check(H5Lcreate_external(file.c_str(), path.c_str(), file_, path.c_str(), links, H5P_DEFAULT), "link " + path);
}

void Hdf5Writer::save(std::filesystem::path const& file) {
  check(H5Fflush(file_, H5F_SCOPE_LOCAL), "flush");
  ssize_t const size = H5Fget_file_image(file_, nullptr, 0);
  if (size <= 0) {
    throw OutputError("HDF5: cannot size the file");
  }
  std::vector<std::byte> image(static_cast<std::size_t>(size));
  if (H5Fget_file_image(file_, image.data(), image.size()) != size) {
    throw OutputError("HDF5: cannot copy the file from memory");
  }
  write_atomically(file, image);
}

bool is_hdf5(std::filesystem::path const& file) {
  silence();
  return H5Fis_hdf5(file.c_str()) > 0;
}

Hdf5Reader::Hdf5Reader(std::filesystem::path const& file) : name_(file.string()) {
  silence();
  file_ = H5Fopen(name_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) {
    throw OutputError(fmt::format("cannot read {}: it is missing, damaged or not HDF5", name_));
  }
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(file_); }

bool Hdf5Reader::has(std::string const& path) const {
  for (std::size_t at = path.find('/', 1);; at = path.find('/', at + 1)) {
    std::string const part = path.substr(0, at);
    if (part != "/" && H5Lexists(file_, part.c_str(), H5P_DEFAULT) <= 0) {
      return false;
    }
    if (at == std::string::npos) {
      return true;
    }
  }
}

bool Hdf5Reader::is_group(std::string const& path) const {
  Handle const object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose, "open " + path + " of " + name_);
  return H5Iget_type(object) == H5I_GROUP;
}

std::vector<std::uint64_t> Hdf5Reader::shape(std::string const& path) const {
  Handle const dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path + " of " + name_);
  Handle const space(H5Dget_space(dataset), H5Sclose, "read the shape of " + path);
  std::vector<hsize_t> dims(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  check(H5Sget_simple_extent_dims(space, dims.data(), nullptr), "read the shape of " + path);
  return {dims.begin(), dims.end()};
}

std::vector<double> Hdf5Reader::read(std::string const& path) const {
  auto const dims = shape(path);
  std::vector<double> data(std::accumulate(dims.begin(), dims.end(), std::size_t{1}, std::multiplies<>{}));
  Handle const dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path + " of " + name_);
  check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()),
        "read " + path + " of " + name_ + ", which may be damaged");
  return data;
}

std::string Hdf5Reader::read_text(std::string const& path) const {
  Handle const dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path + " of " + name_);
  Handle const type(H5Dget_type(dataset), H5Tclose, "read the type of " + path);
  std::string text(H5Tget_size(type), '\0');
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()),
        "read " + path + " of " + name_ + ", which may be damaged");
  return trimmed(text);
}

std::string Hdf5Reader::text_attribute(std::string const& path, std::string const& name) const {
  Handle const attribute(H5Aopen_by_name(file_, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "open attribute " + name + " of " + path);
  Handle const type(H5Aget_type(attribute), H5Tclose, "read the type of " + name);
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, text.data()), "read attribute " + name);
  return trimmed(text);
}

double Hdf5Reader::number_attribute(std::string const& path, std::string const& name) const {
  Handle const attribute(H5Aopen_by_name(file_, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "open attribute " + name + " of " + path);
  double value = 0;
  check(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), "read attribute " + name);
  return value;
}

void Hdf5Reader::verify(std::string const& group) const {
  for (std::string const& name : names(group)) {
    std::string const path = (group == "/" ? "" : group) + "/" + name;
    if (is_group(path)) {
      verify(path);
      continue;
    }
    Handle const dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path + " of " + name_);
    Handle const type(H5Dget_type(dataset), H5Tclose, "read the type of " + path);
    Handle const space(H5Dget_space(dataset), H5Sclose, "read the shape of " + path);
    std::vector<char> data(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(type));
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()),
          "read " + path + " of " + name_ + ", which may be damaged");
  }
}

std::vector<std::string> Hdf5Reader::names(std::string const& group) const {
  Handle const handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, "open " + group + " of " + name_);
  H5G_info_t info;
  check(H5Gget_info(handle, &info), "list " + group);
  std::vector<std::string> out;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::string name(256, '\0');
    check(H5Lget_name_by_idx(handle, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT) < 0 ? -1
                                                                                                                    : 0,
          "list " + group);
    out.push_back(trimmed(name));
  }
  return out;
}

}  // namespace g27
