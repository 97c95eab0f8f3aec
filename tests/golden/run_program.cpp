#include "run_program.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <iterator>
#include <random>
#include <sstream>
#include <thread>

#include "first_contact/figure/child_process.hpp"
#include "places.hpp"

namespace fs = std::filesystem;
namespace process = first_contact::figure::process;

namespace {

std::string all_of(process::ipstream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

std::string built(const std::string& name) {
  return std::string(first_contact::places::build) + "/bin/" + name;
}

Run run(const std::string& file, const std::vector<std::string>& arguments, const fs::path& folder,
        const process::environment& environment) {
  process::ipstream out, err;
  process::child child(file, process::args = arguments, process::start_dir = folder.string(),
                       process::std_in<process::null, process::std_out> out, process::std_err > err,
                       environment);
  auto errors =
      std::async(std::launch::async, [&err] { return all_of(err); });  // both at once, or one could block
  Run result{0, all_of(out), ""};
  result.err = errors.get();
  child.wait();
  result.status = child.exit_code();
  return result;
}

}  // namespace

Run run_program(const std::string& name, const std::vector<std::string>& arguments, const fs::path& folder) {
  return run(built(name), arguments, folder, boost::this_process::environment());
}

Run run_command(const std::string& name, const std::vector<std::string>& arguments) {
  const auto found = process::search_path(name);
  if (found.empty()) return {127, "", ""};
  return run(found.string(), arguments, fs::temp_directory_path(), boost::this_process::environment());
}

Run run_with(const std::string& variable, const std::string& value, const std::string& name,
             const std::vector<std::string>& arguments) {
  process::environment environment = boost::this_process::environment();
  environment[variable] = value;
  return run(built(name), arguments, fs::temp_directory_path(), environment);
}

Run run_into(const std::string& file, const std::string& name, const std::vector<std::string>& arguments) {
  process::ipstream err;
  process::child child(built(name), process::args = arguments,
                       process::std_in<process::null, process::std_out> file, process::std_err > err);
  Run result{0, "", all_of(err)};
  child.wait();
  result.status = child.exit_code();
  return result;
}

Run run_stopped(int signal, const std::map<std::string, std::string>& variables, const std::string& name,
                const std::vector<std::string>& arguments) {
  process::environment environment = boost::this_process::environment();
  for (const auto& [variable, value] : variables) environment[variable] = value;
  process::child child(built(name), process::args = arguments,
                       process::std_in<process::null, process::std_out> process::null,
                       process::std_err > process::null, environment);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  kill(child.id(), signal);
  child.wait();
  return {WTERMSIG(child.native_exit_code()), "", ""};
}

TemporaryFolder::TemporaryFolder() {
  std::random_device random;
  do path_ = fs::temp_directory_path() / ("first-contact-" + std::to_string(random()));
  while (!fs::create_directory(path_));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Chapter> all_chapters() {
  std::vector<Chapter> chapters;
  for (const auto& entry : fs::directory_iterator(fs::path(first_contact::places::source) / "chapters")) {
    const std::string name = entry.path().filename().string();
    if (name.size() > 3 && name[2] == '_') chapters.push_back({name, name.substr(3)});
  }
  std::sort(chapters.begin(), chapters.end(),
            [](const auto& a, const auto& b) { return a.folder < b.folder; });
  return chapters;
}
