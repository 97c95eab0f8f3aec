// The same walk with AVX2 and FMA, where the compiler was told to use them (common/CMakeLists.txt). Nothing
// here may be called before __builtin_cpu_supports has been asked.
#if defined(__AVX2__) && defined(__FMA__)
#include "first_contact/bvh/kernels/walk.inc"

namespace first_contact::bvh {
const Walker avx2_walker{begin, next, resume, visit_node, visit_leaf, features_in_time};
}
#else
#include "first_contact/bvh/kernels/walk.hpp"

namespace first_contact::bvh {
const Walker avx2_walker{};  // empty: this machine has no such instructions
}
#endif
