#pragma once
/// Entry of a table by name, for the commands.
#include <algorithm>
#include <string>
#include <vector>

#include "studies/driver/input_error.hpp"
#include "studies/driver/nearest_key.hpp"

namespace g27 {

/// The entry called `name`; throws InputError naming the nearest. `command` is "g27 case".
template <class Entry>
Entry find_by_name(std::vector<Entry> const& table, std::string const& name, std::string const& command) {
  std::vector<std::string> names;
  for (Entry const& entry : table) {
    if (entry.name == name) {
      return entry;
    }
    names.push_back(entry.name);
  }
  throw InputError(command, name, "there is nothing of that name", suggestion(name, names));
}

}  // namespace g27
