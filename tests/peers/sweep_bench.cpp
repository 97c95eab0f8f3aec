#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "first_contact/partition/bvh/parts.hpp"
#include "peers/scenes.hpp"
#include "peers/yardstick.hpp"

using namespace first_contact;

namespace {

using Casts = std::vector<Moving<Sphere>>;

/// Time of the processor, not of the clock on the wall: other programs may run.
double now() { return static_cast<double>(std::clock()) * (1e9 / CLOCKS_PER_SEC); }

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Nanoseconds per cast, of several ways, in turns on the same casts; the medians of the rounds.
std::vector<double> in_turns(const Casts& casts,
                             const std::vector<std::function<void(std::span<const Moving<Sphere>>)>>& ways) {
  constexpr std::size_t batch = 500;
  std::vector<std::vector<double>> times(ways.size());
  for (std::size_t first = 0; first + batch <= casts.size(); first += batch)
    for (std::size_t way = 0; way < ways.size(); ++way) {
      const double start = now();
      ways[way](std::span(casts).subspan(first, batch));
      times[way].push_back((now() - start) / batch);
    }
  std::vector<double> result;
  for (const auto& t : times) result.push_back(median(t));
  return result;
}

volatile double sink;

void measure(const std::string& name, const Mesh& mesh, double unit, std::size_t count) {
  double start = now();
  const Bvh fast(mesh);
  const double build = (now() - start) / static_cast<double>(mesh.size());
  const PlainBvh plain(mesh);
  std::printf("%-14s %8zu triangles  build %4.0f ns, %3.0f bytes a triangle\n", name.c_str(), mesh.size(),
              build, static_cast<double>(fast.bytes()) / static_cast<double>(mesh.size()));
  for (const scenes::Kind kind : scenes::kinds) {
    const Casts casts = scenes::casts(mesh, kind, count, 7, unit);
    std::vector<std::optional<Contact>> found(count);
    const auto each = [](const auto& sweep) {
      return [&sweep](std::span<const Moving<Sphere>> part) {
        double sum = 0;
        for (const auto& cast : part) sum += sweep(cast);
        sink = sum;
      };
    };
    const auto textbook = [&](const auto& cast) {
      return yardstick::sweep(cast, plain).time < 2 ? 1.0 : 0.0;
    };
    const auto contract = [&](const auto& cast) { return sweep(cast, plain) ? 1.0 : 0.0; };
    const auto quick = [&](const auto& cast) { return sweep(cast, fast) ? 1.0 : 0.0; };
    const auto portable = [&](const auto& cast) {
      return bvh::sweep(cast, fast, bvh::portable_walker) ? 1.0 : 0.0;
    };
    const auto batch = [&](std::span<const Moving<Sphere>> part) {
      sweep(part, fast, std::span(found).first(part.size()));
    };
    const auto ns = in_turns(casts, {each(textbook), each(contract), each(quick), each(portable), batch});
    std::size_t hits = 0, misses = 0, ghosts = 0;
    for (const auto& cast : casts) {
      const auto a = yardstick::sweep(cast, plain);
      const auto b = sweep(cast, fast);
      hits += b.has_value();
      if (a.time > 0 && a.time < 2 && !b) ++misses;
      if (a.time > 2 && b) ++ghosts;
    }
    std::printf(
        "  %-6s textbook %6.0f ns  of it: plain %.2f  fast %.3f (%4.0f ns)  portable %.3f  batch %.3f   hits "
        "%.2f unlike %zu %zu\n",
        to_string(kind), ns[0], ns[1] / ns[0], ns[2] / ns[0], ns[2], ns[3] / ns[0], ns[4] / ns[0],
        static_cast<double>(hits) / static_cast<double>(count), misses, ghosts);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20000;
  const std::uint32_t largest =
      argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : 707;
  for (const std::uint32_t n : {32u, 100u, 316u, 707u})
    if (n <= largest) measure("terrain", scenes::terrain(n), 1, count);
}
