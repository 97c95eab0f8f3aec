#include "task.hpp"

// The point at the parameter t, 0 to 1, of the Bézier curve with these control points, of which there is one
// at least.
Vector2 bezier(const std::vector<Vector2>& points, double t) { return {}; }
