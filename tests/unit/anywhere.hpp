#pragma once
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "digest/record.hpp"
#include "first_contact/geometry/mesh.hpp"

/// \file
/// The same things elsewhere in memory: do they have the same answers?

namespace anywhere {

using namespace first_contact;
using digest::Record;

/// A copy of a thing that begins so many bytes after a multiple of 64.
template <class Thing>
class Placed {
 public:
  Placed(const Thing& thing, std::size_t offset) : thing_(new (room_ + offset) Thing(thing)) {}
  ~Placed() { thing_->~Thing(); }
  Placed(const Placed&) = delete;
  Placed& operator=(const Placed&) = delete;

  const Thing& operator*() const { return *thing_; }

 private:
  alignas(64) std::byte room_[64 + sizeof(Thing)];
  Thing* thing_;
};

constexpr std::size_t step = alignof(double);  // no thing can begin elsewhere

/// What `ask` records of the things, each of them moved to that offset.
template <class Ask>
std::uint64_t answers_at(std::size_t, const Ask& ask) {
  Record record(false);
  ask(record);
  return record.hash();
}
template <class Ask, class First, class... Rest>
std::uint64_t answers_at(std::size_t offset, const Ask& ask, const First& first, const Rest&... rest) {
  const Placed<First> placed(first, offset);
  return answers_at(
      offset, [&](Record& record, const auto&... others) { ask(record, *placed, others...); }, rest...);
}

/// Is what `ask` records the same wherever the things begin?
template <class Ask, class... Things>
bool same_everywhere(const Ask& ask, const Things&... things) {
  const std::uint64_t expected = answers_at(0, ask, things...);
  for (std::size_t offset = step; offset < 64; offset += step)
    if (answers_at(offset, ask, things...) != expected) return false;
  return true;
}

/// The same mesh after so many vertices that no face uses: all vertices are moved by 24 bytes each.
inline Mesh moved_in_memory(const Mesh& mesh, std::uint32_t unused) {
  std::vector<Point> vertices(unused, Point::Zero());
  vertices.insert(vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh::Face> faces = mesh.faces();
  for (Mesh::Face& face : faces)
    for (std::uint32_t& vertex : face) vertex += unused;
  return {std::move(vertices), std::move(faces)};
}

}  // namespace anywhere
