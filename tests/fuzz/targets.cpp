#include "targets.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "film/entry.hpp"
#include "film/read_film.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/mesh_io/mesh_formats.hpp"
#include "first_contact/program/numbers.hpp"

using namespace first_contact;

namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

void check_message(const std::string& message) {
  require(!message.empty() && message.size() < 1000, "a message must be short: " + printable(message));
  for (const char letter : message)
    require(static_cast<unsigned char>(letter) >= 0x20 && letter != 0x7F,
            "a message must be printable: " + printable(message));
}

// A mesh that is read has a face, and is finite; one that is not is refused in a line.
void feed_mesh(const std::string& name, const std::string& bytes) {
  try {
    MeshBytes file;
    file.name = name;
    file.bytes = bytes;
    const Mesh mesh = read_mesh(file, nullptr);
    require(mesh.size() > 0, "a mesh must have a face");
    for (const Point& vertex : mesh.vertices()) require(vertex.allFinite(), "a vertex must be finite");
  } catch (const MeshFileError& error) {
    check_message(error.what());
    require(std::string(error.what()).starts_with(name), "a refusal must name the file");
  }
}

// The locale is C's here, in which strtod reads all that is read, and more.
void check_decimal(const std::string& text) {
  const auto value = decimal(text);
  if (!value) return;
  char* end = nullptr;
  const double other = std::strtod(text.c_str(), &end);
  require(end == text.c_str() + text.size(), "what is read must be a number");
  require(*value == other || (std::isnan(*value) && std::isnan(other)), "a number must be the nearest");
  if (std::isfinite(*value))
    require(decimal(shortest(*value)) == *value, "the shortest must be the same number");
}

// The first byte tells how many numbers are wanted.
void feed_options(const std::string& bytes) {
  if (bytes.empty()) return;
  const std::string text = bytes.substr(1);
  const std::size_t count = static_cast<unsigned char>(bytes[0]) % 5;
  check_decimal(text);
  check_message("x" + printable(text));
  try {
    const auto numbers =
        count == 0 ? std::vector{program::number_of(text)} : program::numbers_of(text, count);
    require(numbers.size() == std::max<std::size_t>(count, 1), "as many numbers as were asked for");
    for (const double number : numbers) require(std::isfinite(number), "a number must be finite");
  } catch (const program::Refused& error) {
    check_message(error.what());
  }
}

// A film that is read has keys in order, each in a place; one that is not is refused in a line.
void feed_film(const std::string& bytes) {
  try {
    const tween_bounce::Film film = tween_bounce::film_of(bytes, "film", "nowhere");
    require(film.keys.size() > 1 && film.begin() < film.end(),
            "a film must have two keys, one after the other");
    for (const tween_bounce::FilmKey& key : film.keys) {
      require(key.place.allFinite() && key.turn.coeffs().allFinite(), "a key must be somewhere");
      require(key.scale > 0 && std::isfinite(key.easing(0.3)), "a key must be drawn, and eased");
    }
  } catch (const tween_bounce::FilmError& error) {
    check_message(error.what());
  }
}

}  // namespace

const std::vector<Target>& all_targets() {
  static const std::vector<Target> all{
      {"obj", [](const std::string& bytes) { feed_mesh("a.obj", bytes); }},
      {"off", [](const std::string& bytes) { feed_mesh("a.off", bytes); }},
      {"ply", [](const std::string& bytes) { feed_mesh("a.ply", bytes); }},
      {"stl", [](const std::string& bytes) { feed_mesh("a.stl", bytes); }},
      {"options", feed_options},
      {"film", feed_film},
  };
  return all;
}
