#include "accuracy.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "first_contact/program/random.hpp"
#include "first_contact/sweep/contact_times.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "twofold.hpp"

using namespace first_contact;
using program::Accuracy, program::uniform, program::unit_vector;

namespace general_sphere_chapter {

namespace {

constexpr int shots = 2000;

// 10^(n/4), without std::pow, whose last bit is not the same everywhere.
double quarter_decades(int n) {
  double power = 1;
  for (int i = 0; i < std::abs(n); ++i) power *= 10;
  power = std::sqrt(std::sqrt(power));
  return n < 0 ? 1 / power : power;
}

// A flight at the edge e that begins at the origin, from m by v, with the radius 1.
template <class Scalar>
struct Flight {
  Vector3<Scalar> e, m, v;
};

template <class Scalar>
Flight<Scalar> flight_from(double distance, std::mt19937& random) {
  Vector edge, direction;
  do {
    edge = unit_vector(random);
    direction = unit_vector(random);
  } while (std::abs(edge.dot(direction)) > 0.8);
  const Vector beside = 0.9 * uniform(random) * edge.cross(direction).normalized();
  const Vector start = edge + beside - distance * direction;  // the middle of the edge is at `edge`
  const Vector travel = (1.5 + 0.4 * uniform(random)) * distance * direction;
  return {(2 * edge).cast<Scalar>(), start.cast<Scalar>(), travel.cast<Scalar>()};
}

//! [edge_formulas]
// When does the centre enter the cylinder of radius 1 about the edge? As books multiply it out: dot products
// of dot products, of size L^2, whose difference should be of size 1.
template <class Scalar>
std::optional<Scalar> textbook_time(const Flight<Scalar>& flight) {
  const auto& [e, m, v] = flight;
  const Scalar ee = e.dot(e), ev = e.dot(v), em = e.dot(m);
  const Scalar a = ee * v.dot(v) - ev * ev, b = ee * m.dot(v) - em * ev, c = ee * (m.dot(m) - 1) - em * em;
  const Scalar discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  return (-b - std::sqrt(discriminant)) / a;
}

// As touch_edge has it: flattened by the cross product, then the closest approach.
template <class Scalar>
std::optional<Scalar> stable_time(const Flight<Scalar>& flight) {
  const auto& [e, m, v] = flight;
  const auto times = contact_times<Scalar>(e.cross(m), e.cross(v), e.norm());
  if (!times) return std::nullopt;
  return times->begin;
}
//! [edge_formulas]

// The truth, on the same numbers; nothing if, rounded to this precision, they miss each other.
template <class Scalar>
std::optional<double> true_time(const Flight<Scalar>& flight) {
  const auto exact = [](const Vector3<Scalar>& a) {
    return Three{double(a.x()), double(a.y()), double(a.z())};
  };
  const Three e = exact(flight.e), w = cross(e, exact(flight.m)), u = cross(e, exact(flight.v));
  const Three moment = cross(w, u);
  const Twofold b = dot(w, u), c = dot(w, w) - dot(e, e);
  const Twofold discriminant = dot(u, u) * dot(e, e) - dot(moment, moment);
  if (discriminant.high < 0 || c.high <= 0) return std::nullopt;
  return (c / (root(discriminant) - b)).high;
}

template <class Scalar>
Accuracy accuracy_from(EdgeFormula formula, double distance, std::mt19937& random) {
  std::vector<double> errors;
  for (int shot = 0; shot < shots; ++shot) {
    const Flight<Scalar> flight = flight_from<Scalar>(distance, random);
    const auto truth = true_time(flight);
    if (!truth) continue;
    const auto time = formula == EdgeFormula::textbook ? textbook_time(flight) : stable_time(flight);
    errors.push_back(time ? std::abs(static_cast<double>(*time) - *truth) / *truth : program::lost_shot);
  }
  return program::accuracy(distance, std::move(errors));
}

// A ray at a triangle, and whether it was aimed into it.
template <class Scalar>
struct Ray {
  Vector3<Scalar> a, b, c, start, travel;
  bool hits;
};

template <class Scalar>
Ray<Scalar> ray_at(double size, bool hits, std::mt19937& random) {
  std::array<Vector, 3> corner;
  Vector normal;
  do {
    for (Vector& each : corner) each = {uniform(random), uniform(random), uniform(random)};
    normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  } while (normal.norm() < 0.5);
  // Weights of the corners; less than 0 for the first one is beside the triangle.
  const double first = hits ? 0.35 + 0.25 * uniform(random) : -0.3 + 0.25 * uniform(random);
  const double second = (1 - first) * (0.5 + 0.4 * uniform(random));
  const Vector target = first * corner[0] + second * corner[1] + (1 - first - second) * corner[2];
  Vector direction;
  do direction = unit_vector(random);
  while (std::abs(direction.dot(normal)) < 0.3 * normal.norm());
  const auto scaled = [&](const Vector& v) { return Vector3<Scalar>((size * v).cast<Scalar>()); };
  return {scaled(corner[0]),          scaled(corner[1]),     scaled(corner[2]),
          scaled(target - direction), scaled(2 * direction), hits};
}

//! [ray_tests]
constexpr double tolerance = 1e-5;

template <class Scalar>
bool hit_by_determinant(const Ray<Scalar>& ray) {
  const Vector3<Scalar> u = ray.b - ray.a, v = ray.c - ray.a, across = ray.travel.cross(v);
  const Scalar determinant = u.dot(across);
  if (std::abs(determinant) < static_cast<Scalar>(tolerance)) return false;  // "parallel"
  const Vector3<Scalar> s = ray.start - ray.a, q = s.cross(u);
  const Scalar i = s.dot(across) / determinant, j = ray.travel.dot(q) / determinant;
  const Scalar t = v.dot(q) / determinant;
  return i >= 0 && j >= 0 && i + j <= 1 && t >= 0 && t <= 1;
}

template <class Scalar>
bool hit_by_areas(const Ray<Scalar>& ray) {
  const Vector3<Scalar> normal = (ray.b - ray.a).cross(ray.c - ray.a);
  const Scalar t = normal.dot(ray.a - ray.start) / normal.dot(ray.travel);
  const Vector3<Scalar> p = ray.start + t * ray.travel;
  const auto area = [](const auto& a, const auto& b, const auto& c) {
    return (b - a).cross(c - a).norm() / 2;
  };
  const Scalar parts = area(p, ray.a, ray.b) + area(p, ray.b, ray.c) + area(p, ray.c, ray.a);
  const Scalar excess = std::abs(parts - normal.norm() / 2);
  return excess < static_cast<Scalar>(tolerance) && t >= 0 && t <= 1;
}

template <class Scalar>
bool hit_by_weights(const Ray<Scalar>& ray) {
  const auto point = [](const Vector3<Scalar>& p) { return Point(p.template cast<double>()); };
  const Triangle triangle(point(ray.a), point(ray.b), point(ray.c));
  return sweep(Moving<Point>{point(ray.start), point(ray.travel)}, triangle).has_value();
}
//! [ray_tests]

template <class Scalar>
bool hit(RayTest test, const Ray<Scalar>& ray) {
  switch (test) {
    case RayTest::determinant:
      return hit_by_determinant(ray);
    case RayTest::areas:
      return hit_by_areas(ray);
    default:
      return hit_by_weights(ray);
  }
}

}  // namespace

template <class Scalar>
std::vector<Accuracy> accuracy_at_an_edge(EdgeFormula formula) {
  std::mt19937 random(1);
  std::vector<Accuracy> results;
  for (int half_decade = 1; half_decade <= 20; ++half_decade) {
    const double distance = quarter_decades(2 * half_decade);
    if (distance * std::numeric_limits<Scalar>::epsilon() > 1) break;
    results.push_back(accuracy_from<Scalar>(formula, distance, random));
  }
  return results;
}

template <class Scalar>
std::vector<Wrong> wrong_answers(RayTest test) {
  std::mt19937 random(2);
  std::vector<Wrong> results;
  for (int quarter = -24; quarter <= 24; ++quarter) {
    const double size = quarter_decades(quarter);
    int wrong = 0;
    for (int shot = 0; shot < shots; ++shot) {
      const Ray<Scalar> ray = ray_at<Scalar>(size, shot % 2 == 0, random);
      wrong += hit(test, ray) != ray.hits;
    }
    results.push_back({size, static_cast<double>(wrong) / shots});
  }
  return results;
}

template std::vector<Accuracy> accuracy_at_an_edge<float>(EdgeFormula);
template std::vector<Accuracy> accuracy_at_an_edge<double>(EdgeFormula);
template std::vector<Wrong> wrong_answers<float>(RayTest);
template std::vector<Wrong> wrong_answers<double>(RayTest);

// What the notes speak of.
void note_accuracy(program::Program& program) {
  const auto note = [&](const std::string& precision, const std::string& formula,
                        const std::vector<program::Accuracy>& measured) {
    for (std::size_t decade = 1; 2 * decade <= measured.size(); ++decade) {
      const program::Accuracy& each = measured[2 * decade - 1];
      const std::string where = "accuracy." + precision + "_1e" + std::to_string(decade) + "_" + formula;
      if (std::isfinite(each.error)) program.value(where, each.error);
      program.value(where + "_lost", each.lost);
    }
  };
  note("single", "textbook", accuracy_at_an_edge<float>(EdgeFormula::textbook));
  note("single", "stable", accuracy_at_an_edge<float>(EdgeFormula::stable));
  note("double", "textbook", accuracy_at_an_edge<double>(EdgeFormula::textbook));
  note("double", "stable", accuracy_at_an_edge<double>(EdgeFormula::stable));

  // Where a test begins to fail: the sizes between which at most one answer in a hundred is wrong.
  const auto span = [&](const std::string& name, const std::vector<Wrong>& measured) {
    double from = 0, to = 0;
    for (const Wrong& each : measured)
      if (each.share <= 0.01) {
        if (from == 0) from = each.size;
        to = each.size;
      }
    program.value("tolerance." + name + "_from", from);
    program.value("tolerance." + name + "_to", to);
  };
  span("determinant", wrong_answers<double>(RayTest::determinant));
  span("areas_single", wrong_answers<float>(RayTest::areas));
  span("areas_double", wrong_answers<double>(RayTest::areas));
  span("none", wrong_answers<double>(RayTest::weights));
  program.value("tolerance.areas_single_wrong", wrong_answers<float>(RayTest::areas).back().share);
}

}  // namespace general_sphere_chapter
