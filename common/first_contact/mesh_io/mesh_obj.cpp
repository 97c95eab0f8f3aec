#include "first_contact/mesh_io/mesh_formats.hpp"
#include "first_contact/mesh_io/text_lines.hpp"

namespace first_contact {
namespace {

// "v x y z", and perhaps a weight or a colour.
Point vertex(const TextLines& lines) {
  for (std::size_t i = 4; i < lines.words().size(); ++i) lines.any_number(i);
  return lines.point(1);
}

// "a", "a/b", "a//c" or "a/b/c": corner a, counted from 1; from the last vertex so far, if negative. Whether
// there is such a vertex is checked when all are known.
std::uint32_t corner(const TextLines& lines, std::string_view word, std::size_t vertices_so_far) {
  const std::int64_t number = lines.whole(word.substr(0, word.find('/')));
  const std::int64_t from_zero =
      number < 0 ? static_cast<std::int64_t>(vertices_so_far) + number : number - 1;
  if (number == 0 || from_zero < 0 || from_zero >= UINT32_MAX)
    lines.refuse("vertex " + std::to_string(number) + ": counted from 1, or from -1 for the last one");
  return static_cast<std::uint32_t>(from_zero);
}

// What stands behind a corner's first slash: the numbers of a texture coordinate, of a normal, or of both.
void check_slashes(const TextLines& lines, std::string_view word) {
  std::size_t slash = word.find('/');
  for (int numbers = 0; slash != word.npos; ++numbers) {
    const std::size_t next = word.find('/', slash + 1);
    const std::string_view number = word.substr(slash + 1, next == word.npos ? next : next - slash - 1);
    const bool left_out = number.empty() && numbers == 0 && next != word.npos;
    if (numbers == 2 || (!left_out && (number.empty() || lines.whole(number) == 0)))
      lines.refuse(in_quotes(word) + ": must be a, a/b, a//c or a/b/c, each a number but 0");
    slash = next;
  }
}

void check_corners(const MeshBytes& file, const RawMesh& mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    for (const std::uint32_t vertex : mesh.faces[i])
      if (vertex >= mesh.vertices.size())
        file.refuse_line(mesh.faces.place(i), "vertex " + std::to_string(vertex + 1) +
                                                  ": must be from 1 to " +
                                                  std::to_string(mesh.vertices.size()));
}

}  // namespace

RawMesh read_obj(const MeshBytes& file) {
  file.refuse_wrappings();
  RawMesh mesh;
  std::vector<std::uint32_t> polygon;
  for (TextLines lines(file, {.comment = '#', .continues = true}); lines.next();) {
    if (lines.words()[0] == "v") mesh.vertices.push_back(vertex(lines));
    if (lines.words()[0] != "f") continue;
    polygon.clear();
    for (std::size_t i = 1; i < lines.words().size(); ++i) {
      check_slashes(lines, lines.words()[i]);
      polygon.push_back(corner(lines, lines.words()[i], mesh.vertices.size()));
    }
    if (polygon.size() < 3) lines.refuse("a face must have at least 3 corners");
    mesh.faces.add(polygon, lines.line());
  }
  check_corners(file, mesh);  // at last: a face may stand before its vertices
  return mesh;
}

}  // namespace first_contact
