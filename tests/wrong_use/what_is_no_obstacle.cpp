// says: Obstacle
#include <string>

#include "first_contact/response/slide.hpp"

using namespace first_contact;

Point end_of(const Moving<Sphere>& ball, const std::string& wall) { return slide(ball, wall).end(); }
