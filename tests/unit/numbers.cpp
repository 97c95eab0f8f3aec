// Where arithmetic goes wrong though the formula is right: curves that turn back, far planes, tiny normals, huge
// stages. The kinds were found in public reports of other libraries, which are named with each case.
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/frustum.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/stage/hit_test.hpp"
#include "places.hpp"

using namespace first_contact;
using nlohmann::json;

namespace {

json cases_of(const std::string& kind) {
  std::ifstream file(std::string(first_contact::places::source) + "/tests/data/numbers.json");
  REQUIRE(file);
  json chosen = json::array();
  for (const json& one : json::parse(file))
    if (one["kind"] == kind) chosen.push_back(one);
  REQUIRE_FALSE(chosen.empty());
  return chosen;
}

template <class Vector>
Vector from(const json& numbers) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = numbers[static_cast<std::size_t>(i)].get<double>();
  return v;
}

template <class Vector>
std::vector<Vector> all_from(const json& list) {
  std::vector<Vector> all;
  for (const json& numbers : list) all.push_back(from<Vector>(numbers));
  return all;
}

std::string name(const json& one) {
  return one["id"].get<std::string>() + " (" + one["source"].get<std::string>() + ")";
}

}  // namespace

TEST_CASE("The lengths of curves that others got wrong") {
  for (const json& one : cases_of("length")) {
    INFO(name(one));
    const double truth = one["length"].get<double>();
    const ArcLength length(Bezier(all_from<Point>(one["points"])));
    CHECK(std::abs(length.total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("A curve with an end that is there twice goes on beyond it along its tangent") {
  for (const json& one : cases_of("beyond")) {
    INFO(name(one));
    const ArcLength length(Bezier(all_from<Point>(one["points"])));
    for (std::size_t i = 0; i < one["parts"].size(); ++i)
      CHECK((length.at(one["parts"][i].get<double>()) - from<Point>(one["at"][i])).norm() <= 1e-12);
  }
}

TEST_CASE("A frustum keeps what it sees and rejects what it does not, however far its far plane") {
  for (const json& one : cases_of("frustum")) {
    INFO(name(one));
    const Frustum sight(Transform::perspective(one["view"][0].get<double>(), one["view"][1].get<double>(),
                                               one["near"].get<double>(), one["far"].get<double>()));
    const bool is_sphere = one.contains("sphere");
    const json& shape = one[is_sphere ? "sphere" : "box"];
    const double size = shape[3].get<double>();
    const Point center = from<Point>(shape);
    const bool no_view = is_sphere ? rejected(sight, Sphere{center, size})
                                   : rejected(sight, Box{center, {size, 0, 0}, {0, size, 0}, {0, 0, size}});
    CHECK(no_view == one["rejected"].get<bool>());
  }
}

TEST_CASE("Bodies part as they should, in any units", "[impact]") {
  using Eigen::Vector2d;
  for (const json& one : cases_of("impact")) {
    INFO(name(one));
    const json &mass = one["masses"], &before = one["velocities"];
    const auto after =
        impact<2>({mass[0].get<double>(), from<Vector2d>(before[0])},
                  {mass[1].get<double>(), from<Vector2d>(before[1])}, from<Vector2d>(one["normal"]), 1);
    const Vector2d p = from<Vector2d>(one["after"][0]), q = from<Vector2d>(one["after"][1]);
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * (p + q).cwiseAbs().maxCoeff();
    CHECK((after.velocity_p - p).cwiseAbs().maxCoeff() <= rounding);
    CHECK((after.velocity_q - q).cwiseAbs().maxCoeff() <= rounding);
  }
}

TEST_CASE("A triangle is hit where it is, on a stage of any size") {
  for (const json& one : cases_of("hit")) {
    INFO(name(one));
    const StageObject object(all_from<Point2>(one["outline"]));
    const Point2 point = from<Point2>(one["point"]);
    CHECK(hit_test_point(object, point) == one["box"].get<bool>());
    CHECK(hit_test_point(object, point, true) == one["shape"].get<bool>());
  }
}

TEST_CASE("A bounding sphere far from the origin is as small as its centre's coordinates let it be") {
  for (const json& one : cases_of("bounding")) {
    INFO(name(one));
    const std::vector<Point> points = all_from<Point>(one["points"]);
    const Sphere sphere = bounding_sphere(points);
    const double truth = one["radius"].get<double>(), eps = std::numeric_limits<double>::epsilon();
    CHECK(sphere.radius <= (1 + 1e-9) * truth + 2 * eps * points[0].cwiseAbs().maxCoeff());
    for (const Point& p : points) CHECK((p - sphere.center).norm() <= sphere.radius);
  }
}
