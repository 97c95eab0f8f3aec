#include "first_contact/program/command_line.hpp"

#include <algorithm>
#include <set>

#include "first_contact/files/printable.hpp"
#include "first_contact/program/numbers.hpp"

namespace first_contact::program {

namespace {

// The option of that name that needs a value, if there is one.
const CLI::Option* option_with_value(const CLI::App& line, const std::string& name) {
  const CLI::Option* const option = name.starts_with("--") ? line.get_option_no_throw(name) : nullptr;
  return option != nullptr && option->get_items_expected_max() > 0 ? option : nullptr;
}

}  // namespace

std::vector<std::string> arguments_of(const CLI::App& line, int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  std::set<const CLI::Option*> given;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], name = word.substr(0, word.find('='));
    arguments.push_back(word);
    const CLI::Option* const option = option_with_value(line, name);
    if (option == nullptr) continue;
    std::string value = word.substr(std::min(name.size() + 1, word.size()));
    if (name == word) {
      if (++i == argc) throw Refused(word + ": must have a value");
      value = argv[i];
      if (value.starts_with("--"))
        throw Refused(word + ": must have a value, not " + printable(value) + " (or " + word + "=" +
                      printable(value) + ")");
      arguments.back() += "=" + value;
    }
    if (value.empty()) throw Refused(name + " '': must have a value that is not empty");
    if (!given.insert(option).second)
      throw Refused(name + " " + printable(value) + ": must be given only once");
  }
  return {arguments.rbegin(), arguments.rend()};
}

}  // namespace first_contact::program
