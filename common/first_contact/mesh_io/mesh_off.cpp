#include <algorithm>

#include "first_contact/mesh_io/mesh_formats.hpp"

namespace first_contact {
namespace {

struct Header {
  bool more_than_positions;  // normals, colours or texture coordinates follow each position
  std::int64_t vertices;
  std::int64_t faces;
};

Header read_header(TextLines& lines) {
  lines.require_next("the header OFF is missing");
  std::string_view name = lines.words()[0];
  for (const std::string_view prefix : {"ST", "C", "N"})
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  if (name != "OFF")
    lines.refuse("must begin with OFF (or COFF, NOFF, STOFF and their like, in three dimensions)");
  const bool prefixed = lines.words()[0] != "OFF";

  std::size_t first = 1;  // the counts may stand behind the name, or on a line of their own
  if (lines.words().size() == 1) {
    lines.require_next("the counts of vertices and faces are missing");
    first = 0;
  }
  if (lines.words()[first] == "BINARY") lines.refuse("binary OFF is not supported: must be text");
  if (lines.words().size() < first + 2) lines.refuse("must have the counts of vertices, faces and edges");
  const Header header{prefixed, lines.whole(lines.words()[first]), lines.whole(lines.words()[first + 1])};
  if (header.vertices < 0 || header.faces < 0) lines.refuse("a count must not be negative");
  return header;
}

std::string progress(std::int64_t done, std::int64_t promised, const std::string& what) {
  return std::to_string(done) + " of " + std::to_string(promised) + " " + what;
}

// "n a b c ... colour": n corners, counted from 0.
std::vector<std::uint32_t> read_polygon(const TextLines& lines, std::size_t vertices) {
  const std::int64_t corners = lines.whole(lines.words()[0]);
  if (corners < 3) lines.refuse("a face must have at least 3 corners");
  const auto given = static_cast<std::int64_t>(lines.words().size()) - 1;
  if (given < corners) lines.refuse(progress(given, corners, "corners: all must be on the line"));
  std::vector<std::uint32_t> polygon;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(corners); ++i) {
    const std::int64_t vertex = lines.whole(lines.words()[i]);
    if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices))
      lines.refuse("vertex " + std::to_string(vertex) + ": must be from 0 to below " +
                   std::to_string(vertices));
    polygon.push_back(static_cast<std::uint32_t>(vertex));
  }
  return polygon;
}

}  // namespace

Mesh read_off(const MeshBytes& file) {
  TextLines lines(file, '#');
  const Header header = read_header(lines);
  std::vector<Point> vertices;
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    lines.require_next(progress(i, header.vertices, "vertices"));
    vertices.push_back(lines.point(0));
    if (!header.more_than_positions && lines.words().size() != 3)
      lines.refuse("a vertex must have 3 numbers");
  }
  std::vector<Mesh::Face> faces;
  for (std::int64_t i = 0; i < header.faces; ++i) {
    lines.require_next(progress(i, header.faces, "faces"));
    add_fan(faces, read_polygon(lines, vertices.size()));
  }
  if (lines.next()) lines.refuse("more follows than the counts promise");
  return {std::move(vertices), std::move(faces)};
}

}  // namespace first_contact
