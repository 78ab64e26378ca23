// Raw system calls: the C library of Debian 12 has no wrappers for them, and its headers only the first version.
#include "env/cage/landlock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace geminga::cage {
namespace {

// <linux/landlock.h> of Linux 6.12; the numbers are the same on every architecture.
constexpr long create_ruleset = 444;
constexpr long add_rule = 445;
constexpr long restrict_self = 446;
constexpr unsigned ask_version = 1;
constexpr int rule_path_beneath = 1;
constexpr int rule_net_port = 2;  // version 4

struct Ruleset {
  std::uint64_t handled_fs = 0;
  std::uint64_t handled_net = 0;  // version 4
  std::uint64_t scoped = 0;       // version 6
};

struct NetPort {
  std::uint64_t allowed;
  std::uint64_t port;
};

struct PathBeneath {
  std::uint64_t allowed;
  std::int32_t parent;
} __attribute__((packed));

constexpr std::uint64_t bit(unsigned number) { return std::uint64_t{1} << number; }
constexpr std::uint64_t execute = bit(0);
constexpr std::uint64_t write_file = bit(1);
constexpr std::uint64_t read_file = bit(2);
constexpr std::uint64_t read_dir = bit(3);
constexpr std::uint64_t remove_folder = bit(4);
constexpr std::uint64_t remove_file = bit(5);
constexpr std::uint64_t make_folder = bit(7);
constexpr std::uint64_t make_regular = bit(8);
constexpr std::uint64_t truncate = bit(14);
constexpr std::uint64_t connect_tcp = bit(1);
/// Names are asked for over TCP where an answer is too long for UDP. The resolver knows no other port.
constexpr std::uint64_t name_server_port = 53;
constexpr std::uint64_t of_files = execute | write_file | read_file | truncate | bit(15);

/// Everything that a version can forbid of the file system.
constexpr std::uint64_t all_rights(long version) {
  if (version >= 5) return bit(16) - 1;  // ioctl of devices
  if (version >= 3) return bit(15) - 1;  // truncate
  if (version == 2) return bit(14) - 1;  // rename into another folder
  return bit(13) - 1;
}

class Rules {
 public:
  Rules(const Ruleset& ruleset, std::size_t size)
      : handled_(ruleset.handled_fs), descriptor_(static_cast<int>(::syscall(create_ruleset, &ruleset, size, 0))) {
    if (descriptor_ < 0) blame("the rules of Landlock", errno);
  }
  ~Rules() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;

  /// Allows these rights below a path. A path that leads nowhere needs none.
  void allow(const std::string& path, std::uint64_t rights) {
    const int place = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (place < 0) {
      if (!is_of_path(errno)) blame(path, errno);
      return;
    }
    struct stat status{};
    const bool is_folder = ::fstat(place, &status) == 0 && S_ISDIR(status.st_mode);
    const PathBeneath rule{rights & handled_ & (is_folder ? ~std::uint64_t{0} : of_files), place};
    // EBADFD: a pipe or a socket, which Landlock leaves open to everyone.
    const bool has_failed =
        rule.allowed != 0 && ::syscall(add_rule, descriptor_, rule_path_beneath, &rule, 0) != 0 && errno != EBADFD;
    if (has_failed) blame(path, errno);
    ::close(place);
  }

  /// Allows TCP to this port of any host.
  void allow_connections_to(std::uint64_t port) {
    const NetPort rule{connect_tcp, port};
    ::syscall(add_rule, descriptor_, rule_net_port, &rule, 0);
  }

  /// Puts the rules in force.
  RestrictedPaths enforce() {
    const bool hold = descriptor_ >= 0 && ::syscall(restrict_self, descriptor_, 0) == 0;
    return {.hold = hold, .fault = std::move(fault_)};
  }

 private:
  /// Whether an error of open() is one of the path, which the process gets again when it needs that path. Any other
  /// (EMFILE, ENFILE, ENOMEM, EIO) may be over by then.
  static bool is_of_path(int error) {
    return error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG || error == ELOOP || error == EACCES;
  }
  void blame(const std::string& path, int error) {
    if (fault_.empty()) fault_ = path + ": cannot be opened: " + std::generic_category().message(error);
  }

  std::uint64_t handled_;
  int descriptor_;
  std::string fault_;
};

}  // namespace

RestrictedPaths restrict_paths(const Freedom& freedom) {
  const long version = ::syscall(create_ruleset, nullptr, 0, ask_version);
  if (version < 1) return {};
  Ruleset ruleset;
  ruleset.handled_fs = all_rights(version);
  if (freedom.may_read_all) ruleset.handled_fs &= ~(execute | read_file | read_dir);
  if (version >= 4 && !freedom.may_talk) ruleset.handled_net = bit(2) - 1;  // bind and connect
  if (version >= 6) ruleset.scoped = bit(2) - 1;                            // abstract sockets and signals
  // A kernel refuses a structure that is longer than the one that it knows.
  const std::size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
  Rules rules(ruleset, size);
  if (is_sanitized) rules.allow("/proc", read_file | read_dir);
  for (const std::string& path : freedom.readable) rules.allow(path, read_file | read_dir);
  const std::uint64_t folders = freedom.may_make_folders ? make_folder | remove_folder : 0;
  for (const std::string& folder : freedom.writable_folders)
    rules.allow(folder, write_file | truncate | make_regular | remove_file | folders);
  for (const std::string& path : freedom.rewritable) rules.allow(path, write_file);
  for (const std::string& folder : freedom.removable_folders) rules.allow(folder, remove_file);
  if (freedom.may_serve && version >= 4) rules.allow_connections_to(name_server_port);
  return rules.enforce();
}

}  // namespace geminga::cage
