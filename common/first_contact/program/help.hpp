#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "first_contact/program/language.hpp"

namespace first_contact::program {

/// What `--help` says: of the program, and of each of its options.
struct Help {
  Text purpose;                                           ///< of the program, one line
  std::vector<std::pair<CLI::Option*, Text>> meanings{};  ///< of the options

  /// All of it, in that language.
  std::string of(CLI::App& line, Language language) const;
};

}  // namespace first_contact::program
