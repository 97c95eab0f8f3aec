#include "walk.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/soup.hpp"

namespace walks {

namespace {

constexpr int frames_per_way = 50;
constexpr int frames_to_rest = 100;  // until a ball that is set down lies where it is pushed to

//! [clearance]
// How far the surface is from a ball, measured without a sweep: among the triangles near it.
class Clearance {
 public:
  explicit Clearance(const Mesh& mesh) : triangles_(mesh) {}

  double of(const Sphere& ball) const {
    const Vector reach = Vector::Constant(1.1 * ball.radius);
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : near(Bounds(ball.center - reach, ball.center + reach), triangles_))
      nearest = std::min(nearest, (closest_point(ball.center, triangles_.all()[i]) - ball.center).norm());
    return nearest - ball.radius;
  }

 private:
  Soup<BoxTree> triangles_;
};
//! [clearance]

// The range of places at which a ball lies.
struct Rest {
  int frames = 0;  // since it was set down
  Bounds places;

  double drift(const Point& place, const Vector& still) {
    if (++frames > frames_to_rest) places.extend(place);
    return places.isEmpty() ? 0 : places.sizes().cwiseProduct(still).maxCoeff();
  }
};

}  // namespace

//! [walk]
Walk walk(const Ground& ground, long frames, std::uint64_t seed) {
  const Bvh bvh{Mesh(ground.mesh)};
  const Clearance clearance(ground.mesh);
  const double size = largest_coordinate(bvh);
  program::Random random(seed);
  Walk total;
  Rest rest;
  Sphere ball = ground.ball;
  Vector way = Vector::Zero();
  for (; total.frames < frames; ++total.frames) {
    if (total.frames % frames_per_way == 0) way = ground.way(random);
    if ((ball.center - ground.ball.center).lpNorm<Eigen::Infinity>() > ground.reach) {
      ball = ground.ball;
      rest = {};
    }
    const double speed = way.norm();
    const Vector forwards = (way / speed + ground.pull(ball.center)).normalized();
    const auto begin = std::chrono::steady_clock::now();
    const Slide path = slide({ball, speed * forwards}, bvh);
    total.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    const double back = -(path.end() - ball.center).dot(forwards) / size;
    ball.center = path.end();
    total.contacts += std::ssize(path.contacts);
    total.exhausted += path.ending == Ending::exhausted;
    total.tunnelled += !ground.on_its_side(ball.center, bvh);
    total.reversed += back > Walk::limit;
    total.backwards = std::max(total.backwards, back);
    total.depth = std::max(total.depth, -clearance.of(ball) / size);
    total.drift = std::max(total.drift, rest.drift(ball.center, ground.still) / size);
    total.trail.push_back(ball.center);
  }
  return total;
}
//! [walk]

bool Walk::good() const {
  return contacts > 0 && tunnelled == 0 && reversed == 0 && depth <= limit && drift <= drift_limit;
}

}  // namespace walks
