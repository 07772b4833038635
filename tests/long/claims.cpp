/// The claims that hold, held: the program's own studies and its default scene end with exit status 0.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/catch.hpp"

namespace {

/// Exit status of the program with these arguments, its results in a folder that is removed afterwards.
int exit_status(std::string const& arguments) {
  std::filesystem::path const out =
      std::filesystem::temp_directory_path() / ("g27-claims-" + std::to_string(static_cast<long>(getpid())));
  std::string const command =
      std::string{G27_PROGRAM} + " " + arguments + " --out " + out.string() + " > /dev/null 2>&1";
  int const status = std::system(command.c_str());
  std::filesystem::remove_all(out);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

// A study fails when one of its findings does: each states its own bound. shock-tubes and work-precision-1d are not
// here, since they report bounds that no scheme meets and times of the machine.
TEST_CASE("every scheme shows its order on every law and mesh", "[claims]") {
  CHECK(exit_status("study order-1d") == 0);
}
TEST_CASE("CFL 0.8 is stable in every symmetry", "[claims]") { CHECK(exit_status("study stability-1d") == 0); }
TEST_CASE("a million Riemann problems are solved to round-off", "[claims]") {
  CHECK(exit_status("study riemann-stress") == 0);
}
TEST_CASE("a charge in air and in spheres meets what it expects", "[claims]") {
  CHECK(exit_status("run tnt-rdx-sphere") == 0);
}
