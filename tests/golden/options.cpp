#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "catch.hpp"
#include "run_program.hpp"

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Bad {
  std::string program;
  std::vector<std::string> arguments;
  std::vector<std::string> named;  // what the one line must name: option, value, rule
};

const std::vector<Bad> all_bad{
    {"tween_bounce", {"--film", "{\"ball\":"}, {"--film", "line 1", "must be JSON (unexpected end of input"}},
    {"tween_bounce", {"--film", "{\"ball\": [1, 1e999]}"}, {"--film", "ball[1]", "range of numbers"}},
    {"plane", {"--plane", "0,0,0,1"}, {"--plane", "0,0,0,1", "not zero"}},
    {"plane", {"--plane", "0,0,1"}, {"--plane", "0,0,1", "4 numbers"}},
    {"plane", {"--plane", "0,0,nan,1"}, {"--plane", "nan", "finite"}},
    {"plane", {"--radius", "-1"}, {"--radius", "-1", "not be negative"}},
    {"plane", {"--radius=inf"}, {"--radius", "inf", "finite"}},
    {"plane", {"--radius", "1m"}, {"--radius", "1m", "number"}},
    {"plane", {"--from", "1,2"}, {"--from", "1,2", "3 numbers"}},
    {"plane", {"--from", "1,2,3,4"}, {"--from", "1,2,3,4", "3 numbers"}},
    {"plane", {"--from", "1,,3"}, {"--from", "1,,3", "number"}},
    {"plane", {"--to", "1e308,0,0", "--from", "-1e308,0,0"}, {"--to", "1e308,0,0", "finite"}},
    {"plane", {"--lang", "fr"}, {"--lang", "fr", "en|zh-TW"}},
    {"plane", {"--format", "bmp"}, {"--format", "bmp", "svg|png|pdf"}},
    {"plane", {"--radius", "1", "--radius=2"}, {"--radius 2", "only once"}},
    {"plane", {"--radius=", "--json"}, {"--radius ''", "not empty"}},
    {"plane", {"--values", "", "--no-figures"}, {"--values ''", "not empty"}},
    {"plane", {"--style", "."}, {"--style .", "file"}},
    {"plane", {"--colour", "red"}, {"--colour", "an option"}},
    {"plane", {""}, {"''", "an option"}},
    {"plane", {"--colour=red"}, {"--colour=red", "an option"}},
    {"plane", {"-r", "1"}, {"-r", "an option"}},
    {"plane", {"--json=yes"}, {"--json=yes", "an option"}},
    {"plane", {"extra"}, {"extra", "an option"}},
    {"plane", {"--radius", "1", "2"}, {"2", "an option"}},
    {"plane", {"--radius"}, {"--radius"}},
    {"box", {"--r", "1,0,0", "--s", "1,1,0"}, {"perpendicular"}},
    {"box", {"--plane", "0,0,0,1"}, {"--plane", "0,0,0,1", "not zero"}},
    {"box", {"--t", "0,0,nan"}, {"--t", "nan", "finite"}},
    {"partitioning", {"--objects", "-5"}, {"--objects", "-5"}},
    {"partitioning", {"--objects", "many"}, {"--objects", "many", "whole number"}},
    {"partitioning", {"--seed", "0.5"}, {"--seed", "0.5", "whole number"}},
    {"partitioning", {"--mesh", "/nowhere/at.off"}, {"--mesh", "/nowhere/at.off"}},
    {"partitioning", {"--pointer", "1"}, {"--pointer", "1", "2 numbers"}},
    {"partitioning", {"--radius", "-1"}, {"--radius", "-1", "not be negative"}},
    {"general_sphere", {"--radius", "-0.1"}, {"--radius", "-0.1", "not be negative"}},
    {"general_sphere", {"--mesh", "/nowhere/at.off"}, {"--mesh", "/nowhere/at.off"}},
    {"general_sphere",
     {"--casts", "/nowhere/in.csv", "--results", "never.csv"},
     {"--casts", "/nowhere/in.csv"}},
    {"general_sphere", {"--results", "never.csv"}, {"--results", "never.csv", "--casts"}},
    {"slide", {"--radius", "-0.1"}, {"--radius", "-0.1", "not be negative"}},
    {"slide", {"--mesh", "/nowhere/at.obj"}, {"--mesh", "/nowhere/at.obj"}},
    {"moving_spheres", {"--rp", "-2"}, {"--rp", "-2", "not be negative"}},
    {"moving_spheres", {"--interval", "3,1"}, {"--interval", "3,1"}},
    {"moving_spheres", {"--interval", "0"}, {"--interval", "0", "2 numbers"}},
    {"tween_bounce", {"--g", "nan"}, {"--g", "nan", "finite"}},
    {"tween_bounce", {"--dt", "0"}, {"--dt", "0"}},
    {"tween_bounce", {"--samples", "0"}, {"--samples", "0"}},
    {"tween_bounce", {"--restitution", "1.5"}, {"--restitution", "1.5", "from 0 to 1"}},
    {"tween_bounce", {"--model", "magic"}, {"--model", "magic", "printed|physical"}},
    {"tween_bounce", {"--csv", "/nowhere/out.csv"}, {"/nowhere/out.csv"}},
    {"angle_demo", {"--mass", "0,1"}, {"--mass", "0,1", "greater than zero"}},
    {"angle_demo", {"--mass", "5"}, {"--mass", "5", "2 numbers"}},
    {"angle_demo", {"--restitution", "-0.1"}, {"--restitution", "-0.1", "from 0 to 1"}},
    {"angle_demo", {"--model", "magic"}, {"--model", "magic", "printed|contact"}},
    {"angle_demo", {"--p1", "1,2,3"}, {"--p1", "1,2,3", "2 numbers"}},
};

std::string text_of(const std::vector<std::string>& arguments) {
  std::string text;
  for (const auto& argument : arguments) text += " " + argument;
  return text;
}

json json_of(const std::string& program, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "--no-figures"});
  const Run run = run_program(program, arguments);
  CAPTURE(program, text_of(arguments), run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out);
}

}  // namespace

TEST_CASE("A bad value is refused in one line that names option, value and rule, with status 2 and no file") {
  for (const Bad& bad : all_bad) {
    const TemporaryFolder folder;
    const Run run = run_program(bad.program, bad.arguments, folder.path());
    CAPTURE(bad.program, text_of(bad.arguments), run.err);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    for (const auto& part : bad.named) {
      CAPTURE(part);
      CHECK(run.err.find(part) != std::string::npos);
    }
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("Each program explains itself with --help, and names every common option") {
  for (const Chapter& chapter : all_chapters()) {
    const Run run = run_program(chapter.program, {"--help"});
    CAPTURE(chapter.program);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    for (const std::string option :
         {"--help", "--out", "--lang", "--json", "--no-figures", "--format", "--theme"})
      CHECK(run.out.find(option) != std::string::npos);
  }
}

TEST_CASE(
    "A bad value is refused in Chinese where Chinese was asked for, and names option and value all the "
    "same") {
  for (const Bad& bad : all_bad) {
    if (bad.arguments.front() == "--lang") continue;
    std::vector<std::string> arguments{"--lang", "zh-TW"};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Run run = run_program(bad.program, arguments);
    CAPTURE(bad.program, text_of(arguments), run.err);
    CHECK(run.status == 2);
    CHECK(run.err.find("：") != std::string::npos);
    for (const std::string english : {"must", "cannot", "exist"})
      CHECK(run.err.find(english) == std::string::npos);
    for (const auto& part : bad.named)
      if (part.starts_with("--")) CHECK(run.err.find(part) != std::string::npos);
  }
}

TEST_CASE("Each program explains the same options in Chinese, each in Chinese") {
  const std::regex option("\n  (--[a-z0-9-]+)");
  for (const Chapter& chapter : all_chapters()) {
    const std::string english = run_program(chapter.program, {"--help"}).out;
    const std::string chinese = run_program(chapter.program, {"--lang=zh-TW", "--help"}).out;
    CAPTURE(chapter.program, chinese);
    std::vector<std::string> names;
    for (std::sregex_iterator each(english.begin(), english.end(), option), end; each != end; ++each)
      names.push_back((*each)[1]);
    CHECK(names.size() > 9);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t from = chinese.find("\n  " + names[i]);
      REQUIRE(from != std::string::npos);
      const std::string told = chinese.substr(
          from, i + 1 < names.size() ? chinese.find("\n  " + names[i + 1]) - from : std::string::npos);
      CAPTURE(told);
      CHECK(std::any_of(told.begin(), told.end(), [](char c) { return (c & '\x80') != 0; }));
    }
  }
}

TEST_CASE("With --json there is nothing but JSON on standard output") {
  for (const Chapter& chapter : all_chapters()) {
    CAPTURE(chapter.program);
    CHECK(json_of(chapter.program, {}).is_object());
  }
}

TEST_CASE("A negative value may follow its option after a space or an equals sign") {
  CHECK(json_of("plane", {"--from", "-1,0,3"}) == json_of("plane", {"--from=-1,0,3"}));
  CHECK(json_of("plane", {"--from", "-.5,0,3"}) == json_of("plane", {"--from=-0.5,0,3"}));
}

TEST_CASE("Numbers in JSON are read back as the doubles that they were") {
  const json result = json_of("plane", {"--from", "0,0,0.1", "--radius", "0", "--to", "0,0,0.3"});
  CHECK(result["distance_start"].get<double>() == 0.1);
  CHECK(result["distance_end"].get<double>() == 0.3);
  CHECK(
      run_program("plane", {"--json", "--no-figures", "--from", "0,0,0.1"}).out.find("0.10000000000000001") !=
      std::string::npos);
}

TEST_CASE("A contact that does not happen is null") {
  CHECK(json_of("plane", {"--to", "0,0,9"})["contact"].is_null());
}

TEST_CASE(
    "A ball that rolls away from all walls touches none, and by its box each tree of boxes leaves out all") {
  const json walls = json_of("partitioning", {"--from", "-1,-1", "--to", "-3,-1"})["walls"];
  CHECK(walls["contact"].is_null());
  for (const char* tree : {"octree", "bvh"}) CHECK(walls[tree]["tests"] == 0);
}

TEST_CASE(
    "A point that rolls down at a wall, 1.2 above it and on its way of 2, touches it after three fifths") {
  const json at_wall = json_of("partitioning", {"--from", "5.4,4.1", "--to", "5.4,2.1", "--radius", "0"});
  CHECK(at_wall["walls"]["contact"]["wall"] == 12);
  CHECK(at_wall["walls"]["contact"]["time"] == Approx(0.6).epsilon(1e-14));
}

TEST_CASE("A pointer in the leaf is found by both hit tests, one beside it by that of the box alone") {
  const json inside = json_of("partitioning", {"--leaf", "5,5", "--pointer", "6,6"});
  const json beside = json_of("partitioning", {"--leaf", "5,5", "--pointer", "7.5,7.5"});
  CHECK(inside["hit_tests"]["point_in_box"] == true);
  CHECK(inside["hit_tests"]["point_in_shape"] == true);
  CHECK(beside["hit_tests"]["point_in_box"] == true);
  CHECK(beside["hit_tests"]["point_in_shape"] == false);
}

TEST_CASE("Without gnuplot a program writes scripts and numbers, and says what is missing") {
  const TemporaryFolder folder;
  const Run run =
      run_with("GNUPLOT", "no-such-gnuplot", "plane", {"--out", (folder.path() / "out").string()});
  CHECK(run.status == 0);
  CHECK(run.err.find("no-such-gnuplot") != std::string::npos);
  CHECK(run.err.find("gnuplot-nox") != std::string::npos);
  CHECK(fs::exists(folder.path() / "out" / "figure-03.gp"));
  CHECK_FALSE(fs::exists(folder.path() / "out" / "figure-03.svg"));
}

TEST_CASE("A locale that is named but not installed changes nothing") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Run run = run_with("LC_ALL", "xx_YY.UTF-8", "plane", {"--out", out});
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(fs::exists(folder.path() / "out" / "figure-03.svg"));
}

TEST_CASE("The user's own settings of gnuplot change no figure") {
  const TemporaryFolder home, other;
  std::ofstream(home.path() / ".gnuplot") << "print \"hello\"\nset samples 3\nset key left\n";
  const auto picture = [&](const TemporaryFolder& where) {
    const Run run =
        run_with("HOME", where.path().string(), "plane", {"--out", (where.path() / "out").string()});
    CAPTURE(run.err);
    CHECK(run.status == 0);
    return content_of(where.path() / "out" / "figure-03.svg");
  };
  CHECK_FALSE(picture(home).empty());
  CHECK(picture(home) == picture(other));
}

TEST_CASE("A TMPDIR that is no folder is named as such, and nothing is written") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Run run = run_with("TMPDIR", "/nowhere", "plane", {"--out", out});
  CHECK(run.status == 1);
  CHECK(run.err.find("TMPDIR '/nowhere': must be a folder") != std::string::npos);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}

TEST_CASE("A gnuplot that fails is noticed: status 1 and its own words") {
  const Run run = run_with("GNUPLOT", "false", "plane", {"--out", TemporaryFolder().path().string()});
  CHECK(run.status == 1);
  CHECK(run.err.find("status 1") != std::string::npos);
}

TEST_CASE("A folder that cannot be made is refused in the name of its option") {
  const TemporaryFolder folder;
  const std::string below_a_file = (folder.path() / "file" / "nowhere").string();
  std::ofstream(folder.path() / "file") << "no folder\n";
  const Run run = run_program("plane", {"--out", below_a_file});
  CHECK(run.status == 2);
  CHECK(run.err.find("--out " + below_a_file) != std::string::npos);
}

TEST_CASE("So is one behind a link that leads nowhere, or of a name that is too long") {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder.path() / "loop");
  std::filesystem::create_symlink("none", folder.path() / "nowhere");
  for (const std::string& out :
       {std::string("loop"), std::string("loop/a"), std::string("nowhere"), std::string(300, 'a')}) {
    const Run run = run_program("plane", {"--out", out}, folder.path());
    CAPTURE(run.err);
    CHECK(run.status == 2);
    CHECK(run.err.starts_with("plane: --out " + out.substr(0, 200)));
    CHECK(run.err.find(": cannot be made (") != std::string::npos);
  }
}
