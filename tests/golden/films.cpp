// Films as a user has them: by a word or a file, on the command line.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hpp"
#include "places.hpp"
#include "run_program.hpp"

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string keys = R"("keys": [{"time": 0, "place": [0, 0, 3], "easing": "in quadratic"},
  {"time": 2, "place": [4, 0, -2]}])";
const std::string bounce = R"({"ball": {"radius": 0.5}, )" + keys + R"(,
  "obstacles": [{"plane": [0, 0, 1, 0]}], "contact": {"do": "bounce", "restitution": 0.5},
  "view": {"tilt": 90, "turn": 0}})";

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

Run run_film(const TemporaryFolder& folder, const std::string& text, std::vector<std::string> options = {}) {
  write(folder.path() / "film.json", text);
  options.insert(options.begin(), {"--film", "film.json"});
  return run_program("tween_bounce", options, folder.path());
}

json results_of(const std::string& word, std::vector<std::string> options) {
  options.insert(options.end(), {"--film", word, "--json", "--no-figures"});
  const Run run = run_program("tween_bounce", options);
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out);
}

// Refused in one line that begins like that; nothing is written beside the film.
void check_refused(const std::string& text, const std::string& begins,
                   const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  const Run run = run_film(folder, text, options);
  CAPTURE(text, options, run.err);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("tween_bounce: " + begins));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

std::vector<double> numbers_of(std::string text, const std::string& between) {
  for (const char letter : between) std::replace(text.begin(), text.end(), letter, ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

std::vector<std::vector<double>> table_of(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  CHECK(line == "time,x,y,z,qw,qx,qy,qz,scale");
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) rows.push_back(numbers_of(line, ","));
  return rows;
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t from = text.find(before) + before.size();
  return text.substr(from, text.find(after, from) - from);
}

// The middle of the ball's outline at each time of an animation, in pixels.
struct Picture {
  double time, x, y;
};
std::vector<Picture> pictures_of(const std::string& svg) {
  const std::string moving = between(svg, "<polygon", "</polygon>");
  const double seconds = std::stod(between(moving, "dur=\"", "s\""));
  const auto times = numbers_of(between(moving, "keyTimes=\"", "\""), ";");
  std::istringstream outlines(between(moving, "values=\"", "\""));
  std::vector<Picture> all;
  std::string outline;
  for (const double time : times) {
    std::getline(outlines, outline, ';');
    const auto corners = numbers_of(outline, ",");
    Picture picture{time * seconds, 0, 0};
    for (std::size_t i = 0; i < corners.size(); i += 2) {
      picture.x += 2 * corners[i] / static_cast<double>(corners.size());
      picture.y += 2 * corners[i + 1] / static_cast<double>(corners.size());
    }
    all.push_back(picture);
  }
  return all;
}

}  // namespace

TEST_CASE(
    "A bad film is refused in one line that names the file and the place in it, and nothing is written") {
  check_refused(
      R"({"ball": {"radius": 1}, "keys": [{"time": 0.7, "place": [0, 0, 0]}, {"time": 0.5, "place": [0, 0, 0]}]})",
      "--film film.json: keys[1].time: 0.5: must be after the key before, 0.7\n");
  check_refused("{\n  \"ball\": }", "--film film.json: line 2, column 11: ");
  check_refused(R"({"ball": {"radius": NaN}})", "--film film.json: line 1, column ");
  check_refused(R"({"ball": {"radius": 1e999}})",
                "--film film.json: ball.radius: 1e999: must stay within the range of numbers");
  check_refused(R"({"ball": {"radius": 1}, "keys": [{"time": 0, "place": [0, 1, -2e400]}]})",
                "--film film.json: keys[0].place[2]: -2e400: must stay within the range of numbers");
  check_refused(R"({"ball": {"radius": 1}, )" + keys + R"(, "obstacles": [{"mesh": "no.off"}]})",
                "--film film.json: obstacles[0].mesh: \"no.off\": no.off: ");
  check_refused(
      R"({"ball": {"radius": 1}, )" + keys + R"(, "obstacles": [{"mesh": "no\u0000.off"}]})",
      "--film film.json: obstacles[0].mesh: \"no\\u0000.off\": no\\x00.off: must be a file that exists");
  check_refused("", "--film film.json: ");
}

TEST_CASE(
    "A film's options are refused where they make no sense: too many pictures, a time that it has not") {
  check_refused(bounce, "--fps 241: must be from 1 to 240\n", {"--fps", "241"});
  check_refused(bounce, "--at 3: must be in the film, from 0 to 2\n", {"--at", "3"});
  check_refused(bounce, "--v0 1: must not be given with --film\n", {"--v0", "1"});
  const std::string long_one = R"({"ball": {"radius": 1}, "keys": [{"time": 0, "place": [0, 0, 0]},
    {"time": 1000, "place": [0, 0, 0]}]})";
  check_refused(long_one, "--film film.json: pictures 25001: must be at most 2000\n");
}

TEST_CASE("A film's file is read whatever its name begins with") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "{brace}.json") << bounce;
  CHECK(run_program("tween_bounce", {"--film", "{brace}.json", "--no-figures"}, folder.path()).status == 0);
}

TEST_CASE("A word that no film has is told which films there are") {
  const Run run = run_program("tween_bounce", {"--film", "hal"});
  CHECK(run.status == 2);
  CHECK(run.err ==
        "tween_bounce: --film hal: must be a JSON file or its text, { }, or one of hall, crate, ramp, "
        "squash\n");
}

TEST_CASE("Without a film there are neither pictures a second nor a time to freeze it") {
  for (const std::string option : {"--fps", "--at"}) {
    const Run run = run_program("tween_bounce", {option, "2"});
    CHECK(run.status == 2);
    CHECK(run.err == "tween_bounce: " + option + " 2: must not be given without --film\n");
  }
}

TEST_CASE("How many pictures a second a film has does not change what is hit, nor when") {
  for (const std::string word : {"hall", "crate", "ramp"}) {
    const json one = results_of(word, {"--fps", "7"}), other = results_of(word, {"--fps", "60"});
    CHECK(one["pictures"] != other["pictures"]);
    CHECK_FALSE(one["contacts"].empty());
    CHECK(one["contacts"] == other["contacts"]);
    CHECK(one["last"] == other["last"]);
  }
}

TEST_CASE("A film that is frozen ends there: its table, its contacts and where the body is") {
  const TemporaryFolder folder;
  const Run run =
      run_film(folder, bounce, {"--at", "0.5", "--csv", "t.csv", "--fps", "10", "--json", "--no-figures"});
  REQUIRE(run.status == 0);
  const json results = json::parse(run.out);
  const auto rows = table_of(content_of(folder.path() / "t.csv"));
  CHECK(rows.size() == 6);
  CHECK(rows.back()[0] == 0.5);
  CHECK(results["contacts"].empty());
  CHECK(results["last"]["time"] == 0.5);
  for (std::size_t i = 0; i < 3; ++i) CHECK(results["last"]["place"][i] == rows.back()[i + 1]);
  CHECK(rows.back()[3] == 3 - 5 * 0.0625);
}

TEST_CASE("The moving picture is where the table says, at each of its times") {
  const TemporaryFolder folder;
  REQUIRE(run_film(folder, bounce, {"--csv", "t.csv", "--out", "out"}).status == 0);
  const auto rows = table_of(content_of(folder.path() / "t.csv"));
  const auto pictures = pictures_of(content_of(folder.path() / "out" / "film-animated.svg"));
  REQUIRE(rows.size() == 51);
  CHECK(pictures.size() == rows.size() + 2);  // one at the contact, and one that holds the end
  const auto at = [&](double time) {
    return *std::min_element(pictures.begin(), pictures.end(), [&](const Picture& a, const Picture& b) {
      return std::abs(a.time - time) < std::abs(b.time - time);
    });
  };
  const Picture first = at(0), last = at(2);
  const double unit = (last.x - first.x) / (rows.back()[1] - rows.front()[1]);
  CHECK(unit > 10);
  for (const auto& row : rows) {
    CAPTURE(row[0]);
    const Picture picture = at(row[0]);
    CHECK(picture.time == Approx(row[0]).margin(1e-4));
    CHECK(picture.x == Approx(first.x + unit * (row[1] - rows[0][1])).margin(0.1));
    CHECK(picture.y == Approx(first.y - unit * (row[3] - rows[0][3])).margin(0.1));
  }
}

TEST_CASE("A table does not take the place of the film that it is made from") {
  check_refused(bounce, "--csv ./film.json: must be another file than --film\n", {"--csv", "./film.json"});
}

TEST_CASE("Whatever a film's file is called, its pictures have names that any script can say") {
  const TemporaryFolder folder;
  const std::string name = "my \"film\"; `x` 球.json";
  write(folder.path() / name, bounce);
  const Run run = run_program("tween_bounce", {"--film", name, "--out", "out", "--fps", "5"}, folder.path());
  CAPTURE(run.err);
  CHECK(run.status == 0);
  CHECK(fs::exists(folder.path() / "out" / "my--film----x--球.svg"));
  write(folder.path() / "(2).json", bounce);  // no script's name may look like an option
  CHECK(run_program("tween_bounce", {"--film", "(2).json", "--out", "out", "--fps", "5"}, folder.path())
            .status == 0);
  CHECK(fs::exists(folder.path() / "out" / "film-2-.svg"));
}

TEST_CASE("A box that jumps by steps into what is in the way is refused") {
  const std::string film = R"({"box": {"sides": [1, 1, 1]}, "keys": [
    {"time": 0, "place": [0, 0, 2], "easing": {"steps": {"count": 2}}}, {"time": 1, "place": [0, 0, -2]}],
    "obstacles": [{"plane": [0, 0, 1, 0]}]})";
  check_refused(film, "--film film.json: box: must not jump, by steps, into what is in the way\n");
}

TEST_CASE("Lists within lists are refused by the place of the innermost that was read") {
  std::string place;
  for (int i = 0; i < 17; ++i) place += "[0]";
  check_refused(std::string(100, '['),
                "--film film.json: " + place + ": must not be nested deeper than 16\n");
}

TEST_CASE(
    "A film draws a still picture, a script, and one that moves, which is still for those who ask for less "
    "motion") {
  const TemporaryFolder folder;
  REQUIRE(run_film(folder, bounce, {"--out", "out", "--fps", "10"}).status == 0);
  for (const std::string name :
       {"film.gp", "film.svg", "film-animated.gp", "film-animated.svg", "film-animated.gif"})
    CHECK(fs::exists(folder.path() / "out" / name));
  const std::string svg = content_of(folder.path() / "out" / "film-animated.svg");
  CHECK(svg.find("prefers-reduced-motion") != std::string::npos);
  CHECK(content_of(folder.path() / "out" / "film-animated.gif").starts_with("GIF89a"));
}

TEST_CASE("A film bounces off a mesh that lies beside it, whatever folder one is in") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "films");
  write(folder.path() / "films" / "floor.off", "OFF\n4 1 0\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\n4 0 1 2 3\n");
  std::string text = bounce;
  text.replace(text.find("{\"plane\": [0, 0, 1, 0]}"), 23, R"({"mesh": "floor.off"})");
  write(folder.path() / "films" / "film.json", text);
  const Run run =
      run_program("tween_bounce", {"--film", "films/film.json", "--json", "--no-figures"}, folder.path());
  REQUIRE(run.status == 0);
  const json contacts = json::parse(run.out)["contacts"];
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0]["time"] == Approx(std::sqrt(2.0)).margin(1e-8));
}

// Changes one thing in the film of the chapter's recipe, as it says there.
std::string changed(const std::string& from, const std::string& to) {
  std::string text =
      content_of(fs::path(first_contact::places::source) / "chapters/07_tween_bounce/film/ball.json");
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

TEST_CASE(
    "The recipe for a ball of one's own can be played as it stands, and with each change that it names") {
  const std::string first = R"("place": [0, 0, 4])", last = R"("place": [6, 0, -2]})",
                    floor = R"({"plane": [0, 0, 1, 0]})";
  const std::vector<std::string> films{
      changed(first, first),
      changed(first, first + R"(, "easing": "in quadratic")"),
      changed(first, first + R"(, "path": {"kind": "bezier", "points": [[3, 0, 5]]})"),
      changed(last, last + R"(, {"time": 3, "place": [9, 0, 0.5]})"),
      changed(R"("ball":)", R"("through": "centripetal", "ball":)"),
      changed(floor, floor + R"(, {"plane": [-1, 0, 0, 5]})"),
      changed(floor, floor + R"(, {"box": {"sides": [1, 2, 1], "centre": [4, 0, 0.5]}})"),
      changed(last, R"("place": [6, 0, -2], "turn": {"axis": [0, 1, 0], "degrees": 150}})"),
      changed(last, R"("place": [6, 0, -2], "scale": 0.6})"),
      changed(R"("ball":)", R"("view": {"tilt": 60, "turn": 30}, "ball":)")};
  for (const std::string& film : films) {
    const TemporaryFolder folder;
    const Run run = run_film(folder, film, {"--json", "--no-figures"});
    CAPTURE(film, run.err);
    CHECK(run.status == 0);
    CHECK_FALSE(json::parse(run.out)["contacts"].empty());
  }
}

TEST_CASE("The report of a film speaks the language that is asked for") {
  const std::string english = run_program("tween_bounce", {"--film", "hall", "--no-figures"}).out;
  const std::string chinese =
      run_program("tween_bounce", {"--film", "hall", "--no-figures", "--lang", "zh-TW"}).out;
  CHECK(english.find("tested before it is played") != std::string::npos);
  CHECK(chinese.find("先測試路徑，再播放") != std::string::npos);
  CHECK(std::count(english.begin(), english.end(), '\n') == std::count(chinese.begin(), chinese.end(), '\n'));
}
