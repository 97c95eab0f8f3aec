// Chapter 4: a moving sphere against an arbitrary environment (paper, 2.1), and a ray against a triangle
// (3.2.3).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "accuracy.hpp"
#include "casts.hpp"
#include "figures/figures.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/program/mesh_loading.hpp"
#include "first_contact/program/mesh_report.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "from_afar.hpp"
#include "jaw.hpp"
#include "plain_edges.hpp"
#include "plain_line.hpp"
#include "scenes.hpp"
#include "seam.hpp"

using namespace first_contact;
using namespace first_contact::program;
using namespace general_sphere_chapter;

namespace {

//! [scene]
struct Scene {
  std::string mesh, solid = "cut-cube";
  Point from{2.6, -0.5, 2.0};
  Point to{0.4, 0.1, 0.5};
  double radius = 0.35;
  std::string casts = "none", results = "none";
  double afar = 1000, beside = 0.6;
};
//! [scene]

std::string from_one_to_1e9(double value) {
  return value >= 1 && value <= 1e9 ? "" : "must be from 1 to 1e9";
}

//! [report]
// Each number is given once: to the reader, and by the rest of its line to --json and to the notes.
void tell_environment(Program& program, const Environment& environment) {
  Report& report = program.report();
  std::map<EdgeKind, std::size_t> count;
  for (const auto& edge : environment.topology().edges()) ++count[edge.kind];
  std::size_t buried = 0;
  for (std::uint32_t i = 0; i < environment.mesh().vertices().size(); ++i)
    buried += environment.topology().buried(i);
  report.title({"A moving sphere meets an arbitrary environment", "通用的球面碰撞"}, "2.1");
  report.say({"The environment: its features, and those that need no test (figures 8 and 9)",
              "環境：面、稜、頂點，以及不須檢測者（圖八、圖九）"});
  program.row("triangles", environment.mesh().size(), {"faces: each is moved out by r", "面：外推 r"})
      .value("faces");
  program
      .row("convex edges", count[EdgeKind::convex],
           {"a cylinder of radius r about each", "稜：半徑為 r 的圓柱體"})
      .value("convex");
  program
      .row("concave edges", count[EdgeKind::concave],
           {"from outside a face is always nearer", "凹陷的稜：不須檢測"})
      .value("concave");
  program
      .row("flat edges", count[EdgeKind::flat],
           {"seams between triangles of one face: no test", "同一平面內的接縫：不須檢測"})
      .value("flat");
  program.row("boundary edges", count[EdgeKind::boundary], {"where the surface ends", "曲面邊界"})
      .value("boundary");
  report.row("non-manifold edges", count[EdgeKind::non_manifold],
             {"of three faces or more", "三個以上的面共用"});
  program.row("buried vertices", buried, {"no test", "埋沒的頂點：不須檢測"}).value("buried");
}

void tell_contact(Program& program, const Moving<Sphere>& moving, const std::optional<Contact>& contact) {
  Report& report = program.report();
  program.result("/contact", nullptr);
  if (!contact) return report.say({"No contact within 0 <= t <= 1.", "0 <= t <= 1 之間沒有發生碰撞"});
  report.say({"The first contact: the earliest over all faces, edges and vertices",
              "碰撞：所有面、稜、頂點之中最早者"});
  program.row("t", contact->time, {"time of impact", "碰撞時間"}).result("/contact/time");
  program
      .row("S(t) = S0 + tV", Point(moving.shape.center + contact->time * moving.displacement),
           {"centre at that time", "碰撞時的球心"})
      .result("/contact/center");
  program.row("C = S(t) - rN", contact->point(), {"point of contact", "碰撞點"}).result("/contact/point");
  program.row("N", contact->normal, {"unit normal, from the environment to the sphere", "單位法向量"})
      .result("/contact/normal");
  program.row("feature", std::string(to_string(contact->feature)), {"what is touched", "接觸的部分"})
      .result("/contact/feature");
  program.row("triangle", contact->triangle, {"its number, from 0", "三角形編號"})
      .result("/contact/triangle");
}

std::string or_none(const std::optional<double>& value) { return value ? readable(*value) : "-"; }

void tell_corrections(Report& report, const Moving<Sphere>& moving, const Environment& environment,
                      const std::optional<Contact>& contact) {
  report.say({"As printed: the cylinder's axis is the edge of the moved-out solid",
              "論文原式：圓柱體的中心線是外推後的稜"});
  report.row("t of that cylinder", or_none(printed_time(moving, environment)),
             {"the ball stops in the air", "球面尚未接觸就停止"});
  report.say({"Corrected: a cylinder of radius r about the original edge, a sphere about the original vertex",
              "修正：以原來的稜為中心線、以原來的頂點為球心"});
  report.row("t", contact ? readable(contact->time) : "-", {"time of impact, as above", "碰撞時間（同上）"});
}

void tell_order(Program& program) {
  Report& report = program.report();
  const Mesh stairs = step();
  const Moving<Sphere> falling{{{1, 0, 3}, 0.5}, {0, 0, -3}};
  report.say(
      {"As printed: the first face that is hit ends the search. A ball of radius 1/2 falls on a step of "
       "height 1",
       "論文原式：一碰到面就略過其餘檢測。半徑 1/2 的球落在高 1 的階梯上"});
  program
      .row("t of the first face listed", first_face_in_the_list(falling, stairs)->time,
           {"the floor below the step: the ball has gone through it", "階梯下的地面：球已穿過階梯"})
      .value("first_face");
  report.say({"Corrected: the earliest of all features", "修正：取所有特徵中最早者"});
  program.row("t of the first contact", sweep(falling, Environment(stairs))->time, {"the step", "階梯"})
      .value("first_contact");
}

void tell_ray(Report& report) {
  const Triangle triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const auto hit = sweep(Moving<Point>{{0.5, 0.5, 1}, {0, 0, -2}}, triangle);
  const auto edge = sweep(Moving<Point>{{1, 1, 1}, {0, 0, -2}}, triangle);
  report.say({"A ray against a triangle (3.2.3) is the path of a sphere of radius 0",
              "光跡對三角形（3.2.3）：半徑為 0 的球面"});
  report.row("t, inside", hit->time, {"a ray through the face", "光跡穿過面"});
  report.row("t, on the edge", edge->time,
             {"a ray through the edge itself: never missed", "光跡恰在稜上：不會遺漏"});
}
//! [report]

//! [notes]
// How far a point is from the surface.
double distance_from(const Environment& environment, const Point& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < environment.mesh().size(); ++i)
    least = std::min(least, (closest_point(point, environment.mesh().triangle(i)) - point).norm());
  return least;
}

// More numbers that the notes speak of: the features of the environment, ...
void note_features(Program& program, const Environment& environment) {
  const std::size_t edges = environment.topology().edges().size();
  const std::size_t vertices = environment.mesh().vertices().size();
  program.value("edges", edges);
  program.value("vertices", vertices);
  program.value("features", environment.mesh().size() + edges + vertices);
}

// What is subtracted under the root, and both times, as floats and as doubles have them.
void note_from_afar(Program& program, const Scene& scene) {
  const FromAfar shot = from_afar(scene.afar, scene.beside);
  for (const auto& [name, entered] :
       {std::pair("float", shot.in_float), std::pair("double", shot.in_double)}) {
    const std::string place = "/afar/" + std::string(name);
    program.result(place + "/minus_b", entered.minus_b);
    if (!std::isnan(entered.root)) program.result(place + "/root", entered.root);
    program.result(place + "/textbook", entered.textbook);
    program.result(place + "/stable", entered.stable);
  }
}

// ... and the cylinder as printed.
void note_faults(Program& program, const Environment& environment, const Moving<Sphere>& moving) {
  const double radius = moving.shape.radius;
  program.value("radius", radius);
  program.value("edge_gap", std::sqrt(2.0) * radius);  // of a right-angled edge, met along the diagonal
  if (const auto printed = printed_time(moving, environment)) {
    const Point stopped = moving.shape.center + *printed * moving.displacement;
    program.value("printed_time", *printed);
    program.value("printed_gap", distance_from(environment, stopped) - radius);
  }
  for (const auto& [name, r] : {std::pair("point", 0.0), std::pair("ball", 1.0)}) {
    const SeamShots shots = shots_at_a_seam(r);
    program.value("seam." + std::string(name) + ".balls", shots.balls);
    program.value("seam." + std::string(name) + ".both_faces_missed", shots.both_faces_missed);
    program.value("seam." + std::string(name) + ".missed", shots.missed);
  }
}

// What breaks that which one writes first.
void note_plain(Program& program) {
  const FarLines far = lines_from(1e8);
  program.value("plain.lines_missed", static_cast<double>(far.missed) / far.lines);
  program.value("plain.lines_missed_by_library", far.missed_by_library);
  const TurnedSolids solids = turned_solids(100);
  program.value("plain.seams", solids.seams);
  program.value("plain.seams_felt", solids.seams_felt);
  program.value("plain.corners", solids.corners);
  program.value("plain.corners_buried", solids.corners_buried);
}
//! [notes]

//! [studies]
void tell_studies(Program& program, const Environment& environment, const Moving<Sphere>& moving) {
  note_features(program, environment);
  note_faults(program, environment, moving);
  note_plain(program);
  note_accuracy(program);
}
//! [studies]

Environment environment_of(Program& program, const Scene& scene) {
  if (!program.given("--mesh")) return Environment(scene.solid == "prism" ? prism() : cut_cube());
  return program.checked("--mesh", [&] { return Environment(load_mesh(scene.mesh)); });
}

// All casts are read, checked and made before anything is written.
void run_casts(Program& program, const Scene& scene, const Environment& environment) {
  if (program.given("--casts") != program.given("--results"))
    throw Refused("--results " + scene.results + ": must be given together with --casts " + scene.casts);
  if (!program.given("--casts")) return;
  const std::string results =
      program.checked("--casts", [&] { return results_of(read_casts(scene.casts), environment); });
  program.checked("--results", [&] { write_file(scene.results, results); });
}

//! [options]
void take_options(Program& program, Scene& scene) {
  program.option("--mesh", scene.mesh, "FILE",
                 {"the environment: an OBJ, OFF, PLY or STL file; progress is shown if it is large",
                  "環境：OBJ、OFF、PLY 或 STL 檔；檔案較大時顯示進度"});
  program.option("--solid", scene.solid, std::vector<std::string>{"cut-cube", "prism"},
                 {"the environment, if there is no mesh", "沒有網格時的環境"});
  program.option("--from", scene.from, "x,y,z", {"centre of the sphere at t = 0", "球心在 t = 0 時的位置"});
  program.option("--to", scene.to, "x,y,z", {"centre of the sphere at t = 1", "球心在 t = 1 時的位置"});
  program.option("--radius", scene.radius, "r", {"radius of the sphere", "球的半徑"}, not_negative);
  program.option("--casts", scene.casts, "IN.csv",
                 {"many casts, a line each: x0,y0,z0,x1,y1,z1,r", "多次投射，每行一次：x0,y0,z0,x1,y1,z1,r"});
  program.option("--results", scene.results, "OUT.csv",
                 {"their results: hit,time,px,py,pz,nx,ny,nz,feature,triangle",
                  "其結果：hit,time,px,py,pz,nx,ny,nz,feature,triangle"});
  program.option(
      "--afar", scene.afar, "d",
      {"radii from which a ball comes at a vertex, in --json", "球從多少個半徑外飛向頂點，列於 --json"},
      from_one_to_1e9);
  program.option("--beside", scene.beside, "d", {"how far beside it", "偏離頂點多遠"}, not_negative);
}
//! [options]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("general_sphere", "04_general_sphere",
                  {"A moving sphere meets an arbitrary environment (paper, 2.1).",
                   "球面與任意環境之間的碰撞（論文 2.1）。"});
  Scene scene;
  take_options(program, scene);
  return program.run(argc, argv, [&] {
    const auto moving = program.checked({"--to", "--from", "--radius"}, [&] {
      return Moving<Sphere>{{scene.from, scene.radius}, scene.to - scene.from};
    });
    const Environment environment = environment_of(program, scene);
    const auto contact = sweep(moving, environment);
    tell_environment(program, environment);
    tell_contact(program, moving, contact);
    tell_corrections(program.report(), moving, environment, contact);
    tell_order(program);
    tell_ray(program.report());
    note_from_afar(program, scene);
    if (!program.results_alone()) jaw::tell(program);
    if (program.given("--mesh")) tell_defects(program.report(), environment.mesh());
    if (const auto printed = printed_time(moving, environment)) program.result("/printed_time", *printed);
    if (!program.results_alone()) tell_studies(program, environment, moving);
    run_casts(program, scene, environment);
    if (program.draws()) draw_general_sphere_figures(program, environment, moving, contact);
  });
}
//! [main]
