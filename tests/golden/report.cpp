#include <nlohmann/json.hpp>

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

TEST_CASE("The chapters are those that the notes list, in their order, from the first eight on") {
  const auto listed = nlohmann::json::parse(
      content_of(std::filesystem::path(first_contact::places::source) / "docs/chapters.json"));
  const std::vector<Chapter> chapters = all_chapters();
  CHECK(chapters.size() >= 8);
  REQUIRE(chapters.size() == listed.size());
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    CHECK(chapters[i].folder == listed[i]["folder"].get<std::string>());
    CHECK(chapters[i].program == listed[i]["program"].get<std::string>());
  }
}

TEST_CASE("Each chapter prints the report that stands beside it") {
  for (const Chapter& chapter : all_chapters()) check_report(chapter, "en", ".expected");
}

TEST_CASE("Each chapter prints its report in Traditional Chinese") {
  for (const Chapter& chapter : all_chapters()) check_report(chapter, "zh-TW", ".zh-TW.expected");
}
