#pragma once
#include <span>
#include <string>
#include <string_view>

namespace first_contact::program {

/// What a message says, in both languages; {} stands for a value, the same ones in the same order.
struct Saying {
  std::string_view english;  ///< as the library throws it
  std::string_view chinese;  ///< as written in Taiwan
};

/// All that the library and the chapters say when they refuse something.
std::span<const Saying> sayings();

/// A message, "--radius -1: must not be negative", in Traditional Chinese. The library speaks English; each part between
/// colons is put into Chinese here, and one that sayings() does not know, such as a value, stays as it is.
std::string in_chinese(std::string_view message);

}  // namespace first_contact::program
