#include "query/ontology_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "query/command.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

namespace fs = std::filesystem;

constexpr const char* ontology_program = "geminga-ontology";

std::string path_of_program() {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / ontology_program;
  return !error && fs::exists(beside, error) ? beside.string() : ontology_program;
}

/// All that comes through a pipe until its end; what is beyond `most` octets is read and thrown away.
std::string read_all(int from, std::size_t most) {
  std::string text;
  std::array<char, 4096> piece{};
  for (ssize_t size = 0; (size = ::read(from, piece.data(), piece.size())) != 0;) {
    if (size < 0 && errno != EINTR) break;
    if (size > 0 && text.size() < most) text.append(piece.data(), static_cast<std::size_t>(size));
  }
  return text;
}

/// A child with these words, whose number is -1 where it could not be started, which is said on standard error.
pid_t spawned(std::vector<std::string> command, const posix_spawn_file_actions_t& actions) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int failed = ::posix_spawnp(&pid, arguments.front(), &actions, nullptr, arguments.data(), environ);
  if (failed == 0) return pid;
  shell::complain(program, "cannot start " + command.front() + ": " + std::generic_category().message(failed));
  return -1;
}

/// The exit status of a child; -1: it did not end by itself, or there is none.
int status_of(pid_t pid) {
  if (pid < 0) return -1;
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The standard output of a program that ended with 0; nothing where it did not.
std::optional<std::string> output_of(std::vector<std::string> command, std::size_t most_bytes) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    shell::complain(program, "no pipe: " + std::generic_category().message(errno));
    return std::nullopt;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const pid_t pid = spawned(std::move(command), actions);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string text;
  if (pid >= 0) text = read_all(ends[0], most_bytes);
  ::close(ends[0]);
  return status_of(pid) == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

std::optional<std::string> ask_ontology_program(const std::string& command, const std::string& file,
                                                const std::vector<std::string>& ontologies, std::size_t most_bytes) {
  std::error_code error;
  // Absolute, so that no path looks like a flag.
  std::vector<std::string> words{path_of_program(), command, fs::absolute(file, error).string()};
  for (const std::string& one : ontologies) {
    if (fs::exists(one, error)) words.push_back(fs::absolute(one, error).string());
  }
  return output_of(std::move(words), most_bytes);
}

int run_ontology_program(std::vector<std::string> words, const std::string& output) {
  words.insert(words.begin(), path_of_program());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const pid_t pid = spawned(std::move(words), actions);
  posix_spawn_file_actions_destroy(&actions);
  return status_of(pid);
}

}  // namespace geminga::query
