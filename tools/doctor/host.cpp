#include "doctor/host.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

namespace geminga::doctor {
namespace {

namespace fs = std::filesystem;

constexpr const char* packaged_socket = "/run/geminga/gcnp";

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
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

/// Whether `iw` says that the radio of this interface saves power. False where it does not say so.
bool saves_power(const std::string& interface) {
  // The kernel allows a name of an interface to hold what a shell would read.
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!std::ranges::all_of(interface, is_plain)) return false;
  const std::string command = "iw dev " + interface + " get power_save 2>/dev/null";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(::popen(command.c_str(), "re"), &::pclose);
  std::array<char, 80> line{};
  if (!output || std::fgets(line.data(), line.size(), output.get()) == nullptr) return false;
  return std::string(line.data()).starts_with("Power save: on");
}

HostInterface& named(std::vector<HostInterface>& interfaces, const std::string& name) {
  const auto found = std::ranges::find(interfaces, name, &HostInterface::name);
  if (found != interfaces.end()) return *found;
  interfaces.emplace_back().name = name;
  return interfaces.back();
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
    if (std::string address = address_of(*one->ifa_addr); !address.empty())
      interface.addresses.push_back(std::move(address));
  }
  for (HostInterface& interface : interfaces) {
    const fs::path folder = fs::path("/sys/class/net") / interface.name;
    const std::string mtu = content_of(folder / "mtu");
    std::from_chars(mtu.data(), mtu.data() + mtu.size(), interface.mtu);
    std::error_code ignored;
    interface.is_wireless = fs::exists(folder / "wireless", ignored) || fs::exists(folder / "phy80211", ignored);
    interface.saves_power = interface.is_wireless && saves_power(interface.name);
  }
  return interfaces;
}

/// The gemingad processes that share our network; those of other network namespaces do not matter here.
std::vector<RunningDaemon> daemons_of_host() {
  std::vector<RunningDaemon> daemons;
  std::error_code error;
  const fs::path own_network = fs::read_symlink("/proc/self/ns/net", error);
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    RunningDaemon daemon;
    const auto [rest, problem] = std::from_chars(name.data(), name.data() + name.size(), daemon.process);
    if (problem != std::errc() || rest != name.data() + name.size()) continue;
    if (content_of(entry->path() / "comm") != "gemingad\n") continue;
    std::error_code ignored;
    const fs::path network = fs::read_symlink(entry->path() / "ns/net", ignored);
    if (!network.empty() && network != own_network) continue;
    daemon.command = content_of(entry->path() / "cmdline");
    std::ranges::replace(daemon.command, '\0', ' ');
    while (daemon.command.ends_with(' ')) daemon.command.pop_back();
    daemons.push_back(std::move(daemon));
  }
  std::ranges::sort(daemons, {}, &RunningDaemon::process);
  return daemons;
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
  return host;
}

}  // namespace geminga::doctor
