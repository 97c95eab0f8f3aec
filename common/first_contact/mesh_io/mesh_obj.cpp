#include "first_contact/mesh_io/mesh_formats.hpp"

namespace first_contact {
namespace {

// The line just read, joined with those that follow while it ends in a backslash.
std::vector<std::string> statement(TextLines& lines) {
  std::vector<std::string> words(lines.words().begin(), lines.words().end());
  while (words.back() == "\\") {
    lines.require_next("a line follows a backslash");
    words.pop_back();
    words.insert(words.end(), lines.words().begin(), lines.words().end());
  }
  return words;
}

// "a/b/c" or "a": corner a, counted from 1; from the last vertex so far, if negative. Checked when all are
// known.
std::uint32_t corner(const TextLines& lines, std::string_view word, std::size_t vertices_so_far) {
  const std::int64_t number = lines.whole(word.substr(0, word.find('/')));
  const std::int64_t from_zero =
      number < 0 ? static_cast<std::int64_t>(vertices_so_far) + number : number - 1;
  if (number == 0 || from_zero < 0 || from_zero >= UINT32_MAX)
    lines.refuse("vertex " + std::to_string(number) + ": counted from 1, or from -1 for the last one");
  return static_cast<std::uint32_t>(from_zero);
}

}  // namespace

Mesh read_obj(const MeshBytes& file) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  std::vector<std::size_t> line_of_face;
  for (TextLines lines(file, '#'); lines.next();) {
    if (lines.words()[0] == "v") vertices.push_back(lines.point(1));
    if (lines.words()[0] != "f") continue;
    std::vector<std::uint32_t> polygon;
    const std::vector<std::string> words = statement(lines);
    for (std::size_t i = 1; i < words.size(); ++i)
      polygon.push_back(corner(lines, words[i], vertices.size()));
    if (polygon.size() < 3) lines.refuse("a face must have at least 3 corners");
    add_fan(faces, polygon);
    line_of_face.resize(faces.size(), lines.line());
  }
  // A face may stand before its vertices.
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const std::uint32_t vertex : faces[i])
      if (vertex >= vertices.size())
        file.refuse_line(line_of_face[i], "vertex " + std::to_string(vertex + 1) + ": must be from 1 to " +
                                              std::to_string(vertices.size()));
  return {std::move(vertices), std::move(faces)};
}

}  // namespace first_contact
