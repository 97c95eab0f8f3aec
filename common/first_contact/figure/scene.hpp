#pragma once
#include <optional>
#include <string>
#include <vector>

#include "first_contact/figure/figure.hpp"
#include "first_contact/figure/paint.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"

namespace first_contact::figure {

/// Where the eye of a parallel projection is, in degrees: `tilt` from straight above (0) to level (90),
/// `turn` about the vertical.
struct View {
  double tilt = 70;  ///< from straight above (0) to level (90), in degrees
  double turn = 24;  ///< about the vertical, in degrees

  Vector eye() const;    ///< unit, from the scene to the eye
  Vector right() const;  ///< unit, to the right of the picture
  Vector up() const;     ///< unit, upwards in the picture
};

enum class Align { left, centre, right };

/// A picture of things in space, sorted from far to near and painted through gnuplot in that order:
/// projection, shading and sorting are done here, so that translucent and hidden parts come out the same
/// everywhere.
///
/// Things are sorted by layer first (higher ones are painted later), then by the depth of their middle.
class Scene {
 public:
  /// The light falls from the upper left, on space as well as on a picture in a plane.
  /// \param view  where the eye is
  /// \param margin  around the things, as a part of their extent; it must hold the labels at the rim
  /// \param origin  of the picture's coordinates: near the things, for a script has few digits
  explicit Scene(View view = {}, double margin = 0.06, const Point& origin = Point::Zero());

  /// A plane polygon, convex or not.
  void polygon(const std::vector<Point>& corners, const Fill& fill, int layer = 0);
  /// The parallelogram about `center` with the half edges u and v.
  void patch(const Point& center, const Vector& u, const Vector& v, const Fill& fill, int layer = 0);
  /// A round disc at right angles to `normal`: a contact shadow, the mouth of a cylinder.
  void disc(const Point& center, const Vector& normal, double radius, const Fill& fill, int layer = 0);
  /// Straight lines from point to point.
  void line(const std::vector<Point>& points, const Pen& pen, int layer = 1);
  /// An arrow, its head at `to`.
  void arrow(const Point& from, const Point& to, const Pen& pen = {colour::red, 2.4}, int layer = 2);
  /// A ball, shaded; below opacity 1 it is of glass.
  /// \param step degrees between two shades; small balls need no fine ones
  void sphere(const Sphere& ball, const Colour& colour = colour::amber, double opacity = 1, int layer = 0,
              double step = 2.5);
  /// The faces of a box that the eye sees, its edges, and its hidden edges dashed in grey.
  void box(const Box& box, const Fill& fill, int layer = 0);
  /// The triangles of a mesh; of a closed one only those that face the eye.
  void mesh(const Mesh& mesh, const Fill& fill, bool closed, int layer = 0);
  /// A small round mark.
  void dot(const Point& at, const Colour& colour = colour::ink);
  /// Text beside a point, moved by (right, up) widths of a character.
  void label(const std::string& text, const Point& at, double right = 0, double up = 0,
             const Colour& colour = colour::ink, Align align = Align::centre);

  /// Makes room for a point at which nothing is drawn, such as what moves over the picture.
  void make_room(const Point& p) { room_.extend(project(p)); }

  /// The size of a picture of this width that the scene just fills.
  Size size(int width = 720) const;
  /// Writes all of it to the figure's script.
  void draw(Figure& figure) const;
  /// Writes all but the plot command to the figure's script.
  /// \return the clauses of that command
  std::string write(Figure& figure) const;

  /// Where a point is in the picture, in the units of the scene.
  Eigen::Vector2d project(const Point& p) const {
    const Vector q = p - origin_;
    return {q.dot(right_), q.dot(up_)};
  }
  /// All of the picture, in the same units.
  Eigen::AlignedBox2d extent() const;

 private:
  struct Item {
    int layer;
    double depth;
    std::string style;  // of a plot clause
    std::vector<Eigen::Vector2d> points;
  };
  struct Text {
    std::string text;
    Eigen::Vector2d at;
    double right, up;
    Colour colour;
    Align align;
  };

  void add(const std::vector<Point>& points, std::string style, int layer, std::optional<double> depth = {});
  void cap(const Sphere& ball, const Vector& pole, double angle, const std::string& style, int layer);
  void fine_mesh(const Mesh& mesh, const Fill& fill, bool closed, int layer);
  std::string fill_style(const Fill& fill, const Vector& normal) const;
  void write_frame(std::ostream& out) const;
  void write_texts(std::ostream& out) const;
  std::vector<const Item*> far_to_near() const;
  static void add_rows(Table& rows, const Item& item);

  Vector eye_, right_, up_, light_;
  double margin_;
  Point origin_;
  Eigen::AlignedBox2d room_;
  std::vector<Item> items_;
  std::vector<Text> texts_;
};

}  // namespace first_contact::figure
