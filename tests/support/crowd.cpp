// A relay with as many participants behind it as are asked for, none of which is a process: what a site of a thousand
// says to a daemon, at the cost of one program. `crowd OWN DAEMON KEY-FILE COUNT SERVICES` speaks from the address OWN
// with the daemon at DAEMON, both on port 4717, and prints `all said` when each participant has said its state.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/relaying/voucher.hpp"
#include "discovery/sealing/key_file.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga {
namespace {

using announcement::Announcement;
using announcement::Kind;
using Octets = std::vector<std::byte>;

constexpr std::uint16_t port = 4717;
constexpr env::InterfaceIndex link{1};
constexpr ParticipantId relay{0x0f000000};
constexpr base::Duration presence_spacing = std::chrono::milliseconds(500);
constexpr base::Duration answer_spacing = std::chrono::milliseconds(30);
/// Words that are said at once, each 5 ms.
constexpr std::size_t words_at_once = 8;
constexpr int pause_ms = 5;

volatile std::sig_atomic_t is_stopped = 0;

sockaddr_in place_of(const char* address) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  ::inet_pton(AF_INET, address, &place.sin_addr);
  return place;
}

class Crowd {
 public:
  Crowd(int socket, const sealing::Key& key, std::size_t count, int services)
      : socket_(socket), random_(seed), key_(key), seal_([this] { return random_.next(); }), voucher_(seal_) {
    sealing::Policy policy{.mode = sealing::Mode::encrypted};
    if (policy.keys.add(key) != sealing::Keyring::Added::yes) std::abort();
    seal_.adopt(policy, now());
    for (std::uint32_t i = 0; i < count; ++i) members_.push_back(member_of(i, services));
  }

  /// Says what is due and takes in what has come, for a pause.
  void step() {
    pollfd ready{socket_, POLLIN, 0};
    while (::poll(&ready, 1, pause_ms) > 0) hear();
    if (claims_ < 3) {
      ++claims_;
      send(header(Kind::claim));
      return;
    }
    if (claims_ == 3) {
      ++claims_;
      say_state();
    }
    for (std::size_t i = 0; i < words_at_once && said_ < members_.size(); ++i) say(said_++);
    if (said_ == members_.size() && !std::exchange(is_told_, true)) {
      std::puts("all said");
      std::fflush(stdout);
    }
    const bool is_asked = seal_.asks(now()) || seal_.is_asked(now());
    if (now() - presence_at_ >= (is_asked ? answer_spacing : presence_spacing)) say_presence();
  }

 private:
  static constexpr std::uint64_t seed = 4717;
  static base::Instant now() { return base::Instant(std::chrono::steady_clock::now().time_since_epoch()); }
  static ParticipantId id_of(std::size_t number) {
    return ParticipantId{0x10000000U + static_cast<std::uint32_t>(number)};
  }

  /// One participant of the crowd, with the numbers of its next datagram.
  struct Member {
    Announcement state;
    sealing::Session session{};
    std::uint32_t counter = 4;
  };

  Member member_of(std::uint32_t number, int services) {
    Member member{.state = {}, .session = sealing::Session(random_.next())};
    Announcement& state = member.state;
    state.group = "default";
    state.participant = id_of(number);
    state.boot = announcement::BootNonce(random_.next());
    state.link = 1;
    state.name = "r" + std::to_string(number);
    state.addresses = {"10.48." + std::to_string(number / 250) + '.' + std::to_string(number % 250 + 1)};
    state.interval = presence_spacing;
    state.revision = 1;
    announcement::PeerState& peer = state.peers.emplace_back();
    peer.id = PeerId{1};
    for (int service = 1; service <= services; ++service) {
      Publication ball;
      ball.mode = ChannelMode::one_to_many_stream;
      ball.identity = TextIdentity{service == 1 ? "ball" : "map-" + std::to_string(service)};
      ball.port = static_cast<std::uint16_t>(5000 + service);
      peer.publications.push_back({static_cast<std::uint32_t>(service), ball});
    }
    return member;
  }

  /// The next datagram of a member, which says its state.
  [[nodiscard]] Octets word_of(Member& member) const {
    member.state.sequence = ++member.counter;
    const auto text = announcement::encode(member.state).front();
    Octets word(text.size() + env::max_envelope_bytes);
    const sealing::Header header{.key = key_.id(), .session = member.session, .counter = member.counter};
    word.resize(sealing::seal(key_, header, text, word));
    return word;
  }

  Announcement header(Kind kind) {
    Announcement said;
    said.kind = kind;
    said.group = "default";
    said.participant = relay;
    said.boot = boot_;
    said.link = 1;
    said.interval = presence_spacing;
    return said;
  }

  void send(Announcement said) {
    said.sequence = sequence_;
    for (const auto& text : announcement::encode(said)) {
      if (said.kind != Kind::relayed) ++sequence_;
      const auto datagram = seal_.seal(text, link, now());
      (void)::send(socket_, datagram.data(), datagram.size(), 0);
    }
  }

  void say(std::size_t number) {
    const Octets word = word_of(members_[number]);
    if (const auto relayed = voucher_.wrap({.datagram = word, .source = "10.48.0.1"}, relay)) send(*relayed);
  }

  void say_state() {
    Announcement state = header(Kind::state);
    state.revision = 1;
    send(state);
  }

  void say_presence() {
    presence_at_ = now();
    Announcement presence = header(Kind::presence);
    presence.revision = 1;
    for (std::size_t i = 0; i < said_; ++i) presence.behind.push_back({.participant = id_of(i), .revision = 1});
    send(presence);
  }

  void hear() {
    std::array<std::byte, 2048> room{};
    const ssize_t size = ::recv(socket_, room.data(), room.size(), MSG_DONTWAIT);
    if (size <= 0) return;
    const auto opened = seal_.open(std::span(room).first(static_cast<std::size_t>(size)),
                                   {.interface = link, .interface_name = "lo", .source = "127.0.0.1", .now = now()});
    if (!opened) return;
    const auto said = announcement::decode(opened->text);
    if (!said) return;
    for (const ParticipantId id : said->lacks) {
      if (id == relay) say_state();
      const std::size_t number = std::to_underlying(id) - std::to_underlying(id_of(0));
      if (number < said_) say(number);
    }
  }

  int socket_;
  base::Random random_;
  const sealing::Key& key_;
  sealing::Seal seal_;
  relaying::Voucher voucher_;
  announcement::BootNonce boot_{random_.next()};
  std::uint64_t sequence_ = 1;
  std::vector<Member> members_;
  std::size_t said_ = 0;
  int claims_ = 0;
  bool is_told_ = false;
  base::Instant presence_at_{};
};

}  // namespace
}  // namespace geminga

int main(int argc, char** argv) {
  const std::span<char*> words(argv, static_cast<std::size_t>(argc));
  if (words.size() != 6) return 2;
  std::signal(SIGTERM, [](int) { geminga::is_stopped = 1; });
  std::ifstream file(words[3]);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto key = geminga::sealing::read_key(text);
  const sockaddr_in own = geminga::place_of(words[1]);
  const sockaddr_in daemon = geminga::place_of(words[2]);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (!key || ::bind(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 ||
      ::connect(socket, reinterpret_cast<const sockaddr*>(&daemon), sizeof daemon) != 0) {
    std::perror("crowd");
    return 2;
  }
  geminga::Crowd crowd(socket, *key, std::strtoul(words[4], nullptr, 10), std::atoi(words[5]));
  while (geminga::is_stopped == 0) crowd.step();
  return 0;
}
