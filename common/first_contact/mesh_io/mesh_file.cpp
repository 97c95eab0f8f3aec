#include "first_contact/mesh_io/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

#include "first_contact/mesh_io/mesh_formats.hpp"

namespace first_contact {
namespace {

MeshBytes load(const std::filesystem::path& file, const ReadingProgress& progress) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, ignored))
    throw MeshFileError(file.string() + ": must be a file that exists and can be read");
  MeshBytes loaded;
  loaded.name = file.string();
  loaded.bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  loaded.progress = progress;
  if (in.bad()) throw MeshFileError(file.string() + ": cannot be read to its end");
  if (loaded.bytes.empty()) throw MeshFileError(file.string() + ": is empty, must hold a mesh");
  return loaded;
}

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

// The fewest digits that are read back as the same double.
std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
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

Mesh read_mesh(const std::filesystem::path& file, const ReadingProgress& progress) {
  using Reader = Mesh (*)(const MeshBytes&);
  constexpr std::array<std::pair<std::string_view, Reader>, 4> readers{
      {{".obj", read_obj}, {".off", read_off}, {".ply", read_ply}, {".stl", read_stl}}};
  const std::string ending = lower_ending(file);
  for (const auto& [name, read] : readers)
    if (ending == name) {
      const MeshBytes loaded = load(file, progress);
      Mesh mesh = read(loaded);
      if (mesh.size() == 0) throw MeshFileError(loaded.name + ": holds no face, must hold at least one");
      if (progress) progress(1);
      return mesh;
    }
  throw MeshFileError(file.string() + ": the name must end in .obj, .off, .ply or .stl");
}

void write_off(const std::filesystem::path& file, const Mesh& mesh) {
  std::filesystem::path part = file;
  part += ".part";
  const bool written = bool(std::ofstream(part, std::ios::binary) << as_off(mesh) << std::flush);
  std::error_code error;
  if (written) std::filesystem::rename(part, file, error);
  if (written && !error) return;
  std::filesystem::remove(part, error);
  throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace first_contact
