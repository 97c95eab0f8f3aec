#include "first_contact/mesh_io/read_mesh.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <new>
#include <string>

#include "first_contact/files/decimal.hpp"
#include "first_contact/files/input.hpp"
#include "first_contact/files/output.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/mesh_io/mesh_formats.hpp"

namespace first_contact {
namespace {

MeshBytes load(const std::filesystem::path& file, const ReadingProgress& progress) {
  MeshBytes loaded;
  loaded.name = file.string();
  loaded.progress = progress;
  try {
    loaded.bytes = read_file(file);
  } catch (const FileError& error) {
    throw MeshFileError(error.what());
  }
  if (loaded.bytes.empty()) throw MeshFileError(printable(loaded.name) + ": is empty, must hold a mesh");
  return loaded;
}

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

using Reader = RawMesh (*)(const MeshBytes&);

Reader reader_of(const std::filesystem::path& file) {
  constexpr std::array<std::pair<std::string_view, Reader>, 4> readers{
      {{".obj", read_obj}, {".off", read_off}, {".ply", read_ply}, {".stl", read_stl}}};
  const std::string ending = lower_ending(file);
  for (const auto& [name, read] : readers)
    if (ending == name) return read;
  throw MeshFileError(printable(file.string()) + ": the name must end in .obj, .off, .ply or .stl");
}

Mesh triangulated(const MeshBytes& file, RawMesh raw, ReadingNotes* notes) {
  if (raw.faces.size() == 0)
    throw MeshFileError(printable(file.name) + ": holds no face, must hold at least one");
  std::vector<Mesh::Face> faces;
  ReadingNotes found;
  for (std::size_t i = 0; i < raw.faces.size(); ++i) {
    const Cut cut = add_triangles(faces, raw.vertices, raw.faces[i]);
    if (cut == Cut::too_long)
      throw MeshFileError(printable(file.name) + ", face " + std::to_string(i + 1) +
                          ": is not convex, and so must have at most " + std::to_string(most_corners) +
                          " corners");
    found.crossing += cut == Cut::crossing;
  }
  if (notes != nullptr) *notes = found;
  return {std::move(raw.vertices), std::move(faces)};
}

std::string as_off(const Mesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices().size()) + " " + std::to_string(mesh.size()) + " 0\n";
  for (const Point& p : mesh.vertices())
    text += shortest(p.x()) + " " + shortest(p.y()) + " " + shortest(p.z()) + "\n";
  for (const auto& [a, b, c] : mesh.faces())
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  return text;
}

}  // namespace

Mesh read_mesh(const MeshBytes& file, ReadingNotes* notes) {
  try {
    Mesh mesh = triangulated(file, reader_of(file.name)(file), notes);
    if (file.progress) file.progress(1);
    return mesh;
  } catch (const MeshFileError&) {
    throw;
  } catch (const std::invalid_argument& error) {  // a vertex out of range
    throw MeshFileError(printable(file.name) + ": " + error.what());
  } catch (const std::bad_alloc&) {
    throw MeshFileError(printable(file.name) + ": needs more memory than there is");
  }
}

Mesh read_mesh(const std::filesystem::path& file, const ReadingProgress& progress, ReadingNotes* notes) {
  reader_of(file);  // the name is looked at before the file is
  return read_mesh(load(file, progress), notes);
}

void write_off(const std::filesystem::path& file, const Mesh& mesh) { write_file(file, as_off(mesh)); }

}  // namespace first_contact
