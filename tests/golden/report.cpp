#include "catch.hpp"
#include "places.hpp"
#include "run_program.hpp"

namespace {

void check_report(const Chapter& chapter, const std::string& language, const std::string& file) {
  CAPTURE(chapter.program, language);
  const auto expected = content_of(std::filesystem::path(first_contact::places::source) / "chapters" /
                                   chapter.folder / (chapter.program + file));
  const Run run = run_program(chapter.program, {"--no-figures", "--lang", language});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  REQUIRE_FALSE(expected.empty());
  CHECK(run.out == expected);
}

}  // namespace

TEST_CASE("There are eight chapters") { CHECK(all_chapters().size() == 8); }

TEST_CASE("Each chapter prints the report that stands beside it") {
  for (const Chapter& chapter : all_chapters()) check_report(chapter, "en", ".expected");
}

TEST_CASE("Each chapter prints its report in Traditional Chinese") {
  for (const Chapter& chapter : all_chapters()) check_report(chapter, "zh-TW", ".zh-TW.expected");
}
