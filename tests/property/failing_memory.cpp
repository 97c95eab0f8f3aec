#include "property/failing_memory.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#ifdef _WIN32
#include <malloc.h>
#endif

// A file of its own: a compiler that sees but one half of a pair of these beside their use warns of the other.

namespace {

std::atomic<long> requests_until_failure{-1};

// Windows has another pair for memory that begins where one asks.
#ifdef _WIN32
void* aligned(std::size_t size, std::size_t unit) { return _aligned_malloc(size, unit); }
void give_back(void* block) { _aligned_free(block); }
#else
void* aligned(std::size_t size, std::size_t unit) {
  return std::aligned_alloc(unit, (size / unit + 1) * unit);
}
void give_back(void* block) { std::free(block); }
#endif

void* memory(std::size_t size, std::size_t unit) {
  if (requests_until_failure >= 0 && requests_until_failure-- == 0) throw std::bad_alloc();
  if (void* block = aligned(size, unit)) return block;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return memory(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t unit) {
  return memory(size, static_cast<std::size_t>(unit));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace first_contact {

FailingOnce::FailingOnce(long after) { requests_until_failure = after; }
FailingOnce::~FailingOnce() { requests_until_failure = -1; }
bool FailingOnce::has_failed() const { return requests_until_failure < 0; }

}  // namespace first_contact
