#pragma once
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace first_contact::bvh {

/// Memory in pages of 2 MiB, where the system has them.
///
/// The idea: the addresses of a large tree in pages of 4 KiB do not fit in the table that the processor keeps
/// of them, so that a cast pays for looking them up as well. It equals std::allocator.
/// Measured (./course bench --own --sides 707, with this advice and without), of the textbook for a hop: .22
/// and .30 on one day, .22 and .21 on another. A virtual machine has large pages only if its host gives them.
template <class Value>
struct LargePages {
  using value_type = Value;
  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}

  Value* allocate(std::size_t n) {
    constexpr std::size_t line = 64, page = std::size_t{1} << 21;
    const std::size_t wanted = n * sizeof(Value), unit = wanted < page ? line : page;
    const std::size_t bytes = (wanted + unit - 1) / unit * unit;
    void* block = std::aligned_alloc(unit, bytes);
    if (!block) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
    if (unit == page)
      madvise(block, bytes, MADV_HUGEPAGE);  // advice only: if it is not taken, nothing is lost
#endif
    return static_cast<Value*>(block);
  }
  void deallocate(Value* block, std::size_t) { std::free(block); }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

template <class Value>
using Block = std::vector<Value, LargePages<Value>>;

}  // namespace first_contact::bvh
