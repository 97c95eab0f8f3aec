// Chapter 5: a ball is steered over a terrain. Of each step it is told how it slides; the next begins where it ends.
#include "first_contact/program/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/response/slide.hpp"
#include "page.hpp"
#include "view.hpp"

using namespace first_contact;
using touch::tell;

namespace {

constexpr std::uint32_t squares = 64;
constexpr double rim = 4;  // so far from it the ball turns

const Bvh& hills() {
  static const Bvh tree(program::terrain(squares));
  return tree;
}

void tell_path(const Slide& path) {
  for (std::size_t i = 0; i < path.positions.size(); ++i)
    tell("positions/" + std::to_string(i), path.positions[i]);
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    const std::string place = "contacts/" + std::to_string(i);
    tell(place + "/time", path.contacts[i].time);
    tell(place + "/point", path.contacts[i].point());
    tell(place + "/normal", path.contacts[i].normal);
    tell(place + "/feature", to_string(path.contacts[i].feature));
    tell(place + "/triangle", double(path.contacts[i].triangle));
  }
  tell("end", path.end());
}

// Across the picture and away from the eye, along the ground; and down.
Point wish(const Point& from, const touch::View& view, double across, double away, double pull) {
  const Vector ahead = Vector(-view.eye.x(), -view.eye.y(), 0).normalized();
  Point to = from + across * view.right + away * ahead - pull * Vector::UnitZ();
  for (int i = 0; i < 2; ++i) to[i] = std::clamp(to[i], rim, 64 - rim);
  return touch::in_thousandths(to);
}

// A ball that has grown, or that an address puts into the ground, is lifted to where one that falls would lie,
// and a thousandth at most above. One that lies there is left, though its last digits may be below.
Point lifted(const Point& from, double radius) {
  constexpr double above = 20, within = 1e-6;
  const auto ground =
      sweep(Moving<Sphere>{{{from.x(), from.y(), above}, radius}, {0, 0, -2 * above}}, hills());
  const double rest = ground ? above - 2 * above * ground->time : from.z();
  return from.z() > rest - within ? from : Point(from.x(), from.y(), std::ceil(1000 * rest) / 1000);
}

}  // namespace

FOR_THE_PAGE(terrain)
(double x, double y, double z, double across, double away, double pull, double radius, double turn,
 double tilt) {
  const Point from = lifted({x, y, z}, radius);
  const Point to = wish(from, touch::View(turn, tilt, from), across, away, pull);
  const Slide path = slide(Moving<Sphere>{{from, radius}, to - from}, hills());
  tell_path(path);
  tell("drawn/from", from);
  tell("drawn/to", to);
  touch::View(turn, tilt, path.end()).tell();
}

FOR_THE_PAGE(terrain_mesh)() { touch::tell_mesh(hills().mesh()); }
