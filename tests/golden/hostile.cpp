// Numbers that nobody would type but a judge.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "run_program.hpp"

namespace {

struct Numbers {
  std::string program, option;
  int count;  // of numbers in its value
};

const std::vector<Numbers> all_options{{"plane", "--plane", 4},
                                       {"plane", "--from", 3},
                                       {"plane", "--to", 3},
                                       {"plane", "--radius", 1},
                                       {"box", "--plane", 4},
                                       {"box", "--from", 3},
                                       {"box", "--to", 3},
                                       {"box", "--r", 3},
                                       {"box", "--s", 3},
                                       {"box", "--t", 3},
                                       {"general_sphere", "--from", 3},
                                       {"general_sphere", "--to", 3},
                                       {"general_sphere", "--radius", 1},
                                       {"slide", "--from", 3},
                                       {"slide", "--to", 3},
                                       {"slide", "--radius", 1},
                                       {"moving_spheres", "--p1", 3},
                                       {"moving_spheres", "--q2", 3},
                                       {"moving_spheres", "--rp", 1},
                                       {"moving_spheres", "--interval", 2},
                                       {"tween_bounce", "--v0", 1},
                                       {"tween_bounce", "--y0", 1},
                                       {"tween_bounce", "--g", 1},
                                       {"tween_bounce", "--dt", 1},
                                       {"tween_bounce", "--restitution", 1},
                                       {"tween_bounce", "--fps", 1},
                                       {"tween_bounce", "--at", 1},
                                       {"angle_demo", "--mass", 2},
                                       {"angle_demo", "--p1", 2},
                                       {"angle_demo", "--v1", 2},
                                       {"angle_demo", "--radius", 1},
                                       {"angle_demo", "--restitution", 1}};

/// An option as it is given.
struct Given {
  std::string option, value;
};

std::string value_of(const Numbers& option, const std::string& number, int place) {
  std::string value;
  for (int i = 0; i < option.count; ++i)
    value += (i == 0 ? "" : ",") + (i == place || place == option.count ? number : std::string("1"));
  return value;
}

// Only what does not happen is null: a contact, its time, the end of a bounce.
bool all_numbers(const nlohmann::json& result) {
  for (const auto& [key, value] : result.items()) {
    if (value.is_null() && key != "contact" && key != "time" && key != "rest_time" &&
        key != "separation_time")
      return false;
    if (value.is_structured() && !all_numbers(value)) return false;
  }
  return true;
}

// Answered with numbers, or refused in one line that names an option and its value.
void check_answer(const std::string& program, const std::vector<Given>& given) {
  std::vector<std::string> arguments{"--json", "--no-figures"};
  for (const Given& one : given) arguments.push_back(one.option + "=" + one.value);
  if (program == "slide") arguments.push_back("--frames=1");
  const Run run = run_program(program, arguments);
  CAPTURE(program, arguments, run.status, run.err, run.out);
  if (run.status == 0) {
    CHECK(all_numbers(nlohmann::json::parse(run.out)));
    CHECK(run.err.empty());
  } else {
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK(std::any_of(given.begin(), given.end(), [&](const Given& one) {
      return run.err.find(one.option + " " + one.value) != std::string::npos;
    }));
  }
}

}  // namespace

TEST_CASE("Whatever number an option has, the answer is of numbers, or a refusal that names the option") {
  const std::string number = GENERATE("nan", "inf", "-inf", "1e308", "-1e308", "1e200", "1e-200", "-0",
                                      "1e-400", "+-2", "", " ", "0x1p3");
  for (const Numbers& option : all_options)
    for (int place = 0; place <= option.count; place += option.count)  // the first of them, and all
      check_answer(option.program, {{option.option, value_of(option, number, place)}});
}

TEST_CASE(
    "Whatever numbers two options have together, the answer is of numbers, or a refusal that names one") {
  const auto [first, second] =
      GENERATE(table<std::string, std::string>({{"1e300", "-1e300"}, {"1e-320", "1e308"}, {"0", "0"}}));
  for (std::size_t i = 0; i < all_options.size(); ++i)
    for (std::size_t j = i + 1; j < all_options.size() && all_options[j].program == all_options[i].program;
         ++j)
      check_answer(all_options[i].program,
                   {{all_options[i].option, value_of(all_options[i], first, all_options[i].count)},
                    {all_options[j].option, value_of(all_options[j], second, all_options[j].count)}});
}

TEST_CASE("A scene in which nothing moves, or nothing comes nearer, is answered") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> scenes{
      {"plane", {"--from", "1,1,1", "--to", "1,1,1"}},
      {"plane", {"--from", "0,0,3", "--to", "1,0,3"}},
      {"plane", {"--from", "1e200,1,1"}},
      {"box", {"--plane", "1,1,1,1"}},
      {"box", {"--from", "0,0,3", "--to", "0,0,3"}},
      {"general_sphere", {"--from", "1,1,1", "--to", "1,1,1"}},
      {"slide", {"--from", "0,0,3", "--to", "0,0,3", "--frames", "1"}},
      {"slide", {"--to", "1e200,1,1", "--frames", "1"}},
      {"moving_spheres", {"--p1", "0,0,0", "--p2", "0,0,0", "--q1", "9,0,0", "--q2", "9,0,0"}},
      {"tween_bounce", {"--v0", "0", "--y0", "0"}},
      {"tween_bounce", {"--g", "0"}},
      {"angle_demo", {"--p1", "1e200,0"}},
      {"angle_demo", {"--v1", "0,0", "--v2", "0,0"}}};
  for (const auto& [program, options] : scenes) {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), {"--json", "--no-figures"});
    const Run run = run_program(program, arguments);
    CAPTURE(program, options, run.err);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    CHECK(nlohmann::json::accept(run.out));
    arguments = options;
    arguments.push_back("--no-figures");
    const std::string told = run_program(program, arguments).out;
    for (const std::string word : {" inf ", " -inf ", " nan ", " -nan "})
      CHECK(told.find(word) == std::string::npos);
  }
}

TEST_CASE("What leads beyond the range of numbers is refused before anything is drawn or written") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> runs{
      {"tween_bounce", {"--y0", "1e200", "--v0", "1e250", "--csv", "samples.csv"}},
      {"angle_demo", {"--v1", "1e200,0"}},
      {"angle_demo", {"--mass", "1e308,1e308"}},
      {"plane", {"--from", "-1e301,0,0", "--to", "1e301,0,0"}}};
  for (const auto& [program, options] : runs) {
    const TemporaryFolder folder;
    const Run run = run_program(program, options, folder.path());
    CAPTURE(program, options, run.err);
    CHECK(run.status == 2);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    for (std::size_t i = 0; i + 1 < options.size(); i += 2)
      if (options[i] != "--csv") CHECK(run.err.find(options[i] + " " + options[i + 1]) != std::string::npos);
    CHECK(std::filesystem::is_empty(folder.path()));
  }
}

TEST_CASE("A value as long as a book is refused in one short line") {
  for (const std::string part : {"1,", "x", "\n", "9"}) {
    std::string value;
    for (int i = 0; i < 30000; ++i) value += part;
    const Run run = run_program("plane", {"--from=" + value});
    CHECK(run.status == 2);
    CHECK(run.err.size() < 1200);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  }
}

TEST_CASE("A refusal names what the user gave or must mend") {
  struct Named {
    std::string program;
    std::vector<std::string> arguments;
    std::string begins;
  };
  const std::vector<Named> all{
      {"box", {"--s", "1,1,0"}, "box: --s 1,1,0: "},
      {"box", {"--r", "1,0,0", "--s", "1,1,0"}, "box: --r 1,0,0, --s 1,1,0: "},
      {"tween_bounce", {"--dt", "1e200"}, "tween_bounce: --dt 1e200: "},
      {"angle_demo", {"--v1", "1e200,0"}, "angle_demo: --v1 1e200,0: "},
      {"plane", {"--from", "1,1,+-2"}, "plane: --from 1,1,+-2: "},
      {"plane", {"--radius", "1\n2"}, "plane: --radius 1\\n2: "},
      {"plane", {"--radius", "\x1b[31m"}, "plane: --radius \\x1b[31m: "},
      {"plane", {"--out", "--no-figures"}, "plane: --out: must have a value, not --no-figures"},
      {"plane", {"--json", "--radius"}, "plane: --radius: must have a value"},
      {"plane", {"--radius", "--json"}, "plane: --radius: must have a value, not --json"},
      {"slide", {"--frames", "1000001"}, "slide: --frames 1000001: must be from 1 to 1000000"},
      {"partitioning", {"--objects", "1000001"}, "partitioning: --objects 1000001: must be from 0 to "}};
  for (const Named& named : all) {
    const Run run = run_program(named.program, named.arguments);
    CAPTURE(named.begins, run.err);
    CHECK(run.status == 2);
    CHECK(run.err.starts_with(named.begins));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  }
}

TEST_CASE("What nothing can move has an infinite mass: a ball bounces off it") {
  const Run run = run_program("angle_demo", {"--mass", "inf,1", "--v1", "0,0", "--v2", "-1,0", "--p1", "0,0",
                                             "--p2", "5,0", "--model", "contact", "--json", "--no-figures"});
  CAPTURE(run.err, run.out);
  CHECK(run.status == 0);
  CHECK(run.out.find("\"collides\": true") != std::string::npos);
  CHECK(run.out.find("[1, 0]") != std::string::npos);
  CHECK(run_program("angle_demo", {"--mass", "inf,inf", "--model", "contact"}).status == 2);
  CHECK(run_program("angle_demo", {"--mass", "-inf,1", "--model", "contact"}).status == 2);
}
