#include <algorithm>
#include <cmath>
#include <functional>

#include "figures.hpp"
#include "film_shapes.hpp"
#include "first_contact/figure/animation.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;
namespace colour = first_contact::figure::colour;

namespace tween_bounce {

namespace {

constexpr int images = 10;    // that the body leaves of itself, equal steps of time apart
constexpr int steps = 240;    // in which its path is drawn
constexpr double held = 0.8;  // seconds that an animation stays at its end

// All moments of a film that a line should go through: many, and each contact.
std::vector<double> moments_of(const Film& film, const Showing& showing, double until,
                               std::vector<double> times) {
  for (const Contact& contact : showing.contacts())
    if (contact.time < until) times.push_back(contact.time);
  for (const FilmKey& key : film.keys)
    if (key.time < until) times.push_back(key.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<double> even_times(double begin, double end, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(begin + (end - begin) * i / count);
  return times;
}

std::vector<Point> places(const std::vector<double>& times, const std::function<Point(double)>& at) {
  std::vector<Point> all;
  for (const double time : times) all.push_back(at(time));
  return all;
}

// All that is drawn: the ways, planned and gone, with the body's reach about them, and what is in the way.
Eigen::AlignedBox3d room_of(const Film& film, const std::vector<Point>& ways) {
  Eigen::AlignedBox3d room;
  const Vector reach = Vector::Constant(1.3 * reach_of(film.actor));
  for (const Point& p : ways) room.extend(p - reach).extend(p + reach);
  for (const Wall& wall : film.walls) {
    if (const Box* box = std::get_if<Box>(&wall))
      for (const Point& p : box->vertices()) room.extend(p);
    if (const Environment* surface = std::get_if<Environment>(&wall))
      for (const Point& p : surface->mesh().vertices()) room.extend(p);
  }
  const double depth = 0.16 * room.sizes().maxCoeff();  // a flat film has a floor to stand on
  const Vector middle = room.center();
  room.extend(middle - depth * Vector(0, 1, 0)).extend(middle + depth * Vector(0, 1, 0));
  return room;
}

// Where a picture's coordinates begin: at the origin, or, of a film that is far from it, in the middle of its keys.
Point origin_of(const Film& film) {
  Eigen::AlignedBox3d all;
  const Vector reach = Vector::Constant(reach_of(film.actor));
  for (const FilmKey& key : film.keys) all.extend(key.place - reach).extend(key.place + reach);
  const Point middle = all.center();
  return middle.cwiseAbs().maxCoeff() > 16 * all.sizes().maxCoeff() ? middle : Point::Zero();
}

/// A film's stage, large enough for all of it: what rests, the way that was planned, and the way as far as it is gone.
class Stage {
 public:
  Stage(const Film& film, const Showing& showing, double until)
      : film_(film), scene_(film.view, 0.02, origin_of(film)) {
    const auto times_until = [&](double end) {
      return moments_of(film, showing, end, even_times(film.begin(), end, steps));
    };
    const auto way = [&](double time) { return showing.at(time).place; };
    const auto all = times_until(film.end());
    const Eigen::AlignedBox3d room = room_of(film, places(all, way));
    for (const Wall& wall : film.walls) put(wall, room);
    const Vector reach = 1.3 * reach_of(film.actor) * (film.view.right() + film.view.up());
    for (const Point& p : places(all, way)) {
      scene_.make_room(p + reach);
      scene_.make_room(p - reach);
    }
    if (!showing.contacts().empty())
      scene_.line(places(all, [&](double time) { return showing.planned(time); }), {colour::grey, 1.4, true},
                  1);
    scene_.line(places(times_until(until), way), {colour::red, 1.8}, 1);
  }

  Scene& scene() { return scene_; }

 private:
  void put(const Wall& wall, const Eigen::AlignedBox3d& room) {
    const Fill fill{colour::floor, 1, false, Pen{colour::grey, 1}};
    if (const Plane* plane = std::get_if<Plane>(&wall))
      scene_.polygon(piece_of(*plane, room, film_.walls, film_.keys.front().place), fill);
    if (const Box* box = std::get_if<Box>(&wall)) scene_.box(*box, {colour::blue, 1, true});
    if (const Environment* surface = std::get_if<Environment>(&wall))
      scene_.mesh(surface->mesh(), {colour::blue, 1, true}, false);
  }

  const Film& film_;
  Scene scene_;
};

// The body, pale or not, above all that rests.
void put_body(Scene& scene, const Film& film, const Frame& frame, double opacity, int layer) {
  const Shape shape = shape_of(film.actor, frame, film.view);
  const double width = opacity < 1 ? 0.7 : 1.4;
  for (const Face& face : shape.faces)
    if (!face.corners.empty())
      scene.polygon(face.corners, {face.colour, opacity, false, Pen{colour::ink, width}}, layer);
  for (const auto& line : shape.lines) scene.line(line, {colour::ink, width}, layer);
}

// The contacts, each with its number, but where that would stand upon another.
void put_numbers(Scene& scene, const Film& film, const Showing& showing, double until) {
  const double aside = 0.35 * reach_of(film.actor);
  std::vector<Point> numbered;
  for (std::size_t i = 0; i < showing.contacts().size() && showing.contacts()[i].time <= until; ++i) {
    const Contact& contact = showing.contacts()[i];
    const Point at = contact.point() - aside * contact.normal;
    scene.dot(contact.point(), colour::blue);
    const auto is_near = [&](const Point& other) { return (other - at).norm() < 3 * aside; };
    if (std::any_of(numbered.begin(), numbered.end(), is_near)) continue;
    scene.label(std::to_string(i + 1), at, 0, -0.3);
    numbered.push_back(at);
  }
}

/// A body at all pictures of an animation, in the plane of the picture.
struct Moves {
  std::vector<std::vector<Outline>> faces, lines;  // part by part, each at all times
  std::vector<const Colour*> colours;
};

Moves moves_of(const Film& film, const Showing& showing, const Scene& scene,
               const std::vector<double>& times) {
  Moves moves;
  for (const double time : times) {
    const Shape shape = shape_of(film.actor, showing.at(time), film.view);
    moves.faces.resize(shape.faces.size());
    moves.lines.resize(shape.lines.size());
    const auto outline = [&](const std::vector<Point>& corners) {
      Outline flat{time - film.begin(), {}};
      for (const Point& p : corners) flat.corners.push_back(scene.project(p));
      return flat;
    };
    moves.colours.clear();
    for (std::size_t i = 0; i < shape.faces.size(); ++i) {
      moves.faces[i].push_back(outline(shape.faces[i].corners));
      moves.colours.push_back(&shape.faces[i].colour);
    }
    for (std::size_t i = 0; i < shape.lines.size(); ++i) moves.lines[i].push_back(outline(shape.lines[i]));
  }
  return moves;
}

// A block for each picture, with an empty row twice between them. What is not seen is at no place.
Table blocks_of(const std::vector<Outline>& outlines, bool closed) {
  Table rows;
  for (const Outline& outline : outlines) {
    if (!rows.empty()) rows.insert(rows.end(), 2, {});
    for (const Eigen::Vector2d& p : outline.corners) rows.push_back({p.x(), p.y()});
    if (outline.corners.empty()) rows.push_back({NAN, NAN});
    if (closed && !outline.corners.empty()) rows.push_back({outline.corners[0].x(), outline.corners[0].y()});
  }
  return rows;
}

// Of two pictures in a row that are alike nothing would be left in a gif, not even the time that one is shown: a corner
// that nobody sees tells them apart.
constexpr const char* corner =
    "set object 1 rectangle from graph 0,0 to graph 0.005,0.005 fc rgb (k % 2 ? 0xFFFFFF : 0xFCFCFC) fs "
    "solid noborder";

// The script: as gif picture by picture, else what rests.
void write_pictures(Figure& figure, const Scene& scene, const Moves& moves, std::size_t count) {
  const std::string resting = scene.write(figure);
  std::string body;
  for (std::size_t i = 0; i < moves.faces.size(); ++i) {
    const std::string name = "face" + std::to_string(i), colour(moves.colours[i]->name);
    figure.data(name, blocks_of(moves.faces[i], true), 5);
    body += ", \\\n $" + name + " index k with filledcurves closed fc rgb " + colour +
            " fs solid border lc rgb INK lw 1.2 notitle";
  }
  for (std::size_t i = 0; i < moves.lines.size(); ++i) {
    const std::string name = "line" + std::to_string(i);
    figure.data(name, blocks_of(moves.lines[i], false), 5);
    body += ", \\\n $" + name + " index k with lines lc rgb INK lw 1.2 notitle";
  }
  figure.script() << "if (format eq \"gif\") {\n  do for [k = 0:" << count - 1 << "] {\n"
                  << corner << "\nplot " << resting << body << "\n}\n} else {\nplot " << resting << "\n}\n";
}

// A gif counts in hundredths of a second, and browsers take less than two for ten.
int delay_of(double per_second) { return std::max(2, static_cast<int>(std::lround(100 / per_second))); }

// The scene as a diagram: gnuplot keeps both units alike, and the picture's height is a whole number of points.
Diagram diagram_of(const Scene& scene) {
  const Size size = scene.size();
  const Eigen::AlignedBox2d all = scene.extent();
  const Eigen::Vector2d points(size.width, size.height);
  const Eigen::Vector2d half = points / (2 * points.cwiseQuotient(all.sizes()).minCoeff());
  return {size, 0, 1, 0, 1, {all.center() - half, all.center() + half}};
}

void draw_moving(const Program& program, const Film& film, const Showing& showing, const FilmCut& cut) {
  Stage stage(film, showing, cut.until);
  const Scene& scene = stage.scene();
  const double duration = cut.until - film.begin() + held;
  Animation animation(diagram_of(scene), duration, duration);
  const auto times = picture_times(film.begin(), cut.until, cut.per_second);
  const Moves smooth = moves_of(film, showing, scene, moments_of(film, showing, cut.until, times));
  for (std::size_t i = 0; i < smooth.faces.size(); ++i) animation.area(smooth.faces[i], *smooth.colours[i]);
  for (const auto& line : smooth.lines) animation.line(line, colour::ink);

  const std::string name = film.name + "-animated";
  const int delay = delay_of(cut.per_second);
  Figure figure(svg_only(program.studio()), name, scene.size());
  figure.script() << gif_terminal(name, scene.size(), delay, program.studio().chinese);
  auto pictures = picture_times(film.begin(), cut.until, 100.0 / delay);
  pictures.insert(pictures.end(), static_cast<std::size_t>(100 * held / delay), cut.until);
  write_pictures(figure, scene, moves_of(film, showing, scene, pictures), pictures.size());
  draw_animated(program.studio(), figure, animation);
}

}  // namespace

// One picture: the way, the images that the body leaves, its contacts, and where it is at last.
void draw_still(const Program& program, const Film& film, const Showing& showing, double until) {
  Stage stage(film, showing, until);
  Scene& scene = stage.scene();
  int layer = 2;
  for (const double time : even_times(film.begin(), until, images))
    if (time < until) put_body(scene, film, showing.at(time), 0.35, layer++);
  put_body(scene, film, showing.at(until), 1, layer);
  put_numbers(scene, film, showing, until);
  Figure figure(program.studio(), film.name, scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_film(const Program& program, const Film& film, const Showing& showing, const FilmCut& cut) {
  draw_still(program, film, showing, cut.until);
  draw_moving(program, film, showing, cut);
}

}  // namespace tween_bounce
