// What a film file may say, and what becomes of it.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "film/entry.hpp"
#include "film/read_film.hpp"
#include "film/scenes.hpp"
#include "film/showing.hpp"

using namespace first_contact;
using namespace tween_bounce;

namespace {

Film read(const std::string& text) { return film_of(text, "film", "."); }

// A film of a ball, with these two keys and whatever else.
std::string film_with(const std::string& first, const std::string& second, const std::string& rest = "") {
  return R"({"ball": {"radius": 1}, "keys": [)" + first + ", " + second + "]" + rest + "}";
}

const std::string start = R"({"time": 0, "place": [0, 0, 3]})", end = R"({"time": 1, "place": [4, 0, -1]})";
const std::string ground = R"(, "obstacles": [{"plane": [0, 0, 1, 0]}])";

std::string start_with(const std::string& member) {
  return R"({"time": 0, "place": [0, 0, 3], )" + member + "}";
}

// Where a way begins, with an easing or a path of its own.
Point on_way(const std::string& member, double time) {
  return Showing(read(film_with(start_with(member), end))).at(time).place;
}

bool is_near(const Point& p, const Point& q, double margin = 1e-8) { return (p - q).norm() <= margin; }

void check_refused(const std::string& text, const std::string& message) {
  CAPTURE(text);
  CHECK_THROWS_WITH(read(text), message);
}

}  // namespace

TEST_CASE("The smallest film is a ball and two keys, and goes straight from the one to the other") {
  const Film film = read(film_with(start, end));
  const Showing showing(film);
  CHECK(film.walls.empty());
  CHECK(showing.contacts().empty());
  CHECK(showing.at(0).place == Point(0, 0, 3));
  CHECK(showing.at(0.5).place == Point(2, 0, 1));
  CHECK(showing.at(1).place == Point(4, 0, -1));
}

TEST_CASE("A film's ball stops, slides or bounces where it meets the ground, as the film says") {
  const auto last = [](const std::string& contact) {
    return Showing(read(film_with(start, end, ground + R"(, "contact": {"do": )" + contact + "}")))
        .at(1)
        .place;
  };
  CHECK(is_near(last(R"("stop")"), {2, 0, 1}));
  CHECK(is_near(last(R"("slide")"), {4, 0, 1}));
  CHECK(is_near(last(R"("slide", "friction": 0.5)"), {3, 0, 1}));
  CHECK(is_near(last(R"("bounce", "restitution": 0.5)"), {4, 0, 2}));
  CHECK(is_near(last(R"("bounce", "restitution": 0.5, "friction": 0.25)"), {3.25, 0, 2}));
}

TEST_CASE("Each kind of path is the library's own") {
  const auto same = [](const std::string& path, const Path& expected) {
    const Leg leg(expected, {0, 0, 3}, {4, 0, -1});
    for (const double part : {0.1, 0.5, 0.8}) {
      CAPTURE(path, part);
      CHECK(on_way(R"("path": )" + path, part) == leg.at(part));
    }
  };
  const std::vector<Point> points{{1, 2, 3}, {4, 5, 6}};
  const std::string listed = R"("points": [[1, 2, 3], [4, 5, 6]]})";
  same(R"("straight")", {});
  same(R"({"kind": "bezier", )" + listed, Path::bezier(points));
  same(R"({"kind": "bezier", "constant_speed": true, )" + listed, Path::bezier(points, true));
  same(R"({"kind": "b-spline", )" + listed, Path::b_spline(points));
  same(R"({"kind": "catmull-rom", )" + listed, Path::through(points, false, Knots::uniform));
  same(R"({"kind": "centripetal", )" + listed, Path::through(points, false, Knots::centripetal));
  same(R"({"kind": "chordal", )" + listed, Path::through(points, false, Knots::chordal));
  same(R"({"kind": "hermite", "velocities": [[1, 2, 3], [4, 5, 6]]})", Path::hermite({1, 2, 3}, {4, 5, 6}));
}

TEST_CASE("One smooth way goes through all places of a film") {
  const std::string middle = R"({"time": 0.5, "place": [1, 1, 1]})";
  const Showing showing(read(film_with(start + ", " + middle, end, R"(, "through": "centripetal")")));
  CHECK(showing.at(0.5).place == Point(1, 1, 1));
  const double h = 1e-6;
  const Vector before = (showing.at(0.5).place - showing.at(0.5 - h).place) / h;
  const Vector after = (showing.at(0.5 + h).place - showing.at(0.5).place) / h;
  CHECK(normalized(before).dot(normalized(after)) > 1 - 1e-9);
}

TEST_CASE("An easing is a name, a style sheet's, or numbers") {
  const auto height = [](const std::string& easing) {
    return (3 - on_way(R"("easing": )" + easing, 0.5).z()) / 4;
  };
  CHECK(height(R"("linear")") == 0.5);
  CHECK(height(R"("in cubic")") == 0.125);
  CHECK(height(R"("ease-in-out")") == Approx(0.5));
  CHECK(height(R"({"power": 2})") == 0.25);
  CHECK(height(R"({"steps": {"count": 4, "jump": "start"}})") == 0.75);
  CHECK(height(R"({"cubic-bezier": [0.25, 0.1, 0.25, 1]})") == height(R"("ease")"));
  CHECK(height(R"({"spring": {"cycles": 1, "damping": 1}})") > 0.5);
}

TEST_CASE("A pose may be one 4x4 matrix, as the paper has it, and is tweened as place and turn are") {
  const std::string matrix =
      R"({"time": 1, "matrix": [[0, 0, 1, 4], [0, 1, 0, 0], [-1, 0, 0, -1], [0, 0, 0, 1]]})";
  const std::string turned =
      R"({"time": 1, "place": [4, 0, -1], "turn": {"axis": [0, 2, 0], "degrees": 90}})";
  const Showing by_matrix(read(film_with(start, matrix))), by_turn(read(film_with(start, turned)));
  for (const double time : {0.0, 0.3, 1.0}) {
    CHECK(by_matrix.at(time).place == by_turn.at(time).place);
    CHECK(by_matrix.at(time).turn.isApprox(by_turn.at(time).turn, 1e-15));
  }
}

TEST_CASE("A body that is squashed stays as tall as its keys say, half way by the ratio of both") {
  const std::string flat = R"({"time": 1, "place": [4, 0, -1], "scale": 0.25})";
  const Showing showing(read(film_with(start_with(R"("scale": 4)"), flat)));
  CHECK(showing.at(0).scale == 4);
  CHECK(showing.at(0.5).scale == 1);
  CHECK(showing.at(1).scale == 0.25);
}

TEST_CASE("A box that tumbles stops, place and turn, where its corner is at the floor") {
  const Film film = read(R"({"box": {"sides": [2, 2, 2]}, "keys": [{"time": 0, "place": [0, 0, 3]},
    {"time": 1, "place": [0, 0, 0], "turn": {"axis": [0, 1, 0], "degrees": 90}}],
    "obstacles": [{"plane": [0, 0, 1, 0]}]})");
  const Showing showing(film);
  REQUIRE(showing.contacts().size() == 1);
  const Frame last = showing.at(1);
  const Box box = Rigid(Quaternion(last.turn.coeffs()), last.place).box(std::get<Box>(film.actor));
  CHECK(box.center.z() - box.effective_radius({0, 0, 1}) == Approx(0).margin(1e-7));
  CHECK(last.turn.isApprox(showing.at(showing.contacts()[0].time).turn));
}

TEST_CASE("Every film that is built in can be read, and is shown without going into anything") {
  CHECK(scenes().size() >= 3);
  for (const auto& [name, text] : scenes()) {
    CAPTURE(name);
    const Film film = film_named(std::string(name));
    const Showing showing(film);
    for (const double time : picture_times(film.begin(), film.end(), 100))
      for (const Wall& wall : film.walls) {
        const Frame frame = showing.at(time);
        const auto& plane = std::get<Plane>(wall);
        const double side = plane.normal().dot(film.keys.front().place) + plane.offset() < 0 ? -1 : 1;
        const double distance = side * (plane.normal().dot(frame.place) + plane.offset());
        const Sphere* ball = std::get_if<Sphere>(&film.actor);
        const double reach = ball ? ball->radius
                                  : Rigid(Quaternion(frame.turn.coeffs()), Vector::Zero())
                                        .box(std::get<Box>(film.actor))
                                        .effective_radius(plane.normal());
        CHECK(distance >= reach - 1e-7);
      }
  }
}

TEST_CASE("The pictures of a film are evenly spaced, and the last one is its end") {
  CHECK(picture_times(0, 1, 4) == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  CHECK(picture_times(2, 3, 1.5) == std::vector<double>{2, 2 + 1 / 1.5, 3});
  CHECK(picture_times(0, 0.7, 10).size() == 8);
  CHECK(picture_times(5, 5, 25) == std::vector<double>{5});
  CHECK_THROWS_WITH(picture_times(0, 1000, 25), "pictures 25001: must be at most 2000");
}

TEST_CASE("A film that cannot be is refused by the place, the value and the rule: its keys") {
  check_refused(film_with(R"({"time": 0.7, "place": [0, 0, 0]})", R"({"time": 0.5, "place": [0, 0, 0]})"),
                "keys[1].time: 0.5: must be after the key before, 0.7");
  check_refused(R"({"ball": {"radius": 1}, "keys": []})", "keys: []: must not be empty");
  check_refused(R"({"ball": {"radius": 1}, "keys": [)" + start + "]}",
                "keys: [{\"place\":[0,0,3],\"time\":0}]: must be two keys at the least");
  check_refused(R"({"ball": {"radius": 1}})", "keys: is missing");
  check_refused(film_with(start, R"({"time": 1})"), "keys[1].place: is missing");
  check_refused(film_with(start, R"({"time": "1", "place": [0, 0, 0]})"),
                "keys[1].time: \"1\": must be a number");
  check_refused(film_with(start, R"({"time": 1, "place": [0, 0]})"),
                "keys[1].place: [0,0]: must be a list of 3 numbers");
  check_refused(film_with(start, R"({"time": 1, "place": [0, 0, 1e7]})"),
                "keys[1].place[2]: 10000000.0: must be from -1e+06 to 1e+06");
  check_refused(film_with(start, R"({"tiem": 1, "place": [0, 0, 0]})"),
                "keys[1].tiem: 1: is none of time, place, turn, matrix, scale, easing, path");
  check_refused(film_with(start, R"({"time": 1, "place": [0, 0, 0], "easing": "linear"})"),
                "keys[1].easing: \"linear\": must not be in the last key, from which no way goes on");
  check_refused(film_with(start, R"({"time": 1, "place": [0, 0, 0], "scale": 0})"),
                "keys[1].scale: 0: must be from 0.125 to 8");
  check_refused(film_with(start, R"({"time": 1, "place": [0, 0, 0], "turn": [0, 0, 0, 0]})"),
                "keys[1].turn: [0,0,0,0]: must not be zero");
}

TEST_CASE("A film that cannot be is refused by the place, the value and the rule: its ways") {
  const auto way = [](const std::string& member, const std::string& message) {
    check_refused(film_with(start_with(member), end), message);
  };
  way(R"("path": "round")", "keys[0].path: \"round\": must be straight, or an object with its kind");
  way(R"("path": {"kind": "spiral", "points": [[0, 0, 0]]})",
      "keys[0].path.kind: \"spiral\": must be one of bezier, b-spline, catmull-rom, centripetal, chordal, "
      "hermite");
  way(R"("path": {"kind": "bezier", "points": []})", "keys[0].path.points: []: must not be empty");
  way(R"("path": {"kind": "hermite", "velocities": [[1, 2, 3]]})",
      "keys[0].path.velocities: [[1,2,3]]: must be two, at the start and at the end");
  way(R"("path": {"kind": "hermite", "points": [[1, 2, 3]]})",
      "keys[0].path.points: [[1,2,3]]: must not be there for hermite");
  way(R"("path": {"kind": "bezier", "points": [[1, 2, 3]], "constant_speed": 1})",
      "keys[0].path.constant_speed: 1: must be true or false");
  way(R"("easing": {"power": -1})", "keys[0].easing.power: -1: must be from 0 to 100");
  way(R"("easing": {"spring": {"cycles": 0, "damping": 1}})",
      "keys[0].easing.spring.cycles: 0: must be from 0.001 to 64");
  way(R"("easing": {"spring": {"cycles": 1, "damping": 0.001}})",
      "keys[0].easing.spring.damping: 0.001: must be from 0.01 to 100");
  way(R"("easing": {"power": 2, "steps": {"count": 2}})",
      "keys[0].easing: {\"power\":2,\"steps\":{\"count\":2}}: must have one of cubic-bezier, steps, spring, "
      "power, not "
      "more");
  way(R"("easing": {"steps": {"count": 1.5}})", "keys[0].easing.steps.count: 1.5: must be a whole number");
}

TEST_CASE("A film that cannot be is refused by the place, the value and the rule: what is in the way") {
  const auto film = [](const std::string& rest, const std::string& message) {
    check_refused(film_with(start, end, rest), message);
  };
  film(R"(, "obstacles": [])", "obstacles: []: must not be empty");
  film(R"(, "obstacles": [{"plane": [0, 0, 0, 1]}])",
       "obstacles[0].plane: [0,0,0,1]: must have a normal that is not zero");
  film(R"(, "obstacles": [{"plane": [0, 0, 1, -2.5]}])",
       "obstacles[0]: {\"plane\":[0,0,1,-2.5]}: must not be where the body begins");
  film(R"(, "obstacles": [{"box": {"sides": [1, 0, 1]}}])",
       "obstacles[0].box.sides: [1,0,1]: each must be at least 1e-06");
  film(ground + R"(, "contact": {"do": "explode"})",
       "contact.do: \"explode\": must be one of stop, slide, bounce");
  film(ground + R"(, "contact": {"do": "bounce"})", "contact.restitution: is missing");
  film(ground + R"(, "contact": {"do": "bounce", "restitution": 1.5})",
       "contact.restitution: 1.5: must be from 0 to 1");
  film(ground + R"(, "contact": {"do": "stop", "friction": 1})",
       "contact.friction: 1: must not be there, as it is to stop");
  check_refused(R"({"ball": {"radius": 1}, "box": {"sides": [1, 1, 1]}, "keys": 1})",
                "film: {\"ball\":{\"radius\":1},\"box\":{\"sides\":[1,1,1]},\"keys\":1}: must have one of "
                "ball, box, not "
                "more");
  check_refused(R"({"ball": {"radius": 0}, "keys": 1})", "ball.radius: 0: must be from 1e-06 to 1e+06");
}

TEST_CASE("A text that is no JSON, or says a thing twice, is refused") {
  check_refused("[]", "film: []: must be an object, { }");
  check_refused(R"({"ball": {"radius": 1, "radius": 2}})", "ball.radius: must not be given twice");
  check_refused(R"({"keys": [{"time": 0}, {"time": 1, "time": 2}]})",
                "keys[1].time: must not be given twice");
  check_refused(std::string("\xFF\xFE{\0", 4), "begins with the mark of UTF-16: must be UTF-8");
  CHECK_THROWS_AS(read(R"({"ball": {"radius": NaN}})"), FilmError);
  CHECK_THROWS_AS(read(R"({"ball": {"radius": 1e999}})"), FilmError);
  CHECK_THROWS_AS(read(R"({"ball": )" + std::string(100, '[')), FilmError);
  CHECK_THROWS_AS(read(std::string(most_bytes + 1, ' ')), FilmError);
  CHECK_NOTHROW(read("\xEF\xBB\xBF" + film_with(start, end)));  // some editors put it before UTF-8
}

TEST_CASE(
    "Whatever number stands anywhere in a film, it is refused in a line, or the body is somewhere at all "
    "times") {
  std::size_t shown = 0, refused = 0;
  for (const auto& [name, text] : scenes()) {
    const nlohmann::json film = nlohmann::json::parse(text), flat = film.flatten();
    for (const auto& [place, value] : flat.items())
      for (const double number : {0.0, -1.0, 1e6, 1e-6, 1e300}) {
        if (!value.is_number()) continue;
        nlohmann::json changed = film;
        changed[nlohmann::json::json_pointer(place)] = number;
        CAPTURE(name, place, number);
        try {
          const Film read_again = read(changed.dump());
          const Showing showing(read_again);
          for (const double time : picture_times(read_again.begin(), read_again.end(), 1e-6))
            CHECK(showing.at(time).place.allFinite());
          ++shown;
        } catch (const std::invalid_argument& error) {
          CHECK(std::string(error.what()).size() < 400);
          ++refused;
        }
      }
  }
  CHECK(shown > 100);
  CHECK(refused > 100);
}

TEST_CASE("A film's text may stand where its name would") {
  const Film film = film_named(R"({"ball": {"radius": 0.4}, "keys": [{"time": 0, "place": [0, 0, 2]},
    {"time": 3.5, "place": [1, 0, 2]}]})");
  CHECK(film.end() == 3.5);
  CHECK(film.name == "film");
  CHECK_THROWS_WITH(film_named("{}"), "film: {}: must have one of ball, box");
}

TEST_CASE("A word that is no film is told which there are") {
  CHECK_THROWS_WITH(film_named("hal"),
                    "must be a JSON file or its text, { }, or one of hall, crate, ramp, squash");
}
