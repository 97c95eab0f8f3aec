#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "catch.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "folder.hpp"

/// \file
/// Files of meshes, made for a test, and what becomes of them.

using first_contact::Mesh;
using first_contact::MeshFileError;
using first_contact::Point;
using first_contact::read_mesh;

inline Mesh read(const std::string& name, const std::string& bytes) {
  const Folder folder;
  return read_mesh(folder.file(name, bytes));
}

/// What the exception says, without the folder's name; empty if there was none.
inline std::string refusal(const std::string& name, const std::string& bytes) {
  const Folder folder;
  try {
    read_mesh(folder.file(name, bytes));
  } catch (const MeshFileError& error) {
    const std::string message = error.what(), prefix = (folder.path() / "").string();
    REQUIRE(message.starts_with(prefix));  // every message names the file
    return message.substr(prefix.size());
  }
  return "";
}

/// A number as the bytes of a file, the lowest first or the highest first.
template <class Number>
std::string bytes_of(Number value, bool little = true) {
  std::string bytes;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;
  const auto bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t byte = little ? i : sizeof(Number) - 1 - i;
    bytes += static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * byte) & 0xff);
  }
  return bytes;
}

/// The square (0,0) (1,0) (1,1) (0,1) at height z, as a binary PLY with doubles, or with floats, and unread
/// extras.
inline std::string binary_ply(bool little, bool doubles, double z, std::uint32_t last_vertex = 3) {
  std::string text =
      std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\ncomment made here\n";
  const std::string real = doubles ? "double" : "float32";
  text += "element vertex 4\nproperty uchar red\nproperty " + real + " x\nproperty " + real +
          " y\nproperty " + real +
          " z\nelement face 1\nproperty list uchar uint vertex_indices\nproperty int group\nend_header\n";
  const double xy[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& [x, y] : xy) {
    text += bytes_of(std::uint8_t{255});
    for (const double value : {x, y, z})
      text += doubles ? bytes_of(value, little) : bytes_of(static_cast<float>(value), little);
  }
  text += bytes_of(std::uint8_t{4});
  for (const std::uint32_t vertex : {0u, 1u, 2u, last_vertex}) text += bytes_of(vertex, little);
  return text + bytes_of(std::uint32_t{7}, little);
}

inline std::string binary_stl(std::uint32_t promised, std::size_t triangles, float first = 0) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as many real files have it
  bytes += bytes_of(promised);
  const float corners[2][9] = {{first, 0, 0, 1, 0, 0, 1, 1, 0}, {first, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (std::size_t i = 0; i < triangles; ++i) {
    for (int k = 0; k < 3; ++k) bytes += bytes_of(0.f);
    for (const float value : corners[i % 2]) bytes += bytes_of(value);
    bytes += std::string(2, '\0');
  }
  return bytes;
}
