#include "first_contact/program/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>

#include "first_contact/program/json.hpp"
#include "first_contact/program/numbers.hpp"

namespace first_contact::program {

namespace {

void obey(const Program::Rule& rule, double value) {
  const std::string broken = rule ? rule(value) : "";
  if (!broken.empty()) throw Refused(broken);
}

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + readable(number);
  return text;
}

// `--p1 -1,8`: a value that begins with a minus sign is joined to its option, or it would be taken for
// another option.
std::vector<std::string> joined_values(int argc, char** argv) {
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool negative = argument.size() > 1 && argument[0] == '-' && argument[1] != '-';
    const bool after_option = !arguments.empty() && arguments.back().starts_with("--") &&
                              arguments.back().find('=') == std::string::npos;
    if (negative && after_option)
      arguments.back() += "=" + argument;
    else
      arguments.push_back(argument);
  }
  return {arguments.rbegin(), arguments.rend()};  // CLI11 wants them last first
}

}  // namespace

struct Program::Inside {
  explicit Inside(const std::string& purpose) : line(purpose) {}

  CLI::App line;
  std::string name;
  std::map<std::string, std::string> given;  // option -> its text
  std::vector<std::function<void()>> checks;
  std::string out, language = "en", theme = "light", format = "svg", values_file;
  bool as_json = false, no_figures = false;
  figure::Studio studio;
  std::optional<Report> report;
  Json json = Json::object();
  Json values = Json::object();

  // The place of a result; the objects and lists on the way to it are made.
  Json& at(const std::string& place) { return json[Json::json_pointer(place)]; }

  // An option whose text is checked and taken over once the whole line has been read.
  void add(const std::string& option, const std::string& letters, const std::string& help,
           const std::string& value, std::function<void(const std::string&)> take) {
    line.add_option_function<std::string>(
            option, [this, option](const std::string& text) { given[option] = text; }, help)
        ->type_name(letters)
        ->default_str(value)
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    checks.emplace_back([this, option, take = std::move(take)] {
      const auto found = given.find(option);
      if (found == given.end()) return;
      try {
        take(found->second);
      } catch (const std::exception& error) {
        throw Refused(option + " " + found->second + ": " + error.what());
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
           if (!std::ifstream(text)) throw Refused("must be a file that can be read");
           in.studio.own = text;
         });
  in.line.add_flag("--json", in.as_json, "print only the results, as JSON");
  in.add("--values", "FILE", "write the numbers that the notes show", "", [&in](const std::string& text) {
    if (text.empty()) throw Refused("must name a file");
    in.values_file = text;
  });
  in.line.add_flag("--no-figures", in.no_figures, "write no figures");
}

Program::~Program() = default;

void Program::option(const std::string& name, double& value, const std::string& letters,
                     const std::string& help, const Rule& rule) {
  inside_->add(name, letters, help, readable(value), [&value, rule](const std::string& text) {
    const double number = number_of(text);
    obey(rule, number);
    value = number;
  });
}

void Program::option(const std::string& name, long& value, const std::string& letters,
                     const std::string& help, const Rule& rule) {
  inside_->add(name, letters, help, std::to_string(value), [&value, rule](const std::string& text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) throw Refused("must be a whole number");
    obey(rule, static_cast<double>(number));
    value = number;
  });
}

void Program::option(const std::string& name, Vector& value, const std::string& letters,
                     const std::string& help) {
  inside_->add(name, letters, help, joined({value.x(), value.y(), value.z()}),
               [&value](const std::string& text) {
                 const auto numbers = numbers_of(text, 3);
                 value = {numbers[0], numbers[1], numbers[2]};
               });
}

void Program::option(const std::string& name, Eigen::Vector2d& value, const std::string& letters,
                     const std::string& help, const Rule& rule) {
  inside_->add(name, letters, help, joined({value.x(), value.y()}), [&value, rule](const std::string& text) {
    const auto numbers = numbers_of(text, 2);
    for (const double number : numbers) obey(rule, number);
    value = {numbers[0], numbers[1]};
  });
}

void Program::option(const std::string& name, Plane& value, const std::string& letters,
                     const std::string& help) {
  const Homogeneous& e = value.coefficients();
  inside_->add(name, letters, help, joined({e.x(), e.y(), e.z(), e.w()}), [&value](const std::string& text) {
    const auto numbers = numbers_of(text, 4);
    value = Plane({numbers[0], numbers[1], numbers[2]}, numbers[3]);
  });
}

void Program::option(const std::string& name, std::string& value, const std::string& letters,
                     const std::string& help) {
  inside_->add(name, letters, help, value, [&value](const std::string& text) {
    if (text.empty()) throw Refused("must not be empty");
    value = text;
  });
}

void Program::option(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                     const std::string& help) {
  inside_->choose(name, value, choices, help);
}

bool Program::given(const std::string& name) const { return inside_->given.contains(name); }

std::string Program::text_of(const std::string& name) const {
  const auto found = inside_->given.find(name);
  return found == inside_->given.end() ? "(its default)" : found->second;
}

int Program::execute(int argc, char** argv, const std::function<void()>& chapter) {
  Inside& in = *inside_;
  in.line.parse(joined_values(argc, argv));
  in.take_over();
  chapter();
  if (!in.values_file.empty()) write_file(in.values_file, to_string(in.values) + "\n");
  if (in.as_json)
    std::cout << to_string(in.json) << '\n';
  else
    in.report->print(std::cout);
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("standard output: could not be written");
  return 0;
}

int Program::run(int argc, char** argv, const std::function<void()>& chapter) {
  const std::string& name = inside_->name;
  try {
    return execute(argc, argv, chapter);
  } catch (const CLI::CallForHelp&) {
    std::cout << inside_->line.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    std::cerr << name << ": " << error.what() << " (see " << name << " --help)\n";
    return 2;
  } catch (const Refused& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::invalid_argument& error) {  // a value that the library refuses
    std::cerr << name << ": " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
}

Report& Program::report() { return *inside_->report; }

void Program::result(const std::string& place, std::nullptr_t) { inside_->at(place) = nullptr; }
void Program::result(const std::string& place, bool value) { inside_->at(place) = value; }
void Program::result(const std::string& place, double value) { inside_->at(place) = value; }
void Program::result(const std::string& place, long value) { inside_->at(place) = value; }
void Program::result(const std::string& place, const std::string& value) { inside_->at(place) = value; }
void Program::result(const std::string& place, const std::vector<double>& value) {
  inside_->at(place) = value;
}
void Program::result(const std::string& place, const Vector& value) {
  inside_->at(place) = {value.x(), value.y(), value.z()};
}
void Program::result_list(const std::string& place) { inside_->at(place) = Json::array(); }

void Program::value(const std::string& name, double number) { inside_->values[name] = number; }
Language Program::language() const { return inside_->studio.chinese ? Language::chinese : Language::english; }
bool Program::draws() const { return !inside_->no_figures; }
const figure::Studio& Program::studio() const { return inside_->studio; }

std::string not_negative(double value) { return value >= 0 ? "" : "must not be negative"; }
std::string positive(double value) { return value > 0 ? "" : "must be greater than zero"; }
std::string at_most_one(double value) { return value >= 0 && value <= 1 ? "" : "must be from 0 to 1"; }

void write_file(const std::filesystem::path& file, const std::string& content) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  const std::filesystem::path unfinished = file.string() + ".part";
  std::ofstream out(unfinished, std::ios::binary);
  out << content;
  out.close();
  if (!out) {
    std::filesystem::remove(unfinished);
    throw std::runtime_error(file.string() + ": could not be written");
  }
  std::filesystem::rename(unfinished, file);
}

}  // namespace first_contact::program
