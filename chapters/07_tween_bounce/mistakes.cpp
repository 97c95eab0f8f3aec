#include "mistakes.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/easing.hpp"
#include "flight.hpp"
#include "stepped_bounce.hpp"
#include "with_digits.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace tween_bounce {

namespace {

// How high a ball dropped from 1 with e = 1 bounces in the last three seconds of a minute.
double stepped_peak(Stepper stepper) {
  const auto states = stepped_bounce(stepper, 1, 9.81, 1, 1.0 / 60, 3600);
  const auto lower = [](const Stepped& a, const Stepped& b) { return a.height < b.height; };
  return std::max_element(states.end() - 180, states.end(), lower)->height;
}

// The same, solved.
double solved_peak() { return Bounce(1, 0, 9.81, 1).apex(66)->height; }

// The fastest speed along a curve by the slowest, if one goes by its parameter.
double unevenness(const Curve& curve) {
  double slowest = 1e300, fastest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double speed = at(derivative(curve), i / 1000.0).norm();
    slowest = std::min(slowest, speed);
    fastest = std::max(fastest, speed);
  }
  return fastest / slowest;
}

// What is left of a way after a second, by a lerp of a tenth in each frame, and by damping.
double left_by_lerp(int frames) {
  double x = 1;
  for (int i = 0; i < frames; ++i) x = std::lerp(x, 0.0, 0.1);
  return x;
}
double left_by_damp() {
  const double rate = -30 * std::log(0.9);
  return damp(1.0, 0.0, rate, 1.0);
}

}  // namespace

void tell_energy(Program& program) {
  program.report().say(
      {"A ball dropped from 1 with e = 1, 60 pictures a second: how high does it bounce after a minute?",
       "自高度 1 落下、e = 1、每秒 60 影格：一分鐘後彈多高？"});
  const auto peak = [&](Stepper stepper, const std::string& name, const std::string& value,
                        const Text& meaning) {
    program.row(name, stepped_peak(stepper), meaning).value(value);
  };
  peak(Stepper::explicit_euler, "explicit Euler", "explicit_peak",
       {"y += v dt, then v -= g dt", "先 y += v dt，再 v -= g dt"});
  peak(Stepper::parabola, "exact parabolas", "parabola_peak",
       {"but each impact up to a step late", "但每次碰撞最多遲一影格"});
  peak(Stepper::semi_implicit_euler, "semi-implicit Euler", "semi_peak",
       {"v -= g dt, then y += v dt", "先 v -= g dt，再 y += v dt"});
  program.report().row("solved at impacts", solved_peak(), {"nothing drifts", "沒有漂移"});
}

void tell_tweens(Program& program) {
  Report& report = program.report();
  report.say({"Tweens that go wrong: speed by a curve's parameter, and a lerp by 0.1 a frame",
              "補間的常見錯誤：以曲線參數當距離；每影格 lerp 0.1"});
  const ArcLength arch(tween_bounce::arch());
  program
      .row("fastest/slowest", unevenness(arch.curve()),
           {"along a Bezier arch by its parameter; 1 by its length, " + readable(arch.total()),
            "沿貝茲拱形的參數；依弧長 " + readable(arch.total()) + " 則為 1"})
      .value("unevenness");
  const auto left = [](int frames) { return with_digits(100 * left_by_lerp(frames), 2) + " %"; };
  report.row("left after 1 s, lerp", left(30) + ", " + left(60),
             {"at 30 and at 60 frames a second", "每秒 30 與 60 影格"});
  program
      .row("left after 1 s, damp", Shown{left_by_damp(), with_digits(100 * left_by_damp(), 2) + " %"},
           {"e^(-rate t), at any frame rate", "e^(-rate t)，與影格速率無關"})
      .value("left_damp");
  program.value("arch_length", arch.total());
  program.value("left_30", left_by_lerp(30));
  program.value("left_60", left_by_lerp(60));
}

}  // namespace tween_bounce
