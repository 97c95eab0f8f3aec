#include "words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "film.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/motion/css_easing.hpp"
#include "first_contact/motion/easing_family.hpp"

using namespace first_contact;

namespace tween_bounce {

namespace {

//! [easing_words]
std::optional<Easing> easing_named(const std::string& name) {
  static const std::map<std::string, std::array<double, 4>> of_style_sheets{
      {"ease", {0.25, 0.1, 0.25, 1}},
      {"ease-in", {0.42, 0, 1, 1}},
      {"ease-out", {0, 0, 0.58, 1}},
      {"ease-in-out", {0.42, 0, 0.58, 1}}};
  for (const ease::Named& named : ease::all())
    if (named.name == name) return named.easing;
  const auto found = of_style_sheets.find(name);
  if (found == of_style_sheets.end()) return std::nullopt;
  const auto& [x1, y1, x2, y2] = found->second;
  return ease::cubic_bezier(x1, y1, x2, y2);
}
//! [easing_words]

Easing steps_of(const Entry& entry) {
  entry.only({"count", "jump"});
  static const std::map<std::string, ease::Jump> jumps{{"start", ease::Jump::start},
                                                       {"end", ease::Jump::end},
                                                       {"none", ease::Jump::none},
                                                       {"both", ease::Jump::both}};
  const Entry count = entry.member("count");
  const double number = count.number(1, 1000);
  if (number != std::floor(number)) count.refuse("must be a whole number");
  ease::Jump jump = ease::Jump::end;
  if (const auto where = entry.find("jump")) {
    const auto found = jumps.find(where->word());
    if (found == jumps.end()) where->refuse("must be one of start, end, none, both");
    jump = found->second;
  }
  return made_of(entry, [&] { return ease::steps(static_cast<int>(number), jump); });
}

Easing easing_with_numbers(const Entry& entry) {
  entry.only({"cubic-bezier", "steps", "spring", "power"});
  const std::string kind = entry.one_of({"cubic-bezier", "steps", "spring", "power"});
  const Entry value = entry.member(kind);
  if (kind == "steps") return steps_of(value);
  return made_of(value, [&]() -> Easing {
    if (kind == "power") return ease::power(value.number(0, 100));
    if (kind == "cubic-bezier") {
      const auto numbers = value.numbers(4, 100);
      return ease::cubic_bezier(numbers[0], numbers[1], numbers[2], numbers[3]);
    }
    value.only({"cycles", "damping"});
    return ease::spring(value.member("cycles").number(0.001, 64), value.member("damping").number(0.01, 100));
  });
}

std::vector<Point> points_of(const Entry& entry) {
  std::vector<Point> points;
  for (const Entry& point : entry.items(most_points)) points.push_back(point.vector());
  return points;
}

}  // namespace

Easing easing_of(const Entry& entry) {
  if (!entry.is_word()) return easing_with_numbers(entry);
  if (auto easing = easing_named(entry.word())) return *easing;
  entry.refuse(
      "must be linear, a family such as \"in cubic\", \"out cubic\", \"in-out cubic\" (quadratic, cubic, "
      "quartic, "
      "quintic, sine, exponential, circular, back, elastic, bounce), or ease, ease-in, ease-out, "
      "ease-in-out");
}

Knots knots_of(const Entry& entry) {
  const std::string word = entry.word();
  if (word == "catmull-rom") return Knots::uniform;
  if (word == "centripetal") return Knots::centripetal;
  if (word == "chordal") return Knots::chordal;
  entry.refuse("must be one of catmull-rom, centripetal, chordal");
}

Path path_of(const Entry& entry) {
  if (entry.is_word() && entry.word() == "straight") return {};
  if (entry.is_word()) entry.refuse("must be straight, or an object with its kind");
  entry.only({"kind", "points", "velocities", "constant_speed"});
  const Entry kind = entry.member("kind");
  const std::string word = kind.word();
  const auto speed = entry.find("constant_speed");
  const bool by_length = speed && speed->truth();
  if (const auto needless = entry.find(word == "hermite" ? "points" : "velocities"))
    needless->refuse("must not be there for " + printable(word, 60));
  if (word == "bezier") return Path::bezier(points_of(entry.member("points")), by_length);
  if (word == "b-spline") return Path::b_spline(points_of(entry.member("points")), by_length);
  if (word == "catmull-rom" || word == "centripetal" || word == "chordal")
    return Path::through(points_of(entry.member("points")), by_length, knots_of(kind));
  if (word != "hermite")
    kind.refuse("must be one of bezier, b-spline, catmull-rom, centripetal, chordal, hermite");
  const Entry velocities = entry.member("velocities");
  const auto both = velocities.items(2);
  if (both.size() != 2) velocities.refuse("must be two, at the start and at the end");
  return Path::hermite(both[0].vector(), both[1].vector(), by_length);
}

Quaternion turn_of(const Entry& entry) {
  if (entry.is_list()) {
    const auto q = entry.numbers(4, most_length);
    Quaternion turn(q[0], q[1], q[2], q[3]);
    if (!(norm(turn) > 0)) entry.refuse("must not be zero");
    return turn;
  }
  entry.only({"axis", "degrees"});
  const Entry axis = entry.member("axis");
  const Vector direction = axis.vector();
  if (direction.isZero(0)) axis.refuse("must not be zero");
  const double half = entry.member("degrees").number(-36000, 36000) * std::numbers::pi / 360;
  const Vector vector = std::sin(half) * normalized(direction);
  return {std::cos(half), vector.x(), vector.y(), vector.z()};
}

Box box_of(const Entry& entry) {
  entry.only({"sides", "centre", "turn"});
  const Entry sides = entry.member("sides");
  const Vector lengths = sides.vector();
  if (!(lengths.minCoeff() >= least_length)) sides.refuse("each must be at least " + shortest(least_length));
  const auto centre = entry.find("centre");
  const auto turn = entry.find("turn");
  const Rigid motion(turn ? turn_of(*turn) : Quaternion(1, 0, 0, 0),
                     centre ? centre->vector() : Vector::Zero());
  return motion.box(Box(Point::Zero(), {lengths.x(), 0, 0}, {0, lengths.y(), 0}, {0, 0, lengths.z()}));
}

}  // namespace tween_bounce
