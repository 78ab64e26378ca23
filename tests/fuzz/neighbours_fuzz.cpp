// Any sequence of datagrams, pauses and lost interfaces: the table of neighbours keeps its limits, and a registry that
// makes all its changes in order has exactly the services that the table counts.
//
// A step is an octet for the kind and the source, an octet for the time since the last step, and for a datagram its
// size in two octets, the low one first, and its octets.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace {

using namespace geminga;
using namespace geminga::membership;

void require(bool condition) {
  if (!condition) std::abort();
}

constexpr ParticipantId ourselves{0x0a0b0c0d};
constexpr announcement::BootNonce our_life{0x1234};

/// The longest time that a neighbour is kept without a sign of life.
base::Duration longest_patience() { return patience(announcement::max_interval, {.loss = 1}); }

/// The octets of the input, one after the other.
class Input {
 public:
  explicit Input(std::span<const std::byte> octets) : octets_(octets) {}

  [[nodiscard]] bool is_empty() const { return octets_.empty(); }
  std::uint8_t octet() {
    if (octets_.empty()) return 0;
    const auto first = std::to_integer<std::uint8_t>(octets_.front());
    octets_ = octets_.subspan(1);
    return first;
  }
  std::span<const std::byte> datagram() {
    const std::size_t low = octet();
    const std::size_t said = low + (std::size_t{octet()} << 8);
    const auto datagram = octets_.first(std::min(said, octets_.size()));
    octets_ = octets_.subspan(datagram.size());
    return datagram;
  }

 private:
  std::span<const std::byte> octets_;
};

/// The services of a registry that makes all changes.
class Registry {
 public:
  void operator()(const PutPublication& put) { publications_[put.key.participant].insert(number(put.key)); }
  void operator()(const PutSubscription& put) { subscriptions_[put.key.participant].insert(number(put.key)); }
  void operator()(const RemovePublication& gone) {
    require(publications_[gone.key.participant].erase(number(gone.key)) == 1);
  }
  void operator()(const RemoveSubscription& gone) {
    require(subscriptions_[gone.key.participant].erase(number(gone.key)) == 1);
  }
  void operator()(const RemoveParticipant& gone) {
    publications_.erase(gone.participant);
    subscriptions_.erase(gone.participant);
  }

  /// Whether it has the services that the table counts, and no others.
  void check(const NeighbourTable& table) {
    std::size_t services = 0;
    table.neighbours().for_each([&](const Neighbour& neighbour) {
      require(publications_[neighbour.id].size() == neighbour.publications);
      require(subscriptions_[neighbour.id].size() == neighbour.subscriptions);
      require(neighbour.publications + neighbour.subscriptions <= announcement::max_services_per_participant);
      services += neighbour.publications + neighbour.subscriptions;
    });
    for (const auto& [participant, numbers] : publications_)
      require(numbers.empty() || table.neighbours().is_known(participant));
    for (const auto& [participant, numbers] : subscriptions_)
      require(numbers.empty() || table.neighbours().is_known(participant));
    require(services <=
            announcement::max_remote_services + announcement::reserved_services * announcement::max_participants);
  }

 private:
  using Numbers = std::set<std::pair<PeerId, std::uint32_t>>;
  static Numbers::value_type number(const ServiceKey& key) { return {key.peer, key.number}; }

  std::map<ParticipantId, Numbers> publications_;
  std::map<ParticipantId, Numbers> subscriptions_;
};

/// The answers that we would send about others can be encoded and decoded.
void check_report(NeighbourTable& table, base::Instant now) {
  Report report = table.report(now);
  announcement::Announcement presence;
  presence.kind = announcement::Kind::presence;
  presence.participant = ourselves;
  presence.boot = our_life;
  presence.witness = std::move(report.witness);
  presence.lacks = std::move(report.lacks);
  presence.doubts = std::move(report.doubts);
  const auto datagrams = announcement::encode(presence);
  require(datagrams.size() == 1 && announcement::decode(datagrams.front()).has_value());
}

void check_table(NeighbourTable& table, Registry& registry, base::Instant now) {
  for (const Change& change : table.take_changes()) std::visit(registry, change);
  registry.check(table);
  require(table.neighbours().size() <= announcement::max_participants && !table.neighbours().is_known(ourselves));
  table.neighbours().for_each([&](const Neighbour& neighbour) {
    require(neighbour.paths.size() <= announcement::max_paths);
    require(neighbour.deadline <= now + longest_patience());
  });
  if (const auto loss = table.neighbours().loss()) require(*loss >= 0 && *loss < 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  Input input(std::as_bytes(std::span(octets, size)));
  NeighbourTable table("default");
  table.set_secret(7);
  table.set_self(ourselves, our_life);
  Registry registry;
  base::Instant now{std::chrono::hours(1)};
  while (!input.is_empty()) {
    const std::uint8_t what = input.octet();
    now += std::chrono::milliseconds(10) * input.octet();
    table.expire(now);
    require(table.next_deadline() > now);
    const env::InterfaceIndex interface{1U + (what & 1U)};
    const std::string source = "10.0.0." + std::to_string(1 + ((what >> 1) & 3U));
    switch (what >> 5) {
      case 6:
        check_report(table, now);
        break;
      case 7:
        table.forget_interface(interface);
        break;
      default:
        if (const auto heard = announcement::decode(input.datagram())) {
          (void)table.hear(*heard, {interface, "eth0", source, now});
        }
    }
    check_table(table, registry, now);
  }
  // Every silent neighbour is dropped.
  now += longest_patience();
  table.expire(now);
  check_table(table, registry, now);
  require(table.neighbours().size() == 0);
  return 0;
}
