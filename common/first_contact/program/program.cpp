#include "first_contact/program/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <optional>

#include "first_contact/figure/interruption.hpp"
#include "first_contact/files/output.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/program/command_line.hpp"
#include "first_contact/program/json.hpp"
#include "first_contact/program/numbers.hpp"

namespace first_contact::program {

namespace {

void obey(const Program::Rule& rule, double value) {
  const std::string broken = rule ? rule(value) : "";
  if (!broken.empty()) throw Refused(broken);
}

constexpr std::size_t most_of_a_message = 2000;  // bytes

int all_printed() {
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("standard output: could not be written");
  return 0;
}

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + readable(number);
  return text;
}

}  // namespace

struct Program::Inside {
  explicit Inside(const std::string& purpose) : line(purpose) {}

  CLI::App line;
  std::string name;
  std::vector<std::string> own_options;  // of the chapter, which its numbers depend on
  std::vector<std::function<void()>> checks;
  std::string out, language = "en", theme = "light", format = "svg", values_file;
  bool as_json = false, no_figures = false;
  figure::Studio studio;
  std::optional<Report> report;
  Json json = Json::object();
  Json values = Json::object();

  // The place of a result; the objects and lists on the way to it are made.
  Json& at(const std::string& place) { return json[Json::json_pointer(place)]; }

  // Was an option given, and as what?
  bool given(const std::string& option) const { return line.count(option) > 0; }
  std::string text_of(const std::string& option) const { return line.get_option(option)->as<std::string>(); }

  // An option whose text is checked and taken over once the whole line has been read. CLI11's own validators
  // do not serve: they let nan into every range, cut 1e20 down to the largest whole number, take "1,2,3," for
  // three numbers, and do not set the value beside its option.
  void add(const std::string& option, const std::string& letters, const std::string& help,
           const std::string& value, std::function<void(const std::string&)> take) {
    line.add_option(
            option, [](const CLI::results_t&) { return true; }, help)
        ->type_name(letters)
        ->default_str(value)
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    checks.emplace_back([this, option, take = std::move(take)] {
      if (!given(option)) return;
      try {
        take(text_of(option));
      } catch (const std::exception& error) {
        throw Refused(option + " " + printable(text_of(option)) + ": " + error.what());
      }
    });
  }

  void choose(const std::string& option, std::string& value, const std::vector<std::string>& choices,
              const std::string& help) {
    std::string all;
    for (const auto& choice : choices) all += (all.empty() ? "" : "|") + choice;
    add(option, all, help, value, [&value, choices, all](const std::string& text) {
      if (std::find(choices.begin(), choices.end(), text) == choices.end())
        throw Refused("must be one of " + all);
      value = text;
    });
  }

  void take_over() {
    for (const auto& check : checks) check();
    studio.folder = out;
    studio.theme = theme;
    studio.formats = {format};
    studio.chinese = language == "zh-TW";
    if (const char* gnuplot = std::getenv("GNUPLOT")) studio.gnuplot = gnuplot;
    report.emplace(studio.chinese ? Language::chinese : Language::english);
  }
};

Program::Program(std::string name, const std::string& chapter, const std::string& purpose)
    : inside_(std::make_unique<Inside>(purpose)) {
  Inside& in = *inside_;
  in.name = std::move(name);
  in.line.name(in.name);
  in.line.set_help_flag("--help", "print this and exit");
  in.out = "out/" + chapter;
  in.add("--out", "DIR", "folder for figures", in.out, [&in](const std::string& text) {
    if (text.empty()) throw Refused("must name a folder");
    in.out = text;
  });
  in.choose("--lang", in.language, {"en", "zh-TW"}, "language of report and labels");
  in.choose("--format", in.format, {"svg", "png", "pdf"}, "of the pictures");
  in.choose("--theme", in.theme, {"light", "dark", "grey"},
            "of png and pdf; an svg follows its reader's theme");
  in.add("--style", "FILE", "gnuplot commands read after the house style: sizes, letters, colours", "",
         [&in](const std::string& text) {
           std::error_code ignored;
           if (!std::filesystem::is_regular_file(text, ignored) || !std::ifstream(text))
             throw Refused("must be a file that can be read");
           in.studio.own = text;
         });
  in.line.add_flag("--json", in.as_json, "print only the results, as JSON");
  in.add("--values", "OUT.json", "write the numbers that the notes show", "", [&in](const std::string& text) {
    if (text.empty()) throw Refused("must name a file");
    in.values_file = text;
  });
  in.line.add_flag("--no-figures", in.no_figures, "write no figures");
}

Program::~Program() = default;

void Program::add(const std::string& name, const std::string& letters, const std::string& help,
                  const std::string& value, std::function<void(const std::string&)> take) {
  inside_->own_options.push_back(name);
  inside_->add(name, letters, help, value, std::move(take));
}

void Program::option(const std::string& name, double& value, const std::string& letters,
                     const std::string& help, const Rule& rule) {
  add(name, letters, help, readable(value), [&value, rule](const std::string& text) {
    const double number = number_of(text);
    obey(rule, number);
    value = number;
  });
}

void Program::option(const std::string& name, long& value, const std::string& letters,
                     const std::string& help, const Rule& rule) {
  add(name, letters, help, std::to_string(value), [&value, rule](const std::string& text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) throw Refused("must be a whole number");
    obey(rule, static_cast<double>(number));
    value = number;
  });
}

void Program::option(const std::string& name, Vector& value, const std::string& letters,
                     const std::string& help) {
  add(name, letters, help, joined({value.x(), value.y(), value.z()}), [&value](const std::string& text) {
    const auto numbers = numbers_of(text, 3);
    value = {numbers[0], numbers[1], numbers[2]};
  });
}

void Program::option(const std::string& name, Eigen::Vector2d& value, const std::string& letters,
                     const std::string& help, const Rule& rule, Range range) {
  add(name, letters, help, joined({value.x(), value.y()}), [&value, rule, range](const std::string& text) {
    const auto numbers = numbers_of(text, 2, range);
    for (const double number : numbers) obey(rule, number);
    value = {numbers[0], numbers[1]};
  });
}

void Program::option(const std::string& name, Plane& value, const std::string& letters,
                     const std::string& help) {
  const Homogeneous& e = value.coefficients();
  add(name, letters, help, joined({e.x(), e.y(), e.z(), e.w()}), [&value](const std::string& text) {
    const auto numbers = numbers_of(text, 4);
    value = Plane({numbers[0], numbers[1], numbers[2]}, numbers[3]);
  });
}

void Program::option(const std::string& name, std::string& value, const std::string& letters,
                     const std::string& help) {
  add(name, letters, help, value, [&value](const std::string& text) {
    if (text.empty()) throw Refused("must not be empty");
    value = text;
  });
}

void Program::option(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                     const std::string& help) {
  inside_->choose(name, value, choices, help);
}

bool Program::given(const std::string& name) const { return inside_->given(name); }

// "--r 1,0,0, --s 1,1,0": the options of these that were given, with their values.
std::string Program::told(const std::vector<std::string>& names) const {
  std::string all;
  for (const std::string& name : names)
    if (given(name)) all += (all.empty() ? "" : ", ") + name + " " + printable(inside_->text_of(name));
  return all.empty() ? names.front() + " (its default)" : all;
}

// What the chapter did not foresee is refused in the name of all options that were given to it.
void Program::run_chapter(const std::function<void()>& chapter) {
  Inside& in = *inside_;
  try {
    chapter();
  } catch (const FileError& error) {  // of a figure
    throw Refused("--out " + printable(in.out) + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    const auto& own = in.own_options;
    if (std::none_of(own.begin(), own.end(), [&](const auto& name) { return given(name); })) throw;
    throw Refused(told(own) + ": " + error.what());
  }
}

// All of the line is checked before anything is done, and all is done before anything is printed.
int Program::execute(int argc, char** argv, const std::function<void()>& chapter) {
  Inside& in = *inside_;
  try {
    in.line.parse(arguments_of(in.line, argc, argv));
  } catch (const CLI::CallForHelp&) {
    std::cout << in.line.help();
    return all_printed();
  }
  require_different_files(in.line);
  in.take_over();
  run_chapter(chapter);
  if (!in.values_file.empty())
    checked("--values", [&] { write_file(in.values_file, to_string(in.values) + "\n"); });
  if (in.as_json)
    std::cout << to_string(in.json) << '\n';
  else
    in.report->print(std::cout);
  return all_printed();
}

int Program::run(int argc, char** argv, const std::function<void()>& chapter) {
  const auto fail = [this](int status, const std::string& what) {
    std::cerr << inside_->name << ": " << printable(what, most_of_a_message) << '\n';
    return status;
  };
  try {
    return execute(argc, argv, chapter);
  } catch (const CLI::ParseError& error) {
    return fail(2, std::string(error.what()) + " (see " + inside_->name + " --help)");
  } catch (const Refused& error) {
    return fail(2, error.what());
  } catch (const std::invalid_argument& error) {  // a value that the library refuses
    return fail(2, error.what());
  } catch (const figure::Interrupted& error) {
    return std::raise(error.signal());
  } catch (const std::bad_alloc&) {
    return fail(1, "needs more memory than there is");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}

Report& Program::report() { return *inside_->report; }

void Program::result(const std::string& place, std::nullptr_t) { inside_->at(place) = nullptr; }
void Program::result(const std::string& place, bool value) { inside_->at(place) = value; }
void Program::result(const std::string& place, double value) { inside_->at(place) = finite(value, place); }
void Program::result(const std::string& place, long value) { inside_->at(place) = value; }
void Program::result(const std::string& place, const std::string& value) { inside_->at(place) = value; }
void Program::result(const std::string& place, const std::vector<double>& value) {
  for (const double number : value) finite(number, place);
  inside_->at(place) = value;
}
void Program::result(const std::string& place, const Vector& value) {
  result(place, std::vector<double>{value.x(), value.y(), value.z()});
}
void Program::result_list(const std::string& place) { inside_->at(place) = Json::array(); }

bool Program::results_alone() const { return inside_->as_json && inside_->values_file.empty(); }
void Program::value(const std::string& name, double number) { inside_->values[name] = number; }
Language Program::language() const { return inside_->studio.chinese ? Language::chinese : Language::english; }
bool Program::draws() const { return !inside_->no_figures; }
const figure::Studio& Program::studio() const { return inside_->studio; }

std::string not_negative(double value) { return value >= 0 ? "" : "must not be negative"; }
std::string positive(double value) { return value > 0 ? "" : "must be greater than zero"; }
std::string at_most_one(double value) { return value >= 0 && value <= 1 ? "" : "must be from 0 to 1"; }

}  // namespace first_contact::program
