#pragma once
#include <string>

namespace first_contact::program {

/// The languages that the chapters speak: English, and Traditional Chinese as the paper does.
enum class Language { english, chinese };

/// One wording in both languages.
struct Text {
  std::string english;  ///< the English wording
  std::string chinese;  ///< the Traditional Chinese one

  /// The wording in that language.
  const std::string& in(Language language) const { return language == Language::chinese ? chinese : english; }
};

/// How many columns of a terminal a UTF-8 text takes: two for each Chinese character, none for a combining
/// mark.
std::size_t columns(const std::string& text);

/// The text followed by spaces up to the given number of columns.
std::string padded(const std::string& text, std::size_t width);

}  // namespace first_contact::program
