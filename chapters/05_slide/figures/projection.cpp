#include "figures.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// One half of the next figure, seen from the side: where the ball ends, with Q as the formula is given it.
void add_side_view(figure::Scene& scene, double x, const Point& q, const Colour& tone,
                   const std::string& title) {
  const Vector shift(x, 0, 0);
  const Point centre = Point(-0.5, 0, 0.5) + shift, p2 = Point(0.9, 0, -0.375) + shift, given = q + shift;
  const Point p3 = slide_target(p2, given, {0, 0, 1});
  scene.polygon({Point(-1.25, 0, 0) + shift, Point(1.6, 0, 0) + shift, Point(1.6, 0, -0.75) + shift,
                 Point(-1.25, 0, -0.75) + shift},
                {colour::floor}, -3);
  scene.line({Point(-1.25, 0, 0) + shift, Point(1.6, 0, 0) + shift}, {colour::blue, 1.6}, -2);
  scene.sphere({centre, 0.5}, colour::amber, 0.35);
  scene.sphere({p3, 0.5}, tone, 0.6);
  scene.line({given, p2, p3}, undone, 1);
  scene.arrow(given, p3, {tone, 2.4});
  for (const Point& dot : {given, p2, p3}) scene.dot(dot);
  scene.label("{/:Italic Q}", given, -0.9, 0.5);
  scene.label("{/:Italic P}_2", p2, 1.2, -0.1);
  scene.label("{/:Italic P}_3", p3, 0.6, 0.8);
  scene.label(title, Point(0.175, 0, 1.2) + shift, 0, 0, tone);
}

}  // namespace

void draw_projection(const Studio& studio) {
  const ::Scene paper;
  const auto ball = paper.ball();
  const auto contact = *sweep(ball, paper.environment());
  const Point &p1 = paper.from, &p2 = paper.to;
  const Point q = p1 + contact.time * ball.displacement, p3 = slide_target(p2, q, contact.normal);
  const double r = paper.radius;
  const View view{72, 20};

  figure::Scene scene(view, 0.03);
  scene.patch(ground[0].middle, ground[0].u, ground[0].v, {colour::floor, 1, false, wall_edge}, -3);
  add_shadow(scene, {p1, r}, 0.6);
  add_shadow(scene, {q, r});
  add_shadow(scene, {p3, r});
  add_ghost(scene, {p2, r}, view);
  scene.sphere({p1, r});
  scene.sphere({q, r}, colour::amber, 0.4);
  scene.sphere({p3, r}, colour::amber, 0.6);
  scene.line({q, p2}, undone, 2);
  scene.line({p2, p3}, undone, 2);
  scene.arrow(p1, q);
  scene.arrow(q, p3, way);
  scene.arrow(q, q + Vector(0, 0, 1.1), {colour::ink, 2.4});
  for (const Point& dot : {p1, q, p2, p3}) scene.dot(dot);
  scene.label("{/:Italic P}_1", p1 - r * view.right(), -0.6, 0, colour::ink, Align::right);
  scene.label("{/:Italic P}_2", p2, 1.2, -0.2);
  scene.label("{/:Italic P}_3", p3, 1.2, 0.4);
  scene.label("{/:Italic Q}", q, -1.0, -0.6);
  scene.label("{/:Bold N}", q + Vector(0, 0, 1.1), 1.2, -0.2);
  Figure figure(studio, "figure-10", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_half_sunk(const program::Program& program) {
  figure::Scene scene(from_the_side, 0.03);
  add_side_view(scene, 0, {-0.5, 0, 0}, colour::pink,
                program.say({"{/:Italic Q} on the surface", "{/:Italic Q} 為碰撞點"}));
  add_side_view(scene, 3.3, {-0.5, 0, 0.5}, colour::green,
                program.say({"{/:Italic Q} the centre", "{/:Italic Q} 為球心"}));
  Figure figure(program.studio(), "half-sunk", scene.size());
  scene.draw(figure);
  figure.draw();
}
