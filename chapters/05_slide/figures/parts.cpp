#include "parts.hpp"

#include <cmath>
#include <numbers>

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void add_ghost(figure::Scene& scene, const Sphere& ball, const View& view) {
  std::vector<Point> outline;
  for (int degrees = 0; degrees <= 360; degrees += 4) {
    const double angle = degrees * std::numbers::pi / 180;
    outline.emplace_back(ball.center +
                         ball.radius * (std::cos(angle) * view.right() + std::sin(angle) * view.up()));
  }
  scene.line(outline, undone, 1);
}

void add_shadow(figure::Scene& scene, const Sphere& ball, double opacity) {
  scene.disc({ball.center.x(), ball.center.y(), 0}, {0, 0, 1}, 0.85 * ball.radius, {colour::shadow, opacity},
             -2);
}
