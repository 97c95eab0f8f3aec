#include "first_contact/mesh_io/mesh_formats.hpp"
#include "first_contact/mesh_io/text_lines.hpp"

namespace first_contact {
namespace {

struct OffHeader {
  std::size_t least,
      most;  // numbers of a vertex: its position, and what the name of the format promises besides
  std::int64_t vertices;
  std::int64_t faces;
};

// "OFF", or with ST for texture coordinates, C for a colour, N for a normal before it.
void read_name(const TextLines& lines, OffHeader& header) {
  struct Prefix {
    std::string_view letters;
    std::size_t least, most;
  };
  std::string_view name = lines.words()[0];
  header.least = header.most = 3;
  for (const Prefix& prefix : {Prefix{"ST", 2, 2}, Prefix{"C", 1, 4}, Prefix{"N", 3, 3}}) {
    if (!name.starts_with(prefix.letters)) continue;
    name.remove_prefix(prefix.letters.size());
    header.least += prefix.least;
    header.most += prefix.most;
  }
  if (name != "OFF")
    lines.refuse("must begin with OFF (or COFF, NOFF, STOFF and their like, in three dimensions)");
}

OffHeader read_off_header(TextLines& lines) {
  lines.require_next("the header OFF is missing");
  OffHeader header{};
  read_name(lines, header);
  std::size_t first = 1;  // the counts may stand behind the name, or on a line of their own
  if (lines.words().size() == 1) {
    lines.require_next("the counts of vertices and faces are missing");
    first = 0;
  }
  if (lines.words()[first] == "BINARY") lines.refuse("binary OFF is not supported: must be text");
  if (lines.words().size() < first + 2) lines.refuse("must have the counts of vertices, faces and edges");
  header.vertices = lines.whole(lines.words()[first]);
  header.faces = lines.whole(lines.words()[first + 1]);
  if (header.vertices < 0 || header.faces < 0) lines.refuse("a count must not be negative");
  return header;
}

Point read_vertex(const TextLines& lines, const OffHeader& header) {
  const std::size_t numbers = lines.words().size();
  const Point position = lines.point(0);
  if (numbers < header.least || numbers > header.most)
    lines.refuse("a vertex must have " + std::to_string(header.least) +
                 (header.most == header.least ? "" : " to " + std::to_string(header.most)) + " numbers");
  for (std::size_t i = 3; i < numbers; ++i) lines.any_number(i);
  return position;
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

RawMesh read_off(const MeshBytes& file) {
  file.refuse_wrappings();
  TextLines lines(file, {.comment = '#'});
  const OffHeader header = read_off_header(lines);
  RawMesh mesh;
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    lines.require_next(progress(i, header.vertices, "vertices"));
    mesh.vertices.push_back(read_vertex(lines, header));
  }
  for (std::int64_t i = 0; i < header.faces; ++i) {
    lines.require_next(progress(i, header.faces, "faces"));
    mesh.faces.add(read_polygon(lines, mesh.vertices.size()), lines.line());
  }
  if (lines.next()) lines.refuse("more follows than the counts promise");
  return mesh;
}

}  // namespace first_contact
