/// The long test: sweeps of the fast tree against the truth, a million casts as a rule, aimed at where sweeps
/// go wrong.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <mutex>
#include <thread>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/partition/bvh/parts.hpp"
#include "first_contact/partition/plain_bvh.hpp"
#include "verify/surfaces.hpp"
#include "verify/truth.hpp"

using namespace first_contact;

namespace {

constexpr int casts_per_surface = 200;

struct Tally {
  std::uint64_t casts = 0, hits = 0, at_start = 0, grazes = 0, misses = 0, ghosts = 0, inexact = 0,
                unlike = 0;
  double worst = 0;  // how far outside the radius's bound an answer would be true, in bounds
  void add(const Tally& t) {
    casts += t.casts, hits += t.hits, at_start += t.at_start, grazes += t.grazes, misses += t.misses;
    ghosts += t.ghosts, inexact += t.inexact, unlike += t.unlike;
    worst = std::max(worst, t.worst);
  }
  bool good() const { return misses + ghosts + inexact + unlike == 0; }
};

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

/// What rounding may take from or add to the radius.
/// \see sphere_triangle.hpp
double bound(const Mesh& mesh, const Moving<Sphere>& moving) {
  double corner = 0, side = 0;
  for (const Mesh::Face& face : mesh.faces())
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &p = mesh.vertices()[face[i]], &q = mesh.vertices()[face[(i + 1) % 3]];
      corner = std::max(corner, (p - moving.shape.center).norm());
      side = std::max(side, (q - p).norm());
    }
  return 16 * std::numeric_limits<double>::epsilon() *
         (corner + side + moving.displacement.norm() + moving.shape.radius);
}

void judge(const Mesh& mesh, const Moving<Sphere>& moving, const std::optional<Contact>& contact,
           Tally& tally) {
  const double delta = bound(mesh, moving);
  const auto [earliest, latest] = truth::first_times(mesh, moving, delta);
  tally.hits += contact.has_value();
  if (earliest && *earliest == 0) {  // overlapping, or touching: compared with the plain tree only
    ++tally.at_start;
    return;
  }
  if (!latest && earliest) ++tally.grazes;
  if (latest && !contact) ++tally.misses;
  if (!earliest && contact) ++tally.ghosts;
  if (!contact || !earliest) return;
  constexpr truth::Real rounding = std::numeric_limits<double>::epsilon();
  const truth::Real t = contact->time;
  if (t < *earliest * (1 - rounding) || (latest && t > *latest * (1 + rounding))) ++tally.inexact;
  truth::Real distance = std::numeric_limits<truth::Real>::infinity();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    distance = std::min(distance, truth::Approach(mesh.triangle(i), moving).distance(t));
  if (latest)
    tally.worst = std::max(
        tally.worst, static_cast<double>(std::abs(distance - truth::Real(moving.shape.radius)) / delta));
}

/// One surface and some casts at it.
void verify(std::uint64_t seed, int kind, std::array<Tally, surfaces::aims>& tallies) {
  surfaces::Random random(seed);
  const double exponent = static_cast<double>(random() % 13) - 6;
  const double size = std::pow(10.0, exponent);
  const Vector offset = random() % 2 ? Vector(Vector::Zero())
                                     : Vector(size * std::pow(10.0, random() % 4) * Vector(1, -0.7, 0.3));
  const Mesh mesh = surfaces::moved(surfaces::surface(kind, random), size, offset);
  const Bvh fast(mesh);
  const PlainBvh plain(mesh);
  std::vector<Moving<Sphere>> casts;
  for (int i = 0; i < casts_per_surface; ++i)
    casts.push_back(surfaces::cast(mesh, i % surfaces::aims, random));
  std::vector<std::optional<Contact>> together(casts.size());
  sweep(casts, fast, together);
  for (std::size_t i = 0; i < casts.size(); ++i) {
    Tally& tally = tallies[i % surfaces::aims];
    ++tally.casts;
    const auto contact = sweep(casts[i], fast);
    if (!same(contact, together[i]) || !same(contact, bvh::sweep(casts[i], fast, bvh::portable_walker)) ||
        !same(contact, sweep(casts[i], plain)))
      ++tally.unlike;
    const Tally before = tally;
    judge(mesh, casts[i], contact, tally);
    if (before.good() && !tally.good())
      std::printf("wrong: surface %s, seed %llu, cast %zu\n", surfaces::name(kind),
                  static_cast<unsigned long long>(seed), i);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Sweeps of a moving sphere against trees of triangles, verified by bisection in long double");
  std::uint64_t count = 1'000'000, seed = 1;
  app.add_option("--count", count, "how many casts")->capture_default_str();
  app.add_option("--seed", seed, "of the random surfaces and casts")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::array<std::array<Tally, surfaces::aims>, surfaces::kinds> total{};
  std::mutex mutex;
  std::atomic<std::uint64_t> next{0};
  const std::uint64_t rounds = (count + casts_per_surface - 1) / casts_per_surface;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < rounds; i = next++) {
      const int kind = static_cast<int>(i % surfaces::kinds);
      std::array<Tally, surfaces::aims> tallies{};
      verify(seed + i, kind, tallies);
      const std::lock_guard lock(mutex);
      for (std::size_t aim = 0; aim < tallies.size(); ++aim)
        total[static_cast<std::size_t>(kind)][aim].add(tallies[aim]);
    }
  };
  bvh::in_parallel_copies(std::max(1u, std::thread::hardware_concurrency()), work);

  Tally all;
  std::printf("%-12s %-9s %9s %9s %9s %7s %7s %7s %8s %7s %6s\n", "surface", "aimed at", "casts", "hits",
              "at start", "grazes", "missed", "false", "inexact", "unlike", "worst");
  const auto row = [](const char* surface, const char* aim, const Tally& t) {
    std::printf("%-12s %-9s %9llu %9llu %9llu %7llu %7llu %7llu %8llu %7llu %6.3f\n", surface, aim,
                static_cast<unsigned long long>(t.casts), static_cast<unsigned long long>(t.hits),
                static_cast<unsigned long long>(t.at_start), static_cast<unsigned long long>(t.grazes),
                static_cast<unsigned long long>(t.misses), static_cast<unsigned long long>(t.ghosts),
                static_cast<unsigned long long>(t.inexact), static_cast<unsigned long long>(t.unlike),
                t.worst);
  };
  for (int kind = 0; kind < surfaces::kinds; ++kind)
    for (int aim = 0; aim < surfaces::aims; ++aim) {
      const Tally& t = total[static_cast<std::size_t>(kind)][static_cast<std::size_t>(aim)];
      row(surfaces::name(kind), surfaces::aim_name(aim), t);
      all.add(t);
    }
  row("all", "", all);
  std::printf(
      "missed, false: against the bound; inexact: t outside the times for r + bound and r - bound; unlike: "
      "the fast tree on\n"
      "this machine's instructions, on portable ones, in a batch, and the plain tree do not agree to the "
      "last bit;\n"
      "worst: | distance at t - r |, in bounds.\n");
  return all.good() ? 0 : 1;
}
