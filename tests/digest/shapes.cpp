#include "shapes.hpp"

namespace digest {

Plane plane(Dice& dice, double unit) { return {dice.vector(), unit * dice.coordinate()}; }

Rigid turn(Dice& dice) {
  const int w = dice.whole(1, 4), x = dice.whole(-3, 3), y = dice.whole(-3, 3), z = dice.whole(-3, 3);
  const Point shift = dice.point();
  return {Quaternion(w, x, y, z), shift};
}

Box box(Dice& dice, double unit) {
  const Eigen::Matrix3d axes = (dice.one_in(3) ? Rigid() : turn(dice)).rotation();
  const auto axis = [&](int i) { return Vector(unit * dice.length() * axes.col(i)); };
  const Vector r = axis(0), s = axis(1), t = axis(2);
  return {unit * dice.point(), r, s, t};
}

Triangle triangle(Dice& dice, double unit) {
  const Point a = dice.point(), b = dice.point();
  Point c = dice.point();
  if (dice.one_in(6)) c = a + dice.part() * (b - a);  // a splinter, or a segment
  const Vector little = 0x1p-30 * dice.vector();
  if (dice.one_in(6)) c = a + dice.whole(0, 3) * little;  // a needle, or a segment
  return {unit * a, unit * b, unit * c};
}

Moving<Sphere> ball(Dice& dice, double unit) {
  const Point start = 2 * dice.point(), goal = 0.5 * dice.point();
  const Vector way = dice.one_in(12) ? Vector(Vector::Zero()) : Vector(dice.whole(1, 3) * (goal - start));
  return {{unit * start, unit * 0.5 * dice.length()}, unit * way};
}

Moving<Sphere> grazing_ball(Dice& dice, const Point& target, double unit) {
  const Vector out = normalized(dice.vector()), aside = dice.vector(), along = out.cross(aside);
  const double radius = dice.length();
  const double beside = radius * (1 + dice.whole(-8, 8) * 0x1p-52);
  const Point closest = target + unit * beside * out;
  const double before = dice.one_in(4) ? 0 : dice.part();  // when it is there
  const Vector way = unit * (along + dice.whole(-2, 2) * 0x1p-40 * out);
  return {{closest - before * way, unit * radius}, way};
}

Mesh ground(Dice& dice, int n, double unit) {
  const int kind = dice.pick(3);
  std::vector<Point> vertices;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double height = kind == 0 ? 0 : kind == 1 ? dice.whole(-1, 1) / 2.0 : dice.part();
      vertices.emplace_back(unit * Point(4.0 * i / n - 2, 4.0 * j / n - 2, height));
    }
  std::vector<Mesh::Face> faces;
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return {std::move(vertices), std::move(faces)};
}

std::vector<Triangle> soup(Dice& dice, int n, double unit) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < n; ++i) {
    const Point place = 2 * dice.point();
    const auto corner = [&] { return Point(unit * (place + 0.5 * dice.point())); };
    const Point a = corner(), b = corner(), c = corner();
    triangles.emplace_back(a, b, c);
  }
  return triangles;
}

}  // namespace digest
