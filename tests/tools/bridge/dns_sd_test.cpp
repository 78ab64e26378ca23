// geminga-bridge dns-sd between a daemon and a real avahi-daemon, and a stranger on the same link.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* avahi = "/usr/sbin/avahi-daemon";
constexpr const char* bus = "/usr/bin/dbus-daemon";
constexpr const char* browse = "/usr/bin/avahi-browse";

/// A host's own bus and avahi-daemon, in a mount namespace whose /run is empty.
class Avahi {
 public:
  Avahi(const Lab& lab, std::size_t host, const std::string& folder)
      : lab_(lab), host_(host), folder_(folder + "host" + std::to_string(host)) {
    std::filesystem::create_directory(folder_);
    std::ofstream(folder_ + "/bus.conf")
        << "<!DOCTYPE busconfig PUBLIC \"-//freedesktop//DTD D-BUS Bus Configuration 1.0//EN\" "
           "\"http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd\"><busconfig><type>system</type><listen>"
        << address()
        << "</listen><auth>EXTERNAL</auth><policy context=\"default\"><allow send_destination=\"*\"/><allow "
           "receive_sender=\"*\"/><allow own=\"*\"/><allow user=\"*\"/></policy></busconfig>";
    configure();
    start_bus();
    start_avahi();
  }
  /// Holds from the next start. `server`: more lines of the section [server].
  void configure(const std::string& server = "") {
    std::ofstream(folder_ + "/avahi.conf") << "[server]\nhost-name=host" << host_ << "\nuse-ipv6=no\n"
                                           << server << "[publish]\npublish-hinfo=no\npublish-workstation=no\n";
  }
  void start_bus() {
    std::filesystem::remove(folder_ + "/bus");
    bus_ = std::make_unique<Process>(
        start({bus, "--config-file=" + folder_ + "/bus.conf", "--nofork", "--print-address=1"}));
    ASSERT_TRUE(bus_->wait_for("unix:path=")) << bus_->said();
  }
  void start_avahi() {
    avahi_ = std::make_unique<Process>(
        start({"/bin/sh", "-c",
               "exec unshare -m /bin/sh -c 'mount -t tmpfs tmpfs /run && mkdir /run/avahi-daemon && exec " +
                   std::string(avahi) + " -f " + folder_ + "/avahi.conf --no-drop-root --no-rlimits --no-chroot'"}));
    ASSERT_TRUE(avahi_->wait_for("Server startup complete")) << avahi_->said();
  }
  void stop_avahi() { avahi_.reset(); }
  void stop_bus() { bus_.reset(); }

  /// A program on this host that finds this bus.
  [[nodiscard]] Process::Start start(std::vector<std::string> words) const {
    Process::Start start = lab_.on(host_, std::move(words));
    start.environment["DBUS_SYSTEM_BUS_ADDRESS"] = address();
    return start;
  }

 private:
  [[nodiscard]] std::string address() const { return "unix:path=" + folder_ + "/bus"; }

  const Lab& lab_;
  std::size_t host_;
  std::string folder_;
  std::unique_ptr<Process> bus_;
  std::unique_ptr<Process> avahi_;
};

/// A message of multicast DNS (RFC 6762) that a hostile host may send.
class Message {
 public:
  /// `from`: labels with dots between them. `to`: labels that may be any octets.
  Message& pointer(const std::string& from, const std::vector<std::string>& to) { return record(from, 12, name(to)); }
  Message& service(const std::string& from, std::uint16_t port, const std::string& host) {
    return record(from, 33, std::string(4, '\0') + number(port) + name(split(host)));
  }
  Message& text(const std::string& from) { return record(from, 16, std::string(1, '\0')); }
  /// `address`: numeric, of either family.
  Message& address(const std::string& from, const std::string& address) {
    const bool is_ipv6 = address.contains(':');
    std::string data(is_ipv6 ? sizeof(in6_addr) : sizeof(in_addr), '\0');
    EXPECT_EQ(::inet_pton(is_ipv6 ? AF_INET6 : AF_INET, address.c_str(), data.data()), 1);
    return record(from, is_ipv6 ? 28 : 1, data);
  }
  [[nodiscard]] std::string octets() const {
    std::string head("\0\0\x84\0\0\0\0\0\0\0\0\0", 12);
    head[7] = static_cast<char>(answers_);
    return head + octets_;
  }

 private:
  Message& record(const std::string& owner, std::uint16_t type, const std::string& data) {
    const std::string one_hour("\0\0\x0e\x10", 4);
    octets_ += name(split(owner)) + number(type) + number(1 /* IN */) + one_hour +
               number(static_cast<std::uint16_t>(data.size())) + data;
    ++answers_;
    return *this;
  }
  static std::string number(std::uint16_t value) {
    return {static_cast<char>(value >> 8), static_cast<char>(value & 0xff)};
  }
  static std::string name(const std::vector<std::string>& labels) {
    std::string octets;
    for (const std::string& label : labels) octets += static_cast<char>(label.size()) + label;
    return octets + '\0';
  }
  static std::vector<std::string> split(const std::string& name) {
    std::vector<std::string> labels(1);
    for (const char octet : name) {
      if (octet == '.') {
        labels.emplace_back();
      } else {
        labels.back() += octet;
      }
    }
    return labels;
  }

  std::string octets_;
  int answers_ = 0;
};

/// Sends from the port of multicast DNS, as Avahi wants it.
void send_to_all(const std::vector<Message>& messages) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEPORT, &yes, sizeof yes);
  const unsigned char far = 255;
  ::setsockopt(socket, IPPROTO_IP, IP_MULTICAST_TTL, &far, sizeof far);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(5353);
  EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
  ip_mreqn interface{};
  ::inet_pton(AF_INET, "10.47.17.2", &interface.imr_address);
  ::setsockopt(socket, IPPROTO_IP, IP_MULTICAST_IF, &interface, sizeof interface);
  ::inet_pton(AF_INET, "224.0.0.251", &place.sin_addr);
  for (const Message& message : messages) {
    const std::string octets = message.octets();
    EXPECT_EQ(
        ::sendto(socket, octets.data(), octets.size(), 0, reinterpret_cast<const sockaddr*>(&place), sizeof place),
        static_cast<ssize_t>(octets.size()));
  }
  ::close(socket);
}

class DnsSd : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* needed : {avahi, bus, browse, "/usr/bin/unshare"}) {
      if (::access(needed, X_OK) != 0) GTEST_SKIP() << needed << " is not installed";
    }
    if (!lab_.has_namespaces()) GTEST_SKIP() << "no network namespaces can be made";
    ours_ = std::make_unique<Avahi>(lab_, 0, folder_.path(""));
    theirs_ = std::make_unique<Avahi>(lab_, 1, folder_.path(""));
    start_daemon();
    start_bridge();
    module_ = std::make_unique<Talk>(lab_.talk(0));
  }
  void start_daemon() {
    lab_.start(0, {"--ontology", GEMINGA_SOURCE_DIR "/ontology/core.ttl", "--ontology",
                   GEMINGA_SOURCE_DIR "/ontology/dns-sd.ttl"});
  }
  void start_bridge(const std::vector<std::string>& flags = {}) {
    std::vector<std::string> words{program("geminga-bridge"), "dns-sd"};
    words.insert(words.end(), flags.begin(), flags.end());
    bridge_ = std::make_unique<Process>(ours_->start(words));
    ASSERT_TRUE(bridge_->wait_for("Avahi is there")) << bridge_->said();
  }
  std::unique_ptr<Process> offer(const std::string& name, const std::string& type, const std::string& port,
                                 const std::string& txt) {
    return std::make_unique<Process>(theirs_->start({"/usr/bin/avahi-publish", "-s", name, type, port, txt}));
  }
  /// Waits until the daemon has a publication with all these words, or has none.
  bool knows(const std::vector<std::string>& words, bool is_there = true) {
    if (bridge_) bridge_->listen();
    Talk asker = lab_.talk(0);
    return asker.wait_until("services", [&](const std::vector<std::string>& lines) {
      const bool found = std::ranges::any_of(lines, [&](const std::string& line) {
        return std::ranges::all_of(words, [&](const auto& word) { return line.contains(word); });
      });
      return found == is_there;
    });
  }
  /// Waits until another host sees a text in our services, or sees it no more.
  bool others_see(const std::string& text, bool is_there = true) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      const Ran ran = run(theirs_->start({browse, "-rtp", "_geminga._udp"}));
      if (ran.said.contains(text) == is_there) return true;
    }
    return false;
  }

  Folder folder_;
  Lab lab_{2};
  std::unique_ptr<Avahi> ours_;
  std::unique_ptr<Avahi> theirs_;
  std::unique_ptr<Process> bridge_;
  std::unique_ptr<Talk> module_;
};

TEST_F(DnsSd, ShowsEachSideWhatTheOtherOffersAndTakesAway) {
  module_->say(
      "1 pub create mode=otm/stream concept=geminga:Image representation=geminga:BinaryRecord port=5000 rate=30");
  auto printer = offer("Laser Jet", "_ipp._tcp", "631", "rp=printers/x");
  const auto unknown = offer("Thing", "_thing._udp", "7", "a=b");
  EXPECT_TRUE(knows({"concept=dns:Printing", "port=631", "address=10.47.17.2", "dns.name=\"Laser Jet\"",
                     "dns.txt.rp=printers/x", "protocol=dns-sd"}));
  EXPECT_TRUE(knows({"text=_thing._udp", "port=7"}));
  EXPECT_TRUE(others_see("\"representation=geminga:BinaryRecord\""));
  EXPECT_TRUE(others_see("\"concept=geminga:Image\""));
  EXPECT_TRUE(knows({"text=_geminga"}, false)) << "our own do not come back";
  printer.reset();
  EXPECT_TRUE(knows({"dns:Printing"}, false));
  module_->say("1 pub remove");
  EXPECT_TRUE(others_see("geminga:Image", false));
  bridge_->signal(SIGTERM);
  EXPECT_EQ(bridge_->wait(), 0);
  EXPECT_TRUE(knows({"_thing._udp"}, false));
}

TEST_F(DnsSd, HealsWhenAvahiTheBusAndTheDaemonCameBack) {
  module_->say("1 pub create mode=otm/stream concept=geminga:Image port=5000");
  const auto printer = offer("Laser Jet", "_ipp._tcp", "631", "rp=x");
  EXPECT_TRUE(knows({"dns:Printing"}));
  ours_->stop_avahi();
  EXPECT_TRUE(bridge_->wait_for("Avahi is away")) << bridge_->said();
  EXPECT_TRUE(knows({"dns:Printing"}, false)) << "nothing is left of what nobody vouches for";
  ours_->stop_bus();
  ours_->start_bus();
  ours_->start_avahi();
  EXPECT_TRUE(knows({"dns:Printing"})) << bridge_->said();
  EXPECT_TRUE(others_see("geminga:Image"));
  lab_.daemon(0).signal(SIGKILL);
  EXPECT_EQ(lab_.daemon(0).wait(), 128 + SIGKILL);
  EXPECT_TRUE(others_see("geminga:Image", false));
  start_daemon();
  EXPECT_TRUE(knows({"dns:Printing"})) << bridge_->said();
}

TEST_F(DnsSd, AnnouncesAServiceThatAvahiRefusedOnceThereIsRoomForIt) {
  bridge_.reset();
  ours_->stop_avahi();
  ours_->configure("objects-per-client-max=1\n");
  ours_->start_avahi();
  start_bridge({"--only", "out"});
  module_->say("1 pub create mode=otm/stream text=first-lamp port=5000");
  EXPECT_TRUE(others_see("first-lamp")) << bridge_->said();
  module_->say("2 pub create mode=otm/stream text=second-lamp port=5001");
  EXPECT_TRUE(bridge_->wait_for("services of ours that Avahi refused")) << bridge_->said();
  module_->say("1 pub remove");
  EXPECT_TRUE(others_see("second-lamp")) << bridge_->said();
}

TEST_F(DnsSd, TakesTheIpv4AddressOfAHostWhoseIpv6AddressOfTheLinkCameFirst) {
  Message first;
  first.pointer("_cam._tcp.local", {"Camera", "_cam", "_tcp", "local"})
      .service("Camera._cam._tcp.local", 80, "c.local");
  first.text("Camera._cam._tcp.local").address("c.local", "fe80::1");
  Message then;
  then.address("c.local", "10.47.17.2");
  start_bridge({"--type", "_cam._tcp"});
  lab_.visit(1, [&] { send_to_all({first}); });
  EXPECT_TRUE(bridge_->wait_for("without an address that others can use")) << bridge_->said();
  lab_.visit(1, [&] { send_to_all({then}); });
  EXPECT_TRUE(knows({"text=_cam._tcp", "address=10.47.17.2", "port=80"})) << bridge_->said();
}

TEST_F(DnsSd, TakesNoHarmFromNamesThatAreNoTextAndFromAFlood) {
  std::vector<Message> messages;
  Message bad;
  bad.pointer("_services._dns-sd._udp.local", {"_bad", "_tcp", "local"});
  bad.pointer("_services._dns-sd._udp.local", {"_\xff\xfe", "_tcp", "local"});
  bad.pointer("_services._dns-sd._udp.local", {"no type", "_tcp", "local"});
  bad.pointer("_bad._tcp.local", {"\xff\xfe\xfd", "_bad", "_tcp", "local"});
  bad.pointer("_bad._tcp.local", {"\x1b[2J\x01", "_bad", "_tcp", "local"});
  bad.pointer("_bad._tcp.local", {std::string(63, 'n'), "_bad", "_tcp", "local"});
  messages.push_back(bad);
  for (int i = 0; i < 100; ++i) {
    Message flood;
    for (int k = 0; k < 8; ++k) {
      const std::string number = std::to_string(8 * i + k);
      flood.pointer("_services._dns-sd._udp.local", {"_t" + number, "_tcp", "local"});
      flood.pointer("_bad._tcp.local", {"flood " + number, "_bad", "_tcp", "local"});
    }
    messages.push_back(flood);
  }
  lab_.visit(1, [&] { send_to_all(messages); });
  EXPECT_TRUE(bridge_->wait_for("types over the limit")) << bridge_->said();
  EXPECT_THAT(bridge_->said(), Not(HasSubstr("\x1b")));
  bridge_.reset();
  start_bridge({"--type", "_bad._tcp"});
  const auto printer = offer("Laser Jet", "_bad._tcp", "631", "rp=x");
  EXPECT_TRUE(knows({"text=_bad._tcp", "port=631"})) << bridge_->said();
}

}  // namespace
}  // namespace geminga::system
