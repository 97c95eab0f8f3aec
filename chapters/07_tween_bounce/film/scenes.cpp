#include "scenes.hpp"

namespace tween_bounce {

namespace {

//! [hall]
// Down a straight line, and along curves that know of no floor and of no wall.
constexpr std::string_view hall = R"({
  "ball": {"radius": 0.5},
  "keys": [
    {"time": 0, "place": [0, 0, 5], "easing": "in quadratic"},
    {"time": 1, "place": [2, 0, 3.5], "turn": {"axis": [0, 1, 0], "degrees": 120},
     "path": {"kind": "bezier", "points": [[4, 0, 2], [7.6, 0, -5.5]]}},
    {"time": 2.5, "place": [10, 0, 0.5], "turn": {"axis": [0, 1, 0], "degrees": 280}, "easing": "out quadratic",
     "path": {"kind": "bezier", "points": [[11.2, 0, 3.5]]}},
    {"time": 3.5, "place": [12, 0, 0.5], "turn": {"axis": [0, 1, 0], "degrees": 400}}
  ],
  "obstacles": [{"plane": [0, 0, 1, 0]}, {"plane": [-1, 0, 0, 8]}],
  "contact": {"do": "bounce", "restitution": 0.6},
  "view": {"tilt": 78, "turn": 18}
})";
//! [hall]

// A crate that tumbles as it falls, and stays as it first touches the floor.
constexpr std::string_view crate = R"({
  "box": {"sides": [2, 1, 1]},
  "keys": [
    {"time": 0, "place": [0, 0, 4.5], "easing": "in quadratic",
     "path": {"kind": "bezier", "points": [[2, 0, 4.5]], "constant_speed": true}},
    {"time": 2, "place": [4, 0, -0.5], "turn": {"axis": [0, 1, 0], "degrees": 150}}
  ],
  "obstacles": [{"plane": [0, 0, 1, 0]}],
  "contact": {"do": "stop"}
})";

// Along a smooth way through five keys, which a ramp and then the floor make straight.
constexpr std::string_view ramp = R"({
  "ball": {"radius": 0.4},
  "through": "centripetal",
  "keys": [
    {"time": 0, "place": [0, 0, 3.8]},
    {"time": 0.8, "place": [1.2, 0, 2.2]},
    {"time": 1.8, "place": [3, 0, 0.6], "turn": {"axis": [0, 1, 0], "degrees": 140}},
    {"time": 2.8, "place": [5.5, 0, -0.6], "turn": {"axis": [0, 1, 0], "degrees": 310}, "easing": "out cubic"},
    {"time": 4.5, "place": [9, 0, 0.4], "turn": {"axis": [0, 1, 0], "degrees": 480}}
  ],
  "obstacles": [{"plane": [0.5, 0, 1, -2]}, {"plane": [0, 0, 1, 0]}],
  "contact": {"do": "slide", "friction": 0.1}
})";

// A soft ball: it grows long as it falls, is pressed flat a hair above the floor, and becomes round again.
constexpr std::string_view squash = R"({
  "ball": {"radius": 0.6},
  "keys": [
    {"time": 0, "place": [0, 0, 4], "easing": "in quadratic"},
    {"time": 0.8, "place": [1.4, 0, 0.6], "scale": 1.35, "easing": "out cubic"},
    {"time": 0.9, "place": [1.5, 0, 0.6], "scale": 0.6, "easing": "in cubic"},
    {"time": 1, "place": [1.6, 0, 0.6], "scale": 1.25,
     "path": {"kind": "bezier", "points": [[2.6, 0, 4.6]]}},
    {"time": 2, "place": [3.6, 0, 0.6], "scale": 1.2, "easing": "out cubic"},
    {"time": 2.1, "place": [3.7, 0, 0.6], "scale": 0.75, "easing": "out elastic"},
    {"time": 3, "place": [3.7, 0, 0.6]}
  ],
  "obstacles": [{"plane": [0, 0, 1, 0.001]}],
  "contact": {"do": "slide"},
  "view": {"tilt": 82, "turn": 10}
})";

constexpr BuiltIn all[]{{"hall", hall}, {"crate", crate}, {"ramp", ramp}, {"squash", squash}};

}  // namespace

std::span<const BuiltIn> scenes() { return all; }

std::string scene_names() {
  std::string names;
  for (const auto& [name, text] : all) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace tween_bounce
