// says: this pair of shapes has no sweep yet
#include "first_contact/sweep/obstacle.hpp"

using namespace first_contact;

// As a new mover would ask, whose pair has no line of its own there.
void ask() { missing::say_which<Point, Plane>(); }
