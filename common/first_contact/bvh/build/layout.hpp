#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// \file
/// What the tree is in memory: wide nodes of three cache lines, and leaves of up to eight triangles.
///
/// The idea: a cast waits for memory more than it computes. Eight children to a node make the tree a third as
/// deep as one of pairs; eight bits to a coordinate make eight boxes fit in one cache line; a leaf stores a
/// shared vertex once, and has with it all that a cast asks of its triangles. It equals a binary tree of boxes
/// of doubles (trees/plain_bvh.hpp), whose every box lies within the box stored here.
///
/// All lengths are in the tree's own unit (\see space.hpp), in which the mesh lies between -1 and 1, so that
/// no number here depends on the scale or the place of the mesh.
///

namespace first_contact::bvh {

/// How many children a node has, triangles a leaf, and lanes a vector of floats.
inline constexpr int width = 8;
/// How many different vertices a leaf may have: a vertex number is 4 bits.
inline constexpr int most_vertices = 16;

/// No path from the root is longer than this many nodes (\see split.cpp), so that so many may wait on a stack.
inline constexpr int deepest = 72;
inline constexpr int most_waiting = (width - 1) * deepest + 1;

/// There are fewer nodes than triangles, of which there are 2^28 at most.
inline constexpr std::uint32_t most_nodes = (std::uint32_t{1} << 28) - 1;

/// Names a node or a leaf: its number, with the top bit set for a leaf, which is counted in units of
/// leaf_unit bytes.
using Ref = std::uint32_t;
inline constexpr Ref leaf_bit = 0x80000000U;
inline constexpr std::uint32_t leaf_unit = 32;

/// A node: up to eight children, each with its box and a slab.
///
/// Child j's box goes along axis i from origin + step * side[i][j] to origin + step * side[3 + i][j],
/// rounded outward; step is a power of two. Its slab holds all its points x: slab[0][j] <= slab step *
/// n.(x - origin) + offset <= slab[1][j] (\see pack.cpp).
struct alignas(64) Node {
  float origin[3], step[3];       ///< along the three axes
  std::uint32_t first_node : 28;  ///< its inner children are numbered from here on
  std::uint32_t count : 4;        ///< how many children
  std::uint32_t first_leaf;       ///< its first leaf
  std::uint8_t side[6][width];
  std::uint8_t child[width];       ///< 0..7: inner child; 128 + n: the leaf n units after the first
  std::uint32_t leaves_of[width];  ///< the first leaf of an inner child, to be fetched together with it; or 0
  std::int8_t normal[3][width];    ///< the mean normal of a child, 127 long
  std::uint16_t slab[2][width];
  std::uint8_t cone[width];  ///< the cosine of the child's cone, in 255ths, or 0 for none: \see cones.hpp
};
static_assert(sizeof(Node) == 192);

/// Leaves lie in units of this size, so that few of them begin in one cache line and end in another.
struct alignas(leaf_unit) LeafUnit {
  unsigned char bytes[leaf_unit];
};

/// The head of a leaf; after it x of all its vertices, then y, then z, as floats relative to the leaf's
/// origin, in the leaf's unit; then the numbers that the mesh has for the vertices, and for the triangles.
struct LeafHead {
  std::uint8_t triangles, vertices;
  std::int16_t
      exponent;  ///< its unit of length is 2^exponent; no coordinate of a vertex is larger than one unit
  std::uint32_t corner[3];   ///< corner a, b, c of triangle j: vertex number (corner >> 4 j) & 15
  float origin[4];           ///< along the three axes; and 0
  std::uint8_t cone[width];  ///< the cosine of each triangle's cone, in 255ths, or 0: \see cones.hpp
};
static_assert(sizeof(LeafHead) == 40);

/// A triangle of a leaf, as the mesh has it: its number, and those of its corners, each the lowest at its
/// position.
struct LeafFace {
  std::uint32_t number;
  std::array<std::uint32_t, 3> corner;
};

/// The whole tree.
struct Tree {
  const Node* nodes;
  const LeafUnit* leaves;
  Ref root;
  float leaf_size;          ///< the mean size of a leaf
  double center[3], scale;  ///< its unit: \see space.hpp
  double offset;            ///< 1 + the largest coordinate of its centre, in its unit
};

/// A child of a node.
inline Ref child(const Node& node, int j) {
  const Ref number = node.child[j];
  return number & 128 ? leaf_bit | (node.first_leaf + (number & 127)) : node.first_node + number;
}
/// A leaf.
inline const LeafHead& leaf_at(const LeafUnit* leaves, Ref ref) {
  return *reinterpret_cast<const LeafHead*>(leaves + (ref & ~leaf_bit));
}
/// Where the coordinates of its vertices begin.
inline const float* coordinates(const LeafHead& leaf) { return reinterpret_cast<const float*>(&leaf + 1); }
/// The numbers of its vertices.
inline const std::uint32_t* vertex_numbers(const LeafHead& leaf) {
  return reinterpret_cast<const std::uint32_t*>(&leaf + 1) + std::size_t{3} * leaf.vertices;
}
/// How many units it takes.
inline std::uint32_t units_of(const LeafHead& leaf) {
  const std::uint32_t numbers = 4U * leaf.vertices + leaf.triangles;
  return (static_cast<std::uint32_t>(sizeof leaf) + 4 * numbers + leaf_unit - 1) / leaf_unit;
}
/// Which of its vertices is corner i of triangle j?
inline std::uint32_t corner_of(const LeafHead& leaf, int j, std::size_t i) {
  return leaf.corner[i] >> 4 * j & 15;
}
/// Its triangle j.
inline LeafFace face_of(const LeafHead& leaf, int j) {
  const std::uint32_t* number = vertex_numbers(leaf);
  return {number[leaf.vertices + j],
          {number[corner_of(leaf, j, 0)], number[corner_of(leaf, j, 1)], number[corner_of(leaf, j, 2)]}};
}

/// 2^exponent, put together from its bits.
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

}  // namespace first_contact::bvh
