#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "catch.hpp"
#include "places.hpp"
#include "run_program.hpp"

namespace fs = std::filesystem;

namespace {

// The scripts hold results of sines and roots, whose last digits may differ between two C libraries; they are
// written with at most nine digits, so that they agree to a few units of the fifth at the least.
constexpr double relative = 1e-4;

bool same_word(const std::string& a, const std::string& b) {
  if (a == b) return true;
  char *end_a = nullptr, *end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
  const bool numbers =
      end_a == a.c_str() + a.size() && end_b == b.c_str() + b.size() && !a.empty() && !b.empty();
  return numbers && std::abs(x - y) <= relative * std::max({1.0, std::abs(x), std::abs(y)});
}

// The first words in which two scripts differ, or nothing.
std::string difference(const std::string& drawn, const std::string& committed) {
  std::istringstream a(drawn), b(committed);
  std::string word_a, word_b;
  while (true) {
    const bool more_a = static_cast<bool>(a >> word_a), more_b = static_cast<bool>(b >> word_b);
    if (!more_a && !more_b) return "";
    if (more_a != more_b) return "one is longer";
    if (!same_word(word_a, word_b)) return word_a + " for " + word_b;
  }
}

// SVGs are compared byte for byte only where gnuplot is the version that drew the committed ones.
bool pinned_gnuplot() {
  return run_command("gnuplot", {"--version"}).out.starts_with("gnuplot 5.4 patchlevel 4");
}

void check_chapter(const Chapter& chapter, bool pinned) {
  const TemporaryFolder folder;
  const fs::path committed = fs::path(first_contact::places::source) / "figures" / chapter.folder;
  REQUIRE(run_program(chapter.program, {"--out", folder.path().string()}).status == 0);
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    const fs::path file = entry.path().filename();
    CAPTURE(chapter.folder, file.string());
    const std::string drawn = content_of(entry.path()), kept = content_of(committed / file);
    if (file.extension() == ".gp") CHECK(difference(drawn, kept).empty());
    if (file.extension() == ".svg" && pinned) CHECK((drawn == kept));
    count += file.extension() == ".gp";
  }
  CAPTURE(chapter.folder);
  CHECK(count > 0);
  const auto is_script = [](const auto& entry) { return entry.path().extension() == ".gp"; };
  CHECK(static_cast<std::size_t>(std::count_if(fs::directory_iterator(committed), {}, is_script)) == count);
}

}  // namespace

TEST_CASE("Each chapter draws the figures that are committed: scripts by number, pictures by byte") {
  const bool pinned = pinned_gnuplot();
  for (const Chapter& chapter : all_chapters()) check_chapter(chapter, pinned);
}

TEST_CASE("Every figure of the paper up to 16 is there, as a script and as a picture") {
  for (int number = 1; number <= 16; ++number) {
    const std::string name = (number < 10 ? "figure-0" : "figure-") + std::to_string(number);
    int scripts = 0, pictures = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(first_contact::places::source) / "figures")) {
      scripts += entry.path().filename() == name + ".gp";
      pictures += entry.path().filename() == name + ".svg";
    }
    CAPTURE(name);
    CHECK(scripts == 1);
    CHECK(pictures == 1);
  }
}

TEST_CASE("The comparison of scripts sees a number that is wrong in the third digit") {
  CHECK(difference("1.001 2", "1.002 2") == "1.001 for 1.002");
  CHECK(difference("a 1.00000001", "a 1").empty());
  CHECK(difference("1 2", "1 2 3") == "one is longer");
}
