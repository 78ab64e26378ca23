// geminga-bridge: starts the bridge of a kind, each of which is a program, a package and a page of the manual of its
// own.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "shell/exit_status.hpp"
#include "shell/options.hpp"
#include "shell/report.hpp"

namespace geminga::bridge {
namespace {

constexpr std::string_view program = "geminga-bridge";
constexpr std::array<std::string_view, 4> kinds{"dns-sd", "dds", "mqtt", "nats"};

constexpr const char* examples = R"(Examples:
  geminga-bridge dns-sd
  geminga-bridge dds --domain 7
  geminga-bridge dns-sd --help

Kinds:
  dns-sd   DNS-SD over multicast DNS, through avahi-daemon
  dds      the readers and writers of a DDS domain, of ROS 2 among them, by Cyclone DDS
  mqtt     announcements of daemons that no network connects, over an MQTT server
  nats     the same over a NATS server

Each kind is the program geminga-bridge-KIND of the package of that name. No bridge runs unless it is started, and the services
that it states for others end with it.

Exit status: that of the kind; 2 wrong usage, also a kind that is not installed.)";

int fail(const std::string& text) {
  shell::complain(program, text);
  return static_cast<int>(shell::ExitStatus::wrong_use);
}

/// The folder of this program, in which the kinds are, too.
std::filesystem::path own_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

/// Becomes the program of a kind. Returns where that fails.
int become(const std::string& kind, char** words) {
  if (std::ranges::find(kinds, kind) == kinds.end()) {
    std::string known;
    for (const std::string_view one : kinds) known += (known.empty() ? "" : ", ") + std::string(one);
    return fail("'" + base::printable(kind) + "' is no kind of bridge: the kinds are " + known);
  }
  const std::string name = std::string(program) + '-' + kind;
  const std::string path = own_folder() / name;
  ::execv(path.c_str(), words);
  if (errno == ENOENT) return fail("the kind " + kind + " is not installed: install the package " + name);
  return fail(path + ": " + std::strerror(errno));
}

int run(int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-' && argv[1][0] != '\0') return become(argv[1], argv + 1);
  CLI::App app("Starts a bridge between the team and the services of others.", std::string(program));
  app.footer(examples);
  std::string kind;
  std::vector<std::string> words;
  app.add_option("KIND", kind, "The kind of bridge")->required();
  app.add_option("WORDS", words, "Its flags and words: see geminga-bridge KIND --help");
  app.set_version_flag("--version", std::string(program) + " " GEMINGA_VERSION, "Print the version and exit");
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  return fail("the kind comes first: geminga-bridge KIND");
}

}  // namespace
}  // namespace geminga::bridge

int main(int argc, char** argv) { return geminga::bridge::run(argc, argv); }
