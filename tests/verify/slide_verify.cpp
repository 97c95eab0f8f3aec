// Slides over whole surfaces, frame after frame: ./course verify. Exit status 1 on a fault.
#include <cstdio>
#include <cstdlib>

#include "05_slide/walk.hpp"

namespace {

void tell(const walks::Ground& ground, const walks::Walk& walk) {
  std::printf("%-17s %9zu %11.1e %9ld %9ld %9ld %9.1e %9ld %9ld %9.2f   %s\n", ground.name.english.c_str(),
              ground.mesh.size(), walk.depth, walk.tunnelled, walk.reversed, walk.exhausted, walk.drift,
              walk.contacts, walk.frames, 1e6 * walk.seconds / static_cast<double>(walk.frames),
              walk.good() ? "" : "FAULT");
}

}  // namespace

int main(int argc, char** argv) {
  const long frames = argc > 1 ? std::atol(argv[1]) : 1'000'000;
  const long seed = argc > 2 ? std::atol(argv[2]) : 1;
  if (frames < 1 || seed < 0)
    return std::fputs("slide_verify [FRAMES [SEED]]: must be at least 1, and at least 0\n", stderr), 2;
  std::printf("%-17s %9s %11s %9s %9s %9s %9s %9s %9s %9s   seed %ld\n", "scene", "triangles", "penetration",
              "tunnelled", "reversed", "exhausted", "drift", "contacts", "frames", "us a step", seed);
  bool good = true;
  for (const walks::Ground& ground : walks::grounds()) {
    const walks::Walk walk = walks::walk(ground, frames, static_cast<std::uint64_t>(seed));
    tell(ground, walk);
    good = walk.good() && good;
  }
  std::printf(
      "penetration: the deepest in any frame (at most %.0e), less than 0 if the gap was always kept.  "
      "tunnelled: frames "
      "that end beyond a wall.\n"
      "reversed: frames that end behind where they began.  drift: of what should not change once the ball "
      "lies still "
      "(at most %.0e).\n"
      "Lengths in units of the largest coordinate of the scene.\n",
      walks::Walk::limit, walks::Walk::drift_limit);
  return good ? 0 : 1;
}
