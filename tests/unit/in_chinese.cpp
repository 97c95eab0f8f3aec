// What is refused, said in Chinese.
#include "first_contact/program/in_chinese.hpp"

#include <filesystem>
#include <regex>

#include "catch.hpp"
#include "first_contact/files/input.hpp"
#include "places.hpp"

namespace fs = std::filesystem;
using namespace first_contact;
using namespace first_contact::program;

namespace {

// As a part of a saying, or, with a value in it, as one.
bool is_said(const std::string& words) {
  for (const Saying& saying : sayings())
    if (saying.english.find(words) != saying.english.npos) return true;
  return in_chinese(words) != words || in_chinese(words + " 7") != words + " 7";
}

int values_of(std::string_view pattern) {
  int count = 0;
  for (std::size_t at = pattern.find("{}"); at != pattern.npos; at = pattern.find("{}", at + 2)) ++count;
  return count;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* folder : {"common/first_contact", "chapters"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(places::source) / folder)) {
      const std::string path = entry.path().generic_string();
      const bool of_students = path.find("/exercises/") != path.npos || path.find("/workbook/") != path.npos;
      if (entry.path().extension() == ".cpp" && !of_students) files.push_back(entry.path());
    }
  return files;
}

// The parts of messages in a source that tell a rule, without what stands around them.
std::vector<std::string> rules_in(const std::string& text) {
  const std::regex code("^[^\"\n]*//.*$|static_assert\\([^;]*;", std::regex::multiline);
  const std::regex rule("\"[ :),]*((?:[^\"\\\\\n]*[^a-z\"])?(?:must|cannot be) [^\"\\\\\n]*?)[ (]*[\"\\\\]");
  const std::string bare = std::regex_replace(text, code, "");
  std::vector<std::string> rules;
  for (std::sregex_iterator each(bare.begin(), bare.end(), rule), end; each != end; ++each)
    rules.push_back((*each)[1]);
  return rules;
}

}  // namespace

TEST_CASE("Each rule that the library or a chapter names is known in Chinese") {
  std::size_t found = 0;
  for (const fs::path& file : sources()) {
    if (file.filename() == "sayings.cpp") continue;
    for (const std::string& rule : rules_in(read_file(file))) {
      CAPTURE(file.string(), rule);
      CHECK(is_said(rule));
      ++found;
    }
  }
  CHECK(found > 140);
}

TEST_CASE("A saying has the same values in both languages") {
  for (const Saying& saying : sayings()) {
    CAPTURE(saying.english);
    CHECK(values_of(saying.english) == values_of(saying.chinese));
  }
}

TEST_CASE("Each saying is reached: none before it takes its messages") {
  for (const Saying& saying : sayings()) {
    const std::string message = std::regex_replace(std::string(saying.english), std::regex("\\{\\}"), "7");
    const std::string wanted = std::regex_replace(std::string(saying.chinese), std::regex("\\{\\}"), "7");
    CHECK(in_chinese(message) == wanted);
  }
}

TEST_CASE("Each part between colons is put into Chinese, and what is a value stays as it is") {
  CHECK(in_chinese("--radius -1: must not be negative") == "--radius -1：不可為負");
  CHECK(in_chinese("--mesh a.obj: a.obj, line 3: must be a number") ==
        "--mesh a.obj：a.obj 第 3 行：必須是數字");
  CHECK(in_chinese("--at 9: must be in the film, from 0 to 2") == "--at 9：必須在影片之內，從 0 到 2");
  CHECK(in_chinese("no words of ours") == "no words of ours");
  CHECK(in_chinese("") == "");
}
