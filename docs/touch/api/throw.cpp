#include "throw.hpp"

#include <cstdint>
#include <vector>

#include "page.hpp"

namespace touch {

namespace {

constexpr double far = 30;         // from the picture's plane to beyond the rabbit
constexpr double in_the_hand = 7;  // before that plane the ball begins
constexpr double beyond = 1.25;    // of the way to what is picked: so far the ball would go

Mesh bunny_mesh() {
  const std::vector<double> numbers = given("bunny/vertices"), corners = given("bunny/faces");
  std::vector<Point> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  std::vector<Mesh::Face> faces;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    faces.push_back(
        {std::uint32_t(corners[i]), std::uint32_t(corners[i + 1]), std::uint32_t(corners[i + 2])});
  return {std::move(vertices), std::move(faces)};
}

// The point of the rabbit that is seen there; where none is, one of the picture's plane.
Point picked(const View& view, double x, double y) {
  const Moving<Sphere> ray{{view.point(x, y, far), 0}, -2 * far * view.eye};
  const auto contact = sweep(ray, bunny());
  if (!contact) return view.point(x, y, 0);
  tell("drawn/picked/triangle", double(contact->triangle));
  return contact->point();
}

}  // namespace

const Bvh& bunny() {
  static const Bvh tree(bunny_mesh());
  return tree;
}

Moving<Sphere> Throw::ball(const View& view) const {
  const Point from = in_thousandths(view.point(hand_x, hand_y, in_the_hand));
  const Point to = in_thousandths(from + beyond * (picked(view, aim_x, aim_y) - from));
  tell("drawn/from", from);
  tell("drawn/to", to);
  return {{from, radius}, to - from};
}

std::optional<Contact> tell_contact(const Moving<Sphere>& ball) {
  const auto contact = sweep(ball, bunny());
  if (!contact) return contact;
  tell("contact/time", contact->time);
  tell("contact/center", ball.shape.center + contact->time * ball.displacement);
  tell("contact/point", contact->point());
  tell("contact/normal", contact->normal);
  tell("contact/feature", to_string(contact->feature));
  tell("contact/triangle", double(contact->triangle));
  return contact;
}

}  // namespace touch
