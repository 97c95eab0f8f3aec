// Chapter 5: a sphere slides along what it meets (paper, 2.2).
#include "first_contact/response/slide.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "figures/figures.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "first_contact/program/mesh_report.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "jitter.hpp"
#include "places.hpp"
#include "scene.hpp"
#include "walk_report.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

std::string up_to_a_million(double value) {
  return value >= 1 && value <= 1e6 ? "" : "must be from 1 to 1000000";
}

std::string up_to_a_thousand(double value) {
  return value >= 0 && value <= 1000 ? "" : "must be from 0 to 1000";
}

Text text_of(Ending ending) {
  switch (ending) {
    case Ending::arrived:
      return {"all of the motion is made", "走完全程"};
    case Ending::cornered:
      return {"no way on: the sphere stands", "無路可滑：停止"};
    default:
      return {"too many contacts: the sphere stands", "碰撞次數過多：停止"};
  }
}

double length_of(const Slide& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    length += norm(path.positions[i] - path.positions[i - 1]);
  return length;
}

//! [report]
// The first contact, and the paper's one projection. Each number is given once: to the reader, and by the rest
// of its line to --json and to the notes.
void tell_projection(Program& program, const Environment& environment, const Moving<Sphere>& ball) {
  Report& report = program.report();
  const Point p2 = ball.shape.center + ball.displacement;
  report.row("P1", ball.shape.center, {"centre of the sphere at the start", "起點（球心）"});
  report.row("P2", p2, {"where it is sent", "欲行進至的位置"});
  program.row("r", ball.shape.radius, {"radius of the sphere", "球面半徑"}).value("radius");
  const auto contact = sweep(ball, environment);
  if (!contact) return report.say({"It meets nothing on its way.", "途中沒有發生碰撞"});

  const Vector& n = contact->normal;
  const Point q = ball.shape.center + contact->time * ball.displacement, c = contact->point();
  const Point p3 = slide_target(p2, q, n), sunk = slide_target(p2, c, n);
  program.row("t", contact->time, {"time of the first contact", "碰撞時間"}).value("time");
  report.row("Q = P1 + t(P2 - P1)", q, {"centre of the sphere at contact", "碰撞時的球心"});
  report.row("N", n, {"unit normal of the surface, to the sphere", "表面的單位法向量"});
  report.say({"As printed, the collision is \"at Q\"; with Q the point of the surface",
              "論文原式：「在 Q 會發生碰撞」；若 Q 取表面上的碰撞點"});
  report.row("C", c, {"point of contact", "碰撞點"});
  report.row("P2 - [(P2 - C).N] N", sunk, {"the sphere ends half sunk", "球面陷入表面一半"});
  report.row("(P3 - C).N", (sunk - c).dot(n),
             {"height of the centre above the wall; it should be r", "球心離牆高度；應為 r"});
  report.say({"Corrected: Q is the centre of the sphere", "修正：Q 為球心"});
  report.row("P3 = P2 - [(P2 - Q).N] N", p3, {"where it slides to", "滑行後的新位置"});
  report.row("(P3 - C).N ", (p3 - c).dot(n), {"height of the centre above the wall", "球心離牆高度"});
  program.row("|P3 - Q|", norm(p3 - q), {"distance that it slides", "滑行距離"}).value("slid");
}

// The whole slide: each corner of the path.
void tell_path(Program& program, const Slide& path, const Moving<Sphere>& ball) {
  Report& report = program.report();
  report.say({"The slide, each motion swept: " + text_of(path.ending).english,
              "滑行的路徑（每段皆作碰撞偵測）：" + text_of(path.ending).chinese});
  report.row("contacts", path.contacts.size(), {"how often it meets a wall", "碰撞次數"});
  for (std::size_t i = 0; i < path.positions.size(); ++i)
    program
        .row("position " + std::to_string(i), path.positions[i],
             i == 0                           ? Text{"start", "起點"}
             : i + 1 == path.positions.size() ? Text{"end", "終點"}
                                              : Text{"it meets a wall", "碰撞"})
        .result("/positions/" + std::to_string(i));
  program.row("length", length_of(path), {"of the path; never more than asked", "路徑長；不大於原距離"})
      .value("length");
  program.row("|P2 - P1|", norm(ball.displacement), {"asked", "原距離"}).value("asked");
}

// One projection alone leads into the next wall; the loop does not.
void tell_second_wall(Report& report, const std::vector<Rectangle>& room, const Moving<Sphere>& ball,
                      const Text& heading) {
  const Environment environment(walls(room));
  const Slide path = slide(ball, environment);
  const Contact& first = path.contacts[0];
  const Point p2 = ball.shape.center + ball.displacement;
  const Point q = ball.shape.center + first.time * ball.displacement;
  report.say(heading);
  report.row("P3", slide_target(p2, q, first.normal),
             {"after the first wall alone: beyond the second", "只算第一面牆：穿過第二面"});
  report.row("end", path.end(), text_of(path.ending));
}

// What is left of a gap that is laid back along the path, by the angle of approach.
void tell_gap(Report& report) {
  report.say({"The gap before the wall, laid back along the path by g or kept along the normal",
              "與牆的間隙 g：沿路徑或沿法向量"});
  for (const double degrees : {90.0, 10.0, 1.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Plane level({0, 0, 1}, 0);
    const Moving<Sphere> ball{{{0, 0, 2}, 1}, {2 / std::tan(angle), 0, -2}};
    const double gap = slide_gap * (2 + std::max(2.0, 2 / std::tan(angle)));
    const double kept = (slide(ball, level).positions[1].z() - 1) / gap;
    report.row("at " + readable(degrees) + (degrees == 1 ? " degree" : " degrees"),
               readable(std::sin(angle)) + " g, " + readable(std::round(kept * 100) / 100) + " g",
               {"height above the wall: along the path, along the normal", "離牆高度：沿路徑、沿法向量"});
  }
}
//! [report]

void give_contacts(Program& program, const Slide& path) {
  program.result_list("/contacts");
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    const Contact& contact = path.contacts[i];
    const std::string place = "/contacts/" + std::to_string(i);
    program.result(place + "/time", contact.time);
    program.result(place + "/point", contact.point());
    program.result(place + "/normal", contact.normal);
    program.result(place + "/feature", to_string(contact.feature));
    program.result(place + "/triangle", contact.triangle);
  }
  program.result("/end", path.end());
}

//! [notes]
// More numbers that the notes speak of: of one wall, of walls one after the other, of a walk over the bunny.
void note_wall(Program& program, const Environment& environment, const Moving<Sphere>& ball) {
  program.value("gap", slide_gap * std::max(largest_coordinate(environment),
                                            ball.shape.center.lpNorm<Eigen::Infinity>() +
                                                ball.displacement.lpNorm<Eigen::Infinity>()));
  const auto contact = sweep(ball, environment);
  if (!contact) return;
  const Point p2 = ball.shape.center + ball.displacement;
  const Point q = ball.shape.center + contact->time * ball.displacement;
  const Point p3 = slide_target(p2, q, contact->normal);
  program.value("depth", (p2 - q).dot(contact->normal));
  program.value("left", norm(p2 - q));
  program.value("through_x", p3.x());
  program.value("through_y", p3.y());
  program.value("through_z", p3.z());
}

// Where the ball would end after the first wall alone, and where it ends in truth.
void note_second_wall(Program& program, const std::string& name, const std::vector<Rectangle>& room,
                      const Moving<Sphere>& ball) {
  const Slide path = slide(ball, Environment(walls(room)));
  const Contact& first = path.contacts[0];
  const Point p2 = ball.shape.center + ball.displacement;
  const Point q = ball.shape.center + first.time * ball.displacement;
  const Point p3 = slide_target(p2, q, first.normal);
  program.value(name + "_through_x", p3.x());
  program.value(name + "_through_y", p3.y());
  program.value(name + "_end_x", path.end().x());
  program.value(name + "_end_y", path.end().y());
}

// How large the gap is if it is laid along the path, as part of what it should be, at one degree and at ten.
void note_gap(Program& program) {
  for (const int degrees : {1, 10})
    program.value("gap_at_" + std::to_string(degrees), std::sin(degrees * std::numbers::pi / 180));
}

void note_frames(Program& program) {
  const Environment wide(wide_corner), bunny(read_mesh(places::meshes + std::string("/bunny.off")));
  const int frames = 40, settled = 10;  // by then the ball is in the corner
  const auto width = [](const Frames& run) {
    double most = 0;
    for (std::size_t i = settled + 1; i < run.positions.size(); ++i)
      most = std::max(most, (run.positions[i] - run.positions[i - 1]).norm());
    return most;
  };
  program.value("jitter", width(wall_after_wall_frames(into_wide_corner, wide, frames)));
  program.value("no_jitter", width(slide_frames(into_wide_corner, wide, frames)));
  const Point& far_end = wide_corner.vertices()[1];
  program.value("wide_corner_degrees", 2 * std::atan2(far_end.y(), far_end.x()) * 180 / std::numbers::pi);
  program.value("wish", into_wide_corner.displacement.norm());
  const Frames walk = slide_frames(over_the_bunny, bunny, 150);
  program.value("bunny_triangles", static_cast<double>(bunny.mesh().size()));
  program.value("bunny_frames", static_cast<double>(walk.positions.size() - 1));
  program.value("bunny_contacts", static_cast<double>(walk.contacts));
}
//! [notes]

//! [studies]
// What is longer than a slide: walks by the thousand, the numbers of the notes, the figures.
void tell_studies(Program& program, const Environment& environment, const Moving<Sphere>& ball,
                  const Slide& path, long frames) {
  const auto grounds = walks::grounds();
  const auto all_walks = tell_walks(program, grounds, frames);
  if (program.given("--mesh")) tell_defects(program.report(), environment.mesh());
  note_wall(program, environment, ball);
  note_second_wall(program, "crease", crease, into_crease);
  note_second_wall(program, "corner", corner, into_corner);
  note_gap(program);
  note_frames(program);
  note_walks(program, grounds, all_walks);
  if (!program.draws()) return;
  draw_slide_figures(program, environment, ball, path);
  draw_walk(program.studio(), grounds[0], all_walks[0]);
}
//! [studies]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("slide", "05_slide",
                  {"A sphere slides along what it meets (paper, 2.2).", "球面沿障礙物滑動（論文 2.2）。"});
  Scene scene;
  long frames = 10000;
  program.option(
      "--mesh", scene.mesh, "FILE",
      {"the surface: .obj, .off, .ply or .stl; a level wall if none; progress is shown if it is large",
       "曲面：.obj、.off、.ply 或 .stl；未指定時為一面水平牆；檔案較大時顯示進度"});
  program.option("--from", scene.from, "x,y,z", {"P1, centre of the sphere at the start", "P1，球心的起點"});
  program.option("--to", scene.to, "x,y,z", {"P2, where it is sent", "P2，球心的目標"});
  program.option("--radius", scene.radius, "r", {"radius of the sphere", "球的半徑"}, not_negative);
  program.option("--wall", scene.wall, "x,y,z",
                 {"a second wall, from the ground at x = 1 by this vector; 0: none",
                  "第二面牆，自地面 x = 1 處沿此向量立起；0 表示沒有"});
  program.option("--terrain", scene.terrain, "n",
                 {"a bumpy terrain of 2 n n triangles instead, 64 long and wide; 0: none",
                  "改用起伏的地形，共 2 n n 個三角形，長寬各 64；0 表示沒有"},
                 up_to_a_thousand);
  program.option("--frames", frames, "n", {"of the walk over each whole surface", "走過每個曲面的影格數"},
                 up_to_a_million);
  return program.run(argc, argv, [&] {
    const auto environment = program.checked({"--mesh", "--wall"}, [&] { return scene.environment(); });
    const auto ball = program.checked({"--to", "--from", "--radius"}, [&] { return scene.ball(); });
    const Slide path = slide(ball, environment);
    Report& report = program.report();
    report.title({"A sphere slides along what it meets", "碰撞後的滑行距離"}, "2.2");
    tell_projection(program, environment, ball);
    tell_path(program, path, ball);
    tell_second_wall(report, crease, into_crease,
                     {"A second wall: the sphere goes on along the crease", "第二面牆：沿兩牆的交線滑行"});
    tell_second_wall(report, corner, into_corner,
                     {"A third wall: the sphere stops in the corner", "第三面牆：停在角落"});
    tell_gap(report);
    give_contacts(program, path);
    program.result("/wall_after_wall", wall_after_wall(ball, environment));
    if (!program.results_alone() || program.draws()) tell_studies(program, environment, ball, path, frames);
  });
}
//! [main]
