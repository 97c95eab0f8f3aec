#include "jitter.hpp"

#include <cmath>
#include <numbers>

#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

namespace {

const Vector one_way{5, 5 * std::numbers::sqrt3, 0},
    other_way{5, -5 * std::numbers::sqrt3, 0};  // 60 degrees off x

constexpr double skin = 0.001;  // so far from a wall it stands, as in most games

}  // namespace

const Mesh wide_corner = walls({{one_way, one_way, {0, 0, 5}}, {other_way, other_way, {0, 0, 5}}});
const Moving<Sphere> into_wide_corner{{{2.5, 0.22, 0}, 0.5}, {-0.5, 0.02, 0}};

//! [wall_after_wall]
Point wall_after_wall(const Moving<Sphere>& ball, const Environment& environment) {
  auto [sphere, step] = ball;
  for (int contacts = 0; contacts < 8; ++contacts) {
    const auto contact = sweep(Moving<Sphere>{sphere, step}, environment);
    if (!contact) return sphere.center + step;
    const Point p2 = sphere.center + step;
    sphere.center += contact->time * step + skin * contact->normal;
    step = slide_target(p2, sphere.center, contact->normal) - sphere.center;
  }
  return sphere.center;
}
//! [wall_after_wall]

Frames wall_after_wall_frames(const Moving<Sphere>& ball, const Environment& environment, int frames) {
  Frames run{{ball.shape.center}};
  for (int frame = 0; frame < frames; ++frame)
    run.positions.push_back(
        wall_after_wall({{run.positions.back(), ball.shape.radius}, ball.displacement}, environment));
  return run;
}
