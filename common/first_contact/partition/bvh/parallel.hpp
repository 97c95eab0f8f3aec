#pragma once
#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace first_contact::bvh {

/// How many threads are worth starting for so many triangles.
inline unsigned threads_for(std::size_t triangles) {
  constexpr std::size_t worth_a_thread = 1 << 14;
  const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
  return static_cast<unsigned>(std::min(most, 1 + triangles / worth_a_thread));
}

/// Calls work(first, last) for parts of 0 ... n - 1, at the same time.
template <class Work>
void in_parallel(std::size_t n, const Work& work) {
  const std::size_t parts = threads_for(n);
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < parts; ++i)
    others.emplace_back([=, &work] { work(n * i / parts, n * (i + 1) / parts); });
  work(std::size_t{0}, n / parts);
  for (std::thread& other : others) other.join();
}

}  // namespace first_contact::bvh
