#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge begins its clock at `from`, as seen from the second ball, with more digits.
inline std::optional<double> judge(Point P, Vector Vp, Point Q, Vector Vq, double d, double from, double to) {
  using Long = long double;
  const Vector w = P + from * Vp - Q - from * Vq, u = Vp - Vq;
  const Long uu = dot(u, u), wu = dot(w, u), ww = dot(w, w), sum = d;
  if (wu >= 0) return {};
  if (ww <= sum * sum) return from;
  const Long under = wu * wu - uu * (ww - sum * sum);
  if (under < 0) return {};
  const Long t = (ww - sum * sum) / (-wu + std::sqrt(under));
  if (t > to - from) return {};
  return from + static_cast<double>(t);
}

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  return {
      {"one moves, one rests", {{-4, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"both move", {{-4, 0, 0}, {2, 0, 0}, {4, 0, 0}, {-6, 0, 0}, 2, 0, 1}},
      {"the second alone moves", {{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {-4, 0, 0}, 2, 0, 1}},
      {"aside of the middle", {{-4, 3, 0}, {8, 0, 0}, {0, 0, 0}, {0, 0, 0}, 5 - 0.5, 0, 1}},
      {"they fly through each other between two pictures",
       {{-9, 0, 0}, {18, 0, 0}, {9, 0, 0}, {-18, 0, 0}, 1, 0, 1}},
      {"they pass each other by", {{-4, 3, 0}, {8, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"they part", {{-4, 0, 0}, {-4, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"both move alike", {{-4, 0, 0}, {3, 1, 0}, {0, 0, 0}, {3, 1, 0}, 2, 0, 1}},
      {"too late: after the span", {{-9, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"a span of ten", {{-9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 10}},
      {"a span that begins later, when they still are apart",
       {{-9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 3, 10}},
      {"a span that begins when they overlap and go deeper",
       {{-9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 8, 10}},
      {"a span that begins when they overlap and part",
       {{-9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 10, 12}},
      {"a span that begins after they have parted", {{-9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 12, 20}},
      {"a span before 0", {{9, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, -20, 0}},
      {"they overlap and go deeper", {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"they overlap and part", {{-1, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 2, 0, 1}},
      {"they overlap and move alike", {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, 2, 0, 1}},
  };
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the first contact of the two balls between `from` and `to`, or nothing";
  probes.names = {"P", "Vp", "Q", "Vq", "d", "from", "to"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    const Vector Vp = chance.vector(6), Q = chance.vector(5), Vq = chance.vector(6);
    const double d = chance.number(0.5, 5), from = chance.number(-3, 3), to = from + chance.number(0.25, 3);
    Point P = chance.vector(5);
    if (chance.below(2) == 0)  // aimed: within d of each other, at some time in the span
      P = Q + chance.vector(0.5 * d) - chance.number(from, to) * (Vp - Vq);
    return std::tuple{P, Vp, Q, Vq, d, from, to};
  };
  probes.allowed = [](const auto& input) {
    return std::get<4>(input) > 0 && std::get<5>(input) < std::get<6>(input);
  };
  probes.judge = judge;
  probes.along = {"y of P", -5, 5, [](auto& input, double at) { std::get<0>(input).y = at; }};
  return probes;
}
