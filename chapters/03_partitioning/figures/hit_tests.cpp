#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

std::vector<Point> on_page(const std::vector<Point2>& outline, const Vector& shift) {
  std::vector<Point> points;
  for (const Point2& p : outline) points.emplace_back(shift + Vector(p.x(), p.y(), 0));
  return points;
}

void add_shape(figure::Scene& scene, const StageObject& object, const Vector& shift, bool hit,
               double opacity = 1) {
  scene.polygon(on_page(object.outline(), shift),
                {hit ? colour::amber : colour::floor, opacity, false,
                 hit ? Pen{colour::orange, 1.6} : Pen{colour::blue, 1.6}},
                1);
}

void add_box(figure::Scene& scene, const Rectangle& box, const Vector& shift, bool hit) {
  const auto& [low, high] = box;
  scene.polygon(on_page({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, shift),
                {hit ? colour::amber : colour::mist, hit ? 0.3 : 1, false,
                 hit ? Pen{colour::orange, 1.4, true} : Pen{colour::grey, 1.2, true}},
                0);
}

// The arrow of a mouse, its tip at a point.
void add_pointer(figure::Scene& scene, const Point& tip) {
  const std::vector<Point2> arrow{{0, 0},        {0, -0.62},    {0.14, -0.49}, {0.24, -0.71},
                                  {0.33, -0.67}, {0.23, -0.45}, {0.42, -0.43}};
  scene.polygon(on_page(arrow, tip), {colour::paper, 1, false, Pen{colour::ink, 1.4}}, 5);
}

}  // namespace

void draw_hit_tests(const Studio& studio, const Stage& stage) {
  figure::Scene scene({0, 0}, 0.04);
  const auto title = [&](const Vector& shift, double middle, const std::string& call, bool hit) {
    scene.label(call, shift + Vector(middle, -0.55, 0));
    scene.label(hit ? "true" : "false", shift + Vector(middle, -1.05, 0), 0, 0,
                hit ? colour::red : colour::green);
  };
  const Point tip(stage.pointer.x(), stage.pointer.y(), 0);
  const Vector first(0, 0, 0), second(5.0, 0, 0), third(10.0, 0, 0);
  const bool in_box = hit_test_point(stage.leaf, stage.pointer);
  add_box(scene, stage.leaf.bounding_box(), first, in_box);
  add_shape(scene, stage.leaf, first, false);
  add_pointer(scene, first + tip);
  title(first, 1.7, "hitTestPoint({/:Italic x}, {/:Italic y}, false)", in_box);

  const bool in_shape = hit_test_point(stage.leaf, stage.pointer, true);
  add_box(scene, stage.leaf.bounding_box(), second, false);
  add_shape(scene, stage.leaf, second, in_shape);
  add_pointer(scene, second + tip);
  title(second, 1.7, "hitTestPoint({/:Italic x}, {/:Italic y}, true)", in_shape);

  const bool boxes = hit_test_object(stage.leaf, stage.hook);
  add_box(scene, stage.leaf.bounding_box(), third, false);
  add_box(scene, stage.hook.bounding_box(), third, false);
  add_box(scene, stage.leaf.bounding_box().common(stage.hook.bounding_box()), third, boxes);
  add_shape(scene, stage.leaf, third, false);
  add_shape(scene, stage.hook, third, false);
  title(third, 1.9, "hitTestObject", boxes);
  Figure figure(studio, "hit-tests", scene.size(960));
  scene.draw(figure);
  figure.draw();
}
