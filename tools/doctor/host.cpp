#include "doctor/host.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "doctor/command_output.hpp"

namespace geminga::doctor {
namespace {

namespace fs = std::filesystem;

constexpr const char* packaged_socket = "/run/geminga/gcnp";

/// The whole file; what was read of it where it cannot be read to its end, as of a process that ends meanwhile. The
/// iterators of a stream's buffer would throw there.
std::string content_of(const fs::path& file) {
  const std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

/// The text of an address without its scope; empty for what is neither IPv4 nor IPv6.
std::string address_of(const sockaddr& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  const void* number = nullptr;
  if (address.sa_family == AF_INET) number = &reinterpret_cast<const sockaddr_in&>(address).sin_addr;
  if (address.sa_family == AF_INET6) number = &reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
  if (number == nullptr || ::inet_ntop(address.sa_family, number, text.data(), text.size()) == nullptr) return "";
  return text.data();
}

/// The length of the prefix of an IPv4 netmask.
int length_of(const sockaddr& mask) {
  return std::popcount(reinterpret_cast<const sockaddr_in&>(mask).sin_addr.s_addr);
}

/// Whether `iw` says that the radio of this interface saves power. False where it does not say so.
bool saves_power(const std::string& interface) {
  // The kernel allows a name of an interface to hold what a shell would read.
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!std::ranges::all_of(interface, is_plain)) return false;
  const auto said = output_of("iw dev " + interface + " get power_save");
  return said && said->starts_with("Power save: on");
}

HostInterface& named(std::vector<HostInterface>& interfaces, const std::string& name) {
  const auto found = std::ranges::find(interfaces, name, &HostInterface::name);
  if (found != interfaces.end()) return *found;
  interfaces.emplace_back().name = name;
  return interfaces.back();
}

/// Octets of a packet on this interface; 0 where the kernel does not tell. Asked of the kernel and not of /sys, which
/// may show another network namespace.
std::size_t mtu_of(const std::string& interface) {
  ifreq request{};
  if (interface.size() >= sizeof request.ifr_name) return 0;
  interface.copy(request.ifr_name, interface.size());
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return 0;
  const bool is_told = ::ioctl(socket, SIOCGIFMTU, &request) == 0;
  ::close(socket);
  return is_told && request.ifr_mtu > 0 ? static_cast<std::size_t>(request.ifr_mtu) : 0;
}

/// The kernel's rp_filter of an interface: '0', '1' (strict) or '2' (loose); the greater of this and that of `all` is
/// in force (Documentation/networking/ip-sysctl.rst of Linux).
char reverse_path(const std::string& interface) {
  const std::string text = content_of("/proc/sys/net/ipv4/conf/" + interface + "/rp_filter");
  return text.empty() ? '0' : text.front();
}

std::vector<HostInterface> interfaces_of_host() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(list, &::freeifaddrs);
  std::vector<HostInterface> interfaces;
  for (const ifaddrs* one = list; one != nullptr; one = one->ifa_next) {
    HostInterface& interface = named(interfaces, one->ifa_name);
    interface.is_up = (one->ifa_flags & IFF_UP) != 0;
    interface.has_carrier = (one->ifa_flags & IFF_RUNNING) != 0;
    interface.can_multicast = (one->ifa_flags & IFF_MULTICAST) != 0;
    interface.is_loopback = (one->ifa_flags & IFF_LOOPBACK) != 0;
    if (one->ifa_addr == nullptr) continue;
    if (std::string address = address_of(*one->ifa_addr); !address.empty()) {
      if (one->ifa_addr->sa_family == AF_INET && one->ifa_netmask != nullptr)
        interface.networks.push_back(address + '/' + std::to_string(length_of(*one->ifa_netmask)));
      interface.addresses.push_back(std::move(address));
    }
  }
  for (HostInterface& interface : interfaces) {
    const fs::path folder = fs::path("/sys/class/net") / interface.name;
    interface.mtu = mtu_of(interface.name);
    std::error_code ignored;
    interface.is_wireless = fs::exists(folder / "wireless", ignored) || fs::exists(folder / "phy80211", ignored);
    interface.is_strict = std::max(reverse_path("all"), reverse_path(interface.name)) == '1';
    interface.saves_power = interface.is_wireless && saves_power(interface.name);
  }
  return interfaces;
}

/// The network namespace of a process: the inode of a file that each namespace has of its own. Unlike /proc/PID/ns/net
/// it can be read of others' processes. 0: there is none, as of a process that ends.
ino_t network_of(const std::string& process) {
  struct stat status{};
  return ::stat(("/proc/" + process + "/net/dev").c_str(), &status) == 0 ? status.st_ino : 0;
}

/// The parent of a process; 0: it has none. The name of the program in the file may hold blanks and brackets.
int parent_of(const std::string& process) {
  const std::string text = content_of("/proc/" + process + "/stat");
  int parent = 0;
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return parent;
  std::istringstream fields(text.substr(name_end + 1));
  char state = 0;
  fields >> state >> parent;
  return parent;
}

/// The gemingad processes that share our network; those of other network namespaces do not matter here.
std::vector<RunningDaemon> daemons_of_host() {
  std::vector<RunningDaemon> daemons;
  std::map<int, int> parents;
  const ino_t own_network = network_of("self");
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    RunningDaemon daemon;
    const auto [rest, problem] = std::from_chars(name.data(), name.data() + name.size(), daemon.process);
    if (problem != std::errc() || rest != name.data() + name.size()) continue;
    if (content_of(entry->path() / "comm") != "gemingad\n" || network_of(name) != own_network) continue;
    daemon.command = content_of(entry->path() / "cmdline");
    if (daemon.command.empty()) continue;  // it ends
    std::ranges::replace(daemon.command, '\0', ' ');
    while (daemon.command.ends_with(' ')) daemon.command.pop_back();
    parents[daemon.process] = parent_of(name);
    daemons.push_back(std::move(daemon));
  }
  // A daemon's child has its name until it becomes the program that reads ontologies.
  std::erase_if(daemons, [&](const RunningDaemon& one) { return parents.contains(parents[one.process]); });
  std::ranges::sort(daemons, {}, &RunningDaemon::process);
  return daemons;
}

/// The key files that the daemons' command lines name, and those beside the package's configuration.
std::vector<KeyFile> key_files(const std::vector<RunningDaemon>& daemons) {
  std::set<fs::path> paths;
  for (const RunningDaemon& daemon : daemons) {
    std::istringstream words(daemon.command);
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/" + std::to_string(daemon.process) + "/cwd", ignored);
    for (std::string word, value; words >> word;) {
      constexpr std::string_view flag = "--key-file";
      if (word == flag && words >> value) paths.insert(folder / value);
      if (word.starts_with(std::string(flag) + '=')) paths.insert(folder / word.substr(flag.size() + 1));
    }
  }
  std::error_code error;
  for (fs::directory_iterator entry("/etc/geminga", error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".key") paths.insert(entry->path());
  }
  std::vector<KeyFile> files;
  for (const fs::path& path : paths) {
    const fs::file_status status = fs::status(path, error);
    if (!error && fs::is_regular_file(status))
      files.push_back({.path = path, .mode = static_cast<unsigned>(status.permissions())});
  }
  return files;
}

}  // namespace

Host look_at_host() {
  Host host;
  host.interfaces = interfaces_of_host();
  host.daemons = daemons_of_host();
  std::error_code ignored;
  host.has_packaged_socket = fs::exists(packaged_socket, ignored);
  host.may_use_packaged_socket = !host.has_packaged_socket || ::access(packaged_socket, R_OK | W_OK) == 0;
  const passwd* user = ::getpwuid(::geteuid());
  host.user = user == nullptr ? std::to_string(::geteuid()) : user->pw_name;
  host.keys = key_files(host.daemons);
  host.nft_ruleset = output_of("nft -j list ruleset").value_or("");
  host.iptables_rules = output_of("iptables-save").value_or("");
  host.ip6tables_rules = output_of("ip6tables-save").value_or("");
  return host;
}

}  // namespace geminga::doctor
