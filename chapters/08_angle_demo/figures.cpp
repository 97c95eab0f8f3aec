#include "figures.hpp"

#include <algorithm>
#include <cstdio>

#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;
using Eigen::Vector2d;

namespace {

const View above{0, 0};  // the discs' plane is the picture
const std::array<Colour, 2> body{colour::amber, colour::sky};

Point flat(const Vector2d& v) { return {v.x(), v.y(), 0}; }

// With a true minus sign.
std::string number_text(double value, const char* form) {
  char text[40];
  std::snprintf(text, sizeof text, form, std::abs(value));
  return (value < 0 ? "−" : "") + std::string(text);
}

std::string angle_text(double degrees) { return number_text(degrees, "%.4g°"); }

void add_disc(figure::Scene& scene, const Vector2d& center, double radius, const Colour& colour,
              double opacity) {
  std::vector<Point> rim;
  for (int i = 0; i < 120; ++i) {
    const double angle = i * std::numbers::pi / 60;
    rim.push_back(flat(center + radius * Vector2d(std::cos(angle), std::sin(angle))));
  }
  scene.polygon(rim, {colour, opacity, false, Pen{colour, 1.4}}, 0);
}

// A text beyond an arrow's tip: its side if the arrow is steep, and the room that it needs.
struct Name {
  std::string text;
  double room = 0;
  Align side = Align::centre;
};

// A velocity as an arrow that begins at a body's rim.
void add_velocity(figure::Scene& scene, const Vector2d& center, double rim, const Vector2d& velocity,
                  const Colour& colour, const Name& name = {}) {
  if (velocity.norm() == 0) return;
  const Vector2d way = velocity.normalized(), tip = center + rim * way + velocity;
  scene.arrow(flat(center + rim * way), flat(tip), {colour, 2.4}, 3);
  if (name.text.empty()) return;
  const bool level = std::abs(way.x()) > 0.6;
  const Align align = !level ? name.side : way.x() > 0 ? Align::left : Align::right;
  const double aside = align == Align::left ? 0.6 : align == Align::right ? -0.6 : 0;
  scene.label(name.text, flat(tip), aside, level ? 0.6 * way.y() : 0.9 * way.y(), colour, align);
  scene.label("",
              flat(tip + (level ? name.room * Vector2d(way.x() > 0 ? 1 : -1, 0) : 0.3 * name.room * way)));
  if (!level && align == Align::centre) scene.label("", flat(tip - Vector2d(0.6 * name.room, 0)));
}

// One of the four cases by itself: velocities before and after. The distance is not to scale.
void add_case(figure::Scene& scene, const Vector2d& origin, const Vector2d& between, double scale,
              const Encounter& encounter) {
  constexpr double size = 0.34;
  const Outcome printed = as_printed(encounter), corrected = at_contact(encounter);
  const Colour& after = printed.collides == corrected.collides ? colour::green : colour::pink;
  const std::array<Vector2d, 2> at{origin, origin + between}, before{encounter.v1, encounter.v2};
  scene.line({flat(at[0]), flat(at[1])}, {colour::grey, 1.2, true}, -1);
  for (const std::size_t i : {0U, 1U}) {
    add_disc(scene, at[i], size, body[i], 1);
    const std::string mass = "{/:Italic m} = " + program::readable(encounter.mass[static_cast<int>(i)]);
    if (between.x() > 1)
      scene.label(mass, flat(at[i]), 0, -1.5);
    else  // one above the other
      scene.label(mass, flat(at[i]), i ? 1.8 : 0, i ? 0 : 1.5, colour::ink, i ? Align::left : Align::centre);
    if (printed.collides) add_velocity(scene, at[i], size, scale * before[i], colour::red);
    add_velocity(scene, at[i], size, scale * printed.velocity[i], after, {angle_text(printed.angle[i]), 1.2});
  }
}

// Velocities before and after the impact in the four cases of program 4.
void draw_cases(const program::Program& program) {
  const auto cases = paper_cases();
  figure::Scene scene(above, 0.02);
  const Vector2d aside(3, 0);
  add_case(scene, {0, 4.2}, aside, 1.1, cases[0]);
  add_case(scene, {10.2, 4.2}, aside, 1.1, cases[1]);
  add_case(scene, {0, -0.6}, aside, 1.1, cases[2]);
  add_case(scene, {10.8, 0.5}, {0.08, -1.6}, 0.6, cases[3]);
  const std::string before = program.say({"before", "碰撞前"});
  const std::string after = program.say({"after", "碰撞後"});
  const std::string as_printed = program.say({"as printed;", "論文所印；"});
  const std::string apart = program.say({"they never meet", "其實並未相碰"});
  scene.label(before, {1.5, 4.6, 0}, 0, 0, colour::red);
  scene.label(after, {5, 4.6, 0}, 0, 0, colour::green, Align::left);
  scene.label(as_printed, {12.1, -1.9, 0}, 0, 0, colour::pink, Align::left);
  scene.label(apart, {12.1, -2.5, 0}, 0, 0, colour::pink, Align::left);
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i + 1);
    scene.label(program.say({"Case " + number, "狀況" + number}), {i % 2 ? 8.1 : -1.2, i < 2 ? 6.7 : 2.1, 0},
                0, 0, colour::ink, Align::left);
  }
  scene.label("", {16.2, 7, 0});
  scene.label("", {-1.4, -4, 0});
  Figure figure(program.studio(), "cases", scene.size(960));
  scene.draw(figure);
  figure.draw();
}

// The way from the start to where the discs meet, or where they are nearest to each other.
void add_ways(figure::Scene& scene, const Encounter& encounter, double time, bool meet) {
  const auto start = centres(encounter, 0), end = centres(encounter, time);
  for (const std::size_t i : {0U, 1U}) {
    const bool moves = start[i] != end[i];
    if (moves) add_disc(scene, start[i], encounter.radius, body[i], 0.3);
    if (moves) scene.arrow(flat(start[i]), flat(end[i]));
    add_disc(scene, end[i], encounter.radius, body[i], 0.85);
    scene.dot(flat(end[i]));
  }
  scene.line({flat(end[0]), flat(end[1])}, {meet ? colour::ink : colour::grey, 1.4, true}, 2);
  const Point middle = flat(0.5 * (end[0] + end[1]));
  if (!meet) {
    scene.label(number_text((end[1] - end[0]).norm(), "%.4g"), middle, 0.8, -0.2, colour::ink, Align::left);
    scene.label("{/:Italic t} = " + number_text(time, "%.4g"), flat(end[0]), 1.4, 0, colour::red,
                Align::left);
  }
}

}  // namespace

Encounter aimed_beside() {
  Encounter aimed;
  aimed.mass = {1, 1};
  aimed.p1 = {-5, 1};
  aimed.p2 = {0, 0};
  aimed.v1 = {5, 0};
  aimed.v2 = {0, 0};
  return aimed;
}

Encounter soft_and_aslant() {
  Encounter soft;
  soft.mass = {1, 1};
  soft.p1 = {-1, 0};
  soft.p2 = {1, 0};
  soft.v2 = {-1, -1};
  soft.restitution = 0.5;
  return soft;
}

// Restitution 1/2: as printed, the velocities across the line of centres shrink as well.
static void draw_drag(const program::Program& program) {
  const Encounter soft = soft_and_aslant();
  const Outcome wrong = as_printed(soft), truth = at_contact(soft);
  const auto at = centres(soft, 0);
  const std::array<Vector2d, 2> before{soft.v1, soft.v2};
  const double scale = 1.7;
  figure::Scene scene(above, 0.03);
  scene.line({{-4, 0, 0}, {4, 0, 0}}, {colour::grey, 1.2, true}, -1);
  scene.line({{0, -1.6, 0}, {0, 1.6, 0}}, {colour::grey, 1.2, true}, -1);
  for (const std::size_t i : {0U, 1U}) {
    add_disc(scene, at[i], 1, body[i], 0.55);
    scene.arrow(flat(at[i]), flat(at[i] + scale * before[i]), {colour::red, 2.4}, 3);
    scene.arrow(flat(at[i]), flat(at[i] + scale * wrong.velocity[i]), {colour::pink, 2.4}, 3);
    scene.arrow(flat(at[i]), flat(at[i] + scale * truth.velocity[i]), {colour::green, 2.4}, 3);
    scene.dot(flat(at[i]));
  }
  scene.label(program.say({"before", "碰撞前"}), flat(at[0] + scale * before[0]), 0.6, 0.3, colour::red,
              Align::left);
  scene.label(program.say({"as printed", "論文所印"}), flat(at[0] + scale * wrong.velocity[0]), -0.6, 0,
              colour::pink, Align::right);
  scene.label(program.say({"corrected", "修正"}), flat(at[0] + scale * truth.velocity[0]), -0.6, 0.3,
              colour::green, Align::right);
  Figure figure(program.studio(), "drag", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_encounter(const program::Program& program, const std::string& name, const Encounter& encounter,
                    bool printed, bool corrected) {
  const Outcome wrong = as_printed(encounter), truth = at_contact(encounter);
  const double time = truth.time.value_or(closest_approach(encounter).time);
  const auto from = centres(encounter, truth.collides ? time : 0);
  const auto start = centres(encounter, 0);
  const double extent = std::max({(start[1] - start[0]).norm(), time * encounter.v1.norm(),
                                  time * encounter.v2.norm(), 4 * encounter.radius});
  double fastest = 0;
  for (const auto* outcome : {&wrong, &truth})
    for (const Vector2d& v : outcome->velocity) fastest = std::max(fastest, v.norm());
  const double scale = fastest > 0 ? 0.35 * extent / fastest : 0;

  figure::Scene scene(above, 0.05);
  add_ways(scene, encounter, time, truth.collides);
  for (const std::size_t i : {0U, 1U}) {
    const bool last = i == 1;  // the arrows are explained once
    const double room = (last ? 0.65 : 0.3) * (extent + 2 * encounter.radius);
    const std::string first = last ? program.say({", as printed", "，論文所印"}) : "";
    const std::string second = last ? program.say({", at contact", "，碰撞時"}) : "";
    if (printed && wrong.collides)
      add_velocity(scene, from[i], encounter.radius, scale * wrong.velocity[i], colour::pink,
                   {angle_text(wrong.angle[i]) + first, room, truth.collides ? Align::right : Align::centre});
    if (corrected && truth.collides)
      add_velocity(scene, from[i], encounter.radius, scale * truth.velocity[i], colour::green,
                   {angle_text(truth.angle[i]) + second, room, Align::left});
  }
  const Size size = scene.size();
  const bool tall = size.height > size.width;
  Figure figure(program.studio(), name, tall ? Size{480, 720} : size);
  scene.draw(figure);
  figure.draw();
}

void draw_paper_cases(const program::Program& program) {
  draw_cases(program);
  draw_encounter(program, "case-4", paper_cases()[3], true, true);
  draw_encounter(program, "normal-at-contact", aimed_beside(), true, true);
  draw_drag(program);
}
