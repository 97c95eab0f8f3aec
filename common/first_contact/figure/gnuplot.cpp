#include "first_contact/figure/gnuplot.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <locale>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "first_contact/figure/child_process.hpp"
#include "first_contact/figure/interruption.hpp"
#include "first_contact/files/decimal.hpp"
#include "first_contact/files/printable.hpp"

namespace first_contact::figure {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_complaints = 1 << 16;  // bytes: who says more is stopped
constexpr std::size_t quoted_complaints = 600;    // bytes

// gnuplot counts the pictures of an animation aloud, "25 frames in animation sequence": no complaint, all
// else is one.
bool is_count_of_frames(const std::string& said) {
  constexpr std::string_view rest = " frames in animation sequence";
  const std::size_t number = said.find_first_not_of("0123456789");
  return number != 0 && number != std::string::npos && said.substr(number, rest.size()) == rest &&
         said.find_first_not_of(" \n", number + rest.size()) == std::string::npos;
}

// What was said, on one line.
std::string words(const std::string& said) {
  std::string line;
  for (const char letter : said) {
    const bool blank = letter == ' ' || letter == '\n' || letter == '\t';
    if (!blank || !(line.empty() || line.back() == ' ')) line += blank ? ' ' : letter;
    if (line.size() > 2 * quoted_complaints) break;
  }
  return printable(line, quoted_complaints);
}

// In the child, before it becomes gnuplot: it dies with this program where the system offers that, and by an
// alarm clock of its own in any case. No signal is blocked or ignored there that ends it. Boost can do so on
// POSIX's systems alone: others make no child before its program is there.
#ifdef BOOST_POSIX_API
void end_in_time(double seconds) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  alarm(static_cast<unsigned>(std::ceil(seconds)) + 1);
}

auto at_its_beginning(double seconds) {
  return process::extend::on_exec_setup = [seconds](auto&) { end_in_time(seconds); };
}
#else
auto at_its_beginning(double) {
  return process::extend::on_setup = [](auto&) {};
}
#endif

// gnuplot at work, and whatever it starts; stopped if it is not waited for.
class Child {
 public:
  Child(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder,
        double seconds)
      : complaints_(folder / "complaints"), seconds_(seconds) {
    process::environment environment = boost::this_process::environment();
    environment["LC_ALL"] = "C.UTF-8";  // else its conversion of a degree sign fails
    gnuplot_ = process::child(
        program.string(), process::args = arguments, process::start_dir = folder.string(),
        process::std_in<process::null, process::std_out> process::null,
        process::std_err > complaints_.string(), environment, group_, at_its_beginning(seconds));
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    std::error_code gone;
    if (!gnuplot_.running(gone)) return;
    group_.terminate(gone);
    gnuplot_.wait(gone);
  }

  int status() const { return gnuplot_.exit_code(); }
  // What it said, or the beginning of that.
  std::string said() const {
    std::string begin(most_complaints + 1, ' ');
    std::ifstream in(complaints_, std::ios::binary);
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    return begin;
  }

  void wait() {
    const Interruption interruption;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds_);
    for (auto pause = 1ms; gnuplot_.running(); pause = std::min(2 * pause, 20ms)) {
      interruption.check();
      if (Clock::now() > end) throw std::runtime_error("was not done in " + shortest(seconds_) + " s");
      std::error_code unknown;
      if (fs::file_size(complaints_, unknown) > most_complaints && !unknown)
        throw std::runtime_error("complained without an end: " + words(said()));
      std::this_thread::sleep_for(pause);
    }
  }

 private:
  fs::path complaints_;
  double seconds_;
  process::group group_;
  process::child gnuplot_;
};

// Boost converts names as the user's locale has it, and gives up on one that is named but not installed.
void do_without_missing_locale() {
  try {
    std::locale("");
  } catch (const std::runtime_error&) {
    boost::this_process::environment()["LC_ALL"] = "C";
  }
}

// A text as gnuplot takes it literally.
std::string literal(const std::string& text) {
  std::string letters = "'";
  for (const char letter : text) letters += letter == '\'' ? "''" : std::string(1, letter);
  return letters + "'";
}

// What gnuplot says of itself goes to standard error, and its status may be 0 all the same: both count.
// With -d it reads no settings of the user's own (~/.gnuplot), which would draw another figure.
void draw(const fs::path& program, const Studio& studio, const fs::path& script, const std::string& format) {
  std::vector<std::string> arguments{"-d", "-e", "format='" + format + "'", "-e",
                                     "theme='" + (format == "svg" ? "light" : studio.theme) + "'"};
  if (!studio.own.empty())
    arguments.insert(arguments.end(), {"-e", "own=" + literal(fs::absolute(studio.own).string())});
  arguments.push_back(script.filename().string());
  Child child(program, arguments, script.parent_path(), studio.patience);
  child.wait();
  const std::string said = child.said();
  if (child.status() != 0 || !(said.empty() || is_count_of_frames(said)))
    throw std::runtime_error("ended with status " + std::to_string(child.status()) +
                             " and said: " + words(said));
}

}  // namespace

fs::path find_gnuplot(const std::string& name) {
  const fs::path path = name;
  do_without_missing_locale();
  if (!path.has_parent_path()) return process::search_path(name).string();
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool runs =
      fs::is_regular_file(status) && (status.permissions() & fs::perms(0111)) != fs::perms::none;
  return runs ? fs::absolute(path, ignored) : fs::path();
}

void run_gnuplot(const fs::path& program, const Studio& studio, const fs::path& script,
                 const std::string& format) {
  const std::string who = program.string() + ", drawing " + script.filename().string() + " as " + format;
  try {
    draw(program, studio, script, format);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(who + ": " + error.what());
  }
}

}  // namespace first_contact::figure
