#include "first_contact/program/command_line.hpp"

#include "first_contact/files/printable.hpp"
#include "first_contact/program/numbers.hpp"

namespace first_contact::program {

namespace {

// Is this the name of an option alone, whose value is the next word?
bool wants_value(const CLI::App& line, const std::string& word) {
  const CLI::Option* const option = word.starts_with("--") ? line.get_option_no_throw(word) : nullptr;
  return option != nullptr && option->get_items_expected_max() > 0;
}

}  // namespace

std::vector<std::string> arguments_of(const CLI::App& line, int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    arguments.push_back(word);
    if (!wants_value(line, word)) continue;
    if (++i == argc) throw Refused(word + ": must have a value");
    const std::string value = argv[i];
    if (value.starts_with("--"))
      throw Refused(word + ": must have a value, not " + printable(value) + " (or " + word + "=" +
                    printable(value) + ")");
    arguments.back() += "=" + value;
  }
  return {arguments.rbegin(), arguments.rend()};
}

}  // namespace first_contact::program
