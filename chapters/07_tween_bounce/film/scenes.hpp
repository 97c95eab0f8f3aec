#pragma once
#include <span>
#include <string>
#include <string_view>

namespace tween_bounce {

/// A film that is built in.
struct BuiltIn {
  std::string_view name;
  std::string_view text;  ///< as a file would have it
};

/// All of them.
std::span<const BuiltIn> scenes();
/// Their names, with commas between them.
std::string scene_names();

}  // namespace tween_bounce
