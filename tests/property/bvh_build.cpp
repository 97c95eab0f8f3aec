#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "first_contact/bvh/build/large_pages.hpp"
#include "first_contact/bvh/build/parallel.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/program/terrain.hpp"
#include "property/failing_memory.hpp"

using namespace first_contact;

namespace {

/// Large enough that threads are worth starting.
Mesh large_terrain() {
  return program::height_field(150, 2, [](double x, double y) { return 0.1 * std::sin(7 * x) * y; });
}

}  // namespace

TEST_CASE("What a part of the work throws reaches the caller, in whatever thread it ran") {
  const unsigned threads = GENERATE(1u, 2u, 7u);
  const std::size_t bad = GENERATE(0u, 1u, 50u, 99u);
  const auto work = [&](std::size_t part) {
    if (part == bad) throw std::runtime_error("part " + std::to_string(part));
  };
  CHECK_THROWS_WITH(bvh::in_parallel(threads, 100, work), "part " + std::to_string(bad));
}

TEST_CASE("Each part of the work is done once, by however many threads") {
  const unsigned threads = GENERATE(1u, 2u, 7u, 200u);
  std::vector<std::atomic<int>> times(100);
  bvh::in_parallel(threads, times.size(), [&](std::size_t part) { ++times[part]; });
  for (const auto& done : times) CHECK(done == 1);
}

TEST_CASE("Wherever memory runs out while a tree is built, the caller is told, and nothing else happens") {
  const Mesh mesh = large_terrain();
  int failures = 0;
  for (long after = 0; after < 1'000'000; after = after + 1 + after / 4) {
    Mesh copy = mesh;
    const FailingOnce failing(after);
    try {
      const Bvh tree(std::move(copy));
      if (!failing.has_failed()) break;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
  }
  CHECK(failures > 10);
}

TEST_CASE("Memory for a tree begins at a cache line, and from half a MiB on at a page of two") {
  const std::size_t size = GENERATE(1u, 63u, 64u, (1u << 19) - 1, 1u << 19, 1u << 21, (5u << 20) + 7);
  const auto begins_at = [](const bvh::LargeVector<unsigned char>& memory, std::uintptr_t unit) {
    return reinterpret_cast<std::uintptr_t>(memory.data()) % unit == 0;
  };
  bvh::LargeVector<unsigned char> memory(size, 7);
  memory.push_back(8);
  memory.shrink_to_fit();
  CAPTURE(size);
  CHECK(begins_at(memory, size < (1u << 19) - 1 ? 64 : 1u << 21));
  CHECK(std::count(memory.begin(), memory.end(), 7) == static_cast<std::ptrdiff_t>(size));
  CHECK(memory.back() == 8);
}

TEST_CASE("As many contacts as spheres are asked of a batch of casts, or it is refused with both numbers") {
  const Bvh tree(program::height_field(4, 2, [](double, double) { return 0.0; }));
  const std::vector<Moving<Sphere>> moving(1000, {Sphere{{0, 0, 1}, 0.5}, {0, 0, -1}});
  for (const std::size_t places : {0u, 1u, 999u, 1001u}) {
    std::vector<std::optional<Contact>> first(places);
    CHECK_THROWS_AS(sweep(moving, tree, first), std::invalid_argument);
    CHECK_THROWS_WITH(sweep(moving, tree, first), "sweep of many spheres: " + std::to_string(places) +
                                                      " contacts for 1000 spheres: must be as many");
  }
  std::vector<std::optional<Contact>> first(1000);
  sweep(moving, tree, first);
  CHECK(first[999]->time == 0.5);
}
