#include "ontology/travel/taking.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "base/text.hpp"
#include "geminga/node.hpp"
#include "ontology/travel/offering.hpp"

namespace geminga::ontology {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr const char* peer_name_of_taker = "ontology-fetch";
/// The time between two questions for providers while there is none, and the longest wait for one message.
constexpr milliseconds between_looks{200};
constexpr milliseconds message_wait{500};
/// How often a provider may be lost before it is not asked again. One that lied is never asked again.
constexpr int most_losses = 3;

std::string name_of(const Candidate& candidate) {
  return base::printable(candidate.participant_name.empty() ? candidate.participant : candidate.participant_name) +
         " (" + candidate.service + ')';
}

/// Why a provider did not bring the rest.
struct Loss {
  std::string text;
  bool is_lie = false;
};

NamedSubscription subscription_of(const Candidate& candidate) {
  NamedSubscription wanted;
  wanted.identity = ontology_number();
  wanted.mode = ChannelMode::one_to_many_pubsub;
  wanted.providers = {{candidate.participant, candidate.peer}};
  wanted.where = "digest = \"" + candidate.digest + '"';
  wanted.limit = 1;
  wanted.protocols = {"tcp"};
  return wanted;
}

/// Takes from one provider until the arrival is whole, the provider fails, or the time is over.
class Transfer {
 public:
  Transfer(Node& node, Subscriber& subscriber, Arrival& arrival, Clock::time_point end)
      : node_(node), subscriber_(subscriber), arrival_(arrival), end_(end) {}

  std::expected<void, Loss> run() {
    arrival_.begin_provider();
    Clock::time_point last_news = Clock::now();
    while (!arrival_.is_whole()) {
      const auto message = subscriber_.receive(message_wait);
      if (message) {
        const auto* octets = reinterpret_cast<const char*>(message->payload.data());
        const auto taken = arrival_.take(std::string_view(octets, message->payload.size()));
        if (!taken) return std::unexpected(Loss{taken.error(), true});
        if (*taken) last_news = Clock::now();
      }
      if (auto lost = take_events(); lost && !message) return std::unexpected(Loss{std::move(*lost)});
      if (Clock::now() > end_) return std::unexpected(Loss{"was too slow"});
      if (Clock::now() - last_news > stall_patience)
        return std::unexpected(Loss{"has brought nothing new for " + std::to_string(stall_patience.count()) + " s" +
                                    (problem_.empty() ? "" : ": " + problem_)});
    }
    return {};
  }

 private:
  /// Why the provider is gone, where it is.
  std::optional<std::string> take_events() {
    while (const auto event = node_.next_event()) {
      if (const auto* problem = std::get_if<Problem>(&*event)) problem_ = base::printable(problem->text);
      if (const auto* refused = std::get_if<Refused>(&*event)) gone_ = "was refused: " + refused->error.text;
      const auto* change = std::get_if<ProviderChange>(&*event);
      if (change == nullptr) continue;
      if (change->what == ProviderChange::What::added) gone_.reset();
      // A connection that was lost is made again by the library.
      if (change->what == ProviderChange::What::removed && change->reason != "lost")
        gone_ = "is gone: " + base::printable(change->reason);
    }
    return gone_;
  }

  Node& node_;
  Subscriber& subscriber_;
  Arrival& arrival_;
  Clock::time_point end_;
  std::string problem_;              ///< the last one
  std::optional<std::string> gone_;  ///< said when all that had come is taken
};

std::expected<void, Loss> take_from(const Candidate& candidate, Arrival& arrival, const Wish& wish,
                                    Clock::time_point end) {
  auto node = Node::open({.connect = wish.connect, .name = peer_name_of_taker});
  if (!node) return std::unexpected(Loss{node.error().text});
  auto subscriber = node->subscribe(subscription_of(candidate));
  if (!subscriber) return std::unexpected(Loss{subscriber.error().text});
  return Transfer(*node, *subscriber, arrival, end).run();
}

TakingError of_client(ClientError error) {
  std::string text = error.text;
  return {TakingError::Kind::of_the_daemon, std::move(text), std::move(error)};
}

/// The different ontologies of these candidates, in one line.
std::string list_of(const std::vector<Candidate>& candidates) {
  std::string text;
  std::string last;
  for (const Candidate& candidate : candidates) {
    if (std::exchange(last, candidate.digest) == candidate.digest) continue;
    text += (text.empty() ? "" : ", ") + candidate.digest.substr(0, 12) + "... version " +
            std::to_string(candidate.version) + " of " + name_of(candidate);
  }
  return text;
}

class Search {
 public:
  Search(const Wish& wish, const std::function<void(std::string_view)>& warn)
      : wish_(wish), warn_(warn), begin_(Clock::now()) {}

  std::expected<Taken, TakingError> run() {
    auto client = Client::connect({.connect = wish_.connect, .name = {}});
    if (!client) return std::unexpected(of_client(client.error()));
    const auto sealed = are_channels_sealed(*client);
    if (!sealed) return std::unexpected(of_client(sealed.error()));
    if (!*sealed && !wish_.is_open) return std::unexpected(of_client(not_sealed()));
    std::optional<Arrival> arrival;
    while (true) {
      auto all = candidates(*client);
      if (!all) {  // the daemon may have been started again
        client = Client::connect({.connect = wish_.connect, .name = {}});
        if (!client) return std::unexpected(of_client(client.error()));
        all = candidates(*client);
        if (!all) return std::unexpected(of_client(all.error()));
      }
      const auto chosen = choose(*all);
      if (!chosen) return std::unexpected(chosen.error());
      if (Clock::now() - begin_ > wish_.time)
        return std::unexpected(TakingError{TakingError::Kind::timed_out, "the ontology was not whole in time"});
      if (!*chosen) {
        if (const auto event = client->next_event(between_looks); !event)
          return std::unexpected(of_client(event.error()));
        continue;
      }
      const Candidate& candidate = **chosen;
      if (!arrival) arrival.emplace(candidate.digest);
      digest_ = candidate.digest;
      const auto taken = take_from(candidate, *arrival, wish_, begin_ + wish_.time);
      if (taken) return Taken{candidate, std::move(*arrival)};
      losses_[candidate.service] += taken.error().is_lie ? most_losses : 1;
      warn_(name_of(candidate) + ' ' + taken.error().text);
      since_ = Clock::now();
    }
  }

 private:
  /// The next provider to be asked; nothing where there is none yet.
  std::expected<std::optional<Candidate>, TakingError> choose(const std::vector<Candidate>& all) {
    std::vector<Candidate> left = candidates_for(wish_, all);
    if (!digest_.empty()) std::erase_if(left, [&](const Candidate& one) { return one.digest != digest_; });
    std::erase_if(left, [&](const Candidate& one) {
      const auto lost = losses_.find(one.service);
      return lost != losses_.end() && lost->second >= most_losses;
    });
    const bool are_several = !left.empty() && std::ranges::any_of(left, [&](const Candidate& one) {
      return one.digest != left.front().digest;
    });
    if (are_several)
      return std::unexpected(
          TakingError{TakingError::Kind::several,
                      "several are offered: " + list_of(left) + ": say --from PARTICIPANT or --digest DIGEST"});
    if (!left.empty()) {
      // One that was lost least is asked first.
      return *std::ranges::min_element(left, {}, [&](const Candidate& one) {
        const auto lost = losses_.find(one.service);
        return lost == losses_.end() ? 0 : lost->second;
      });
    }
    if (Clock::now() - since_ <= wish_.patience) return std::nullopt;
    if (!losses_.empty())
      return std::unexpected(TakingError{TakingError::Kind::not_taken, "no provider brought the whole ontology"});
    const std::string of = wish_.participant.empty() ? "nobody" : base::printable(wish_.participant) + " does not";
    return std::unexpected(TakingError{
        TakingError::Kind::nobody,
        (wish_.participant.empty() ? "nobody offers" : of + " offer") +
            std::string(" this ontology: run geminga-ontology serve there, and see geminga-query services")});
  }

  const Wish& wish_;
  const std::function<void(std::string_view)>& warn_;
  Clock::time_point begin_;
  Clock::time_point since_ = begin_;  ///< since when a provider is missed
  std::string digest_;                ///< of what was begun
  std::map<std::string, int> losses_;
};

}  // namespace

std::vector<Candidate> candidates_for(const Wish& wish, const std::vector<Candidate>& all) {
  std::vector<Candidate> found;
  for (const Candidate& candidate : all) {
    const bool is_from = wish.participant.empty() || candidate.participant == wish.participant ||
                         candidate.participant_name == wish.participant;
    // A part of the digest is enough where it says which one.
    if (!is_from || !candidate.digest.starts_with(wish.digest)) continue;
    if (candidate.version < wish.least_version) continue;
    found.push_back(candidate);
  }
  if (wish.is_newest && !found.empty())
    std::erase_if(found, [digest = found.front().digest](const Candidate& one) { return one.digest != digest; });
  return found;
}

std::expected<Taken, TakingError> take(const Wish& wish, const std::function<void(std::string_view)>& warn) {
  return Search(wish, warn).run();
}

}  // namespace geminga::ontology
