#include "first_contact/program/command_line.hpp"

#include <algorithm>
#include <set>

#include "first_contact/files/output.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/program/numbers.hpp"
#include "first_contact/program/one_file.hpp"

namespace first_contact::program {

namespace {

// The option of that name that needs a value, if there is one.
const CLI::Option* option_with_value(const CLI::App& line, const std::string& name) {
  const CLI::Option* const option = name.starts_with("--") ? line.get_option_no_throw(name) : nullptr;
  return option != nullptr && option->get_items_expected_max() > 0 ? option : nullptr;
}

bool is_written(const CLI::Option& option) { return option.get_type_name().starts_with("OUT"); }

bool names_a_file(const CLI::Option& option) {
  const std::string letters = option.get_type_name();
  return letters.find("FILE") != std::string::npos || letters.find('.') != std::string::npos;
}

}  // namespace

Language language_asked(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--lang=zh-TW" || (words[i] == "zh-TW" && i > 0 && words[i - 1] == "--lang"))
      return Language::chinese;
  return Language::english;
}

void require_different_files(const CLI::App& line) {
  const auto files = line.get_options(
      [](const CLI::Option* option) { return option->count() > 0 && names_a_file(*option); });
  for (const CLI::Option* out : files)
    for (const CLI::Option* other : files) {
      if (out == other || !is_written(*out)) continue;
      const auto name = out->as<std::string>();
      if (are_one_file(other->as<std::string>(), name))
        throw Refused(out->get_name() + " " + printable(name) + ": must be another file than " +
                      other->get_name());
    }
}

void require_writable_files(const CLI::App& line) {
  for (const CLI::Option* out : line.get_options()) {
    if (out->count() == 0 || !is_written(*out)) continue;
    const auto name = out->as<std::string>();
    try {
      require_writable(name);
    } catch (const FileError& error) {
      throw Refused(out->get_name() + " " + printable(name) + ": " + error.what());
    }
  }
}

std::vector<std::string> arguments_of(const CLI::App& line, int argc, const char* const* argv) {
  std::vector<std::string> arguments;
  std::set<const CLI::Option*> given;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], name = word.substr(0, word.find('='));
    arguments.push_back(word);
    const CLI::Option* const option = option_with_value(line, name);
    if (option == nullptr && line.get_option_no_throw(word) == nullptr)
      throw Refused((word.empty() ? "''" : printable(word)) + ": must be an option that --help lists");
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
