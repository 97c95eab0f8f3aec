#include "run.hpp"

#include "figures/figures.hpp"
#include "read_film.hpp"
#include "scenes.hpp"
#include "showing.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace tween_bounce {

namespace {

const std::vector<std::string> of_the_ball{"--v0",          "--y0",    "--g",     "--dt",  "--samples",
                                           "--restitution", "--model", "--curve", "--part"};

// What would go unread is refused.
void require_film_alone(Program& program, bool film) {
  const std::string rule = film ? "must not be given with --film" : "must not be given without --film";
  for (const std::string& name : film ? of_the_ball : std::vector<std::string>{"--fps", "--at"})
    if (program.given(name)) program.checked(name.c_str(), [&] { throw Refused(rule); });
}

double frozen_at(Program& program, const Film& film, double at) {
  if (!program.given("--at")) return film.end();
  return program.checked("--at", [&] {
    if (at >= film.begin() && at <= film.end()) return at;
    throw Refused("must be in the film, from " + readable(film.begin()) + " to " + readable(film.end()));
  });
}

void tell_contact(Program& program, const Contact& contact, std::size_t i) {
  const std::string n = std::to_string(i + 1), place = "/contacts/" + std::to_string(i);
  program.row("t" + n, contact.time, {"contact " + n, "第 " + n + " 次接觸的時間"}).result(place + "/time");
  program.row("Q" + n, Point(contact.point()), {"where it touches", "接觸點"}).result(place + "/point");
  program.row("N" + n, contact.normal, {"normal there", "該處的法向量"}).result(place + "/normal");
  program.result(place + "/feature", to_string(contact.feature));
}

void tell_film(Program& program, const Film& film, const Showing& showing, const FilmOptions& options,
               double until, std::size_t pictures) {
  Report& report = program.report();
  report.title({"A film: its path is tested before it is played", "影片：先測試路徑，再播放"}, "1.1, 2.4.2");
  program.result("/film", film.name);
  program.row("keys", film.keys.size(), {"key frames", "關鍵影格"}).result("/keys");
  program.row("t", readable(film.begin()) + " .. " + readable(film.end()),
              {"first and last key", "首末兩個關鍵影格的時間"});
  program.result("/begin", film.begin());
  program.result("/end", film.end());
  program
      .row("pictures", pictures,
           {readable(options.per_second) + " a second", "每秒 " + readable(options.per_second) + " 影格"})
      .result("/pictures");
  program.row("in the way", film.walls.size(), {"planes, boxes and meshes", "平面、匣面體與網格"})
      .result("/obstacles");
  report.say({"The path is tested: what is met, and when", "測試路徑：碰到什麼、何時碰到"});
  program.result_list("/contacts");
  std::size_t told = 0;
  for (const Contact& contact : showing.contacts())
    if (contact.time <= until) tell_contact(program, contact, told++);
  report.row("contacts", told,
             {"after each it is to " + film.contact.what, "接觸後的動作：" + film.contact.what});
  const Frame last = showing.at(until);
  report.say({"At t = " + readable(until), "t = " + readable(until) + " 時"});
  program.row("P", last.place, {"place", "位置"}).result("/last/place");
  program.result("/last/time", until);
  const Eigen::Quaterniond& q = last.turn;
  program.result("/last/turn", std::vector<double>{q.w(), q.x(), q.y(), q.z()});
  program.row("scale", last.scale, {"how tall it is drawn", "繪製時的高度比例"}).result("/last/scale");
}

}  // namespace

FilmOptions::FilmOptions(Program& program) {
  program.option("--film", word, "WORD|FILE",
                 {"a film instead: " + scene_names() + ", a JSON file, or its text",
                  "改放影片：" + scene_names() + "、JSON 檔，或其內容"});
  program.option("--fps", per_second, "n", {"pictures of a film in one second", "影片每秒的畫面數"},
                 [](double value) {
                   return value >= 1 && value <= 240 ? std::string() : std::string("must be from 1 to 240");
                 });
  program.option("--at", at, "t", {"freezes the film at that time", "將影片凍結在該時刻"});
}

bool run_film(Program& program, const FilmOptions& options, const std::string& table) {
  require_film_alone(program, !options.word.empty());
  if (options.word.empty()) return false;
  const Film film = program.checked("--film", [&] { return film_named(options.word); });
  const double until = frozen_at(program, film, options.at);
  const auto times = program.checked({"--film", "--fps"},
                                     [&] { return picture_times(film.begin(), until, options.per_second); });
  const Showing showing = program.checked("--film", [&] { return Showing(film); });
  tell_film(program, film, showing, options, until, times.size());
  if (!table.empty()) program.checked("--csv", [&] { write_file(table, csv(showing, times)); });
  if (program.draws()) draw_film(program, film, showing, {until, options.per_second});
  return true;
}

}  // namespace tween_bounce
