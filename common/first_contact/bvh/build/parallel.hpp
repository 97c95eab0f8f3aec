#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace first_contact::bvh {

/// How many threads are worth starting for so many triangles.
inline unsigned threads_for(std::size_t triangles) {
  constexpr std::size_t worth_a_thread = 1 << 14;
  const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<unsigned>(std::min(most, 1 + triangles / worth_a_thread));
}

/// Calls work() in so many threads at the same time.
template <class Work>
void in_parallel_copies(unsigned threads, const Work& work) {
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
}

/// Calls work(first, last) for parts of 0 ... n - 1, at the same time.
template <class Work>
void in_parallel(std::size_t n, const Work& work) {
  const unsigned parts = threads_for(n);
  std::atomic<std::size_t> next{0};
  in_parallel_copies(parts, [&] {
    const std::size_t i = next++;
    work(n * i / parts, n * (i + 1) / parts);
  });
}

}  // namespace first_contact::bvh
