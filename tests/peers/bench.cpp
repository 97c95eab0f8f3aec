// One table: our ways to sweep and those of other engines, on the same casts, in turns; with what they miss,
// and how wrong their times are. And two figures of it: cost against size, and error against size.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <map>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/figure/figure.hpp"
#include "peers/scenes.hpp"
#include "peers/truth_of.hpp"
#include "peers/ways.hpp"

using namespace first_contact;
using namespace peers;

namespace {

using Casts = std::vector<Moving<Sphere>>;
constexpr std::size_t kinds = std::size(scenes::kinds);
constexpr std::size_t turn = 250;  // casts

/// One row of the table: a way on one mesh.
struct Row {
  std::string way;
  std::size_t triangles;
  std::array<double, kinds> ns{};  // per cast, the medians
  Worth worth;
  bool of_spheres;
};

/// Keeps the medians of what Google Benchmark measures, and prints nothing.
class Medians : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        all_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime() / turn);
  }
  double of(const std::string& name) {
    std::vector<double>& times = all_.at(name);
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
  }

 private:
  std::map<std::string, std::vector<double>> all_;
};

std::string name_of(std::size_t kind, const Way& way) { return std::to_string(kind) + way.name; }

/// Has Google Benchmark run all ways on all casts, in random turns.
void measure(const std::vector<Way>& ways, const std::array<Casts, kinds>& casts, int repetitions,
             Medians& medians) {
  std::vector<double> times(turn);
  for (std::size_t kind = 0; kind < kinds; ++kind)
    for (const Way& way : ways)
      benchmark::RegisterBenchmark(name_of(kind, way).c_str(),
                                   [&, kind](benchmark::State& state) {
                                     std::size_t first = 0;
                                     for (auto _ : state) {
                                       way.sweep(std::span(casts[kind]).subspan(first, turn), times);
                                       benchmark::DoNotOptimize(times.data());
                                       first = (first + turn) % casts[kind].size();
                                     }
                                   })
          ->Repetitions(repetitions)
          ->MinTime(0.02)
          ->Unit(benchmark::kNanosecond);
  benchmark::RunSpecifiedBenchmarks(&medians);
  benchmark::ClearRegisteredBenchmarks();
}

void judge(const Mesh& mesh, const std::vector<Way>& ways, const std::array<Casts, kinds>& casts,
           std::size_t count, std::vector<Row>& rows) {
  const PlainBvh tree(mesh);
  std::vector<double> times(count);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const auto some = std::span(casts[kind]).first(count);
    std::vector<Truth> truths;
    for (const auto& cast : some) truths.push_back(truth_of(cast, tree));
    for (std::size_t way = 0; way < ways.size(); ++way) {
      if (!ways[way].of_spheres) continue;
      ways[way].sweep(some, times);
      for (std::size_t i = 0; i < count; ++i) rows[way].worth.add(truths[i], times[i]);
    }
  }
}

std::vector<Row> compare(const Mesh& mesh, std::size_t count, int repetitions, bool only_own) {
  std::vector<Way> ways = own_ways(mesh);
  for (const MakeWay make : only_own ? std::vector<MakeWay>() : engines()) {
    Way way = make(mesh);
    if (mesh.size() <= way.most_triangles) ways.push_back(std::move(way));
  }
  std::array<Casts, kinds> casts;
  for (std::size_t kind = 0; kind < kinds; ++kind)
    casts[kind] = scenes::casts(mesh, scenes::kinds[kind], 20 * turn, 7, 1);
  Medians medians;
  measure(ways, casts, repetitions, medians);
  std::vector<Row> rows;
  for (const Way& way : ways) {
    Row& row = rows.emplace_back(Row{way.name, mesh.size(), {}, {}, way.of_spheres});
    for (std::size_t kind = 0; kind < kinds; ++kind) row.ns[kind] = medians.of(name_of(kind, way));
  }
  judge(mesh, ways, casts, count, rows);
  return rows;
}

void print(std::vector<Row>& rows) {
  for (Row& row : rows) {
    std::printf("%8zu  %-21s", row.triangles, row.way.c_str());
    for (const double ns : row.ns) std::printf(" %7.0f", ns);
    for (std::size_t kind = 0; kind < kinds; ++kind) std::printf(" %5.2f", row.ns[kind] / rows[0].ns[kind]);
    if (row.of_spheres)
      std::printf(" %7zu %6zu %8.1e %8.1e", row.worth.missed, row.worth.false_hits, row.worth.median_error(),
                  row.worth.worst_error());
    std::printf("\n");
  }
  std::fflush(stdout);
}

void print_build(const Mesh& mesh) {
  const auto start = std::chrono::steady_clock::now();
  const Bvh tree(mesh);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::printf("%8zu  the fast tree is built in %.0f ms and takes %.0f bytes a triangle\n", mesh.size(),
              time.count(), static_cast<double>(tree.bytes()) / static_cast<double>(mesh.size()));
}

/// A curve for each way, of one value against the number of triangles.
template <class Value>
void draw(const figure::Studio& studio, const char* name, const char* label, const std::vector<Row>& rows,
          const Value& value) {
  figure::Figure chart(studio, name, {820, 500});
  std::vector<std::string> ways;
  for (const Row& row : rows)
    if (std::find(ways.begin(), ways.end(), row.way) == ways.end()) ways.push_back(row.way);
  std::string plot = "plot ";
  constexpr std::array colours{"GREY", "INK", "BLUE", "SKY", "GREEN", "RED", "ORANGE", "PINK"};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    figure::Table table;
    for (const Row& row : rows)
      if (row.way == ways[i] && value(row) > 0)
        table.push_back({static_cast<double>(row.triangles), value(row)});
    if (table.empty()) continue;  // each way keeps its colour in all figures
    const std::string block = "way" + std::to_string(i);
    chart.data(block, table);
    plot += (i ? ", \\\n  $" : "$") + block + " with linespoints lw 2.2 pt 7 ps 0.5 lc rgb " +
            colours[i % colours.size()] + " title \"" + ways[i] + "\"";
  }
  chart.script()
      << "set logscale xy\nset format x \"10^{%L}\"\nset format y \"10^{%L}\"\nset grid\n"
      << "set key outside right center reverse Left font \",14\"\nset xlabel \"triangles\" font \",16\"\n"
      << "set ylabel \"" << label << "\" font \",16\"\nset xrange [1000:2e6]\n"
      << plot << "\n";
  chart.draw();
}

void print_head() {
  std::printf("%8s  %-21s %s  %s  %s\n", "", "", "ns a cast, of the processor    ", "of the textbook's      ",
              "contacts");
  std::printf("%8s  %-21s", "size", "way");
  for (const auto kind : scenes::kinds) std::printf(" %7s", scenes::to_string(kind));
  for (const auto kind : scenes::kinds) std::printf(" %5s", scenes::to_string(kind));
  std::printf(" %7s %6s %8s %8s\n", "missed", "false", "error", "worst");
}

void print_foot(std::size_t judged) {
  std::printf(
      "missed, false: of %zu casts of each kind, less those that overlap at the start; grazes within 1e-12 r "
      "are neither.\n"
      "error: of the time of contact, the median and the worst.\n",
      judged);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Sweeps of a sphere against terrains: our ways and other engines', in turns on the same casts");
  std::string out = "build/bench";
  std::size_t judged = 500;
  int repetitions = 9;
  std::vector<std::uint32_t> sides{32, 100, 316, 707};
  app.add_option("--out", out, "folder of the figures")->capture_default_str();
  app.add_option("--judged", judged, "how many casts of each kind are judged")
      ->check(CLI::Range(1, 5000))
      ->capture_default_str();
  app.add_option("--repetitions", repetitions, "of which the median is taken")->capture_default_str();
  app.add_option("--sides", sides, "squares along a side of each terrain, of two triangles each");
  bool only_own = false;
  app.add_flag("--own", only_own, "only our own ways, without the other engines");
  CLI11_PARSE(app, argc, argv);
  std::string own = argv[0], mixed = "--benchmark_enable_random_interleaving=true";
  std::array arguments{own.data(), mixed.data()};
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());

  print_head();
  std::vector<Row> all;
  for (const std::uint32_t n : sides) {
    const Mesh mesh = scenes::terrain(n);
    print_build(mesh);
    std::vector<Row> rows = compare(mesh, judged, repetitions, only_own);
    print(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  print_foot(judged);
  figure::Studio studio;
  studio.folder = out;
  draw(studio, "cost", "a hop, in ns", all, [](const Row& row) { return row.ns[1]; });
  draw(studio, "error", "median error of t", all,
       [](Row row) { return std::max(row.worth.median_error(), row.of_spheres ? 1e-18 : 0); });
}
