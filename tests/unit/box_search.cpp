#include "first_contact/trees/box_search.hpp"

#include "catch.hpp"
#include "first_contact/trees/ball_search.hpp"

using namespace first_contact;

namespace {

/// Of objects it takes any.
class AnyInBox : public BoxSearch {
 public:
  using BoxSearch::BoxSearch;

 private:
  bool hit(std::size_t) override { return true; }
};

}  // namespace

TEST_CASE(
    "A small box in a large scene reaches the planes that pass it within the scene's rounding, on both "
    "sides") {
  const double size = 1e6, half = 1e-3;
  const Bounds scene = bounds_between(Point::Constant(-size), Point::Constant(size));
  const Bounds box = bounds_between(Point::Constant(-half), Point::Constant(half));
  const AnyInBox search(box, scene);
  for (const double part : {0.0, 0.5, 0.9, 1.1, 2.0}) {
    CAPTURE(part);
    const double away = half + part * search_margin * size;
    for (const double side : {1.0, -1.0}) {
      const Sides sides = search.sides(Plane({0, 0, side}, away), {0, 1});
      CHECK_FALSE(sides.front.empty());
      CHECK(sides.back.empty() == (part > 1));
    }
  }
}
