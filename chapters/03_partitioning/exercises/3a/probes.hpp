#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge walks from border to border: every time at which a side is met, and what is in between.
inline bool is_in(const Bounds& box, Point S) {
  const double slack = 1e-12 * (1 + norm(S));
  return S.x >= box.least.x - slack && S.x <= box.most.x + slack && S.y >= box.least.y - slack &&
         S.y <= box.most.y + slack && S.z >= box.least.z - slack && S.z <= box.most.z + slack;
}

inline std::optional<Stay> judge(const Bounds& box, Point S0, Vector V) {
  std::vector<double> times{0, 1};
  const auto meet = [&](double side, double s, double v) {
    if (v != 0 && (side - s) / v > 0 && (side - s) / v < 1) times.push_back((side - s) / v);
  };
  for (const Point& side : {box.least, box.most})
    meet(side.x, S0.x, V.x), meet(side.y, S0.y, V.y), meet(side.z, S0.z, V.z);
  std::sort(times.begin(), times.end());
  std::optional<Stay> stay;
  for (const double t : times)
    if (is_in(box, S0 + t * V)) {
      if (!stay) stay = {t, t};
      stay->leaves = t;
    }
  return stay;
}

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  const Bounds cube{{0, 0, 0}, {1, 1, 1}};
  return {
      {"along x, through the middle", {cube, {-1, 0.5, 0.5}, {4, 0, 0}}},
      {"the same way back", {cube, {3, 0.5, 0.5}, {-4, 0, 0}}},
      {"across", {cube, {-1, -2, 0.25}, {4, 8, 1}}},
      {"across, downward", {cube, {2, 2, 2}, {-4, -4, -4}}},
      {"it starts inside", {cube, {0.5, 0.5, 0.5}, {4, 0, 0}}},
      {"it ends inside", {cube, {-1.5, 0.5, 0.5}, {2, 0, 0}}},
      {"the box is behind it", {cube, {2, 0.5, 0.5}, {4, 0, 0}}},
      {"the box is too far away", {cube, {-9, 0.5, 0.5}, {4, 0, 0}}},
      {"parallel to x, beside the box", {cube, {-1, 3, 0.5}, {4, 0, 0}}},
      {"parallel to x, exactly along a side: 0 times infinity", {cube, {-1, 0, 0.5}, {4, 0, 0}}},
      {"parallel to x, exactly along the upper side", {cube, {-1, 0.5, 1}, {4, 0, 0}}},
      {"parallel to z, exactly along a side", {cube, {1, 0.5, -1}, {0, 0, 4}}},
      {"past the corner: the spans do not overlap", {cube, {-1, 0.5, 0.5}, {4, 8, 0}}},
      {"no motion, inside", {cube, {0.5, 0.5, 0.5}, {0, 0, 0}}},
      {"no motion, outside", {cube, {2, 0.5, 0.5}, {0, 0, 0}}},
      {"a box elsewhere", {{{4, -3, 2}, {6, -1, 5}}, {0, -2, 3}, {10, 0, 0}}},
  };
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "from when to when, within [0, 1], the path is in the box; or nothing";
  probes.names = {"box", "S0", "V"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    const Point corner = chance.vector(3);
    Vector V = chance.vector(12);
    if (chance.below(3) == 0) V.y = 0;
    if (chance.below(3) == 0) V.z = 0;
    const Vector size{chance.number(0.25, 4), chance.number(0.25, 4), chance.number(0.25, 4)};
    Point S0 = chance.vector(5);
    if (chance.below(2) == 0)  // aimed: in the box, or close to it, at some time
      S0 = corner + 0.5 * size + chance.number(0, 0.625) * size - chance.number(0, 1) * V;
    return std::tuple{Bounds{corner, corner + size}, S0, V};
  };
  probes.allowed = [](const auto& input) {
    const Vector size = std::get<0>(input).most - std::get<0>(input).least;
    return size.x > 0 && size.y > 0 && size.z > 0;
  };
  probes.judge = judge;
  probes.along = {"y of S0 (the time of entering)", -2, 3,
                  [](auto& input, double at) { std::get<1>(input).y = at; }};
  return probes;
}
