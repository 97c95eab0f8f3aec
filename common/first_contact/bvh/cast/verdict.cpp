#include "first_contact/bvh/cast/verdict.hpp"

#include <algorithm>
#include <bit>

namespace first_contact::bvh {

template <class Key>
bool Verdict::Recent<Key>::seen(const Key& k) {
  if (!filled) key.fill(0);
  filled = true;
  Key& place = key[(k ^ k / key.size()) % key.size()];
  const bool known = place == k + 1;
  place = k + 1;
  return known;
}

//! [verdict]
void Verdict::consider(const LeafFace& face, unsigned features, bool within_face) {
  known_.note(face);
  if (features == 0) return;
  const std::array<std::uint32_t, 3>& corners = face.corner;
  if (features & 1) first_.face(face.number, corners, known_.facet(face), within_face);
  for (unsigned left = features >> 1; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (i < 3)
      consider_edge(corners[i], corners[(i + 1) % 3]);
    else if (!vertices_.seen(corners[i - 3]))
      first_.vertex(corners[i - 3]);
  }
}

void Verdict::consider_edge(std::uint32_t p, std::uint32_t q) {
  const auto [low, high] = std::minmax(p, q);
  if (low != high && !edges_.seen(std::uint64_t{low} << 32 | high)) first_.edge(p, q);
}
//! [verdict]

void Verdict::forget() {
  first_.forget();
  known_.forget();
  edges_.filled = vertices_.filled = false;
}

}  // namespace first_contact::bvh
