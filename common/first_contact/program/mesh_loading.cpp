#include "first_contact/program/mesh_loading.hpp"

#include <iostream>

#include "first_contact/files/printable.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "first_contact/program/progress_line.hpp"

namespace first_contact::program {

namespace {

constexpr std::uintmax_t large = 4 << 20;  // bytes: what is read in less time than one notices

Mesh read_large(const std::filesystem::path& file, ReadingNotes& notes) {
  const ProgressLine line(file.filename().string());
  return read_mesh(
      file, [&](double part) { line.show(part); }, &notes);
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& file) {
  std::error_code unknown;  // what cannot be asked cannot be read either, and read_mesh says so
  const auto bytes = std::filesystem::file_size(file, unknown);
  ReadingNotes notes;
  const Mesh mesh = unknown || bytes < large ? read_mesh(file, {}, &notes) : read_large(file, notes);
  if (notes.crossing > 0)
    std::cerr << "note: " << printable(file.string())
              << ": faces that cross themselves, each cut into a fan of triangles: " << notes.crossing
              << '\n';
  return mesh;
}

}  // namespace first_contact::program
