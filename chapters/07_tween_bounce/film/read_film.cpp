#include "read_film.hpp"

#include <algorithm>
#include <cctype>

#include "entry.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/input.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "scenes.hpp"
#include "words.hpp"

using namespace first_contact;

namespace tween_bounce {

namespace {

constexpr double most_degrees = 360;

Actor actor_of(const Entry& film) {
  const std::string kind = film.one_of({"ball", "box"});
  const Entry entry = film.member(kind);
  if (kind == "ball") {
    entry.only({"radius"});
    return Sphere{Point::Zero(), entry.member("radius").number(least_length, most_length)};
  }
  entry.only({"sides"});
  return box_of(entry);
}

// Where a body is and how it is turned: by a place and a turn, or by one 4x4 matrix, row by row, as the paper has it.
void take_pose(const Entry& entry, FilmKey& key) {
  const auto matrix = entry.find("matrix");
  const auto turn = entry.find("turn");
  key.turn = turn ? turn_of(*turn) : Quaternion(1, 0, 0, 0);
  if (!matrix) {
    key.place = entry.member("place").vector();
    return;
  }
  if (turn || entry.find("place")) matrix->refuse("must stand alone, without place and turn");
  const auto rows = matrix->items(4);
  if (rows.size() != 4) matrix->refuse("must have four rows");
  Matrix m;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto row = rows[static_cast<std::size_t>(i)].numbers(4, most_length);
    for (Eigen::Index j = 0; j < 4; ++j) m(i, j) = row[static_cast<std::size_t>(j)];
  }
  const Pose pose = made_of(*matrix, [&] { return first_contact::pose(0, m); });
  key.place = pose.position;
  key.turn = pose.orientation;
}

FilmKey key_of(const Entry& entry, bool is_last) {
  entry.only({"time", "place", "turn", "matrix", "scale", "easing", "path"});
  FilmKey key{entry.member("time").number(-most_time, most_time), {}, {1, 0, 0, 0}, 1, ease::linear, {}};
  take_pose(entry, key);
  if (const auto scale = entry.find("scale")) key.scale = scale->number(1 / most_scale, most_scale);
  const auto easing = entry.find("easing"), path = entry.find("path");
  for (const auto& way : {easing, path})
    if (is_last && way) way->refuse("must not be in the last key, from which no way goes on");
  if (easing) key.easing = easing_of(*easing);
  if (path) key.path = path_of(*path);
  return key;
}

// One smooth way through all places, instead of a path of each key's own.
void take_smooth_way(const Entry& way, const std::vector<Entry>& entries, std::vector<FilmKey>& keys) {
  const Knots knots = knots_of(way);
  std::vector<KeyFrame> frames;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (const auto path = entries[i].find("path"))
      path->refuse("must not be there, as the film has a way through all");
    frames.push_back({keys[i].time, keys[i].place});
  }
  frames = made_of(way, [&] { return smooth(std::move(frames), knots); });
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i].path = frames[i].path;
}

std::vector<FilmKey> keys_of(const Entry& film) {
  const Entry list = film.member("keys");
  const std::vector<Entry> entries = list.items(most_keys);
  if (entries.size() < 2) list.refuse("must be two keys at the least");
  std::vector<FilmKey> keys;
  for (const Entry& entry : entries) {
    const FilmKey key = key_of(entry, keys.size() + 1 == entries.size());
    if (!keys.empty() && !(key.time > keys.back().time))
      entry.member("time").refuse("must be after the key before, " + shortest(keys.back().time));
    keys.push_back(key);
  }
  if (const auto way = film.find("through")) take_smooth_way(*way, entries, keys);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    made_of(entries[i], [&] { return Leg(keys[i].path, keys[i].place, keys[i + 1].place); });
  return keys;
}

// Read here, without a bar that tells how far one is: a mesh to bounce off is no large one.
Environment mesh_of(const Entry& entry, const std::filesystem::path& folder) {
  try {
    Mesh mesh = read_mesh(folder / entry.word());
    if (!(mesh.largest_coordinate() <= most_length))
      entry.refuse("must have no coordinate larger than " + shortest(most_length));
    return Environment(std::move(mesh));
  } catch (const FilmError&) {
    throw;
  } catch (const std::exception& error) {
    entry.refuse(error.what());
  }
}

Wall wall_of(const Entry& entry, const std::filesystem::path& folder) {
  entry.only({"plane", "box", "mesh"});
  const std::string kind = entry.one_of({"plane", "box", "mesh"});
  const Entry value = entry.member(kind);
  if (kind == "box") return box_of(value);
  if (kind == "mesh") return mesh_of(value, folder);
  const auto e = value.numbers(4, most_length);
  if (e[0] == 0 && e[1] == 0 && e[2] == 0) value.refuse("must have a normal that is not zero");
  return made_of(value, [&] {
    Plane plane({e[0], e[1], e[2]}, e[3]);
    if (!(std::abs(plane.offset()) <= most_length))
      value.refuse("must be no farther from the origin than " + shortest(most_length));
    return plane;
  });
}

ContactRule contact_of(const Entry& entry, bool is_ball) {
  entry.only({"do", "restitution", "friction"});
  const Entry what = entry.member("do");
  const std::string word = what.word();
  const auto restitution = entry.find("restitution"), friction = entry.find("friction");
  if (word != "stop" && word != "slide" && word != "bounce")
    what.refuse("must be one of stop, slide, bounce");
  if (word != "stop" && !is_ball) what.refuse("must be stop, as what moves is a box");
  if (word != "bounce" && restitution) restitution->refuse("must not be there, unless it is to bounce");
  if (word == "stop" && friction) friction->refuse("must not be there, as it is to stop");
  const double mu = friction ? friction->number(0, 1000) : 0;
  if (word == "stop") return {word, After::stop()};
  if (word == "slide") return {word, After::slide(mu)};
  return {word, After::bounce(entry.member("restitution").number(0, 1), mu)};
}

figure::View view_of(const Entry& entry) {
  entry.only({"tilt", "turn"});
  figure::View view;
  if (const auto tilt = entry.find("tilt")) view.tilt = tilt->number(0, 90);
  if (const auto turn = entry.find("turn")) view.turn = turn->number(-most_degrees, most_degrees);
  return view;
}

// Does the body stand in the wall before anything has begun? To touch it is no fault: a hair is taken off.
bool stands_in(const Actor& actor, const FilmKey& key, const Wall& wall) {
  constexpr double hair = 1 - 1e-9;
  const Rigid pose(key.turn, key.place);
  return std::visit(
      [&](const auto& obstacle) {
        if (const Sphere* ball = std::get_if<Sphere>(&actor))
          return overlap(Sphere{key.place, hair * ball->radius}, obstacle);
        const Box& b = std::get<Box>(actor);
        return overlap(pose.box(Box(b.center, hair * b.r, hair * b.s, hair * b.t)), obstacle);
      },
      wall);
}

// Of a file's name what a picture's name may have in every script: letters of any language, digits, - and _.
std::string picture_name(std::string stem) {
  const auto is_plain = [](unsigned char letter) {
    return letter >= 0x80 || std::isalnum(letter) || letter == '_';
  };
  std::replace_if(
      stem.begin(), stem.end(), [&](char letter) { return !is_plain(static_cast<unsigned char>(letter)); },
      '-');
  return stem.starts_with('-') ? "film" + stem : stem;
}

}  // namespace

Film film_of(const std::string& text, const std::string& name, const std::filesystem::path& folder) {
  if (text.size() > most_bytes)
    throw FilmError("must be at most " + std::to_string(most_bytes) + " bytes long");
  const Entry entry = Entry::of(without_byte_order_mark(text));
  entry.only({"ball", "box", "keys", "through", "obstacles", "contact", "view"});
  Film film{name, actor_of(entry), keys_of(entry)};
  const auto contact = entry.find("contact"), obstacles = entry.find("obstacles"), view = entry.find("view");
  if (contact) film.contact = contact_of(*contact, std::holds_alternative<Sphere>(film.actor));
  if (view) film.view = view_of(*view);
  if (!obstacles) return film;
  for (const Entry& obstacle : obstacles->items(most_walls)) {
    film.walls.push_back(wall_of(obstacle, folder));
    if (stands_in(film.actor, film.keys.front(), film.walls.back()))
      obstacle.refuse("must not be where the body begins");
  }
  return film;
}

Film film_named(const std::string& word) {
  for (const auto& [name, text] : scenes())
    if (word == name) return film_of(std::string(text), word, ".");
  const std::filesystem::path file = word;
  const std::size_t begin = word.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (std::error_code ignored;
      word[std::min(begin, word.size() - 1)] == '{' && !std::filesystem::exists(file, ignored))
    return film_of(word, "film", ".");
  if (word.find_first_of("./\\") == std::string::npos)
    throw FilmError("must be a JSON file or its text, { }, or one of " + scene_names());
  return film_of(read_file(file, most_bytes), picture_name(file.stem().string()), file.parent_path());
}

}  // namespace tween_bounce
