#include "figures.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_room(const Studio& studio, const char* name, const std::vector<Rectangle>& room,
               const Moving<Sphere>& ball) {
  const Slide path = slide(ball, Environment(walls(room)));
  const double r = ball.shape.radius;
  const Point p2 = ball.shape.center + ball.displacement;
  const Point p3 = slide_target(p2, path.positions[1], path.contacts[0].normal);
  const View view{66, -26};

  figure::Scene scene(view, 0.03);
  for (std::size_t i = 0; i < room.size(); ++i)
    scene.patch(room[i].middle, room[i].u, room[i].v,
                {i == 0 ? colour::floor : colour::mist, 1, false, wall_edge}, -4);
  add_shadow(scene, ball.shape, 0.6);
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    add_shadow(scene, {path.positions[i], r}, i + 1 < path.positions.size() ? 0.6 : 1);
  add_ghost(scene, {p3, r}, view);
  scene.line({path.positions[1], p3}, undone, 1);
  scene.sphere(ball.shape);
  scene.sphere({path.end(), r}, colour::amber, 0.6, 1);
  scene.arrow(path.positions[0], path.positions[1]);
  for (std::size_t i = 1; i + 1 < path.positions.size(); ++i) {
    scene.arrow(path.positions[i], path.positions[i + 1], way, 3);
    scene.dot(path.positions[i]);
    scene.label("{/:Italic Q}_" + std::to_string(i), path.positions[i], 1.4, -0.5);
  }
  for (const Point& dot : {path.positions[0], path.end(), p3}) scene.dot(dot);
  scene.label("{/:Italic P}_1", path.positions[0] - r * view.right(), -0.6, 0, colour::ink, Align::right);
  scene.label("{/:Italic P}_3", p3, 1.2, 0.4, colour::grey);
  scene.label("{/:Italic P}", path.end(), 0.3, 0.9);
  Figure figure(studio, name, scene.size());
  scene.draw(figure);
  figure.draw();
}
