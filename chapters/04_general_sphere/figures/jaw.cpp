#include "jaw.hpp"

#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using namespace jaw;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

// By how far the jaw has opened, at the hinge and at the tip of the spur.
void draw_angle(figure::Scene& scene, const Turning<Mesh>& turning, double stop, const Vector& apart) {
  const Point tip(1.38, -2.2, grown);
  std::vector<Point> arc;
  for (int i = 0; i <= 30; ++i) {
    const Point p = Eigen::AngleAxisd(stop * opening * i / 30, turning.axis) * tip;
    arc.emplace_back(p + apart);
  }
  const Point hinge = Point(0, -2.2, 0) + apart;
  scene.line({hinge, arc.front()}, {colour::grey, 1.2, true}, 3);
  scene.line({hinge, arc.back()}, {colour::grey, 1.2, true}, 3);
  scene.line(arc, {colour::red, 2.0}, 3);
  scene.arrow(arc[27], arc.back(), {colour::red, 2.0}, 3);
  scene.dot(hinge);
  scene.label(program::readable(std::round(10 * stop * opening * degrees) / 10) + "°",
              hinge + 1.1 * (arc[15] - hinge), 0.4, 0.3, colour::red, Align::left);
}

}  // namespace

void draw_jaw(const program::Program& program) {
  const View view{76, -33};
  figure::Scene scene(view, 0.04);
  const Turning<Mesh> turning = opening_jaw(grown);
  const Mesh cheek = cheek_bone(-1), other_cheek = cheek_bone(1);
  const auto contact = sweep(turning, cheek);
  const double stop = contact ? contact->time : 1;
  const Vector apart = 7.0 * view.right();
  const auto moved = [](const Mesh& mesh, const Vector& by) {
    std::vector<Point> vertices;
    for (const Point& p : mesh.vertices()) vertices.emplace_back(p + by);
    return Mesh(vertices, mesh.faces());
  };
  const auto bones = [&](double time, const Vector& by) {
    scene.mesh(moved(other_cheek, by), {colour::sky, 1, true}, true, 0);
    scene.mesh(moved(turned(turning, time), by), {colour::amber, 1, true}, true, 1);
    scene.mesh(moved(cheek, by), {colour::sky, 0.62, true}, true, 2);
  };
  bones(0, Vector::Zero());
  bones(stop, apart);
  draw_angle(scene, turning, stop, apart);
  if (contact) scene.dot(contact->point() + apart, colour::red);
  if (contact) scene.label("{/:Italic C}", contact->point() + apart, 1.1, 0.5, colour::red);
  scene.label(program.say({"closed", "閉合"}), Point(1.8, 0, -4.7), 0, 0);
  scene.label(program.say({"opening", "張口"}), Point(1.8, 0, -4.7) + apart, 0, 0);
  Figure figure(program.studio(), "figure-16", scene.size());
  scene.draw(figure);
  figure.draw();
}
