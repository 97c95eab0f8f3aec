// A figure's script has few digits: what is far from the origin must not be drawn by them alone.
#include <fstream>
#include <regex>

#include "catch.hpp"
#include "run_program.hpp"

namespace {

// All numbers of the still picture of a ball that falls onto a floor, at these places across.
std::vector<double> drawn(const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "film.json")
      << R"({"ball": {"radius": 0.5}, "obstacles": [{"plane": [0, 0, 1, 0]}], "keys": [{"time": 0, "place": [)"
      << from << R"(, 0, 3]}, {"time": 1, "place": [)" << to << ", 0, -3]}]}";
  const Run run =
      run_program("tween_bounce", {"--film", "film.json", "--out", "out", "--fps", "5"}, folder.path());
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const std::string text = content_of(folder.path() / "out" / "film.svg");
  const std::regex number(R"([-+]?([0-9]+\.?[0-9]*|\.[0-9]+))");
  std::vector<double> all;
  for (std::sregex_iterator found(text.begin(), text.end(), number), none; found != none; ++found)
    all.push_back(std::stod(found->str()));
  return all;
}

}  // namespace

TEST_CASE("A film far from the origin is drawn as one at the origin") {
  const auto near = drawn("0", "4");
  CHECK(near.size() > 300);
  for (const auto& far : {drawn("1e5", "100004"), drawn("-999000", "-998996")}) {
    REQUIRE(far.size() == near.size());
    // The gap of a contact is a part of the scene's size, so that places differ by a thousandth.
    for (std::size_t i = 0; i < near.size(); ++i) CHECK(far[i] == Approx(near[i]).margin(0.5));
  }
}
