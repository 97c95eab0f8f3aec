// says: include first_contact/sweep/sphere_triangle.hpp
#include "first_contact/response/slide.hpp"

using namespace first_contact;

Point end_of(const Moving<Sphere>& ball, const Triangle& triangle) { return slide(ball, triangle).end(); }
