#include "figures.hpp"

using namespace first_contact;

void draw_paper_cases(const program::Program& program) {
  draw_cases(program);
  draw_encounter(program, "case-4", paper_cases()[3], true, true);
  draw_encounter(program, "normal-at-contact", aimed_beside(), true, true);
  draw_drag(program);
}
