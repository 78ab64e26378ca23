#include "ontology/travel/offering.hpp"

#include <chrono>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "geminga/node.hpp"
#include "ontology/travel/candidates.hpp"
#include "ontology/travel/delivery.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::ontology {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// The name of this program among the peers of its daemon.
constexpr const char* peer_name = "ontology";
/// The longest time for which the seal that was looked at counts.
constexpr std::chrono::seconds seal_look{1};
/// The time until it is looked again whether there is room.
constexpr milliseconds between_tries{2};
/// The messages that are sent between two looks at signals and sockets.
constexpr int messages_per_turn = 16;

NamedPublication publication_of(const Parcel& parcel, NamedIdentity identity) {
  return {.identity = std::move(identity),
          .mode = ChannelMode::one_to_many_pubsub,
          .address = {},
          .port = 0,
          .protocol = "tcp",
          .priority = 0,
          .attributes = {{"digest", parcel.digest()},
                         {"version", std::to_string(parcel.manifest().version)},
                         {"files", std::to_string(parcel.manifest().files.size())},
                         {"octets", std::to_string(parcel.manifest().octets())}}};
}

/// Offers by the concept, or by its number where the daemon's ontology does not have it.
Result<Publisher, ClientError> publish(Node& node, const Parcel& parcel) {
  auto publisher = node.publish(publication_of(parcel, ConceptNames{'<' + std::string(ontology_concept) + '>', ""}));
  const bool is_unknown = !publisher && publisher.error().kind == ClientError::Kind::refused &&
                          publisher.error().code == ErrorCode::impossible;
  if (!is_unknown) return publisher;
  return node.publish(publication_of(parcel, ontology_number()));
}

/// Whether channels are sealed, looked at anew after a second.
class Seal {
 public:
  Seal(const Offering& offering, Client client) : offering_(offering), client_(std::move(client)) {}

  /// The error: they are not and must be, or the daemon does not say. A daemon that is away changes nothing.
  std::expected<void, ClientError> check() {
    if (offering_.is_open || Clock::now() < next_look_) return {};
    auto sealed = are_channels_sealed(client_);
    if (!sealed) {
      auto again = Client::connect({.connect = offering_.connect, .name = {}});
      if (!again) return {};
      client_ = std::move(*again);
      sealed = are_channels_sealed(client_);
      if (!sealed) return std::unexpected(sealed.error());
    }
    if (!*sealed) return std::unexpected(not_sealed());
    next_look_ = Clock::now() + seal_look;
    return {};
  }
  [[nodiscard]] const Welcome& welcome() const { return client_.welcome(); }

 private:
  const Offering& offering_;
  Client client_;
  Clock::time_point next_look_{};
};

/// The messages of one parcel to the consumers that there are.
class Sending {
 public:
  Sending(const Parcel& parcel, Publisher& publisher)
      : parcel_(parcel), publisher_(publisher), delivery_(parcel.pieces().size()) {}

  void tell(const ConsumerChange& change) {
    if (change.what == ConsumerChange::What::added) delivery_.add(change.life);
    if (change.what == ConsumerChange::What::removed) delivery_.remove(change.life);
  }

  /// Sends some messages. Returns the time after which to go on; nothing where nobody lacks one.
  std::optional<milliseconds> send() {
    for (int turn = 0; turn < messages_per_turn; ++turn) {
      if (!next_) next_ = delivery_.next();
      if (!next_) return std::nullopt;
      const std::string& message = next_->piece ? parcel_.pieces()[*next_->piece] : parcel_.manifest_message();
      if (!publisher_.has_room(message.size())) {
        if (!waits_since_) waits_since_ = Clock::now();
        const milliseconds patience = delivery_.is_repeating() ? repeated_piece_patience : piece_patience;
        if (Clock::now() - *waits_since_ < patience) return between_tries;
      }
      waits_since_.reset();
      const std::uint64_t left_out = publisher_.count().left_out;
      if (!publisher_.send(message)) return std::nullopt;
      if (publisher_.count().left_out != left_out) delivery_.note_left_out();
      next_.reset();
    }
    return milliseconds{0};
  }

 private:
  const Parcel& parcel_;
  Publisher& publisher_;
  Delivery delivery_;
  std::optional<Delivery::Next> next_;  ///< waits for room
  std::optional<Clock::time_point> waits_since_;
};

/// Goes on until a signal comes or the daemon refuses.
std::expected<void, ClientError> serve_consumers(Node& node, Publisher& publisher, const Parcel& parcel, Seal& seal,
                                                 const shell::StopSignals& signals) {
  Sending sending(parcel, publisher);
  std::optional<milliseconds> pause;
  while (signals.wait(node.descriptor(), pause) != shell::StopSignals::Woken::stopped) {
    node.process();
    while (const auto event = node.next_event()) {
      // The concept may have been refused before the number was taken.
      if (const auto* refused = std::get_if<Refused>(&*event);
          refused != nullptr && refused->channel == publisher.number())
        return std::unexpected(ClientError{ClientError::Kind::refused, refused->error.text, refused->error.code});
      const auto* change = std::get_if<ConsumerChange>(&*event);
      if (change == nullptr) continue;
      if (auto sealed = seal.check(); !sealed) return sealed;
      sending.tell(*change);
    }
    pause = sending.send();
  }
  return {};
}

}  // namespace

ClientError not_sealed() {
  return {ClientError::Kind::wrong_use,
          "the daemon does not seal channels, so that strangers could take or forge the ontology: give the team a key "
          "(gemingad --generate-key), or say --open"};
}

std::expected<void, ClientError> offer(const Parcel& parcel, const Offering& offering) {
  const shell::StopSignals signals;
  auto client = Client::connect({.connect = offering.connect, .name = {}});
  if (!client) return std::unexpected(client.error());
  Seal seal(offering, std::move(*client));
  if (auto sealed = seal.check(); !sealed) return sealed;
  ClientOptions options;
  options.connect = offering.connect;
  options.name = peer_name;
  // Errors tell of everything else.
  options.log = [&offering](std::string_view line) {
    if (offering.say && (line.starts_with("no daemon at ") || line.starts_with("the daemon at "))) offering.say(line);
  };
  auto node = Node::open(options);
  if (!node) return std::unexpected(node.error());
  auto publisher = publish(*node, parcel);
  if (!publisher) return std::unexpected(publisher.error());
  if (offering.begun) offering.begun(to_string(seal.welcome().participant));
  auto served = serve_consumers(*node, *publisher, parcel, seal, signals);
  publisher->withdraw();
  return served;
}

}  // namespace geminga::ontology
