#include "first_contact/figure/figure.hpp"

#include <fstream>
#include <iomanip>
#include <utility>

#include "first_contact/figure/render.hpp"
#include "first_contact/figure/style.hpp"
#include "first_contact/figure/temporary_folder.hpp"
#include "first_contact/files/input.hpp"
#include "first_contact/files/output.hpp"

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

// gnuplot-iostream writes to a file when its name begins with '>'. Script and pictures are made in a folder
// of their own, and appear under their names once they are whole.
struct Figure::Session {
  explicit Session(const std::string& name) : script(folder.path() / (name + ".gp")) {
    stream = std::make_unique<Gnuplot>(">" + script.string());
    *stream << std::defaultfloat << std::setprecision(9);
  }

  TemporaryFolder folder;
  fs::path script;
  std::unique_ptr<Gnuplot> stream;  // until the script is whole
};

Figure::Figure(const Studio& studio, std::string name, Size size) : studio_(studio), name_(std::move(name)) {
  session_ = std::make_unique<Session>(name_);
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

void Figure::close() {
  if (!session_->stream) return;
  session_->stream->flush();
  if (!*session_->stream) session_->folder.refuse_writing();
  session_->stream.reset();
  make_folder(studio_.folder);
  keep("gp", read_file(session_->script));
}

std::optional<std::string> Figure::picture(const std::string& format) {
  close();
  return render(studio_, session_->script, format);
}

void Figure::keep(const std::string& format, const std::string& picture) const {
  write_file(studio_.folder / (name_ + "." + format), picture);
}

void Figure::draw() {
  close();
  for (const std::string& format : studio_.formats)
    if (const auto drawn = picture(format)) keep(format, *drawn);
}

}  // namespace first_contact::figure
