#pragma once
#include "first_contact/stage/hit_test.hpp"

/// Two shapes on a stage whose bounding boxes overlap although they do not, and a pointer between them.
struct Stage {
  first_contact::StageObject leaf, hook;
  first_contact::Point2 pointer{2.35, 2.05};

  Stage();
};
