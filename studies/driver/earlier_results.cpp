#include "studies/driver/earlier_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/input_error.hpp"

namespace g27 {
namespace {

namespace fs = std::filesystem;

struct Results {
  std::vector<std::string> files;  ///< the summary last
  bool complete = false;
};

Results results_in(fs::path const& folder) {
  std::ifstream file(folder / "summary.json");
  auto const summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("runs")) return {};
  Results out{.files = {}, .complete = true};
  for (auto const& run : summary["runs"]) {
    std::string const name = run.value("name", ""), scheme = run.value("scheme", "");
    if (name.empty() || name.find('/') != std::string::npos) continue;
    for (char const* ending : {".h5", ".xdmf", ".state", ".failure.json"}) out.files.push_back(name + ending);
    if (name.size() > scheme.size() + 1) out.files.push_back(name.substr(0, name.size() - scheme.size() - 1) + ".png");
    out.complete = out.complete && run.value("complete", false);
  }
  for (char const* name :
       {"runs.csv", "saved.csv", "bodies.csv", "problems.csv", "ledger.csv", "verdict.csv", "summary.json"})
    out.files.emplace_back(name);
  return out;
}

void remove_results(fs::path const& folder) {
  std::error_code ignored;
  for (std::string const& name : results_in(folder).files) fs::remove_all(folder / name, ignored);
}

}  // namespace

EarlierResults::EarlierResults(fs::path const& out) : out_(out), aside_(out / "earlier") {}

EarlierResults::~EarlierResults() {
  std::error_code ignored;
  if (fs::exists(aside_ / "summary.json", ignored)) {
    fmt::print(stderr, "the results of the run before are in {} until a run is complete\n", aside_.string());
  }
}

void EarlierResults::set_aside() const {
  Results const results = results_in(out_);
  if (!results.complete) {
    remove_results(out_);
    return;
  }
  remove();
  make_output_folder(aside_);
  for (std::string const& name : results.files) {
    std::error_code error;
    fs::rename(out_ / name, aside_ / name, error);
    if (error && error != std::errc::no_such_file_or_directory) {
      throw InputError("g27 run", "--out",
                       fmt::format("cannot set aside {}: {}", (out_ / name).string(), error.message()),
                       "choose another folder");
    }
  }
}

void EarlierResults::remove() const {
  remove_results(aside_);
  std::error_code ignored;
  fs::remove(aside_, ignored);  // unless it holds something else
}

}  // namespace g27
