#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

/// \file
/// Work that is shared between threads while a tree is built.
///
/// The idea: the parts are numbered, and whoever is free takes the next. So it does not matter how many
/// threads there are, nor whether the system gives as many as were asked for. What a part throws reaches the
/// caller, by way of its std::future, when all threads have ended.
///
/// std::async hands on what is thrown, for which std::jthread would need an exception_ptr, and every standard
/// library has it; oneTBB builds a tree no sooner, and would be one more package for every user.

namespace first_contact::bvh {

/// How many threads are worth starting for so many triangles.
inline unsigned threads_for(std::size_t triangles) {
  constexpr std::size_t worth_a_thread = 1 << 14;
  const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<unsigned>(std::min(most, 1 + triangles / worth_a_thread));
}

/// Calls work(i) for i = 0 ... parts - 1, in so many threads at the same time, this one included.
template <class Work>
void in_parallel(unsigned threads, std::size_t parts, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take_parts = [&] {
    for (std::size_t i = next++; i < parts; i = next++) work(i);
  };
  std::vector<std::future<void>> others;
  try {
    for (unsigned i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, take_parts));
  } catch (const std::system_error&) {
    // no more threads to be had: those that there are do all
  }
  take_parts();
  for (std::future<void>& other : others) other.get();
}

/// Calls work(first, last) for parts of 0 ... n - 1, at the same time.
template <class Work>
void in_parallel_ranges(std::size_t n, const Work& work) {
  const unsigned parts = threads_for(n);
  in_parallel(parts, parts, [&](std::size_t i) { work(n * i / parts, n * (i + 1) / parts); });
}

}  // namespace first_contact::bvh
