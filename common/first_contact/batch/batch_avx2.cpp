// The same loops with AVX2 and FMA, where the compiler was told to use them (common/CMakeLists.txt).
#if defined(__AVX2__) && defined(__FMA__)
#include "first_contact/batch/batch_loops.inc"

namespace first_contact::batch {
const Loops avx2_loops{sphere_sphere_loop, sphere_plane_loop, box_plane_loop};
}
#else
#include "first_contact/batch/batch_loops.hpp"

namespace first_contact::batch {
const Loops avx2_loops{};
}
#endif
