#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge keeps places as they were at 0 for each disc's own straight piece, and its clock.
inline std::vector<Impact> judge(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  const auto origin = [](const Disc& disc, double now) {
    return Disc{disc.place - now * disc.velocity, disc.velocity, disc.radius};
  };
  double now = 0;
  for (int n = 0; n < 60; ++n) {
    Impact next{until, -1, -1};
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = i + 1; j < discs.size(); ++j) {
        const Disc a{discs[i].place + now * discs[i].velocity, discs[i].velocity, discs[i].radius};
        const Disc b{discs[j].place + now * discs[j].velocity, discs[j].velocity, discs[j].radius};
        if (const auto t = meeting(a, b); t && now + *t < next.time)
          next = {now + *t, static_cast<int>(i), static_cast<int>(j)};
      }
    if (next.first < 0) break;
    now = next.time;
    Disc& a = discs[static_cast<std::size_t>(next.first)];
    Disc& b = discs[static_cast<std::size_t>(next.second)];
    a.place = a.place + now * a.velocity, b.place = b.place + now * b.velocity;
    collide(a, b);
    a = origin(a, now), b = origin(b, now);
    list.push_back(next);
  }
  return list;
}

using Discs = std::vector<Disc>;

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  return {
      {"one impact", {Discs{{{-3, 0}, {1, 0}, 1}, {{3, 0}, {0, 0}, 1}}, 10}},
      {"none in time", {Discs{{{-3, 0}, {1, 0}, 1}, {{3, 0}, {0, 0}, 1}}, 2}},
      {"three in a row: the push goes on",
       {Discs{{{-3, 0}, {2, 0}, 1}, {{0, 0}, {0, 0}, 1}, {{4, 0}, {0, 0}, 1}}, 10}},
      {"the row is listed from right to left",
       {Discs{{{4, 0}, {0, 0}, 1}, {{0, 0}, {0, 0}, 1}, {{-3, 0}, {2, 0}, 1}}, 10}},
      {"what was foreseen is void: disc 1 is struck away before disc 2 comes",
       {Discs{{{-3, 0}, {4, 0}, 1}, {{0, 0.5}, {0, 0}, 1}, {{0, 9.5}, {0, -2}, 1}}, 10}},
      {"to and fro between two that come nearer",
       {Discs{{{-9, 0}, {1, 0}, 1}, {{0, 0}, {3, 0}, 1}, {{9, 0}, {-1, 0}, 1}}, 5}},
      {"two far apart pairs",
       {Discs{{{-3, 0}, {1, 0}, 1}, {{3, 0}, {-2, 0}, 1}, {{-3, 50}, {1, 0}, 1}, {{3, 50}, {0, 0}, 1}}, 10}},
      {"nobody", {Discs{}, 10}},
      {"one alone", {Discs{{{0, 0}, {1, 1}, 1}}, 10}},
  };
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "all impacts up to `until`: (time, first, second), in the order of time";
  probes.names = {"discs", "until"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    Discs discs;
    for (std::size_t n = 2 + chance.below(4); n > 0; --n) {
      const Vector2 place = chance.vector2(7);
      discs.push_back({place, chance.vector2(1) - 0.4 * place, chance.number(0.5, 1.25)});
    }
    return std::tuple{discs, chance.number(2, 8)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [discs, until] = input;
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = 0; j < discs.size(); ++j)
        if (discs[i].radius < 0.1 ||
            (i != j && norm(discs[i].place - discs[j].place) < discs[i].radius + discs[j].radius + 0.01))
          return false;
    return until > 0;
  };
  probes.judge = judge;
  probes.tolerance = 1e-8;
  probes.unit = Unit::scene;
  probes.along = {"x of the first disc (time of the first impact)", -9, 9, [](auto& input, double at) {
                    if (!std::get<0>(input).empty()) std::get<0>(input)[0].place.x = at;
                  }};
  return probes;
}
