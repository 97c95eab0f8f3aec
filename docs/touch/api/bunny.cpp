// Chapter 4: a ball thrown at the rabbit, and what the fast tree does.
#include <algorithm>

#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "page.hpp"
#include "throw.hpp"

using namespace first_contact;
using touch::tell;

namespace {

// How many nodes of the tree the sweep opens, and how many leaves.
void tell_work(const Moving<Sphere>& ball) {
  bvh::SphereCast cast(ball, touch::bunny().parts(), touch::bunny().parts().walker);
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
  const touch::View view(turn, tilt, touch::middle_of(touch::bunny().mesh()));
  view.tell();
  const Moving<Sphere> ball = touch::Throw{hand_x, hand_y, aim_x, aim_y, radius}.ball(view);
  const auto contact = touch::tell_contact(ball);
  tell("drawn/ball", ball.shape.center + std::min(time, contact ? contact->time : 1) * ball.displacement);
  tell_work(ball);
}

/// The same sweep so many times, for the page's clock.
FOR_THE_PAGE(bunny_again)
(double x0, double y0, double z0, double x1, double y1, double z1, double radius, double count) {
  const Moving<Sphere> ball{{{x0, y0, z0}, radius}, Point(x1, y1, z1) - Point(x0, y0, z0)};
  double contacts = 0;
  for (double i = 0; i < count; ++i) contacts += sweep(ball, touch::bunny()).has_value();
  tell("contacts", contacts);
}
