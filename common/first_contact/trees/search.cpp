#include "first_contact/trees/search.hpp"

#include <algorithm>

namespace first_contact {

void Search::count_node(std::size_t depth) {
  ++statistics_.nodes;
  statistics_.depth = std::max(statistics_.depth, depth);
}

void Search::test(std::size_t object) {
  ++statistics_.tests;
  if (!hit(object)) return;
  ++statistics_.hits;
  found_.push_back(object);
}

std::vector<std::size_t> Search::found() const {
  std::vector<std::size_t> sorted = found_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace first_contact
