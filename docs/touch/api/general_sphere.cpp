// Chapter 4: a ball against a prism, seen along its edges: which feature is met first, and the cylinders as printed.
#include "04_general_sphere/scenes.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "page.hpp"

using namespace first_contact;
using namespace general_sphere_chapter;
using touch::tell;

namespace {

void tell_section() {
  std::vector<double> numbers;
  for (const Vector2& corner : section_of_prism()) numbers.insert(numbers.end(), {corner.x(), corner.y()});
  tell("drawn/section", numbers);
}

void tell_contact(const Moving<Sphere>& ball, const Contact& contact) {
  tell("contact/time", contact.time);
  tell("contact/center", ball.shape.center + contact.time * ball.displacement);
  tell("contact/point", contact.point());
  tell("contact/normal", contact.normal);
  tell("contact/feature", to_string(contact.feature));
  tell("contact/triangle", double(contact.triangle));
}

// Where the paper's cylinders stand in the section: those about the edges that go through it.
void tell_printed_axes(const Environment& solid, double radius) {
  std::vector<double> numbers;
  for (const auto& edge : solid.topology().edges()) {
    if (edge.kind != EdgeKind::convex) continue;
    const auto axis = printed_axis(solid, edge, radius);
    if (!axis || (*axis)[0].y() * (*axis)[1].y() >= 0) continue;
    numbers.insert(numbers.end(), {(*axis)[0].x(), (*axis)[0].z()});
  }
  tell("drawn/axes", numbers);
}

}  // namespace

FOR_THE_PAGE(general_sphere)
(double x0, double z0, double x1, double z1, double radius) {
  static const Environment solid(prism());
  const Point from{x0, 0, z0}, to{x1, 0, z1};
  const Moving<Sphere> ball{{from, radius}, to - from};
  tell_section();
  tell_printed_axes(solid, radius);
  if (const auto contact = sweep(ball, solid)) tell_contact(ball, *contact);
  if (const auto time = printed_time(ball, solid)) {
    tell("printed_time", *time);
    tell("drawn/stopped", ball.shape.center + *time * ball.displacement);
  }
}
