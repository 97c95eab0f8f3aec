#include "told.hpp"

#include <cstdio>

#include "walls.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace partitioning_chapter {

std::string fixed(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string truth(bool value) { return value ? "true" : "false"; }

void tell_hit_tests(Program& program, const Stage& stage) {
  Report& report = program.report();
  report.say({"Hit tests as ActionScript defines them (paper, 2.4.1): boxes overlap, shapes do not",
              "ActionScript 的碰撞偵測（論文 2.4.1）：範圍框重疊，形狀並未接觸"});
  const auto tell_test = [&](const char* name, const char* place, bool hit, const Text& meaning) {
    report.row(name, truth(hit), meaning);
    program.result(place, hit);
  };
  tell_test("hitTestObject", "/hit_tests/boxes", hit_test_object(stage.leaf, stage.hook),
            {"box against box", "範圍框對範圍框"});
  tell_test("shape against shape", "/hit_tests/shapes", overlap(stage.leaf, stage.hook),
            {"what it cannot tell", "實際形體"});
  tell_test("hitTestPoint", "/hit_tests/point_in_box", hit_test_point(stage.leaf, stage.pointer),
            {"the pointer against a bounding box", "滑鼠對範圍框"});
  tell_test("with shapeFlag", "/hit_tests/point_in_shape", hit_test_point(stage.leaf, stage.pointer, true),
            {"against the shape itself", "滑鼠對形狀"});
}

namespace {

template <class Tree>
std::optional<Contact> tell_roll(Program& program, const std::string& name, const Tree& tree, Cast&& cast) {
  const auto [counted, contact] = found_in(tree, cast);
  program
      .row(name + ", tests", counted.tests,
           {"of a wall; nodes looked at: " + std::to_string(counted.nodes),
            "牆面的測試；檢視的節點：" + std::to_string(counted.nodes)})
      .result("/walls/" + name + "/tests");
  program.result("/walls/" + name + "/nodes", counted.nodes);
  return contact;
}

}  // namespace

void tell_walls(Program& program, const Moving<Sphere>& ball) {
  const Yard yard;
  const auto cast = [&] { return Cast(ball, yard.walls, yard.bounds()); };
  program.report().say({"A ball that rolls among " + std::to_string(yard.walls.size()) + " walls, in a plane",
                        "球在平面上的 " + std::to_string(yard.walls.size()) + " 面牆之間滾動"});
  tell_roll(program, "octree", yard.octree, cast());
  tell_roll(program, "bsp", yard.bsp, cast());
  const auto contact = tell_roll(program, "bvh", yard.bvh, cast());
  program.result("/walls/contact", nullptr);
  if (!contact) return program.report().say({"It touches none", "未碰到任何牆"});
  program.report().row("t", fixed(contact->time, 4), {"first contact", "碰撞時間"});
  program.result("/walls/contact/time", contact->time);
  program.result("/walls/contact/wall", contact->triangle);
  program.result("/walls/contact/normal", contact->normal);
}

}  // namespace partitioning_chapter
