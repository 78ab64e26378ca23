// Standard output and standard error go through files, so that nothing can block.
#include "tools/ontology/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

namespace geminga::ontology {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Program::Program() {
  std::string name = (std::filesystem::temp_directory_path() / "geminga-ontology-test-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) folder_ = name;
  std::filesystem::create_directory(folder_ / "in");
}

Program::~Program() {
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
}

Outcome Program::run(const std::vector<std::string>& arguments) const {
  const std::string program = std::string(GEMINGA_BINARY_DIR) + "/bin/geminga-ontology";
  const std::string out = (folder_ / "stdout").string();
  const std::string err = (folder_ / "stderr").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, (folder_ / "in").c_str());
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  Outcome outcome;
  if (posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ) == 0) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  }
  posix_spawn_file_actions_destroy(&actions);
  outcome.out = content_of(out);
  outcome.err = content_of(err);
  return outcome;
}

void Program::write(const std::string& name, std::string_view content) const {
  const std::filesystem::path path = folder_ / "in" / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << content;
}

void Program::turtle(const std::string& name, std::string_view content) const {
  write(name,
        "@prefix : <http://e/> . @prefix e: <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n" +
            std::string(content));
}

std::string Program::read(const std::string& name) const { return content_of(folder_ / "in" / name); }

std::string shipped() { return std::string(GEMINGA_SOURCE_DIR) + "/ontology"; }

}  // namespace geminga::ontology
