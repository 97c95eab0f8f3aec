#include "studies.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "camera.hpp"
#include "first_contact/program/counted.hpp"

using namespace first_contact;

namespace box_chapter {

namespace {

constexpr double pi = std::numbers::pi;

Landing dropped(const Text& name, const Point& above, const Vector& r, const Vector& s, const Vector& t) {
  const Moving falling{Box{above, r, s, t}, Vector(0, 0, -above.z())};
  const std::optional<Contact> contact = sweep(falling, Plane({0, 0, 1}, 0));
  return {name, Box{above + contact->time * falling.displacement, r, s, t}, *contact};
}

}  // namespace

//! [landings]
// The brick is 1.8 by 1.2 by 0.9; the turns have rational numbers: 3-4-5 about y, and (1, 2, 2), (2, 1, -2),
// (2, -2, 1) divided by 3.
std::array<Landing, 3> landings() {
  return {dropped({"a vertex", "頂點"}, {-2.6, 0, 3}, {0.6, 1.2, 1.2}, {0.8, 0.4, -0.8}, {0.6, -0.6, 0.3}),
          dropped({"an edge", "稜"}, {0, 0, 3}, {1.44, 0, 1.08}, {0, 1.2, 0}, {-0.54, 0, 0.72}),
          dropped({"a face", "面"}, {2.6, 0, 3}, {1.8, 0, 0}, {0, 1.2, 0}, {0, 0, 0.9})};
}

TurnedTogether turned_together() {
  const Rigid turn(Eigen::Quaterniond(1, 2, 3, 4), {0, 0, 0});
  const Box brick = turn.box({{0, 0, 0}, {1.8, 0, 0}, {0, 1.2, 0}, {0, 0, 0.9}});
  const Vector n = turn.plane(Plane({0, 0, 1}, 0)).normal();
  TurnedTogether count{0, 0, {0, 0, 0}, 0.5 * (brick.r + brick.s).norm()};
  Eigen::Index i = 0;
  for (const Vector& axis : {brick.r, brick.s, brick.t}) {
    count.slopes[i++] = axis.dot(n) / axis.norm();
    count.exact_zeros += axis.dot(n) == 0;
    count.within_tolerance += std::abs(axis.dot(n)) <= parallel_tolerance * axis.norm();
  }
  return count;
}
//! [landings]

//! [sights]
Sight sight_of(const Text& name, const Box& box) {
  const Seen found = seen(box);
  const std::size_t worst = found.worst();
  return {name, box, worst, found.distance[worst], found.radius[worst], found.rejected};
}

std::vector<Sight> sights() {
  const auto judged = [](const Text& name, const Point& q, double turn, const Vector& size) {
    const Rigid stand = Rigid::moved_by(q).after(Rigid::turned({0, 0, 1}, turn));
    return sight_of(name, stand.box({{0, 0, 0}, {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()}}));
  };
  return {judged({"within", "在內"}, {3.4, 0.3, -0.2}, 0.5, {0.8, 0.8, 0.8}),
          judged({"across the side", "跨邊"}, {4.2, -2.4, 0}, 0.2, {1, 1, 0.8}),
          judged({"beside", "在旁"}, {2.4, 3.1, 0}, 0.4, {0.9, 0.9, 0.8}),
          judged({"beyond", "過遠"}, {7.2, -0.6, 0.2}, 0.1, {0.9, 0.9, 0.9}),
          judged({"off an edge", "稜外"}, {6.18, 3.66, 0}, 1.04, {0.25, 3.0, 0.8})};
}
//! [sights]

namespace {

// As many directions as one likes, spread evenly over the sphere, along a golden spiral.
std::vector<Vector> directions(std::size_t count) {
  std::vector<Vector> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double angle = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
    all.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  return all;
}

double width(const std::vector<Point>& points, const Vector& n) {
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [&](const Point& a, const Point& b) { return n.dot(a) < n.dot(b); });
  return n.dot(*high - *low);
}

template <class WidthOf>
double mean_over_directions(WidthOf width_of) {
  const std::vector<Vector> all = directions(2000);
  double sum = 0;
  for (const Vector& n : all) sum += width_of(n);
  return sum / static_cast<double>(all.size());
}

double mean_width(const std::vector<Point>& points) {
  return mean_over_directions([&](const Vector& n) { return width(points, n); });
}

Bounded bounded(const Text& name, double volume, const std::vector<Point>& points) {
  return {name, volume, points, bounding_sphere(points), bounding_box(points), principal_box(points)};
}

}  // namespace

double more_often(const Sphere& sphere, const std::vector<Point>& points) {
  return 2 * sphere.radius / mean_width(points);
}

double more_often(const Box& box, const std::vector<Point>& points) {
  return mean_over_directions([&](const Vector& n) { return 2 * box.effective_radius(n); }) /
         mean_width(points);
}

//! [multiplications]
Multiplications multiplications() {
  using program::Counted;
  using Counted3 = Eigen::Matrix<Counted, 3, 1>;
  const Counted3 n = Counted3::Ones(), center = n, half = n;
  const Eigen::Matrix<Counted, 3, 3> half_axes = Eigen::Matrix<Counted, 3, 3>::Identity();
  const Counted d = 1;
  const auto distance = [&] { return n.dot(center) + d; };
  return {
      Counted::in(distance).multiplications,
      Counted::in([&] { return distance() - half.dot(n.cwiseAbs()); }).multiplications,
      Counted::in([&] { return distance() - (half_axes.transpose() * n).cwiseAbs().sum(); }).multiplications};
}
//! [multiplications]

std::string rounded(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

//! [bounded_shapes]
std::array<Bounded, 3> bounded_shapes() {
  const Rigid lean = Rigid::turned({0, 0, 1}, 0.6).after(Rigid::turned({0, 1, 0}, -0.7));
  const Box plank{{0, 0, 0}, {3.2, 0, 0}, {0, 0.9, 0}, {0, 0, 0.4}};
  const auto plank_corners = lean.box(plank).vertices();

  std::vector<Point>
      bracket;  // an L of two bricks, each 2.4 by 1.2 by 0.5, one standing on the end of the other
  for (const double y : {-0.6, 0.6})
    for (const auto& [x, z] :
         {std::pair{0.0, 0.0}, {2.4, 0.0}, {2.4, 0.5}, {0.5, 0.5}, {0.5, 2.9}, {0.0, 2.9}})
      bracket.emplace_back(x, y, z);

  return {
      bounded({"a leaning plank", "斜置木板"}, volume(plank), {plank_corners.begin(), plank_corners.end()}),
      bounded({"a bracket", "L 形角鐵"}, 2 * 2.4 * 1.2 * 0.5, bracket),
      bounded({"a ball", "球"}, volume(Sphere{{0, 0, 0}, 1}), directions(2000))};
}
//! [bounded_shapes]

}  // namespace box_chapter
