// Films at random: whatever is designed, nothing goes into what is in the way.
#include <cmath>
#include <random>

#include "catch.hpp"
#include "film/showing.hpp"

using namespace first_contact;
using namespace tween_bounce;

namespace {

using Random = std::mt19937_64;

double number(Random& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Point place(Random& random, double low) {
  return {number(random, -4, 4), number(random, -4, 4), number(random, low, 5)};
}

Path any_path(Random& random) {
  const std::vector<Point> points{place(random, -4), place(random, -4)};
  switch (random() % 5) {
    case 0:
      return {};
    case 1:
      return Path::bezier(points);
    case 2:
      return Path::through(points, true);
    case 3:
      return Path::hermite(points[0], points[1]);
    default:
      return Path::b_spline(points, true);
  }
}

ContactRule any_rule(Random& random) {
  switch (random() % 3) {
    case 0:
      return {"stop", After::stop()};
    case 1:
      return {"slide", After::slide(number(random, 0, 0.5))};
    default:
      return {"bounce", After::bounce(number(random, 0, 1), number(random, 0, 0.5))};
  }
}

// A ball that begins above the floor and between two walls, and keys that know of neither.
Film any_film(Random& random) {
  const auto easings = ease::all();
  Film film{"any", Sphere{Point::Zero(), number(random, 0.1, 1)}, {}};
  for (int i = 0; i < 3; ++i)
    film.keys.push_back({static_cast<double>(i), place(random, i == 0 ? 1.5 : -4), Quaternion(1, 0, 0, 0), 1,
                         easings[random() % easings.size()].easing, any_path(random)});
  film.walls = {
      Plane({0, 0, 1}, 0), Plane({-1, 0, 0}, 5.5), Plane({1, 0.2, 0}, 6),
      Box({number(random, -3, 3), number(random, -3, 3), 0.1}, {0.6, 0, 0}, {0, 1, 0}, {0, 0, 0.2})};
  film.contact = any_rule(random);
  return film;
}

Quaternion any_turn(Random& random) {
  return {number(random, -1, 1), number(random, -1, 1), number(random, -1, 1), number(random, -1, 1)};
}

double distance(const Wall& wall, const Point& from) {
  if (const Plane* plane = std::get_if<Plane>(&wall)) return plane->normal().dot(from) + plane->offset();
  const Box& box = std::get<Box>(wall);  // an upright one
  const Vector beyond = (from - box.center).cwiseAbs() - (box.r + box.s + box.t) / 2;
  return beyond.cwiseMax(0).norm();
}

}  // namespace

TEST_CASE("A film of any keys, ways and easings never goes into a wall") {
  constexpr double hair = 1e-6;  // what tween_gap allows for each of many contacts
  Random random(20261126);
  std::size_t contacts = 0;
  for (int i = 0; i < 24; ++i) {
    const Film film = any_film(random);
    const Showing showing(film);
    CAPTURE(i, film.contact.what, showing.contacts().size());
    contacts += showing.contacts().size();
    double nearest = 1;
    for (int k = 0; k <= 400; ++k) {
      const Frame frame = showing.at(2 * k / 400.0);
      for (const Wall& wall : film.walls)
        nearest = std::min(nearest, distance(wall, frame.place) - std::get<Sphere>(film.actor).radius);
    }
    CHECK(nearest >= -hair);
  }
  CHECK(contacts > 24);
}

TEST_CASE("A film of a box that tumbles stops it before any of its corners is in the floor or in a wall") {
  constexpr double hair = 1e-6;
  Random random(7);
  std::size_t contacts = 0;
  for (int i = 0; i < 24; ++i) {
    Film film = any_film(random);
    const Box box({0, 0, 0}, {number(random, 0.1, 1.2), 0, 0}, {0, number(random, 0.1, 1.2), 0}, {0, 0, 1});
    film.actor = box;
    film.walls.pop_back();
    film.contact = {"stop", After::stop()};
    for (FilmKey& key : film.keys) key.turn = any_turn(random);
    const Showing showing(film);
    CAPTURE(i, showing.contacts().size());
    contacts += showing.contacts().size();
    double nearest = 1;
    for (int k = 0; k <= 400; ++k) {
      const Frame frame = showing.at(2 * k / 400.0);
      const Box turned = Rigid(Quaternion(frame.turn.coeffs()), frame.place).box(box);
      for (const Wall& wall : film.walls)
        nearest = std::min(
            nearest, distance(wall, turned.center) - turned.effective_radius(std::get<Plane>(wall).normal()));
    }
    CHECK(nearest >= -hair);
  }
  CHECK(contacts > 12);
}
