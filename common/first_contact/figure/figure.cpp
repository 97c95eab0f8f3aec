#include "first_contact/figure/figure.hpp"

#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "first_contact/figure/render.hpp"
#include "first_contact/figure/style.hpp"

#if __has_include(<gnuplot-iostream.h>)
#include <gnuplot-iostream.h>
#else
// Where gnuplot-iostream is not packaged: of all it does, a figure needs the writing of a script to ">FILE".
struct Gnuplot : std::ofstream {
  explicit Gnuplot(const std::string& file) : std::ofstream(file.substr(1)) {}
};
#endif

namespace first_contact::figure {

namespace fs = std::filesystem;

// gnuplot-iostream writes to a file when its name begins with '>'. The script appears under its name once it
// is whole.
struct Figure::Session {
  explicit Session(const fs::path& file) : script(file), unfinished(file.string() + ".part") {
    stream = std::make_unique<Gnuplot>(">" + unfinished.string());
    *stream << std::defaultfloat << std::setprecision(9);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() {
    stream.reset();
    std::error_code ignored;
    fs::remove(unfinished, ignored);
  }

  fs::path script, unfinished;
  std::unique_ptr<Gnuplot> stream;
};

Figure::Figure(const Studio& studio, std::string name, Size size) : studio_(studio), name_(std::move(name)) {
  fs::create_directories(studio_.folder);
  session_ = std::make_unique<Session>(studio_.folder / (name_ + ".gp"));
  script() << style(name_, size.width, size.height, studio_.chinese);
}

Figure::~Figure() = default;

std::ostream& Figure::script() { return *session_->stream; }

void Figure::data(std::string_view name, const Table& rows, int digits) {
  std::ostream& out = script();
  out << std::setprecision(digits);
  out << '$' << name << " << EOD\n";
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i ? " " : "") << row[i];
    out << '\n';
  }
  out << "EOD\n" << std::setprecision(9);
}

void Figure::draw() {
  const fs::path script_file = session_->script;
  session_->stream->flush();
  if (!*session_->stream) throw std::runtime_error(script_file.string() + ": could not be written");
  session_->stream.reset();
  fs::rename(session_->unfinished, script_file);
  for (const std::string& format : studio_.formats) render(studio_, script_file, format);
}

}  // namespace first_contact::figure
