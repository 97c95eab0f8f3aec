// Chapter 4: a ball thrown at the rabbit. A ray through the pointer picks where it is sent (paper, 3.2.3 and 3.2.4), and the
// fast tree finds what it meets.
#include <algorithm>

#include "bunny_mesh.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "page.hpp"
#include "view.hpp"

using namespace first_contact;
using touch::tell;

namespace {

constexpr double far = 30;         // from the picture's plane to beyond the rabbit
constexpr double in_the_hand = 7;  // before that plane the ball begins
constexpr double beyond = 1.25;    // of the way to what is picked: so far the ball would go

const Bvh& bunny() {
  static const Bvh tree(touch::bunny_mesh());
  return tree;
}

void tell_contact(const Moving<Sphere>& ball, const Contact& contact) {
  tell("contact/time", contact.time);
  tell("contact/center", ball.shape.center + contact.time * ball.displacement);
  tell("contact/point", contact.point());
  tell("contact/normal", contact.normal);
  tell("contact/feature", to_string(contact.feature));
  tell("contact/triangle", double(contact.triangle));
}

// The point of the rabbit that is seen there; where none is, one of the picture's plane.
Point picked(const touch::View& view, double x, double y) {
  const Moving<Sphere> ray{{view.point(x, y, far), 0}, -2 * far * view.eye};
  const auto contact = sweep(ray, bunny());
  if (!contact) return view.point(x, y, 0);
  tell("drawn/picked/triangle", double(contact->triangle));
  return contact->point();
}

// How many nodes of the tree the sweep opens, and how many leaves.
void tell_work(const Moving<Sphere>& ball) {
  bvh::SphereCast cast(ball, bunny().parts(), bunny().parts().walker);
  double nodes = 0, leaves = 0;
  do
    for (bvh::Pause at = cast.begin(); at != bvh::Pause::end;) {
      const bool at_node = at == bvh::Pause::node, at_leaf = at == bvh::Pause::leaf;
      nodes += at_node;
      leaves += at_leaf;
      at = at_node ? cast.visit_node() : at_leaf ? cast.visit_leaf() : cast.decide();
    }
  while (!cast.finish());
  tell("drawn/nodes", nodes);
  tell("drawn/leaves", leaves);
}

}  // namespace

FOR_THE_PAGE(bunny)
(double turn, double tilt, double hand_x, double hand_y, double aim_x, double aim_y, double radius,
 double time) {
  const touch::View view(turn, tilt, touch::middle_of(bunny().mesh()));
  view.tell();
  const Point from = touch::in_thousandths(view.point(hand_x, hand_y, in_the_hand));
  const Point to = touch::in_thousandths(from + beyond * (picked(view, aim_x, aim_y) - from));
  const Moving<Sphere> ball{{from, radius}, to - from};
  const auto contact = sweep(ball, bunny());
  if (contact) tell_contact(ball, *contact);
  tell("drawn/from", from);
  tell("drawn/to", to);
  tell("drawn/ball", from + std::min(time, contact ? contact->time : 1) * ball.displacement);
  tell_work(ball);
}

/// The same sweep so many times, for the page's clock.
FOR_THE_PAGE(bunny_again)
(double x0, double y0, double z0, double x1, double y1, double z1, double radius, double count) {
  const Moving<Sphere> ball{{{x0, y0, z0}, radius}, Point(x1, y1, z1) - Point(x0, y0, z0)};
  double contacts = 0;
  for (double i = 0; i < count; ++i) contacts += sweep(ball, bunny()).has_value();
  tell("contacts", contacts);
}
