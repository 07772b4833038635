/// HDF5 files: what is written is read back; a write that fails leaves the previous file and says why.
#include "studies/driver/hdf5_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "studies/driver/atomic_file.hpp"
#include "tests/catch.hpp"

namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / ("g27-hdf5-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("data, shapes, units and texts survive a round trip", "[hdf5]") {
  Folder const folder;
  fs::path const file = folder.path / "a.h5";
  std::vector<double> const data{1.0, -0.1, 1e-308, 1e308, 0.0, 3.0};
  {
    g27::Hdf5Writer out;
    out.write("/state/0000/density", data, "kg/m3", {2, 3});
    out.write("/empty", {}, "1");
    out.write_text("/provenance/scene", "title = \"\u00b5\"\n[time]\n");
    out.write_texts("/names", {"a", "longer", ""});
    out.attribute("/state/0000", "time", 0.25);
    out.attribute("/state/0000", "label", std::string("x"));
    out.save(file);
  }
  g27::Hdf5Reader const in(file);
  CHECK(in.read("/state/0000/density") == data);  // bit by bit
  CHECK(in.shape("/state/0000/density") == std::vector<std::uint64_t>{2, 3});
  CHECK(in.text_attribute("/state/0000/density", "units") == "kg/m3");
  CHECK(in.read("/empty").empty());
  CHECK(in.read_text("/provenance/scene") == "title = \"\u00b5\"\n[time]\n");
  CHECK(in.number_attribute("/state/0000", "time") == 0.25);
  CHECK(in.text_attribute("/state/0000", "label") == "x");
  CHECK(in.names("/") == std::vector<std::string>{"empty", "names", "provenance", "state"});
  CHECK_FALSE(in.has("/state/0001"));
  CHECK_FALSE(in.has("/nothing/here"));
}

TEST_CASE("misuse and damage are errors, not crashes", "[hdf5]") {
  Folder const folder;
  g27::Hdf5Writer out;
  std::vector<double> const data{1, 2, 3};
  out.write("/a", data, "m");
  CHECK_THROWS_AS(out.write("/a", data, "m"), g27::OutputError);          // exists
  CHECK_THROWS_AS(out.write("/b", data, "m", {2, 2}), g27::OutputError);  // wrong shape
  CHECK_THROWS_AS(out.attribute("/none", "t", 1.0), g27::OutputError);    // no such object
  out.save(folder.path / "a.h5");
  CHECK_THROWS_AS(g27::Hdf5Reader(folder.path / "a.h5").read("/none"), g27::OutputError);
  CHECK_THROWS_AS(g27::Hdf5Reader(folder.path / "none.h5"), g27::OutputError);
  std::ofstream(folder.path / "damaged.h5") << "not an HDF5 file";
  CHECK_THROWS_AS(g27::Hdf5Reader(folder.path / "damaged.h5"), g27::OutputError);
  fs::resize_file(folder.path / "a.h5", fs::file_size(folder.path / "a.h5") / 2);
  CHECK_THROWS_AS(g27::Hdf5Reader(folder.path / "a.h5"), g27::OutputError);
}

TEST_CASE("what is no file is not written over", "[hdf5]") {
  Folder const folder;
  fs::path const pipe = folder.path / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_AS(g27::write_atomically(pipe, "text"), g27::OutputError);
  CHECK(fs::is_fifo(pipe));
}

// Any byte of the data may be hit; checksums of the chunks are the property. Data of 8 kB holds no byte of metadata.
TEST_CASE("data of which one bit has changed is not read", "[hdf5]") {
  Folder const folder;
  fs::path const file = folder.path / "a.h5";
  std::vector<double> data(1000);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = 1e6 + static_cast<double>(i);
  {
    g27::Hdf5Writer out;
    out.write("/state/density", data, "kg/m3");
    out.write_text("/title", "x");
    out.save(file);
  }
  CHECK_NOTHROW(g27::Hdf5Reader(file).verify());
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::string const number(reinterpret_cast<char const*>(&data[500]), sizeof(double));
  std::size_t const at = bytes.find(number);
  REQUIRE(at != std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  std::ofstream(file, std::ios::binary) << bytes;
  CHECK_THROWS_AS(g27::Hdf5Reader(file).read("/state/density"), g27::OutputError);
  CHECK_THROWS_AS(g27::Hdf5Reader(file).verify(), g27::OutputError);
}

TEST_CASE("a failing disk leaves the previous complete file", "[hdf5]") {
  Folder const folder;
  fs::path const file = folder.path / "a.h5";
  std::vector<double> const small(10, 1.0), large(200000, 2.0);
  {
    g27::Hdf5Writer out;
    out.write("/x", small, "m");
    out.save(file);
  }
  {
    // A limit on the file size stands for a full disk: write() fails half-way.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit const tight{100000, before.rlim_max};
    g27::Hdf5Writer out;
    out.write("/x", large, "m");
    setrlimit(RLIMIT_FSIZE, &tight);
    bool refused = false;
    std::string message;
    try {
      out.save(file);
    } catch (g27::OutputError const& error) {
      refused = true;
      message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(refused);
    CHECK(message.find("File too large") != std::string::npos);
    CHECK(message.find(file.string()) != std::string::npos);
  }
  CHECK(g27::Hdf5Reader(file).read("/x") == small);
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);  // no litter
}

TEST_CASE("a folder that is not there is reported", "[hdf5]") {
  CHECK_THROWS_AS(g27::write_atomically("/nonexistent/folder/file", std::string_view("x")), g27::OutputError);
}

TEST_CASE("a writer killed at any moment leaves a complete file", "[hdf5]") {
  Folder const folder;
  fs::path const file = folder.path / "a.h5";
  for (int round = 0; round < 8; ++round) {
    pid_t const child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      for (double n = 0;; ++n) {
        g27::Hdf5Writer out;
        out.write("/x", std::vector<double>(50000, n), "1");
        out.save(file);
      }
    }
    while (!fs::exists(file)) {
      usleep(1000);
    }
    usleep(static_cast<useconds_t>(7000 + 3100 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    auto const x = g27::Hdf5Reader(file).read("/x");
    REQUIRE(x.size() == 50000);
    CHECK(x.front() == x.back());  // one generation, not a mixture of two
  }
}
