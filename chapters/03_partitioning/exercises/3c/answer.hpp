#include "task.hpp"

// True if P lies inside of the polygon, whose last corner is joined to its first.
bool inside(const std::vector<Vector2>& polygon, Vector2 P) { return true; }
