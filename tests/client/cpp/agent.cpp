// The agent of C++: does what it is told on standard input, and says what happens (tests/client/conformance/AGENT.md).
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/cpp/agent_answers.hpp"
#include "discovery/gcnp/request.hpp"
#include "geminga/node.hpp"

namespace geminga::agent {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Messages of a stream that are sent before the rest has its turn.
constexpr int messages_at_once = 64;

struct Stream {
  std::uint64_t next = 1;
  std::uint64_t count = 0;
  std::size_t size = 0;
  milliseconds interval{};
  Clock::time_point due = Clock::now();
};

struct Offer {
  Publisher publisher;
  std::optional<Stream> stream{};
  bool is_closing = false;
};

struct Wish {
  Subscriber subscriber;
  std::uint64_t taken = 0;
  bool is_quiet = false;
  bool is_deaf = false;
};

class Agent {
 public:
  explicit Agent(Node node) : node_(std::move(node)) {
    node_.on_event(
        [this](const ChannelEvent& event) { std::visit([this](const auto& one) { this->tell(one); }, event); });
  }

  void run() {
    std::string read;
    while (!is_quitting_) {
      node_.process();
      look_around();
      std::array<pollfd, 2> waiting{{{STDIN_FILENO, POLLIN, 0}, {node_.descriptor(), POLLIN, 0}}};
      ::poll(waiting.data(), waiting.size(), time_left());
      if ((waiting[0].revents & (POLLIN | POLLHUP)) == 0) continue;
      std::array<char, 65536> bytes;
      const auto count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
      if (count <= 0) break;
      read.append(bytes.data(), static_cast<std::size_t>(count));
      for (std::size_t end = read.find('\n'); end != std::string::npos && !is_quitting_; end = read.find('\n')) {
        obey(std::string(read.substr(0, end)));
        read.erase(0, end + 1);
      }
    }
    node_.close();
  }

 private:
  static void say(const std::string& line) { std::cout << line << '\n' << std::flush; }

  void obey(std::string_view line) {
    const std::string word(next_word(line));
    if (word == "quit") {
      is_quitting_ = true;
    } else if (word == "identity") {
      say(identity_answer(line));
    } else if (word == "frame") {
      say(frame_answer(line));
    } else if (word == "line") {
      say(line_answer(line));
    } else if (!word.empty()) {
      const std::string label(next_word(line));
      obey(word, label, line);
    }
  }

  void obey(const std::string& word, const std::string& label, std::string_view rest) {
    const auto offer = offers_.find(label);
    const auto wish = wishes_.find(label);
    if (word == "pub") {
      publish(label, rest);
    } else if (word == "sub") {
      subscribe(label, rest);
    } else if (word == "convert") {
      const std::string from(next_word(rest));
      const std::string to(next_word(rest));
      conversions_[label][from + '>' + to] =
          [before = from_hex(rest).value_or(Bytes{})](std::span<const std::byte> payload) {
            Bytes after = before;
            after.insert(after.end(), payload.begin(), payload.end());
            return after;
          };
    } else if (offer != offers_.end()) {
      obey(word, label, offer->second, rest);
    } else if (wish != wishes_.end()) {
      obey(word, label, wish->second, rest);
    } else {
      say("error " + label + " there is none of this name");
    }
  }

  void obey(const std::string& word, const std::string& label, Offer& offer, std::string_view rest) {
    if (word == "send") {
      const auto sent = offer.publisher.send(from_hex(rest).value_or(Bytes{}));
      if (!sent) say("error " + label + ' ' + sent.error().text);
    } else if (word == "stream") {
      Stream stream;
      stream.count = number(next_word(rest));
      stream.size = std::max<std::size_t>(number(next_word(rest)), sizeof(std::uint64_t));
      stream.interval = milliseconds(number(next_word(rest)));
      offer.stream = stream;
    } else if (word == "count") {
      const SendCount count = offer.publisher.count();
      say("count " + label + " sent=" + std::to_string(count.sent) + " left_out=" + std::to_string(count.left_out) +
          " dropped=" + std::to_string(count.dropped));
    } else if (word == "modify") {
      const auto request = read("1 pub modify " + std::string(rest));
      if (!request) return say("error " + label + ' ' + request.error().text);
      const auto asked = offer.publisher.modify(std::get<gcnp::PubModify>(*request), Wait::for_nothing);
      if (!asked) say("error " + label + ' ' + asked.error().text);
    } else if (word == "close") {
      offer.is_closing = true;
      offer.publisher.begin_withdraw();
    }
  }

  void obey(const std::string& word, const std::string& label, Wish& wish, std::string_view rest) {
    if (word == "quiet") {
      wish.is_quiet = true;
    } else if (word == "deaf" || word == "reading") {
      wish.is_deaf = word == "deaf";
    } else if (word == "count") {
      const ReceiveCount count = wish.subscriber.count();
      say("count " + label + " received=" + std::to_string(wish.taken) + " missed=" + std::to_string(count.missed) +
          " dropped=" + std::to_string(count.dropped));
    } else if (word == "modify") {
      const auto request = read("1 sub modify " + std::string(rest));
      if (!request) return say("error " + label + ' ' + request.error().text);
      const auto asked = wish.subscriber.modify(std::get<gcnp::SubModify>(*request), Wait::for_nothing);
      if (!asked) say("error " + label + ' ' + asked.error().text);
    } else if (word == "close") {
      labels_.erase(wish.subscriber.number());
      wish.subscriber.withdraw();
      wishes_.erase(label);
      say("closed " + label);
    }
  }

  void publish(const std::string& label, std::string_view rest) {
    const bool has_port = (' ' + std::string(rest)).find(" port=") != std::string::npos;
    const auto request = read("1 pub create " + std::string(rest) + (has_port ? "" : " port=1"));
    if (!request) return say("error " + label + ' ' + request.error().text);
    NamedPublication publication = std::get<gcnp::PubCreate>(*request).publication;
    if (!has_port) publication.port = 0;
    auto publisher = node_.publish(publication, Wait::for_nothing);
    if (!publisher) return say("error " + label + ' ' + publisher.error().text);
    labels_[publisher->number()] = {label};
    offers_.insert_or_assign(label, Offer{std::move(*publisher)});
  }

  void subscribe(const std::string& label, std::string_view rest) {
    const auto request = read("1 sub create " + std::string(rest));
    if (!request) return say("error " + label + ' ' + request.error().text);
    auto subscriber =
        node_.subscribe(std::get<gcnp::SubCreate>(*request).subscription, conversions_[label], Wait::for_nothing);
    if (!subscriber) return say("error " + label + ' ' + subscriber.error().text);
    labels_[subscriber->number()] = {label};
    wishes_.insert_or_assign(label, Wish{std::move(*subscriber)});
  }

  static std::expected<gcnp::Request, Error> read(const std::string& line) {
    const auto statement = gcnp::parse(line);
    if (!statement) return std::unexpected(statement.error().error);
    return gcnp::read_request(*statement);
  }

  /// Messages that came, streams whose next message is due, and what has ended.
  void look_around() {
    for (auto& [label, wish] : wishes_) {
      const auto named = labels_.find(wish.subscriber.number());
      while (!wish.is_deaf && named != labels_.end() && named->second.was_accepted) {
        const auto message = wish.subscriber.poll();
        if (!message) break;
        ++wish.taken;
        if (wish.is_quiet) continue;
        const std::span<const std::byte> payload(message->payload);
        say("message " + label + ' ' + to_string(message->life) + ' ' + std::to_string(message->sequence) + ' ' +
            std::to_string(message->missed) + ' ' + std::to_string(payload.size()) + ' ' +
            to_hex(payload.first(std::min<std::size_t>(payload.size(), 32))));
      }
    }
    for (auto& [label, offer] : offers_) stream(label, offer);
    std::erase_if(offers_, [this](auto& one) {
      if (!one.second.is_closing || !one.second.publisher.has_ended()) return false;
      labels_.erase(one.second.publisher.number());
      say("closed " + one.first);
      return true;
    });
  }

  static void stream(const std::string& label, Offer& offer) {
    for (int i = 0; i < messages_at_once && offer.stream; ++i) {
      Stream& stream = *offer.stream;
      if (stream.next > stream.count) {
        offer.stream.reset();
        return say("streamed " + label);
      }
      if (stream.interval > milliseconds(0) ? Clock::now() < stream.due : !offer.publisher.has_room(stream.size)) {
        return;
      }
      stream.due += stream.interval;
      Bytes payload(stream.size);
      for (int octet = 0; octet < 8; ++octet)
        payload[static_cast<std::size_t>(octet)] = static_cast<std::byte>(stream.next >> (56 - 8 * octet));
      ++stream.next;
      if (const auto sent = offer.publisher.send(payload); !sent) {
        offer.stream.reset();
        say("error " + label + ' ' + sent.error().text);
      }
    }
  }

  /// Until the next message of a stream is due; -1: nothing is.
  [[nodiscard]] int time_left() const {
    int left = -1;
    for (const auto& [label, offer] : offers_) {
      if (!offer.stream) continue;
      int own = 0;
      if (offer.stream->interval > milliseconds(0)) {
        const auto until = std::chrono::ceil<milliseconds>(offer.stream->due - Clock::now()).count();
        own = static_cast<int>(std::max<long long>(until, 0));
      } else if (!offer.publisher.has_room(offer.stream->size)) {
        continue;
      }
      left = left < 0 ? own : std::min(left, own);
    }
    return left;
  }

  struct Label {
    std::string text;
    bool was_accepted = false;
    std::vector<std::string> early{};  ///< said behind the ok
  };
  /// Says `WORD LABEL REST`, behind the ok of the label.
  void say_about(ChannelNumber number, const std::string& word, const std::string& rest) {
    const auto found = labels_.find(number);
    const std::string line = word + ' ' + (found == labels_.end() ? "-" : found->second.text) + ' ' + rest;
    if (found == labels_.end() || found->second.was_accepted) return say(line);
    found->second.early.push_back(line);
  }

  static void tell(const Connected&) { say("connected"); }
  static void tell(const Disconnected&) { say("disconnected"); }
  void tell(const Accepted& accepted) {
    const auto found = labels_.find(accepted.channel);
    if (found == labels_.end() || std::exchange(found->second.was_accepted, true)) return;
    say("ok " + found->second.text);
    for (const std::string& line : std::exchange(found->second.early, {})) say(line);
  }
  void tell(const Refused& refused) {
    const auto found = labels_.find(refused.channel);
    if (found != labels_.end()) say("error " + found->second.text + ' ' + refused.error.text);
  }
  void tell(const ProviderChange& change) {
    say_about(change.channel, "provider",
              std::string(to_string(change.what)) + ' ' + to_string(change.life) + ' ' +
                  (change.reason.empty() ? "-" : change.reason));
  }
  void tell(const ConsumerChange& change) {
    say_about(change.channel, "consumer",
              std::string(to_string(change.what)) + ' ' + to_string(change.life) + ' ' +
                  (change.reason.empty() ? "-" : change.reason));
  }
  void tell(const Problem& problem) { say_about(problem.channel, "problem", problem.text); }

  Node node_;
  std::map<std::string, Offer> offers_;
  std::map<std::string, Wish> wishes_;
  std::map<ChannelNumber, Label> labels_;
  std::map<std::string, Conversions> conversions_;
  bool is_quitting_ = false;
};

}  // namespace
}  // namespace geminga::agent

int main(int argc, char** argv) {
  geminga::ClientOptions options;
  if (argc > 1) options.name = argv[1];
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "agent: " << node.error().text << '\n';
    return 2;
  }
  geminga::agent::Agent(std::move(*node)).run();
  return 0;
}
