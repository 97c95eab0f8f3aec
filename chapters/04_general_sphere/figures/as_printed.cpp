#include "figures.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "parts.hpp"
#include "scenes.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_printed_cylinder(const program::Program& program) {
  figure::Scene scene(from_above);
  const double r = 0.8;
  scene.polygon({at(-2, -1.4), at(0, -1.4), at(0, 0), at(-2, 0)}, {colour::floor});
  scene.line({at(0, -1.4), at(0, 0), at(-2, 0)}, {colour::blue, 1.6});
  scene.line({at(-2, r), at(r, r), at(r, -1.4)}, moved_out);
  const Vector toward = at(-1, -1).normalized();
  const Point edge = at(0, 0), moved = at(r, r), start = at(2.3, 2.3);
  const Point early = moved - r * toward, right = edge - r * toward;
  scene.line(arc(moved, r), {colour::pink, 1.4, true});
  scene.line(arc(edge, r), {colour::green, 1.4, true});
  scene.sphere({early, r}, colour::pink, 0.25);
  scene.sphere({right, r}, colour::amber, 0.5);
  scene.arrow(start, right);
  for (const Point& p : {edge, moved, early, right}) scene.dot(p);
  scene.label(program.say({"as printed", "論文原式"}), early + at(-0.9 * r, r), -0.4, 0, colour::pink,
              Align::right);
  scene.label(program.say({"corrected", "修正"}), at(r, -0.25), 0.8, -1.2, colour::green, Align::left);
  finish(program.studio(), "printed-cylinder", scene);
}

void draw_order(const program::Program& program) {
  figure::Scene scene(from_above);
  const double r = 0.5;
  const Moving<Sphere> falling{{{1, 0, 3}, r}, {0, 0, -3}};
  const Mesh stairs = general_sphere_chapter::step();
  const auto height = [&](double t) { return falling.shape.center.z() + t * falling.displacement.z(); };
  const double through = height(general_sphere_chapter::first_face_in_the_list(falling, stairs)->time);
  const double touching = height(sweep(falling, Environment(stairs))->time);
  scene.polygon({at(-2, -0.25), at(2, -0.25), at(2, 0), at(-2, 0)}, {colour::floor}, -2);
  scene.polygon({at(0, 0), at(2, 0), at(2, 1), at(0, 1)}, {colour::floor}, -2);
  scene.line({at(-2, 0), at(2, 0)}, {colour::blue, 2.4}, -1);
  scene.line({at(0, 0), at(0, 1), at(2, 1)}, {colour::blue, 2.4}, -1);
  scene.line({at(-2, r), at(2, r)}, moved_out);
  scene.line({at(0, 1 + r), at(2, 1 + r)}, moved_out);
  scene.line({at(1, touching), at(1, through)}, {colour::pink, 1.4, true}, 3);
  scene.sphere({at(1, through), r}, colour::pink, 0.3, 1);
  scene.sphere({at(1, touching), r}, colour::amber, 0.55, 2);
  scene.arrow(at(1, 2.7), at(1, touching), {colour::red, 2.4}, 4);
  scene.dot(at(1, through), colour::pink);
  scene.dot(at(1, touching));
  scene.label("1", at(-1.8, 0), 0, 0.9, colour::blue);
  scene.label("2", at(0.2, 1), 0, 0.9, colour::blue);
  scene.label(program.say({"as printed", "論文原式"}), at(2, through), 0.8, 0, colour::pink, Align::left);
  scene.label(program.say({"corrected", "修正"}), at(2, touching), 0.8, 0, colour::green, Align::left);
  scene.label("", at(2.8, 0));  // room for both
  finish(program.studio(), "order", scene);
}
