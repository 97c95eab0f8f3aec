#pragma once
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "first_contact/figure/figure.hpp"
#include "first_contact/figure/palette.hpp"

/// \file
/// Figures that move. gnuplot draws what stands still; what moves is laid over its svg as SMIL, a few
/// kilobytes that any browser plays, sharp at every size. A gif, for where no svg will do, is drawn by
/// gnuplot, picture by picture.

namespace first_contact::figure {

/// The place of a diagram in its picture, fixed so that others can draw into it: its margins as parts of the
/// picture from the left and from below, and its ranges.
struct Diagram {
  Size size;  ///< of the whole picture
  ///@{
  /// Where the diagram ends, as a part of the picture.
  double left, right, bottom, top;
  ///@}
  Eigen::AlignedBox2d range;  ///< of x and y

  /// Where a point of the diagram is in the picture, in points from the upper left corner.
  Eigen::Vector2d pixel(const Eigen::Vector2d& p) const;
  /// How many points long a unit of y is.
  double unit_y() const;
  /// gnuplot's commands for these margins and ranges.
  std::string commands() const;
};

/// Where something is at a time.
struct Moment {
  double time;         ///< in the diagram's unit of time
  Eigen::Vector2d at;  ///< in the diagram's units
};

/// The corners of something at a time, in the diagram's units; none while it is not seen.
struct Outline {
  double time;                           ///< in the diagram's unit of time
  std::vector<Eigen::Vector2d> corners;  ///< of all outlines that are not empty equally many
};

/// The moments that are needed, so that what moves straight from one to the next is never more than
/// `tolerance` from where it should be (Douglas and Peucker, at equal times). The corners of a path are kept.
std::vector<Moment> sparse(const std::vector<Moment>& moments, double tolerance);

/// What moves over a diagram, round and round, from time 0 to `duration`. A reader who asked for less motion
/// sees its last picture instead.
class Animation {
 public:
  /// \param seconds  that one round takes to play
  Animation(const Diagram& diagram, double duration, double seconds);

  /// A disc that moves, its radius in the diagram's unit of y.
  void ball(const std::vector<Moment>& moments, double radius, const Colour& colour);
  /// The path of moments, drawn as time goes by: its x must not decrease.
  void trace(const std::vector<Moment>& moments, const Colour& colour, double width);
  /// A pale disc that appears at a moment and stays.
  void stamp(const Moment& moment, double radius, const Colour& colour, double opacity);
  /// A body's face that moves and turns: its corners go straight from each outline to the next.
  void area(const std::vector<Outline>& outlines, const Colour& fill);
  /// A line upon a body, that moves alike.
  void line(const std::vector<Outline>& outlines, const Colour& colour);
  /// A line of text that is there from a time on, until another.
  void text(const std::string& words, const Eigen::Vector2d& at, double from, double until,
            const Colour& colour, bool chinese);

  /// The svg with all this in it.
  std::string over(std::string svg) const;

 private:
  std::string timing() const;
  void shape(std::vector<Outline> outlines, const std::string& element, const std::string& style);
  std::string appearing(double from, double until, double opacity) const;
  std::string path(const std::vector<Moment>& moments) const;

  Diagram diagram_;
  double duration_, seconds_;
  std::string moving_, still_;
};

/// A figure that moves: `figure`'s script draws what rests, or as gif everything. Writes the script, and,
/// where svg is wanted, the svg with what moves in it, and the gif. The figure must have been begun with
/// svg_only(studio).
void draw_animated(const Studio& studio, Figure& figure, const Animation& animation);
/// The same studio for pictures that are made as svg or not at all.
Studio svg_only(Studio studio);

/// gnuplot's commands that make the pictures of a gif, `delay` hundredths of a second each, if that is the
/// format.
std::string gif_terminal(const std::string& name, Size size, int delay, bool chinese);

}  // namespace first_contact::figure
