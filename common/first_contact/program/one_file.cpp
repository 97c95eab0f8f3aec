#include "first_contact/program/one_file.hpp"

#include <filesystem>

namespace first_contact::program {

bool are_one_file(const std::string& one, const std::string& other) {
  namespace fs = std::filesystem;
  std::error_code none;
  if (fs::exists(one, none)) return fs::is_regular_file(one, none) && fs::equivalent(one, other, none);
  const auto place = [&](const std::string& name) {
    return fs::weakly_canonical(fs::absolute(name, none), none);
  };
  const fs::path there = place(one);  // empty where there can be no file
  return !fs::exists(other, none) && !there.empty() && there == place(other);
}

}  // namespace first_contact::program
