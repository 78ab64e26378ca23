#include "system/container.hpp"

#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace geminga::system {
namespace {

constexpr const char* bridge_network = "172.18.0.0/16";
constexpr const char* address_on_bridge = "172.18.0.2";
constexpr const char* address_on_network = "10.47.17.101";

/// Runs a line of words in the namespace that this thread is in.
void command(const std::string& line) {
  std::istringstream input(line);
  std::vector<std::string> words;
  for (std::string word; input >> word;) words.push_back(word);
  const Ran ran = run({.words = std::move(words), .environment = {}, .before = {}});
  if (ran.status != 0) throw std::runtime_error("container: " + line + ": " + ran.said);
}

void ip(const std::string& line) { command("/bin/ip " + line); }
void nft(const std::string& rules) {
  const Ran ran = run({.words = {"/usr/sbin/nft", rules}, .environment = {}, .before = {}});
  if (ran.status != 0) throw std::runtime_error("container: " + rules + ": " + ran.said);
}

int here() { return ::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC); }
std::string place_of(int space) { return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(space); }

}  // namespace

Container::Container(const Lab& lab, std::size_t host, Way way) : lab_(lab), host_(host), way_(way) {
  lab.visit(host, [this] {
    if (::unshare(CLONE_NEWNET) != 0) throw std::runtime_error("container: unshare");
    namespace_ = here();
  });
  if (way == Way::bridge) {
    join_bridge();
  } else {
    join_network();
  }
}

Container::~Container() { ::close(namespace_); }

void Container::join_bridge() {
  lab_.visit(host_, [this] {
    ip("link add inside type bridge");
    ip("address add 172.18.0.1/16 dev inside");
    ip("link set inside up");
    ip("link add container0 type veth peer name eth0 netns " + place_of(namespace_));
    ip("link set container0 master inside up");
    std::ofstream("/proc/sys/net/ipv4/ip_forward") << 1;
    nft("add table ip nat; add chain ip nat out { type nat hook postrouting priority 100; }; "
        "add chain ip nat in { type nat hook prerouting priority -100; }; add rule ip nat out ip saddr " +
        std::string(bridge_network) + " oifname != \"inside\" masquerade");
  });
  visit([] {
    ip("link set lo up");
    ip("address add " + std::string(address_on_bridge) + "/16 dev eth0");
    ip("link set eth0 up");
    ip("route add default via 172.18.0.1");
  });
}

void Container::join_network() {
  lab_.visit(host_, [this] {
    ip("link add link wlan0 name own0 type macvlan mode bridge");
    ip("link set own0 netns " + place_of(namespace_));
  });
  visit([] {
    ip("link set lo up");
    ip("link set own0 name eth0");
    ip("address add " + std::string(address_on_network) + "/24 dev eth0");
    ip("link set eth0 up");
  });
}

void Container::visit(const std::function<void()>& action) const {
  lab_.visit(host_, [&] {
    if (::setns(namespace_, CLONE_NEWNET) != 0) throw std::runtime_error("container: setns");
    action();
  });
}

Process::Start Container::on(std::vector<std::string> words) const {
  return {.words = std::move(words), .environment = {}, .before = [space = namespace_] {
            if (::setns(space, CLONE_NEWNET) != 0) std::_Exit(1);
          }};
}

Talk Container::talk() const {
  std::optional<Talk> talk;
  visit([&] { talk.emplace("127.0.0.1", std::uint16_t{4717}); });
  return std::move(*talk);
}

std::string Container::address() const { return way_ == Way::bridge ? address_on_bridge : address_on_network; }

void Container::publish(std::uint16_t port, const std::string& protocol) const {
  lab_.visit(host_, [&] {
    nft("add rule ip nat in fib daddr type local " + protocol + " dport " + std::to_string(port) + " dnat to " +
        address_on_bridge + ":" + std::to_string(port));
  });
}

bool Tunnel::can_be_made() { return ::access("/dev/net/tun", R_OK | W_OK) == 0; }

std::string Tunnel::address_of(std::size_t end) { return "10.99.0." + std::to_string(end + 1); }

Tunnel::Tunnel(const Lab& lab, std::size_t one, std::size_t other) {
  const std::array<std::size_t, 2> hosts{one, other};
  for (std::size_t end = 0; end < 2; ++end) {
    lab.visit(hosts[end], [&] {
      ends_[end] = ::open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
      ifreq request{};
      std::strcpy(request.ifr_name, "tun0");
      request.ifr_flags = IFF_TUN | IFF_NO_PI;
      if (::ioctl(ends_[end], TUNSETIFF, &request) != 0) throw std::runtime_error("tunnel: TUNSETIFF");
      ip("address add " + address_of(end) + " peer " + address_of(1 - end) + " dev tun0");
      ip("link set tun0 mtu 1280 multicast off up");
    });
  }
  if (::pipe2(stop_, O_CLOEXEC) != 0) throw std::runtime_error("tunnel: pipe");
  carrier_ = std::thread([this] { carry(); });
}

Tunnel::~Tunnel() {
  ::close(stop_[1]);
  carrier_.join();
  for (const int descriptor : {stop_[0], ends_[0], ends_[1]}) ::close(descriptor);
}

void Tunnel::carry() const {
  std::array<char, 2048> packet{};
  while (true) {
    std::array<pollfd, 3> waiting{pollfd{ends_[0], POLLIN, 0}, pollfd{ends_[1], POLLIN, 0}, pollfd{stop_[0], 0, 0}};
    if (::poll(waiting.data(), waiting.size(), -1) < 0) continue;
    if (waiting[2].revents != 0) return;
    for (std::size_t end = 0; end < 2; ++end) {
      if ((waiting[end].revents & POLLIN) == 0) continue;
      const ssize_t size = ::read(ends_[end], packet.data(), packet.size());
      // A packet for which the other end has no room is lost, as on any network.
      if (size > 0 && ::write(ends_[1 - end], packet.data(), static_cast<std::size_t>(size)) < 0) continue;
    }
  }
}

}  // namespace geminga::system
