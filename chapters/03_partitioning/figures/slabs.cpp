#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// Seen along the y axis: x to the right, z up.
const View front{90, 0};
constexpr double right = 4.6, top = 2.7;  // of the picture, from its middle

Point at(double x, double z) { return {x, 0, z}; }

std::vector<Point> rectangle(double x, double z) { return {at(-x, -z), at(x, -z), at(x, z), at(-x, z)}; }

// A box and, dashed, its sides moved out by the ball's radius: a vertical strip and a level one.
void add_slabs(figure::Scene& scene, const Point& half, double r) {
  scene.polygon(rectangle(half.x() + r, top), {colour::sky, 0.22}, -3);
  scene.polygon(rectangle(right, half.z() + r), {colour::sky, 0.22}, -2);
  for (const double side : {-1.0, 1.0}) {
    const double x = side * (half.x() + r), z = side * (half.z() + r);
    scene.line({at(x, -top), at(x, top)}, {colour::grey, 1.4, true});
    scene.line({at(-right, z), at(right, z)}, {colour::grey, 1.4, true});
  }
  scene.polygon(rectangle(half.x(), half.z()), {colour::floor, 1, false, Pen{colour::blue, 1.6}}, -1);
}

}  // namespace

void draw_slabs(const program::Program& program) {
  const Point half(1.3, 0, 0.75), start = at(-4.2, -2.35), end = at(4.2, 1.95);
  const double r = 0.5;
  const Vector way = end - start;
  figure::Scene scene(front, 0.03);
  add_slabs(scene, half, r);
  const auto when = [&](int axis, double side) {
    return (side * (half[axis] + r) - start[axis]) / way[axis];
  };
  const double into_x = when(0, -1), into_z = when(2, -1), out_of_z = when(2, 1), out_of_x = when(0, 1);
  scene.arrow(start, end);
  scene.line({start + std::max(into_x, into_z) * way, start + std::min(out_of_x, out_of_z) * way},
             {colour::green, 5}, 3);
  for (const double t : {into_x, into_z, out_of_x, out_of_z}) scene.dot(start + t * way);
  scene.label(program.say({"enters {/:Italic x}", "進入 {/:Italic x}"}), start + into_x * way, 0.6, -0.9,
              colour::ink, Align::left);
  scene.label(program.say({"enters {/:Italic z}", "進入 {/:Italic z}"}), start + into_z * way, -0.6, 0.9,
              colour::ink, Align::right);
  scene.label(program.say({"leaves {/:Italic x}", "離開 {/:Italic x}"}), start + out_of_x * way, 0.6, -0.9,
              colour::ink, Align::left);
  scene.label(program.say({"leaves {/:Italic z}", "離開 {/:Italic z}"}), start + out_of_z * way, -0.6, 0.9,
              colour::ink, Align::right);
  Figure figure(program.studio(), "slabs", scene.size());
  scene.draw(figure);
  figure.draw();
}
