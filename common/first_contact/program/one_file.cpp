#include "first_contact/program/one_file.hpp"

#include <filesystem>

namespace first_contact::program {

bool are_one_file(const std::string& one, const std::string& other) {
  std::error_code none;
  return std::filesystem::is_regular_file(one, none) && std::filesystem::equivalent(one, other, none);
}

}  // namespace first_contact::program
