#include <algorithm>

#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;
using Eigen::Vector2d;

namespace {

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
    const std::string first = last ? program.say({", as printed", "，論文原式"}) : "";
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
