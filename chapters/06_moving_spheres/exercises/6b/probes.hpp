#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge computes with more digits, from the closest approach.
inline std::optional<float> judge(const Float3& w, const Float3& u, float d) {
  using Long = long double;
  const Long uu = Long(u.x) * u.x + Long(u.y) * u.y + Long(u.z) * u.z,
             wu = Long(w.x) * u.x + Long(w.y) * u.y + Long(w.z) * u.z;
  if (!(wu < 0)) return {};
  const Long near = -wu / uu, x = w.x + near * u.x, y = w.y + near * u.y, z = w.z + near * u.z;
  const Long half = (Long(d) * d - (x * x + y * y + z * z)) / uu;
  if (half < 0 || near - std::sqrt(half) > 1) return {};
  return static_cast<float>(near - std::sqrt(half));
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the t in [0, 1] at which |w + tu| first is d, or nothing";
  probes.names = {"w", "u", "d"};
  probes.chosen = {
      {"near, straight at the middle", {{-4, 0, 0}, {4, 0, 0}, 1}},
      {"near, aside of the middle", {{-4, 0.5f, 0}, {4, 0, 0}, 1}},
      {"near, with d = 2", {{-6, 1, 0}, {8, 0, 0}, 2}},
      {"near, it passes by", {{-4, 2, 0}, {4, 0, 0}, 1}},
      {"near, it moves away", {{4, 0, 0}, {4, 0, 0}, 1}},
      {"no motion", {{4, 0, 0}, {0, 0, 0}, 1}},
      {"a motion that ends too early", {{-4, 0, 0}, {2, 0, 0}, 1}},
      {"from a hundred d away", {{-60, -79.5f, 0}, {120, 160, 0}, 1}},
      {"from ten thousand d away, along an axis", {{-10000, 0.5f, 0}, {20000, 0, 0}, 1}},
      {"from ten thousand d away, slantwise", {{-6000, -7999.5f, 0.25f}, {12000, 16000, 0}, 1}},
      {"from ten thousand d away, through the middle", {{-6000, -8000, 0}, {12000, 16000, 0}, 1}},
      {"from ten thousand d away, and it passes by", {{-6000, -7998, 0}, {12000, 16000, 0}, 1}},
  };
  probes.random = [](Chance& chance) {
    const Vector u = chance.vector(4), aim = chance.vector(0.75);
    const double far = chance.one_of(std::vector<double>{1, 10, 100, 1000, 2000});
    const Vector w = aim - far * u, v = 2 * far * u;
    const auto floats = [](Vector a) {
      return Float3{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
    };
    return std::tuple{floats(w), (chance.below(4) == 0 ? -1.0f : 1.0f) * floats(v), 1.0f};
  };
  probes.allowed = [](const auto& input) {
    const auto& [w, u, d] = input;
    if (!(d > 0.1f && d < 10 && dot(w, w) > 1.01f * d * d && dot(w, w) < 1.1e8f * d * d)) return false;
    const auto t = judge(w, u, d);  // neither a grazing hit, nor a near miss, nor a contact at the end
    return t == std::nullopt ? !judge(w, u, 1.2f * d) : judge(w, u, 0.8f * d) && *t < 0.99f;
  };
  probes.judge = judge;
  probes.tolerance = 1e-6;
  probes.along = {"y of w", -2, 2,
                  [](auto& input, double at) { std::get<0>(input).y = static_cast<float>(at); }};
  return probes;
}
