#include "first_contact/program/help.hpp"

namespace first_contact::program {

std::string Help::of(CLI::App& line, Language language) const {
  const std::string options = Text{"Options", "選項"}.in(language);
  line.description(purpose.in(language));
  for (const auto& [option, meaning] : meanings) option->description(meaning.in(language))->group(options);
  if (language == Language::chinese) {
    line.get_formatter()->label("Usage", "用法");
    line.get_formatter()->label("OPTIONS", options);
  }
  return line.help();
}

}  // namespace first_contact::program
