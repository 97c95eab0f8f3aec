// Chapter 2: a moving box meets a plane (paper, 1.3), what a camera rejects, and box or sphere (1.1, 3.2.1).
#include <cmath>

#include "camera.hpp"
#include "figures/figures.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/plane_error.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

//! [scene]
struct Scene {
  Plane plane{{0, 0, 1}, 0};
  Point from{-1, 0, 2.4};
  Point to{1, 0, 0.4};
  Vector r{0.6, 1.2, 1.2};
  Vector s{0.8, 0.4, -0.8};
  Vector t{0.6, -0.6, 0.3};
};
//! [scene]

//! [report]
// Each number is given once: to the reader, and by the rest of its line to --json and to the notes.
void tell_scene(Program& program, const Plane& plane, const Moving<Box>& moving) {
  Report& report = program.report();
  const Box& box = moving.shape;
  const Vector n = plane.normal();
  report.title({"A moving box meets a plane", "匣面與平面之間的碰撞"}, "1.3");
  report.say({"The plane, and the box with its axes R, S, T", "平面與匣面，主軸為 R、S、T"});
  report.row("N", n, {"unit normal of the plane E = [N, D]", "平面 E = [N, D] 的單位法向量"});
  report.row("|R|, |S|, |T|", Vector(norm(box.r), norm(box.s), norm(box.t)),
             {"length, width, thickness", "長、寬、厚"});
  report.row("R.N, S.N, T.N", Vector(box.r.dot(n), box.s.dot(n), box.t.dot(n)),
             {"how much each axis rises from the plane", "各主軸沿法向量的分量"});
  program.row("r_eff = 1/2(|R.N|+|S.N|+|T.N|)", box.effective_radius(n), {"effective radius", "等效半徑"})
      .result("/effective_radius");
  program
      .row("E.Q0", plane.signed_distance(box.center),
           {"distance of the centre at t = 0", "t = 0 時中心的距離"})
      .value("distance");
  report.row("E.Q1", plane.signed_distance(box.center + moving.displacement),
             {"distance of the centre at t = 1", "t = 1 時中心的距離"});
}

void tell_contact(Program& program, const Moving<Box>& moving, const std::optional<Contact>& contact) {
  Report& report = program.report();
  program.result("/contact", nullptr);
  if (!contact) return report.say({"No contact within 0 <= t <= 1.", "0 <= t <= 1 之間沒有發生碰撞"});
  report.say({"The first contact: the centre meets the plane moved out by r_eff, E' = [N, D - r_eff]",
              "碰撞：中心位於位移 r_eff 後的平面 E' = [N, D - r_eff]"});
  program.row("t = -(E'.Q0)/(E'.V)", contact->time, {"time of impact", "碰撞時間"}).result("/contact/time");
  program
      .row("Q(t) = Q0 + tV", Vector(moving.shape.center + contact->time * moving.displacement),
           {"centre at that time", "碰撞時的中心"})
      .result("/contact/center");
  program.result("/contact/feature", to_string(contact->feature));
  const Text feature = contact->feature == Feature::vertex ? Text{"a vertex touches", "頂點接觸"}
                       : contact->feature == Feature::edge
                           ? Text{"an edge touches: its two ends", "稜接觸：兩端點"}
                           : Text{"a face touches: its four corners", "面接觸：四頂點"};
  const Eigen::Index count = contact->points.cols();
  for (Eigen::Index i = 0; i < count; ++i)
    program.row(count == 1 ? "C" : "C" + std::to_string(i + 1), Vector(contact->points.col(i)), feature)
        .result("/contact/points/" + std::to_string(i));
  program.result("/contact/normal", contact->normal);
}

// What the paper gets wrong: one common sign for all three axes, and zeros that floating point never sees.
void tell_corrections(Report& report, const Plane& plane, const Box& box) {
  const Vector n = plane.signed_distance(box.center) < 0 ? Vector(-plane.normal()) : plane.normal();
  const Vector half = 0.5 * (box.r + box.s + box.t);
  const box_chapter::TurnedTogether axes = box_chapter::turned_together();
  report.say({"As printed: vertices Q +- 1/2(R + S + T), and an axis is parallel if T.N is exactly zero",
              "論文原式：頂點 Q ± 1/2(R + S + T)；T.N 恰為零時主軸平行於平面"});
  report.row("lowest, one common sign", -std::abs(n.dot(half)),
             {"height of the nearest vertex above the centre", "最近頂點相對於中心的高度"});
  report.row("zeros, turned together", std::to_string(axes.exact_zeros) + " of 2",
             {"a level brick and its floor, both turned: said to land on a vertex",
              "匣面平貼平面並一起旋轉：誤判為頂點接觸"});
  report.say({"Corrected: three signs of their own, and parallel is |T.N| <= 32 eps |T|",
              "修正：三個符號各自獨立；|T.N| <= 32 eps |T| 即為平行"});
  report.row("lowest, three signs", n.dot(lowest_vertices(box, n).col(0) - box.center),
             {"which is -r_eff: this one touches", "即 -r_eff：此頂點接觸"});
  report.row("parallel, turned together", std::to_string(axes.within_tolerance) + " of 2",
             {"the same brick: it lands on its face", "同一匣面：以面接觸"});
}

void tell_landings(Program& program) {
  program.report().say({"One brick of 1.8 x 1.2 x 0.9 falls from height 3: where does it land?",
                        "同一匣面 1.8 x 1.2 x 0.9 自高度 3 落下：以何處接觸？"});
  for (const auto& landing : box_chapter::landings()) {
    const std::string feature = to_string(landing.contact.feature);
    program
        .row("t, " + feature, landing.contact.time,
             {"on " + landing.name.english + ": r_eff = " + readable(landing.box.center.z()) +
                  ", points: " + std::to_string(landing.contact.points.cols()),
              landing.name.chinese + "接觸：r_eff = " + readable(landing.box.center.z()) + "，接觸點 " +
                  std::to_string(landing.contact.points.cols()) + " 個"})
        .value("landing." + feature + ".time");
    program.value("landing." + feature + ".radius", landing.box.center.z());
  }
}

void tell_sight(Report& report, Language language, const box_chapter::Sight& sight) {
  static const std::array<Text, 6> sides{
      {{"left", "左"}, {"right", "右"}, {"lower", "下"}, {"upper", "上"}, {"near", "近"}, {"far", "遠"}}};
  const std::string sign = sight.rejected ? " < " : " > ";
  const Text& side = sides[sight.plane];
  report.row(sight.name.in(language),
             box_chapter::rounded(sight.distance) + sign + box_chapter::rounded(-sight.radius),
             {side.english + " plane: " + (sight.rejected ? "rejected" : "kept"),
              side.chinese + "面：" + (sight.rejected ? "剔除" : "保留")});
}

void tell_sights(Report& report, Language language, const Box& box) {
  report.say({"A camera rejects a box if E.Q < -r_eff for a plane of its frustum (worst plane shown)",
              "視野截錐體：任一面 E.Q < -r_eff 則不可視（列出最差的一面）"});
  tell_sight(report, language, box_chapter::sight_of({"the box above", "上述匣面"}, box));
  for (const auto& sight : box_chapter::sights()) tell_sight(report, language, sight);
  report.also(
      {"  The last is out of view, off an edge of the frustum, but behind no single plane: rejection is "
       "cautious.",
       "  最後一個其實在截錐體的稜外而不可視，但不在任何單一平面之後：此判別是保守的。"});
}

void tell_bounding(Report& report, Language language) {
  report.say(
      {"Box or sphere (3.2.1)? Volume beside the shape's own, and how often a random plane hits it beside "
       "the shape",
       "匣面或球面範圍框（3.2.1；正匣面即 AABB，斜匣面即 OBB）？體積與物件的比，以及被任意平面碰到的次數比"});
  const auto row = [&](const box_chapter::Bounded& shape, const auto& bounding, const Text& name) {
    report.row(shape.name.in(language) + ", " + name.in(language),
               box_chapter::rounded(volume(bounding) / shape.volume) + ", " +
                   box_chapter::rounded(box_chapter::more_often(bounding, shape.points)),
               {"times its volume, times its hits", "倍體積，倍次數"});
  };
  for (const auto& shape : box_chapter::bounded_shapes()) {
    row(shape, shape.sphere, {"sphere", "球面"});
    row(shape, shape.upright, {"upright box", "正匣面"});
    row(shape, shape.turned, {"turned box", "斜匣面"});
  }
  const auto [sphere, upright, turned] = box_chapter::multiplications();
  report.row(
      "multiplications",
      std::to_string(sphere) + ", " + std::to_string(upright) + ", " + std::to_string(turned),
      {"to test a plane: sphere, upright box, turned box", "每測一平面的乘法次數：球面、正匣面、斜匣面"});
}
//! [report]

//! [notes]
// More numbers that the notes speak of: of the scene, ...
void note_scene(Program& program, const Scene& scene, const Moving<Box>& moving) {
  const auto& [box, motion] = moving;
  const Vector n = scene.plane.normal();
  const double radius = box.effective_radius(n), distance = scene.plane.signed_distance(box.center);
  const double one_sign = 0.5 * std::abs(n.dot(box.r + box.s + box.t));
  const Vector lengths(norm(box.r), norm(box.s), norm(box.t));
  for (int i = 0; i < 3; ++i) program.value("size." + std::to_string(i), lengths[i]);
  program.result("/climbs", Vector(box.r.dot(n), box.s.dot(n), box.t.dot(n)));
  program.value("r_n", box.r.dot(n));
  program.value("s_n", box.s.dot(n));
  program.value("t_n", box.t.dot(n));
  program.value("toward", n.dot(motion));
  program.value("closing", -n.dot(motion));
  program.value("gap", std::abs(distance) - radius);
  program.value("depth", radius - std::abs(distance));  // of the lowest vertex, if they overlap
  program.value("thinnest", 0.5 * lengths.minCoeff());
  program.value("half_diagonal", 0.5 * lengths.norm());
  program.value("one_sign", one_sign);
  program.value("one_sign_depth", radius - one_sign);
  program.value("error_bound", error_of_time(lengths_of(box, scene.plane), norm(motion), n.dot(motion)));
}

// ... of what the camera sees of it ...
void note_camera(Program& program, const Box& box) {
  const box_chapter::Seen seen = box_chapter::seen(box);
  for (std::size_t i = 0; i < seen.highest.size(); ++i)
    program.result(std::string("/camera/highest/") + box_chapter::plane_names[i], seen.highest[i]);
  program.result("/camera/rejected", seen.rejected);
}

// ... and of the studies.
void note_studies(Program& program) {
  const box_chapter::TurnedTogether turned = box_chapter::turned_together();
  for (int i = 0; i < 3; ++i) program.value("turned." + std::to_string(i), turned.slopes[i]);
  program.value("turned.exact", turned.exact_zeros);
  program.value("turned.tolerant", turned.within_tolerance);
  program.value("turned.corner_off", turned.corner_off);
  program.value("tolerance", parallel_tolerance);
  program.value("half_degree", std::sin(0.5 * std::acos(-1.0) / 180));
  const auto sights = box_chapter::sights();
  program.value("sight.off_edge.distance", sights.back().distance);
  program.value("sight.off_edge.radius", sights.back().radius);
  const box_chapter::Multiplications cost = box_chapter::multiplications();
  program.value("multiplications.sphere", cost.sphere);
  program.value("multiplications.upright", cost.upright);
  program.value("multiplications.turned", cost.turned);
  for (const auto& shape : box_chapter::bounded_shapes()) {
    const std::string name = shape.name.english.substr(shape.name.english.rfind(' ') + 1);
    const auto note = [&](const std::string& kind, const auto& bounding) {
      program.value(name + "." + kind + ".volume", volume(bounding) / shape.volume);
      program.value(name + "." + kind + ".hits", box_chapter::more_often(bounding, shape.points));
    };
    note("sphere", shape.sphere);
    note("upright", shape.upright);
    note("turned", shape.turned);
  }
}
//! [notes]

//! [studies]
void tell_studies(Program& program, const Box& box) {
  tell_landings(program);
  tell_sights(program.report(), program.language(), box);
  tell_bounding(program.report(), program.language());
  note_studies(program);
}
//! [studies]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("box", "02_box",
                  {"A moving box meets a plane (paper, 1.3).", "盒子與平面之間的碰撞（論文 1.3）。"});
  Scene scene;
  program.option("--plane", scene.plane, "A,B,C,D",
                 {"the plane Ax + By + Cz + D = 0", "平面 Ax + By + Cz + D = 0"});
  program.option("--from", scene.from, "x,y,z", {"centre of the box at t = 0", "盒心在 t = 0 時的位置"});
  program.option("--to", scene.to, "x,y,z", {"centre of the box at t = 1", "盒心在 t = 1 時的位置"});
  program.option("--r", scene.r, "x,y,z",
                 {"axis R of the box, as long as the box is in that direction",
                  "盒子的軸 R，長度等於盒子在該方向的邊長"});
  program.option("--s", scene.s, "x,y,z", {"axis S, perpendicular to R", "軸 S，垂直於 R"});
  program.option("--t", scene.t, "x,y,z", {"axis T, perpendicular to both", "軸 T，垂直於 R 與 S"});
  return program.run(argc, argv, [&] {
    const Box box = program.checked({"--r", "--s", "--t", "--from"}, [&] {
      return Box{scene.from, scene.r, scene.s, scene.t};
    });
    const auto moving = program.checked({"--to", "--from"}, [&] {
      return Moving{box, Vector(scene.to - scene.from)};
    });
    const auto contact = sweep(moving, scene.plane);
    tell_scene(program, scene.plane, moving);
    tell_contact(program, moving, contact);
    tell_corrections(program.report(), scene.plane, box);
    note_scene(program, scene, moving);
    note_camera(program, box);
    if (!program.results_alone()) tell_studies(program, box);
    if (program.draws()) draw_box_figures(program, scene.plane, moving, contact);
  });
}
//! [main]
