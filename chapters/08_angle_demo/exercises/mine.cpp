// stands for: first_contact/response/impact.cpp
// The student's exercise 8a in the place of the library's impact: ./course run angle_demo --mine
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/response/impact.hpp"
#include "workbook/vectors.hpp"

namespace mine {
#include "08_angle_demo/exercises/8a/answer.hpp"

workbook::Vector2 vector(const first_contact::Vector2& v) { return {v.x(), v.y()}; }
first_contact::Vector2 vector(const workbook::Vector2& v) { return {v.x, v.y}; }
}  // namespace mine

namespace first_contact {

template <int Dimension>
Body<Dimension>::Body(double m, const Velocity& v) : mass(m), velocity(v) {
  if (!(mass > 0)) refuse("mass", mass, "must be positive");
  if (!velocity.allFinite()) refuse("velocity", "must be finite");
}

template <>
Impact<2> impact(const Body<2>& p, const Body<2>& q, const Vector2& normal, double restitution) {
  if (!(restitution >= 0 && restitution <= 1)) refuse("restitution", restitution, "must be in 0 .. 1");
  const auto after = mine::impact({p.mass, mine::vector(p.velocity)}, {q.mass, mine::vector(q.velocity)},
                                  mine::vector(normal), restitution);
  const Vector2 velocity = mine::vector(after.first);
  return {velocity, mine::vector(after.second), p.mass * (velocity - p.velocity)};
}

template struct Body<2>;

}  // namespace first_contact
