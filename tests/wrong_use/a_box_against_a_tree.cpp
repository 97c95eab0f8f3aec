// says: a box is swept against an Environment
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/box.hpp"

using namespace first_contact;

bool hits(const Moving<Box>& box, const Bvh& bvh) { return sweep(box, bvh).has_value(); }
