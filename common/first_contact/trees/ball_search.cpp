#include "first_contact/trees/ball_search.hpp"

#include <algorithm>

namespace first_contact {

namespace {

double largest_of(const Moving<Sphere>& ball) {
  const auto& [center, radius] = ball.shape;
  return std::max({center.cwiseAbs().maxCoeff(), ball.displacement.cwiseAbs().maxCoeff(), radius});
}

// The part of a motion in which a distance, from d0 at the start to d1 at the end of it, is at least `limit`.
Passage while_at_least(double limit, double d0, double d1, const Passage& part) {
  if (d0 >= limit && d1 >= limit) return part;
  if (d0 < limit && d1 < limit) return {1, 0};
  const double crossing = part.enter + (limit - d0) / (d1 - d0) * (part.leave - part.enter);
  return d0 < limit ? Passage{std::min(crossing, part.leave), part.leave} : Passage{part.enter, crossing};
}

}  // namespace

BallSearch::BallSearch(const Moving<Sphere>& ball, const Bounds& scene)
    : ball_(ball),
      reach_(ball.shape.radius + search_margin * std::max(largest_coordinate(scene), largest_of(ball))) {}

bool BallSearch::reaches(const Bounds& box) const {
  return passage(ball_.shape.center, ball_.displacement, grown(box, reach_), {0, last_}).has_value();
}

//! [same_side]
Sides BallSearch::sides(const Plane& plane, const Passage& part) const {
  const Passage now{part.enter, std::min(part.leave, last_)};
  if (now.empty()) return {now, now};
  const auto distance_at = [&](double t) {  // E.Q(t)
    return plane.signed_distance(ball_.shape.center + t * ball_.displacement);
  };
  const double d1 = distance_at(now.enter), d2 = distance_at(now.leave);
  return {while_at_least(-reach_, d1, d2, now), while_at_least(-reach_, -d1, -d2, now)};
}
//! [same_side]

}  // namespace first_contact
