#include "support/lab.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

namespace geminga::system {
namespace {

void must(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("lab: " + what + ": " + std::strerror(errno));
}

/// The first link has the addresses 10.47.17.0/24, and each further one the next.
constexpr std::size_t first_network = 17;

constexpr const char* nft_program = "/usr/sbin/nft";

/// The bridge's end of the cable to a host.
std::string port_of(std::size_t host) { return "port" + std::to_string(host); }

/// Runs a program in the namespace that this thread is in.
void command(const std::vector<std::string>& line) {
  const Ran ran = run({.words = line, .environment = {}, .before = {}});
  std::string text;
  for (const std::string& word : line) text += ' ' + word;
  if (ran.status != 0) throw std::runtime_error("lab:" + text + ": " + ran.said);
}

void ip(const std::vector<std::string>& words) {
  std::vector<std::string> line{"/bin/ip"};
  line.insert(line.end(), words.begin(), words.end());
  command(line);
}

/// Becomes root of a user namespace of our own, once, if we are not root yet. With GEMINGA_LAB=lo in the environment
/// the answer is no, so that the other way can be tried anywhere.
bool may_make_namespaces() {
  static const bool may = [] {
    const char* way = std::getenv("GEMINGA_LAB");
    if (way != nullptr && std::string_view(way) == "lo") return false;
    const uid_t user = ::getuid();
    const gid_t group = ::getgid();
    if (::unshare(CLONE_NEWNET) == 0) return true;
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    return true;
  }();
  return may;
}

/// A TCP or UDP port on loopback that is free at this moment.
std::uint16_t free_port(int type) {
  const int socket = ::socket(AF_INET, type | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  must(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, "bind");
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length);
  ::close(socket);
  return ntohs(address.sin_port);
}

}  // namespace

struct Lab::Host {
  std::uint16_t gcnp_port = 4717;
  std::unique_ptr<Process> daemon;
};

/// The namespaces of one lab: the test's own with the bridge, and one for each host. Its descriptor holds each open.
class Lab::Namespaces {
 public:
  explicit Namespaces(std::size_t hosts) {
    must(::unshare(CLONE_NEWNET) == 0, "unshare");
    home_ = ::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
    ip({"link", "set", "lo", "up"});
    ip({"link", "add", "lab", "type", "bridge", "forward_delay", "0", "mcast_snooping", "0"});
    ip({"link", "set", "lab", "up"});
    for (std::size_t host = 0; host < hosts; ++host) add(host);
  }
  ~Namespaces() {
    for (const int descriptor : hosts_) ::close(descriptor);
    ::close(home_);
  }
  Namespaces(const Namespaces&) = delete;
  Namespaces& operator=(const Namespaces&) = delete;

  void enter(std::size_t host) const { must(::setns(hosts_.at(host), CLONE_NEWNET) == 0, "setns"); }
  void leave() const noexcept {
    if (::setns(home_, CLONE_NEWNET) != 0) std::abort();  // every later step would be on the wrong host
  }

  /// Another bridge with these hosts, and a further cable for the one between.
  void add_link(std::size_t between, const std::vector<std::size_t>& hosts) {
    const std::string number = std::to_string(++links_);
    const std::string bridge = "far" + number;
    ip({"link", "add", bridge, "type", "bridge", "forward_delay", "0", "mcast_snooping", "0"});
    ip({"link", "set", bridge, "up"});
    for (const std::size_t host : hosts) {
      ip({"link", "set", port_of(host), "master", bridge});
      enter(host);
      ip({"address", "flush", "dev", "wlan0"});
      ip({"address", "add", address_on(links_, host) + "/24", "dev", "wlan0"});
      leave();
    }
    const std::string port = "farport" + number;
    const std::string interface = "wlan" + number;
    ip({"link", "add", port, "type", "veth", "peer", "name", interface, "netns",
        "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(hosts_.at(between))});
    ip({"link", "set", port, "master", bridge, "up"});
    enter(between);
    ip({"address", "add", address_on(links_, between) + "/24", "dev", interface});
    ip({"link", "set", interface, "up"});
    leave();
  }

  static std::string address(std::size_t host) { return address_on(0, host); }

 private:
  void add(std::size_t host) {
    const std::string port = port_of(host);
    must(::unshare(CLONE_NEWNET) == 0, "unshare");
    hosts_.push_back(::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC));
    leave();
    ip({"link", "add", port, "type", "veth", "peer", "name", "wlan0", "netns",
        "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(hosts_.back())});
    ip({"link", "set", port, "master", "lab", "up"});
    enter(host);
    ip({"link", "set", "lo", "up"});
    ip({"address", "add", address(host) + "/24", "dev", "wlan0"});
    ip({"link", "set", "wlan0", "up"});
    leave();
  }

  int home_ = -1;
  std::vector<int> hosts_;
  std::size_t links_ = 0;  ///< that were added
};

Lab::Lab(std::size_t hosts) : hosts_(hosts) {
  if (may_make_namespaces()) {
    namespaces_ = std::make_unique<Namespaces>(hosts);
  } else {
    udp_port_ = free_port(SOCK_DGRAM);
    for (Host& host : hosts_) host.gcnp_port = free_port(SOCK_STREAM);
  }
  std::cerr << "This lab of " << hosts << " hosts is made of " << way() << ".\n";
}

Lab::~Lab() = default;

bool Lab::can_lose() { return may_make_namespaces() && ::access(nft_program, X_OK) == 0; }

void Lab::lose(double share) {
  const std::string percent = std::to_string(std::lround(share * 100));
  command({nft_program,
           "add table bridge air; add chain bridge air forward { type filter hook forward priority 0; }; "
           "add rule bridge air forward meta protocol { ip, ip6 } numgen random mod 100 < " +
               percent + " drop"});
}

void Lab::part(std::size_t border) {
  const auto ports = [](std::size_t begin, std::size_t end) {
    std::string names = "{ ";
    for (std::size_t host = begin; host < end; ++host) names += port_of(host) + (host + 1 < end ? ", " : " }");
    return names;
  };
  const std::string left = ports(0, border);
  const std::string right = ports(border, hosts_.size());
  command({nft_program,
           "add table bridge wall; add chain bridge wall forward { type filter hook forward priority 1; }; "
           "add rule bridge wall forward iifname " +
               left + " oifname " + right + " drop; add rule bridge wall forward iifname " + right + " oifname " +
               left + " drop"});
}

void Lab::heal() { command({nft_program, "delete table bridge wall"}); }

bool Lab::has_namespaces() const { return namespaces_ != nullptr; }

std::string Lab::way() const {
  return has_namespaces() ? "network namespaces on one bridge" : "daemons on the loopback interface, one port each";
}

Process::Start Lab::on(std::size_t host, std::vector<std::string> words) const {
  Process::Start start{.words = std::move(words), .environment = {}, .before = {}};
  if (has_namespaces()) start.before = [this, host] { namespaces_->enter(host); };
  return start;
}

void Lab::visit(std::size_t host, const std::function<void()>& action) const {
  if (!has_namespaces()) return action();
  struct Visit {
    const Namespaces& namespaces;
    ~Visit() { namespaces.leave(); }
  };
  namespaces_->enter(host);
  const Visit visit{*namespaces_};
  action();
}

void Lab::start(std::size_t host, const std::vector<std::string>& flags) {
  begin(host, flags);
  wait_until_ready(host);
}

void Lab::begin(std::size_t host, const std::vector<std::string>& flags) {
  std::vector<std::string> words{program("gemingad"), "--name", "robot" + std::to_string(host)};
  if (!has_namespaces()) {
    for (const std::string& word :
         {std::string("--interface"), std::string("lo"), std::string("--port"), std::to_string(udp_port_),
          std::string("--gcnp"), "127.0.0.1:" + std::to_string(hosts_.at(host).gcnp_port)}) {
      words.push_back(word);
    }
  }
  words.insert(words.end(), flags.begin(), flags.end());
  hosts_.at(host).daemon = std::make_unique<Process>(on(host, words));
}

void Lab::wait_until_ready(std::size_t host) {
  Process& started = daemon(host);
  const std::string ready = started.rest_of_line_with(" ready: ");
  const bool has_read = !ready.contains("ontology is being loaded") ||
                        started.wait_for_any({" is in force\n", "serving without an ontology"});
  if (ready.empty() || !has_read) throw std::runtime_error("gemingad is not ready: " + started.said());
}

void Lab::start_all(const std::vector<std::string>& flags) {
  for (std::size_t host = 0; host < hosts_.size(); ++host) start(host, flags);
}

Process& Lab::daemon(std::size_t host) { return *hosts_.at(host).daemon; }

Talk Lab::talk(std::size_t host, const std::string& address) {
  std::optional<Talk> talk;
  visit(host, [&] { talk.emplace(address, gcnp_port(host)); });
  return std::move(*talk);
}

bool Lab::wait_for_participants(std::size_t host, std::size_t count) {
  return talk(host).wait_until("participants", [&](const auto& lines) { return lines.size() == count; });
}

void Lab::cut(std::size_t host) {
  if (!has_namespaces()) return daemon(host).signal(SIGSTOP);
  visit(host, [] { ip({"link", "set", "wlan0", "down"}); });
}

void Lab::join(std::size_t host) {
  if (!has_namespaces()) return daemon(host).signal(SIGCONT);
  visit(host, [] { ip({"link", "set", "wlan0", "up"}); });
}

void Lab::keep_multicasts_from(std::size_t host) {
  ip({"link", "set", "dev", port_of(host), "type", "bridge_slave", "mcast_flood", "off"});
}

void Lab::keep_multicasts_between(std::size_t one, std::size_t other) {
  std::string rules =
      "add table bridge station; add chain bridge station forward { type filter hook forward priority 2; }; ";
  for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
    for (const char* groups : {"ip daddr 224.0.0.0/4", "ip6 daddr ff02::4717"})
      rules += "add rule bridge station forward iifname " + port_of(from) + " oifname " + port_of(to) + ' ' + groups +
               " drop; ";
  }
  command({nft_program, rules});
}

void Lab::mute(std::size_t host) {
  command({nft_program,
           "add table bridge mute; add chain bridge mute forward { type filter hook forward priority 3; }; "
           "add rule bridge mute forward iifname " +
               port_of(host) + " meta protocol { ip, ip6 } drop"});
}

void Lab::add_link(std::size_t between, const std::vector<std::size_t>& hosts) {
  namespaces_->add_link(between, hosts);
}

std::string Lab::address_on(std::size_t link, std::size_t host) {
  return "10.47." + std::to_string(first_network + link) + '.' + std::to_string(host + 1);
}

void Lab::translate(std::size_t host, const std::string& outer, const std::string& inside) {
  visit(host, [&] {
    std::ofstream("/proc/sys/net/ipv4/ip_forward") << "1";
    command({nft_program,
             "add table ip translation; "
             "add chain ip translation out { type nat hook postrouting priority srcnat; }; "
             "add rule ip translation out oifname " +
                 outer +
                 " masquerade; "
                 "add chain ip translation in { type nat hook prerouting priority dstnat; }; "
                 "add rule ip translation in iifname " +
                 outer + " udp dport 4717 dnat to " + inside});
  });
}

void Lab::route(std::size_t host, const std::string& addresses, const std::string& through) {
  visit(host, [&] { ip({"route", "add", addresses, "via", through}); });
}

void Lab::end_route(std::size_t host, const std::string& addresses) {
  visit(host, [&] { ip({"route", "delete", addresses}); });
}

void Lab::take_ipv4(std::size_t host) {
  visit(host, [] { ip({"-4", "address", "flush", "dev", "wlan0"}); });
}

std::uint16_t Lab::gcnp_port(std::size_t host) const { return hosts_.at(host).gcnp_port; }
std::uint16_t Lab::udp_port() const { return udp_port_; }
std::string Lab::interface_of(std::size_t) const { return has_namespaces() ? "wlan0" : "lo"; }
std::string Lab::address_of(std::size_t host) const {
  return has_namespaces() ? Namespaces::address(host) : "127.0.0.1";
}

}  // namespace geminga::system
