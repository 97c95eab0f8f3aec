// says: include first_contact/sweep/box_plane.hpp
#include "first_contact/geometry/box.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

bool touch(const Box& box, const Plane& plane) { return overlap(box, plane); }
