#include "first_contact/bvh/build/large_pages.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace first_contact::bvh {

void prefer_large_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  madvise(block, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace first_contact::bvh
