#include "first_contact/program/program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <optional>

#include "first_contact/figure/interruption.hpp"
#include "first_contact/files/output.hpp"
#include "first_contact/files/printable.hpp"
#include "first_contact/program/command_line.hpp"
#include "first_contact/program/help.hpp"
#include "first_contact/program/in_chinese.hpp"
#include "first_contact/program/json.hpp"

namespace first_contact::program {

namespace {

constexpr std::size_t most_of_a_message = 2000;  // bytes

int all_printed() {
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("standard output: could not be written");
  return 0;
}

}  // namespace

struct Program::Inside {
  explicit Inside(Text purpose) : help{std::move(purpose), {}} {}

  CLI::App line;
  Help help;
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
  void add(const std::string& option, const std::string& letters, const Text& meaning,
           const std::string& value, std::function<void(const std::string&)> take) {
    CLI::Option* const added = line.add_option(option, [](const CLI::results_t&) { return true; });
    added->type_name(letters)->default_str(value)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    help.meanings.emplace_back(added, meaning);
    checks.emplace_back([this, option, take = std::move(take)] {
      if (!given(option)) return;
      try {
        take(text_of(option));
      } catch (const std::exception& error) {
        throw Refused(option + " " + printable(text_of(option)) + ": " + error.what());
      }
    });
  }

  void flag(const std::string& option, bool& value, const Text& meaning) {
    help.meanings.emplace_back(line.add_flag(option, value), meaning);
  }

  void choose(const std::string& option, std::string& value, const std::vector<std::string>& choices,
              const Text& meaning) {
    std::string all;
    for (const auto& choice : choices) all += (all.empty() ? "" : "|") + choice;
    add(option, all, meaning, value, [&value, choices, all](const std::string& text) {
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

Program::Program(std::string name, const std::string& chapter, const Text& purpose)
    : inside_(std::make_unique<Inside>(purpose)) {
  Inside& in = *inside_;
  in.name = std::move(name);
  in.line.name(in.name);
  in.help.meanings.emplace_back(in.line.set_help_flag("--help", "-"),
                                Text{"print this and exit", "顯示此說明後結束"});
  in.out = "out/" + chapter;
  in.add("--out", "DIR", {"folder for figures", "存放圖的資料夾"}, in.out, [&in](const std::string& text) {
    if (text.empty()) throw Refused("must name a folder");
    in.out = text;
  });
  in.choose("--lang", in.language, {"en", "zh-TW"},
            {"language of report and labels", "報告、標示、說明與錯誤訊息的語言"});
  in.choose("--format", in.format, {"svg", "png", "pdf"}, {"of the pictures", "圖檔格式"});
  in.choose("--theme", in.theme, {"light", "dark", "grey"},
            {"of png and pdf; an svg follows its reader's theme", "png 與 pdf 的配色；svg 依讀者的設定"});
  in.add("--style", "FILE",
         {"gnuplot commands read after the house style: sizes, letters, colours",
          "在本書樣式之後讀入的 gnuplot 指令：尺寸、字型、顏色"},
         "", [&in](const std::string& text) {
           std::error_code ignored;
           if (!std::filesystem::is_regular_file(text, ignored) || !std::ifstream(text))
             throw Refused("must be a file that can be read");
           in.studio.own = text;
         });
  in.flag("--json", in.as_json, {"print only the results, as JSON", "只以 JSON 輸出結果"});
  in.add("--values", "OUT.json", {"write the numbers that the notes show", "寫出書中所示的數值"}, "",
         [&in](const std::string& text) {
           if (text.empty()) throw Refused("must name a file");
           in.values_file = text;
         });
  in.flag("--no-figures", in.no_figures, {"write no figures", "不畫圖"});
}

Program::~Program() = default;

void Program::add(const std::string& name, const std::string& letters, const Text& help,
                  const std::string& value, std::function<void(const std::string&)> take) {
  inside_->own_options.push_back(name);
  inside_->add(name, letters, help, value, std::move(take));
}

void Program::option(const std::string& name, std::string& value, const std::vector<std::string>& choices,
                     const Text& help) {
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
    std::cout << in.help.of(in.line, language_asked(argc, argv));
    return all_printed();
  }
  require_different_files(in.line);
  in.take_over();
  require_writable_files(in.line);
  if (draws()) checked("--out", [&] { require_folder(in.out); });
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
  const bool chinese = language_asked(argc, argv) == Language::chinese;
  const auto fail = [this, chinese](int status, const std::string& what) {
    const std::string shown = printable(what, most_of_a_message);
    std::cerr << inside_->name << ": " << (chinese ? in_chinese(shown) : shown) << '\n';
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
