#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// How a run of a program ended.
struct Run {
  int status;
  std::string out;
  std::string err;
};

/// Runs a chapter's executable as a user would, in the given folder.
Run run_program(const std::string& name, const std::vector<std::string>& arguments,
                const std::filesystem::path& folder = std::filesystem::temp_directory_path());

/// Runs a command of the system; one that is not found says nothing, with status 127.
Run run_command(const std::string& name, const std::vector<std::string>& arguments);

/// Runs it with another value of an environment variable.
Run run_with(const std::string& variable, const std::string& value, const std::string& name,
             const std::vector<std::string>& arguments);

/// Runs it with its standard output in a file or a device.
Run run_into(const std::string& file, const std::string& name, const std::vector<std::string>& arguments);

/// Runs it with other values of environment variables, and sends it a signal two seconds later; the status is
/// the signal that it ended by.
Run run_stopped(int signal, const std::map<std::string, std::string>& variables, const std::string& name,
                const std::vector<std::string>& arguments);

/// A new, empty folder, removed with all its content at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// All of a file; empty if there is none.
std::string content_of(const std::filesystem::path& file);

/// The chapters and their programs: {"01_plane", "plane"} ...
struct Chapter {
  std::string folder;
  std::string program;
};
std::vector<Chapter> all_chapters();
