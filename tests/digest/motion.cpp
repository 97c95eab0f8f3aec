#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/css_easing.hpp"
#include "first_contact/motion/easing_family.hpp"
#include "first_contact/motion/sweep_tween.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/stage/hit_test.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "record.hpp"
#include "shapes.hpp"

/// Motion, and the stage. Left out is what goes through a sine, a power or a logarithm of the C library,
/// which each library rounds as it likes: the sine, exponential and elastic easings, damp, turns at constant
/// speed (slerp), Rigid::turned and with it meshes that turn, perspective, the impacts of a bounce after the first,
/// and, with the shapes, principal_box. \see tests/oracle/left_out.cpp
namespace digest {

namespace {

std::vector<Point> control_points(Dice& dice, int n, double unit) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back(unit * dice.point());
  return points;
}

Curve curve(Dice& dice, double unit) {
  const int n = dice.whole(2, 7);
  std::vector<Point> points = control_points(dice, n, unit);
  if (dice.one_in(2)) return Bezier(std::move(points));
  return BSpline(std::move(points), static_cast<std::size_t>(dice.whole(1, std::min(3, n - 1))));
}

void curves(Record& record) {
  Dice dice(20);
  for (int i = 0; i < cases; ++i, record.next()) {
    const Curve c = curve(dice, dice.scale());
    const double u = 1.5 * dice.part() - 0.25;
    record.add(at(c, u));
    record.add(at(derivative(c), u));
  }
}

void through_points(Record& record) {
  Dice dice(27);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const auto count = dice.whole(2, 6);
    std::vector<Point> points = control_points(dice, count, dice.scale());
    if (dice.one_in(4)) points.push_back(points.back());
    const auto knots = static_cast<Knots>(dice.pick(3));
    record.add(at(catmull_rom(points, knots), dice.part()));
  }
}

void legs(Record& record) {
  Dice dice(28);
  for (int i = 0; i < cases / 100; ++i, record.next()) {
    const std::vector<Point> p = control_points(dice, 7, 1);
    const Path path =
        Path::of_legs({Path(), Path::bezier({p[0]}), Path::through({p[1], p[2]})}, {p[3], p[4]});
    const Leg leg(path, p[5], p[6]);
    record.add(leg.by_length()->total());
    record.add(leg.at(1.5 * dice.part() - 0.25));
  }
}

void lengths(Record& record) {
  Dice dice(21);
  for (int i = 0; i < cases / 100; ++i, record.next()) {
    const ArcLength length(curve(dice, 1));
    record.add(length.total());
    for (int k = 0; k < 8; ++k) record.add(length.at(dice.part()));
  }
}

/// The easings that are made of additions, products, quotients and roots.
std::vector<Easing> exact_easings() {
  std::vector<Easing> exact;
  for (const ease::Named& named : ease::all()) {
    const auto is = [&](const char* family) { return named.name.find(family) != named.name.npos; };
    if (!is("sine") && !is("exponential") && !is("elastic")) exact.push_back(named.easing);
  }
  return exact;
}

void easings(Record& record) {
  Dice dice(22);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const double t = dice.one_in(4) ? dice.coordinate() : dice.part();
    for (const Easing& easing : exact_easings()) record.add(easing(t));
  }
}

void style_sheets(Record& record) {
  Dice dice(30);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const double x1 = dice.part(), y1 = dice.coordinate(), x2 = dice.part(), y2 = dice.coordinate();
    const Easing curve = ease::cubic_bezier(x1, y1, x2, y2);
    const auto count = dice.whole(2, 9);
    const Easing stairs = ease::steps(count, static_cast<ease::Jump>(dice.pick(4)));
    const Easing back = ease::back(dice.length());
    for (int k = 0; k < 4; ++k) {
      const double t = dice.part();
      record.add(curve(t));
      record.add(stairs(t));
      record.add(back(t));
    }
  }
}

Tween tween(Dice& dice) {
  const std::vector<Easing> list = exact_easings();
  std::vector<KeyFrame> keys;
  double time = dice.coordinate();
  for (int i = dice.whole(1, 5); i > 0; --i) {
    const Path path = dice.one_in(2) ? Path() : Path::bezier(control_points(dice, 2, 1));
    const Point place = dice.point();
    keys.push_back({time, place, list[dice.bits() % list.size()], path});
    time += 0.125 + dice.part();
  }
  return Tween(std::move(keys));
}

void tweens(Record& record) {
  Dice dice(23);
  for (int i = 0; i < cases / 10; ++i) {
    const Tween motion = tween(dice);
    for (int k = 0; k < 10; ++k, record.next()) record.add(motion.at(8 * dice.part() - 2));
  }
}

void along_curves(Record& record) {
  Dice dice(24);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const Curve path = curve(dice, 1);
    const double radius = 0.25 * dice.length();
    const Plane floor = plane(dice, 1);
    record.add(sweep_along(path, radius, floor, 0x1p-8 * std::max(1.0, largest_coordinate(floor))));
    record.add(sweep_along(path, radius, triangle(dice, 1), 0x1p-8));
  }
}

void swept_tweens(Record& record) {
  Dice dice(29);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const Tween motion = tween(dice);
    const double radius = 0.25 * dice.length();
    const Plane floor = plane(dice, 1);
    record.add(sweep(motion, radius, floor));
    record.add(sweep(motion, radius, triangle(dice, 1)));
  }
}

void bounces(Record& record) {
  Dice dice(25);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double height = dice.length(), speed = dice.coordinate(), gravity = dice.length();
    const Bounce ball(height, speed, gravity, dice.one_in(3) ? 1 : dice.part());
    const auto landing = ball.impact(1);
    record.add(landing.has_value());
    if (!landing) continue;
    record.add(landing->time);
    record.add(landing->speed);
    record.add(ball.height(dice.part() * landing->time));
    if (const auto top = ball.apex(0)) record.add(top->height);
  }
}

StageObject object(Dice& dice) {
  std::vector<Point2> outline;
  for (int i = dice.whole(3, 7); i > 0; --i) outline.push_back(dice.point().head<2>());
  Eigen::Affine2d stand = Eigen::Affine2d::Identity();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j) stand(i, j) += dice.whole(-2, 2) / 2.0;
  return StageObject(outline, stand);
}

void hit_tests(Record& record) {
  Dice dice(26);
  for (int i = 0; i < cases; ++i, record.next()) {
    const std::vector<StageObject> drawn{object(dice), object(dice)};
    const Point2 corner = drawn[0].outline()[0],
                 pointer = dice.one_in(3) ? corner : Point2(dice.point().head<2>());
    record.add(hit_test_point(drawn[0], pointer));
    record.add(hit_test_point(drawn[1], pointer, true));
    record.add(hit_test_object(drawn[0], drawn[1]));
    record.add(overlap(drawn[0], drawn[1]));
    if (const auto on_top = pick(drawn, pointer)) record.count(*on_top);
  }
}

}  // namespace

std::vector<Verb> motion_verbs() {
  return {{"curves", curves},
          {"curves through points", through_points},
          {"paths of legs", legs},
          {"arc length", lengths},
          {"easings", easings},
          {"easings of style sheets", style_sheets},
          {"tweens", tweens},
          {"sweep along", along_curves},
          {"sweep tween", swept_tweens},
          {"bounce", bounces},
          {"hit tests", hit_tests}};
}

}  // namespace digest
