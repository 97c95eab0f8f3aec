#pragma once
#include <cmath>

#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge lists all eight vertices and keeps those that are within rounding of the lowest.
inline std::vector<Point> judge(const Box& box, Vector N) {
  std::vector<Point> all;
  for (const double a : {-0.5, 0.5})
    for (const double b : {-0.5, 0.5})
      for (const double c : {-0.5, 0.5}) {
        const bool twice =
            (a > 0 && norm(box.R) == 0) || (b > 0 && norm(box.S) == 0) || (c > 0 && norm(box.T) == 0);
        if (!twice) all.push_back(box.Q + a * box.R + b * box.S + c * box.T);
      }
  double lowest = std::numeric_limits<double>::infinity();
  for (const Point& each : all) lowest = std::min(lowest, dot(each - box.Q, N));
  const double rounding =
      48 * std::numeric_limits<double>::epsilon() * (norm(box.R) + norm(box.S) + norm(box.T));
  std::erase_if(all, [&](const Point& each) { return dot(each - box.Q, N) > lowest + rounding; });
  return all;
}

/// Turned about z, and then about x.
inline Vector turned(Vector v, double about_z, double about_x) {
  v = {std::cos(about_z) * v.x - std::sin(about_z) * v.y, std::sin(about_z) * v.x + std::cos(about_z) * v.y,
       v.z};
  return {v.x, std::cos(about_x) * v.y - std::sin(about_x) * v.z,
          std::sin(about_x) * v.y + std::cos(about_x) * v.z};
}
inline std::tuple<Box, Vector> turned(const std::tuple<Box, Vector>& scene, double z, double x) {
  const auto& [box, N] = scene;
  return {{box.Q, turned(box.R, z, x), turned(box.S, z, x), turned(box.T, z, x)}, turned(N, z, x)};
}

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  const Vector up{0, 0, 1};
  const double half_degree = 0.5 * std::acos(-1.0) / 180;
  const std::tuple flat{Box{{0, 0, 0.5}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}}, up};
  const std::tuple on_edge{Box{{0, 0, 2}, {3, 0, 4}, {0, 2, 0}, {-4, 0, 3}}, up};
  const std::tuple on_corner{Box{{0, 0, 2}, {1, 2, 2}, {2, 1, -2}, {2, -2, 1}}, up};
  const Box tilted{{0, 0, 1},
                   turned({4, 0, 0}, 0, half_degree),
                   turned({0, 2, 0}, 0, half_degree),
                   turned({0, 0, 1}, 0, half_degree)};
  std::vector<Exercise<Signature>::Chosen> list{
      {"on a corner: one point", on_corner},
      {"on an edge: two points", on_edge},
      {"flat: four points", flat},
      {"a box upside down on its corner", {{{0, 0, 2}, {-1, -2, -2}, {-2, -1, 2}, {-2, 2, -1}}, up}},
      {"a normal that points down", {std::get<0>(on_edge), -up}},
      {"tilted by half a degree: on its edge", {tilted, up}},
      {"a plate that lies: four points", {{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 0}}, up}},
      {"a thousand times as large, flat and turned",
       turned(std::tuple{Box{{0, 0, 500}, {4000, 0, 0}, {0, 2000, 0}, {0, 0, 1000}}, up}, 0.7, 1.1)},
  };
  for (int i = 1; i <= 6; ++i) {
    list.push_back(
        {"flat, and turned together with its floor: still four points", turned(flat, 0.7 * i, 1.1 * i)});
    list.push_back({"on an edge, and turned together with its floor: still two points",
                    turned(on_edge, 0.9 * i, 0.4 * i)});
  }
  return list;
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the lowest vertices along N: one, two or four, in any order";
  probes.names = {"box", "N"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    const Box axes{
        {}, {chance.number(0.25, 4), 0, 0}, {0, chance.number(0.25, 4), 0}, {0, 0, chance.number(0.25, 4)}};
    auto scene = turned({axes, Vector{0, 0, 1}}, chance.number(0, 6), chance.number(0, 6));
    std::get<0>(scene).Q = chance.vector(2);
    std::get<1>(scene) = chance.unit();
    return scene;
  };
  probes.allowed = [](const auto& input) {
    const auto& [box, N] = input;
    return std::abs(norm(N) - 1) < 1e-6 &&
           std::abs(dot(box.R, box.S)) + std::abs(dot(box.S, box.T)) + std::abs(dot(box.T, box.R)) < 1e-4;
  };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.any_order = true;
  probes.along = {"tilt of N, radians (x of the first point)", -0.5, 0.5, [](auto& input, double at) {
                    std::get<1>(input) = {std::sin(at), 0, std::cos(at)};
                  }};
  return probes;
}
