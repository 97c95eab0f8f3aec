#pragma once
#include "first_contact/stage/hit_test.hpp"

/// Where two shapes and a pointer stand on a stage: at first the boxes of the shapes overlap although they do
/// not, and the pointer is between them.
struct Places {
  Eigen::Vector2d leaf{0, 0}, hook{3.1, 1.4}, pointer{2.35, 2.05};
};

struct Stage {
  first_contact::StageObject leaf, hook;
  first_contact::Point2 pointer;

  explicit Stage(const Places& places = {});
};
