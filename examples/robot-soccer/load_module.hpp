// One module of a host: it sends and receives what its rows of the table say, and counts that.
#ifndef GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_MODULE_HPP
#define GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_MODULE_HPP

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "geminga/node.hpp"
#include "load_table.hpp"

/// A service, and the time of its next message.
struct Sender {
  geminga::Publisher publisher;
  Clock::duration period;
  std::string payload;
  bool is_for_others;
  Clock::time_point due;
};

struct Receiver {
  geminga::Subscriber subscriber;
  bool is_inside;
};

class Module {
 public:
  Module(geminga::Node node, const std::vector<Row>& rows, const std::string& name) : node_(std::move(node)) {
    for (const Row& row : rows) {
      if (row.module == name) state(row);
    }
  }

  /// Sends and receives until `end`, and counts what happens from `begin` on.
  Counts run(Clock::time_point begin, Clock::time_point end) {
    Counts counts;
    for (;;) {
      const auto now = Clock::now();
      if (now >= end) return counts;
      const bool counts_now = now >= begin;
      auto next = end;
      for (Sender& sender : senders_) {
        if (sender.due <= now) {
          const bool was_sent = sender.publisher.send(sender.payload).has_value();
          sender.due += sender.period;
          if (was_sent && counts_now && sender.is_for_others) ++counts.sent;
        }
        next = std::min(next, sender.due);
      }
      node_.wait(
          std::max(std::chrono::milliseconds(1), std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now())));
      for (Receiver& receiver : receivers_) {
        while (const auto message = receiver.subscriber.poll()) {
          if (!counts_now) continue;
          ++(receiver.is_inside ? counts.inside : counts.received);
          counts.missed += message->missed;
        }
      }
    }
  }

 private:
  void state(const Row& row) {
    const auto mode = geminga::channel_mode(row.mode).value_or(geminga::ChannelMode::one_to_many_stream);
    if (row.direction == "pub") {
      geminga::NamedPublication offer;
      offer.identity = geminga::ConceptNames{row.concept_name, ""};
      offer.mode = mode;
      offer.scope = row.stated_scope();
      offer.attributes["load"] = "1";  // the modules of the demo offer the same, and send nothing
      if (auto publisher = node_.publish(offer)) {
        senders_.push_back({std::move(*publisher), row.period(), std::string(row.octets, 'x'), row.is_for_others(),
                            Clock::now() + row.period()});
      } else {
        complain(row, publisher.error().text);
      }
      return;
    }
    geminga::NamedSubscription wish;
    wish.identity = geminga::ConceptNames{row.concept_name, ""};
    wish.mode = mode;
    wish.weakest = geminga::Degree::exact;
    wish.where = "load = 1";
    wish.scope = row.stated_scope();
    if (auto subscriber = node_.subscribe(wish)) {
      receivers_.push_back({std::move(*subscriber), !row.is_for_others()});
    } else {
      complain(row, subscriber.error().text);
    }
  }

  geminga::Node node_;
  std::vector<Sender> senders_;
  std::vector<Receiver> receivers_;
};

#endif
