#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/response/slide.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double reach = 2.4;  // how far walls and motions are drawn

Vector heading(double degrees) { return {std::cos(degrees * pi / 180), 0, std::sin(degrees * pi / 180)}; }

// Two walls, seen along their crease: the motions from q that lead into neither fill the wedge between them.
// The motion that is left, w, has its nearest in the wedge at v.
void add_wedge(figure::Scene& scene, const Point& q, const Vector& w, const Vector& v) {
  const Vector floor = heading(0), wall = heading(115);  // their directions, away from the crease
  std::vector<Point> wedge{q};
  for (int degrees = 0; degrees <= 115; degrees += 5) wedge.push_back(q + reach * heading(degrees));
  scene.polygon(wedge, {colour::green, 0.16}, -2);
  scene.line({q + reach * floor, q, q + reach * wall}, offset_edge, 0);
  scene.arrow(q + 2.1 * floor, q + 2.1 * floor + 0.7 * heading(90), {colour::ink, 2.0});
  scene.arrow(q + 1.7 * wall, q + 1.7 * wall + 0.7 * heading(25), {colour::ink, 2.0});
  scene.label("{/:Bold N}", q + 2.1 * floor + 0.7 * heading(90), 1.2, 0.2);
  scene.label("{/:Bold M}", q + 1.7 * wall + 0.7 * heading(25), 1.3, 0.2);
  scene.arrow(q, q + w);
  scene.label("{/:Bold w}", q + w, 0, -0.9, colour::red);
  scene.line({q + w, q + v}, {colour::grey, 1.2, true});
  scene.dot(q);
  if (v.norm() > 0) scene.arrow(q, q + v, way, 4);
}

}  // namespace

void draw_wedge(const program::Program& program) {
  const Point left(-3.2, 0, 0), right(3.4, 0, 0);
  const Vector along = 1.9 * heading(-32), into = 1.5 * heading(-118);
  figure::Scene scene(from_the_side, 0.05);
  const Vector slid = slide_target(left + along, left, heading(90)) - left;
  add_wedge(scene, left, along, slid);
  add_wedge(scene, right, into, Vector::Zero());
  scene.label("{/:Bold v}", left + slid, 0.2, 0.8, colour::green);
  scene.label(program.say({"along one wall", "沿一面牆"}), left + Vector(0.8, 0, -2.1));
  scene.dot({0, 0, -2.2}, colour::paper);  // room for the words
  scene.label(program.say({"along the crease, toward you", "沿交線，朝向讀者"}),
              right + Vector(0.8, 0, -2.1));
  scene.label("{/:Italic Q}", left, -1.2, -0.6);
  scene.label("{/:Italic Q}", right, 1.1, -0.6);
  Figure figure(program.studio(), "wedge", scene.size());
  scene.draw(figure);
  figure.draw();
}
