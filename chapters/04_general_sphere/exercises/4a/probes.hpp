#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge computes with more digits, from the point that is nearest to the origin.
inline std::optional<double> judge(Vector m, Vector v, double r) {
  using Long = long double;
  const Long mx = m.x, my = m.y, mz = m.z, vx = v.x, vy = v.y, vz = v.z, radius = r;
  const Long vv = vx * vx + vy * vy + vz * vz, mv = mx * vx + my * vy + mz * vz;
  if (!(vv > 0) || mv >= 0) return {};
  const Long nearest = -mv / vv, x = mx + nearest * vx, y = my + nearest * vy, z = mz + nearest * vz;
  const Long half = (radius * radius - (x * x + y * y + z * z)) / vv;
  if (half < 0) return {};
  return static_cast<double>(nearest - std::sqrt(half));
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the first t >= 0 at which m + tv is at the distance r from the origin, or nothing";
  probes.names = {"m", "v", "r"};
  probes.chosen = {
      {"straight at the middle", {{-3, 0, 0}, {1, 0, 0}, 1}},
      {"a velocity that is no unit vector", {{-3, 0, 0}, {4, 0, 0}, 1}},
      {"aside of the middle", {{-4, 3, 0}, {2, 0, 0}, 5 - 0.5}},
      {"it passes by", {{-3, 2, 0}, {1, 0, 0}, 1}},
      {"it moves away", {{3, 0, 0}, {1, 0, 0}, 1}},
      {"it moves away, slantwise", {{3, 1, 0}, {1, 0.5, 0}, 1}},
      {"it moves across, and never nearer", {{3, 0, 0}, {0, 1, 0}, 1}},
      {"no motion", {{3, 0, 0}, {0, 0, 0}, 1}},
      {"a thousand radii away", {{-1000, 0.5, 0.25}, {1000, 0, 0}, 1}},
      {"ten million radii away, from the side", {{-6e6, -8e6 + 0.625, 0}, {6e6, 8e6, 0}, 1}},
      {"ten million radii away, slantwise", {{-3e6, -4e6, -9e6 + 0.5}, {3e6, 4e6, 9e6}, 1}},
  };
  probes.random = [](Chance& chance) {
    const Vector aim = chance.vector(1.25), v = chance.vector(4);
    const double far = chance.one_of(std::vector<double>{1, 3, 1e3, 1e6});
    return std::tuple{aim - far * v, (chance.below(4) == 0 ? -1 : 1) * v, 1.0};
  };
  probes.allowed = [](const auto& input) {
    const auto& [m, v, r] = input;
    const double nearest = norm(cross(m, v)) / norm(v);  // no grazing: no formula knows its time well
    return r > 0 && norm(m) > 1.001 * r && std::abs(nearest / r - 1) > 0.05;
  };
  probes.judge = judge;
  probes.tolerance = 1e-13;
  probes.along = {"y of m", -2, 2, [](auto& input, double at) { std::get<0>(input).y = at; }};
  return probes;
}
