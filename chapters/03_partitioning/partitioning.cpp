// Chapter 3: who could be hit at all? An octree, a BSP tree, a tree of boxes, and hit tests (paper, 1.4,
// 2.4.1).
#include <algorithm>
#include <cstdio>
#include <numbers>

#include "figures/figures.hpp"
#include "first_contact/program/mesh_loading.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "grown_planes.hpp"
#include "measure.hpp"
#include "plain_bsp.hpp"
#include "plain_octree.hpp"
#include "plain_tree.hpp"
#include "room.hpp"
#include "stage.hpp"
#include "told.hpp"
#include "walls.hpp"

using namespace first_contact;
using namespace first_contact::program;
using partitioning_chapter::fixed, partitioning_chapter::truth, partitioning_chapter::tell_hit_tests,
    partitioning_chapter::tell_walls;

namespace {

constexpr std::size_t flight_count = 100;

//! [costs]
struct Costs {
  Cost octree, bsp, bvh, brute_force;
  std::size_t objects, plain_tests, plain_octree_loses;

  Costs(const std::vector<Triangle>& triangles, std::uint64_t seed) : objects(triangles.size()) {
    const Soup<Octree> in_octree(triangles);
    const auto balls = flights(flight_count, in_octree.bounds(), seed + 1);
    octree = measure(in_octree, balls);
    bsp = measure(Soup<BspTree>(triangles), balls);
    bvh = measure(Soup<BoxTree>(triangles), balls);
    brute_force = measure(Soup<BruteForce>(triangles), balls);
    plain_tests = partitioning_chapter::plain_tests(triangles, balls);
    plain_octree_loses = partitioning_chapter::plain_octree_loses(triangles, balls, brute_force.contacts);
  }
  bool agree() const {
    return same_contacts(octree, brute_force) && same_contacts(bsp, brute_force) &&
           same_contacts(bvh, brute_force);
  }
};
//! [costs]

//! [report]
// Each number is given once: to the reader, and by the rest of its line to --json and to the notes.
void tell_tree(Program& program, const std::string& tree, const Costs& costs, const Cost& cost) {
  const std::string place = "/" + tree, name = "in_" + tree;
  program.row("nodes", cost.nodes, {"of the tree", "樹的節點數"}).result(place + "/nodes");
  program.row("depth", cost.depth, {"of the deepest leaf", "最深的葉節點"}).result(place + "/depth");
  program
      .row("work to build",
           static_cast<double>(cost.work) / std::max<double>(1, static_cast<double>(costs.objects)),
           {"how often an object was looked at, on the average", "建樹時平均每個物品被檢視的次數"})
      .value(name + ".work");
  program.row("nodes looked at", cost.per_flight(cost.looked_at), {"on the average flight", "每次飛行平均"})
      .value(name + ".looked_at");
  program
      .row("tests", cost.per_flight(cost.tests),
           {"of the ball against a triangle, on the average flight", "球與三角形的測試，每次飛行平均"})
      .value(name + ".per_flight");
  program.value(
      name + ".flights_to_pay",
      static_cast<double>(cost.work) / (static_cast<double>(costs.objects) - cost.per_flight(cost.tests) -
                                        cost.per_flight(cost.looked_at)));
  program.value(name + ".times_fewer",
                costs.brute_force.per_flight(costs.brute_force.tests) / cost.per_flight(cost.tests));
  program.result(place + "/tests", cost.tests);
  program.result(place + "/hits", cost.hits);
}

void tell(Program& program, const Costs& costs) {
  Report& report = program.report();
  report.title({"Partitioning: who could be hit at all?", "分割的空間之碰撞測試"}, "1.4");
  report.say({"Balls that fly across a room of triangles", "球面飛越充滿三角形的房間"});
  program.row("k", costs.objects, {"objects in the room", "房間內的物品數"}).result("/objects");
  program.row("flights", flight_count, {"from anywhere to anywhere", "任意起點至任意終點"})
      .result("/flights");
  program.row("hits", costs.brute_force.hits, {"flights that end at a triangle", "發生碰撞的飛行"})
      .value("hits");
  report.say({"No structure: every flight is tested against every object", "不分割：每次飛行測試所有物品"});
  report.row("tests", costs.brute_force.per_flight(costs.brute_force.tests),
             {"on the average flight", "每次飛行平均"});
  report.say({"The octree: a cube cut into eight, and those again", "八元樹：立方體切成八等份，再繼續切"});
  tell_tree(program, "octree", costs, costs.octree);
  program
      .row("log_8 k", log8(costs.objects),
           {"the paper's time to find one object", "論文：平均找到一物品的時間"})
      .value("log8");
  report.say({"The BSP tree: space cut in two along polygons", "BSP tree：以多邊形平面分割空間"});
  tell_tree(program, "bsp", costs, costs.bsp);
  report.say({"The BVH: boxes around boxes, cut where few flights need both parts",
              "BVH：層層包圍的匣面，於較少飛行須兼顧兩側處分割"});
  tell_tree(program, "bvh", costs, costs.bvh);
  report.say({"All four give the same contacts, to the last bit", "四者的碰撞結果完全相同"});
  report.row("same", truth(costs.agree()),
             {"time, point, normal, feature, triangle", "時間、碰撞點、法向量等"});
  program.result("/brute_force/nodes", costs.brute_force.nodes);
  program.result("/brute_force/depth", costs.brute_force.depth);
  program.result("/brute_force/tests", costs.brute_force.tests);
  program.result("/brute_force/hits", costs.brute_force.hits);
  program.result("/same", costs.agree());
}

// The depth of k points in an octree with one point to a leaf.
void tell_log8(Report& report, std::uint64_t seed) {
  const auto tell_depth = [&](Spread spread) {
    for (const std::size_t k : {8U, 64U, 512U, 4096U}) {
      const Depth depth = depth_of_objects(Octree(points(k, spread, seed), OctreeLimits{1, 20}));
      const std::string mean = fixed(depth.mean, 2), deepest = std::to_string(depth.deepest);
      report.row("log_8 " + std::to_string(k), log8(k),
                 {"measured: " + mean + " on the average, " + deepest + " at the deepest",
                  "實測：平均 " + mean + "，最深 " + deepest});
    }
  };
  report.say(
      {"As printed: one of k objects is found in log_8 k steps. True of objects that lie evenly, and one "
       "step off:",
       "論文原式：平均在 log_8 k 的時間內找到物品。物品均勻分布時約成立："});
  tell_depth(Spread::even);
  report.say({"Corrected: of crowded objects it is not; what bounds a search is the depth of the tree",
              "修正：物品聚集時不成立；搜尋時間以樹的深度為界"});
  tell_depth(Spread::clustered);
}

// The same-side test at both ends of a motion, r = 1, plane z = 0.
void tell_same_side(Report& report) {
  const std::vector<Triangle> tile{{{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}}};
  const Moving<Sphere> landing{{{0, 0, 3}, 1}, {0, 0, -2}};
  const Plane e({0, 0, 1}, 0);
  const double d1 = e.signed_distance(landing.shape.center);
  const double d2 = e.signed_distance(landing.shape.center + landing.displacement);
  report.say({"As printed: no contact if E.Q >= r at both ends, or E.Q <= -r at both",
              "論文原式：兩端皆 E.Q >= r 或皆 E.Q <= -r，即無碰撞"});
  report.row("E.Q1", d1, {"r = 1: a ball that comes down on a tile", "r = 1：球落在地磚上"});
  report.row("E.Q2", d2, {"it touches at the very end", "恰在終點接觸"});
  report.row("E.Q >= r", truth(d1 >= 1 && d2 >= 1),
             {"at both ends: no contact, as printed", "兩端皆成立：論文判為無碰撞"});
  report.say({"Corrected: E.Q > r and E.Q < -r reject; what touches is tested",
              "修正：E.Q > r 或 E.Q < -r 才排除；接觸者須測試"});
  report.row("t", sweep(landing, Soup<BspTree>(tile))->time, {"first contact", "碰撞時間"});
}

// Planes moved out by r, at a sharp edge.
void tell_grown_planes(Program& program) {
  Report& report = program.report();
  report.say(
      {"Planes of a tree grown by r instead of a last exact test: at a sharp edge they stick out, r = 1",
       "以外推 r 的平面代替最後的精確測試：在尖銳的稜過度凸出，r = 1"});
  for (const double degrees : {45.0, 15.0, 5.0}) {
    const Wedge wedge{degrees * std::numbers::pi / 180};
    const Moving<Sphere> falling{{{0, 0, 16}, 1}, {0, 0, -16}};
    const auto early = time_at_grown_planes(falling, wedge);
    const auto contact = sweep(falling, Soup<BspTree>(wedge.faces()));
    const std::string exact = readable(16 - 16 * contact->time);
    program
        .row("r / sin " + readable(degrees), 16 - 16 * *early,
             {"height at which the ball stops; it touches at " + exact,
              "外推平面使球停在此高度；實際接觸於 " + exact})
        .value("grown." + readable(degrees));
  }
  const Wedge wedge{15 * std::numbers::pi / 180};
  const Moving<Sphere> passing{{{-8, 0, 2}, 1}, {16, 0, 0}};
  report.row("passing at 2 r", truth(time_at_grown_planes(passing, wedge).has_value()),
             {"a hit of the grown planes at 15 degrees; of the wedge: " +
                  truth(sweep(passing, Soup<BspTree>(wedge.faces())).has_value()),
              "15 度的外推平面是否碰撞；楔形本身：" +
                  truth(sweep(passing, Soup<BspTree>(wedge.faces())).has_value())});
}
//! [report]

//! [notes]
// More numbers that the notes speak of: what a flight costs, ...
void note_costs(Program& program, const Costs& costs, const std::vector<Triangle>& triangles) {
  program.value("all_tests", static_cast<double>(costs.brute_force.tests));
  program.value("plain_tests", costs.bvh.per_flight(costs.plain_tests));
  program.value("plain_octree_loses", static_cast<double>(costs.plain_octree_loses));
  const double pieces = static_cast<double>(BspTree(triangles).order().size());
  program.value("pieces", pieces / std::max<double>(1, static_cast<double>(costs.objects)));
  program.value("octree_node", sizeof(Octree::Node));
  program.value("bsp_node", sizeof(BspTree::Node));
  program.value("bvh_node", sizeof(BoxTree::Node));
  program.value("margin", search_margin);
}

// ... how deep objects lie, and what goes wrong.
void note_depths(Program& program, std::uint64_t seed) {
  for (const Spread spread : {Spread::even, Spread::clustered})
    for (const std::size_t k : {8U, 64U, 512U, 4096U}) {
      const Depth depth = depth_of_objects(Octree(points(k, spread, seed), OctreeLimits{1, 20}));
      const std::string name = (spread == Spread::even ? "even." : "clustered.") + std::to_string(k);
      program.value(name + ".mean", depth.mean);
      program.value(name + ".deepest", static_cast<double>(depth.deepest));
    }
}

void note_faults(Program& program, std::uint64_t seed) {
  const auto room = shards(1000, Spread::even, seed);
  std::vector<Bounds> boxes;
  for (const Triangle& shard : room) boxes.push_back(bounds_of(shard));
  const Pairs pairs = overlapping_pairs(boxes);
  program.value("pairs.all", static_cast<double>(pairs.all));
  program.value("pairs.found", static_cast<double>(pairs.in_one_leaf));
  program.value("pairs.lost", static_cast<double>(pairs.all - pairs.in_one_leaf));
  const auto plain = partitioning_chapter::plain_bsp_costs(
      room, flights(flight_count, bounds_of(std::span<const Bounds>(boxes)), seed + 1));
  program.value("plain_bsp.kept", static_cast<double>(plain.kept) / static_cast<double>(room.size()));
  program.value("plain_bsp.depth", static_cast<double>(plain.depth));
  program.value("plain_bsp.per_flight", static_cast<double>(plain.found) / flight_count);
}
//! [notes]

std::string at_most_a_million(double value) {
  return value >= 0 && value <= 1e6 ? "" : "must be from 0 to 1000000";
}

//! [scene]
struct Scene {
  long objects = 1000;
  long seed = 1;
  std::string mesh;
  Places places;
  partitioning_chapter::Roll roll;
};

// The triangles of a mesh, or as many as are asked for.
std::vector<Triangle> triangles_of(const Scene& scene) {
  if (scene.mesh.empty())
    return shards(static_cast<std::size_t>(scene.objects), Spread::even,
                  static_cast<std::uint64_t>(scene.seed));
  return load_mesh(scene.mesh).triangles();
}
//! [scene]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("partitioning", "03_partitioning",
                  {"Octree, BSP tree and BVH: who could be hit at all? Hit tests (paper, 1.4, 2.4.1).",
                   "八元樹、BSP 樹與 BVH：哪些物件可能被碰到？碰撞測試（論文 1.4、2.4.1）。"});
  Scene scene;
  program.option("--objects", scene.objects, "n", {"number of triangles in the room", "房間裡的三角形個數"},
                 at_most_a_million);
  program.option("--seed", scene.seed, "k", {"of the random numbers", "亂數種子"});
  program.option(
      "--mesh", scene.mesh, "FILE",
      {"search the triangles of this mesh instead (OBJ, OFF, PLY, STL); progress is shown if it is large",
       "改為搜尋此網格的三角形（OBJ、OFF、PLY、STL）；檔案較大時顯示進度"});
  program.option("--leaf", scene.places.leaf, "x,y",
                 {"where the leaf of the hit tests stands", "碰撞測試中葉子的位置"});
  program.option("--hook", scene.places.hook, "x,y", {"where the hook stands", "鉤子的位置"});
  program.option("--pointer", scene.places.pointer, "x,y", {"where the pointer is", "游標的位置"});
  program.option("--from", scene.roll.from, "x,y",
                 {"where a ball that rolls among walls starts", "在牆間滾動的球的起點"});
  program.option("--to", scene.roll.to, "x,y", {"where it ends if it touches none", "未碰到牆時的終點"});
  program.option("--radius", scene.roll.radius, "r", {"its radius", "球的半徑"}, not_negative);
  return program.run(argc, argv, [&] {
    if (program.given("--mesh") && program.given("--objects"))
      throw Refused("--objects " + std::to_string(scene.objects) + ": must not be given with --mesh");
    const auto triangles = program.checked("--mesh", [&] { return triangles_of(scene); });
    const auto seed = static_cast<std::uint64_t>(scene.seed);
    const Stage stage(scene.places);
    const auto rolling = program.checked({"--to", "--from", "--radius"}, [&] { return scene.roll.ball(); });
    const Costs costs(triangles, seed);
    tell(program, costs);
    tell_log8(program.report(), seed);
    tell_same_side(program.report());
    tell_grown_planes(program);
    tell_hit_tests(program, stage);
    tell_walls(program, rolling);
    note_costs(program, costs, triangles);
    note_depths(program, seed);
    note_faults(program, seed);
    if (program.draws()) draw_partitioning_figures(program, seed, stage);
  });
}
//! [main]
