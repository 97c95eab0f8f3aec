#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace first_contact::bvh {

/// For each of some things a list of numbers; all lists lie in one array, one behind the other.
class Lists {
 public:
  /// \param each_pair  calls add(thing, number) for all pairs, whenever it is called: once to count them, and
  /// once to fill the lists. The numbers of a thing stay in their order.
  template <class EachPair>
  Lists(std::size_t things, const EachPair& each_pair) : ends_(things + 1) {
    each_pair([&](std::uint32_t thing, std::uint32_t) { ++ends_[thing + 1]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& end : ends_) end = sum += end;
    numbers_.resize(sum);
    std::vector<std::uint32_t> next(ends_.begin(), ends_.end() - 1);
    each_pair([&](std::uint32_t thing, std::uint32_t number) { numbers_[next[thing]++] = number; });
  }

  std::span<const std::uint32_t> of(std::uint32_t thing) const {
    return {numbers_.data() + ends_[thing], numbers_.data() + ends_[thing + 1]};
  }
  std::size_t bytes() const { return sizeof(std::uint32_t) * (ends_.size() + numbers_.size()); }

 private:
  std::vector<std::uint32_t> ends_;  // of each list, after a 0
  std::vector<std::uint32_t> numbers_;
};

}  // namespace first_contact::bvh
