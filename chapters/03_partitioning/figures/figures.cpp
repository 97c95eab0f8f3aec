#include "figures.hpp"

using namespace first_contact;

void draw_partitioning_figures(const program::Program& program, std::uint64_t seed, const Stage& stage) {
  draw_octree(program.studio());
  draw_bsp(program.studio());
  draw_slabs(program);
  draw_same_side(program.studio());
  draw_grown_planes(program.studio());
  draw_hit_tests(program.studio(), stage);
  draw_costs(program, seed);
  draw_support(program.studio());
  draw_cones(program.studio());
}
