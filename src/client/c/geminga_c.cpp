// The C interface over Node: handles, texts and callbacks. No exception leaves it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/c/parameters.hpp"
#include "geminga/geminga.h"
#include "geminga/identity.hpp"
#include "geminga/node.hpp"

using std::chrono::milliseconds;

struct geminga_writer {
  std::vector<std::byte> written;
};

struct geminga_publisher {
  geminga_node* node;
  geminga::Publisher publisher;
};

struct geminga_subscriber {
  geminga_node* node;
  geminga::Subscriber subscriber;
  std::optional<geminga::Message> last{};
  geminga_message message{};
};

struct geminga_node {
  geminga::Node node;
  std::vector<std::unique_ptr<geminga_publisher>> publishers{};
  std::vector<std::unique_ptr<geminga_subscriber>> subscribers{};
};

namespace {

constexpr milliseconds for_ever = milliseconds::max();

milliseconds timeout_of(int count) { return count < 0 ? for_ever : milliseconds(count); }

int fail(geminga_error* error, int status, const std::string& text, int code = 0) {
  if (error == nullptr) return status;
  error->status = status;
  error->code = code;
  std::snprintf(error->text, sizeof error->text, "%s", text.c_str());
  return status;
}

int fail(geminga_error* error, const geminga::ClientError& failed) {
  const bool is_refused = failed.kind == geminga::ClientError::Kind::refused;
  return fail(error, is_refused ? GEMINGA_REFUSED : GEMINGA_WRONG_USE, failed.text,
              is_refused ? static_cast<int>(failed.code) : 0);
}

int fail(geminga_error* error, const geminga::Error& failed) { return fail(error, GEMINGA_WRONG_USE, failed.text); }

/// The result of the call; `otherwise` and an error if there is no memory or no descriptor.
template <typename Result, typename Call>
Result guarded(geminga_error* error, Result otherwise, const Call& call) {
  try {
    return call();
  } catch (const std::exception& failed) {
    fail(error, GEMINGA_FAILED, failed.what());
  } catch (...) {
    fail(error, GEMINGA_FAILED, "something failed");
  }
  return otherwise;
}

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

const geminga_message* shown(geminga_subscriber& subscriber, std::optional<geminga::Message> message) {
  subscriber.last = std::move(message);
  if (!subscriber.last) return nullptr;
  const geminga::Message& last = *subscriber.last;
  subscriber.message = {static_cast<std::uint64_t>(last.life), last.sequence, last.missed, last.payload.data(),
                        last.payload.size()};
  return &subscriber.message;
}

/// Gives an event to the callback.
class Teller {
 public:
  Teller(geminga_on_event_call call, void* context) : call_(call), context_(context) {}

  void operator()(const geminga::Connected&) const { tell(GEMINGA_CONNECTED, 0, geminga::no_life, "", "", ""); }
  void operator()(const geminga::Disconnected& gone) const {
    tell(GEMINGA_DISCONNECTED, 0, geminga::no_life, gone.reason, "", "");
  }
  void operator()(const geminga::Accepted& accepted) const {
    tell(GEMINGA_ACCEPTED, accepted.channel, geminga::no_life, "", "", "");
  }
  void operator()(const geminga::Refused& refused) const {
    tell(GEMINGA_REQUEST_REFUSED, refused.channel, geminga::no_life, refused.error.text, "", "");
  }
  void operator()(const geminga::ProviderChange& change) const {
    tell(GEMINGA_PROVIDER_ADDED + static_cast<int>(change.what), change.channel, change.life, change.reason,
         change.service.peer_name, change.service.participant_name);
  }
  void operator()(const geminga::ConsumerChange& change) const {
    tell(GEMINGA_CONSUMER_ADDED + static_cast<int>(change.what), change.channel, change.life, change.reason,
         change.consumer.peer_name, change.consumer.participant_name);
  }
  void operator()(const geminga::Problem& problem) const {
    tell(GEMINGA_PROBLEM, problem.channel, geminga::no_life, problem.text, "", "");
  }

 private:
  void tell(int kind, geminga::ChannelNumber channel, geminga::Life life, const std::string& text,
            const std::string& name, const std::string& host) const {
    const geminga_event event{kind,         channel,      static_cast<std::uint64_t>(life),
                              text.c_str(), name.c_str(), host.c_str()};
    call_(context_, &event);
  }
  geminga_on_event_call call_;
  void* context_;
};

geminga::Conversion conversion_of(const geminga_conversion& given) {
  return [convert = given.convert, context = given.context](std::span<const std::byte> payload) {
    geminga_writer writer;
    if (convert(context, payload.data(), payload.size(), &writer) != 0) {
      throw std::runtime_error("the function does not take it");
    }
    return std::move(writer.written);
  };
}

}  // namespace

extern "C" {

geminga_node* geminga_open(const char* connect, const char* name, geminga_error* error) {
  return geminga_open_with_room(connect, name, 0, error);
}

geminga_node* geminga_open_with_room(const char* connect, const char* name, uint32_t room, geminga_error* error) {
  return guarded<geminga_node*>(error, nullptr, [&]() -> geminga_node* {
    geminga::ClientOptions options;
    options.connect = text_of(connect);
    options.name = text_of(name);
    options.room = room;
    auto node = geminga::Node::open(options);
    if (node) return new geminga_node{std::move(*node)};
    fail(error, node.error());
    return nullptr;
  });
}

void geminga_close(geminga_node* node) {
  if (node == nullptr) return;
  guarded(nullptr, 0, [node] {
    node->node.on_event(nullptr);
    node->node.close();
    return 0;
  });
  node->publishers.clear();
  node->subscribers.clear();
  delete node;
}

int geminga_descriptor(const geminga_node* node) { return node->node.descriptor(); }
int geminga_is_connected(const geminga_node* node) { return node->node.is_connected() ? 1 : 0; }

void geminga_process(geminga_node* node) {
  guarded(nullptr, 0, [node] {
    node->node.process();
    return 0;
  });
}

void geminga_wait(geminga_node* node, int count) {
  guarded(nullptr, 0, [node, count] {
    node->node.wait(timeout_of(count));
    return 0;
  });
}

void geminga_run(geminga_node* node, int count) {
  guarded(nullptr, 0, [node, count] {
    node->node.run_for(milliseconds(count));
    return 0;
  });
}

geminga_publisher* geminga_publish(geminga_node* node, const char* parameters, geminga_error* error) {
  return guarded<geminga_publisher*>(error, nullptr, [&]() -> geminga_publisher* {
    const auto publication = geminga::client::read_publication(text_of(parameters));
    if (!publication) return fail(error, publication.error()), nullptr;
    auto publisher = node->node.publish(*publication);
    if (!publisher) return fail(error, publisher.error()), nullptr;
    node->publishers.emplace_back(new geminga_publisher{node, std::move(*publisher)});
    return node->publishers.back().get();
  });
}

geminga_subscriber* geminga_subscribe(geminga_node* node, const char* parameters, geminga_error* error) {
  return geminga_subscribe_converting(node, parameters, nullptr, 0, error);
}

geminga_subscriber* geminga_subscribe_converting(geminga_node* node, const char* parameters,
                                                 const geminga_conversion* conversions, size_t count,
                                                 geminga_error* error) {
  return guarded<geminga_subscriber*>(error, nullptr, [&]() -> geminga_subscriber* {
    const auto subscription = geminga::client::read_subscription(text_of(parameters));
    if (!subscription) return fail(error, subscription.error()), nullptr;
    geminga::Conversions given;
    for (size_t i = 0; i < count; ++i) given[conversions[i].from_to] = conversion_of(conversions[i]);
    auto subscriber = node->node.subscribe(*subscription, std::move(given));
    if (!subscriber) return fail(error, subscriber.error()), nullptr;
    node->subscribers.emplace_back(new geminga_subscriber{node, std::move(*subscriber)});
    return node->subscribers.back().get();
  });
}

void geminga_write(geminga_writer* to, const void* octets, size_t size) {
  const auto* begin = static_cast<const std::byte*>(octets);
  guarded(nullptr, 0, [&] {
    to->written.insert(to->written.end(), begin, begin + size);
    return 0;
  });
}

int geminga_modify_publisher(geminga_publisher* publisher, const char* parameters, geminga_error* error) {
  return guarded<int>(error, GEMINGA_FAILED, [&] {
    const auto change = geminga::client::read_publication_change(text_of(parameters));
    if (!change) return fail(error, change.error());
    const auto changed = publisher->publisher.modify(*change);
    return changed ? 0 : fail(error, changed.error());
  });
}

int geminga_modify_subscriber(geminga_subscriber* subscriber, const char* parameters, geminga_error* error) {
  return guarded<int>(error, GEMINGA_FAILED, [&] {
    const auto change = geminga::client::read_subscription_change(text_of(parameters));
    if (!change) return fail(error, change.error());
    const auto changed = subscriber->subscriber.modify(*change);
    return changed ? 0 : fail(error, changed.error());
  });
}

void geminga_withdraw_publisher(geminga_publisher* publisher) {
  if (publisher == nullptr) return;
  guarded(nullptr, 0, [publisher] {
    publisher->publisher.withdraw();
    return 0;
  });
  std::erase_if(publisher->node->publishers, [publisher](const auto& one) { return one.get() == publisher; });
}

void geminga_withdraw_subscriber(geminga_subscriber* subscriber) {
  if (subscriber == nullptr) return;
  std::erase_if(subscriber->node->subscribers, [subscriber](const auto& one) { return one.get() == subscriber; });
}

int geminga_send(geminga_publisher* publisher, const void* payload, size_t size, geminga_error* error) {
  return guarded<int>(error, GEMINGA_FAILED, [&] {
    const auto sent = publisher->publisher.send(std::span(static_cast<const std::byte*>(payload), size));
    if (sent) return 0;
    const bool is_large = sent.error().kind == geminga::SendError::Kind::too_large;
    return fail(error, is_large ? GEMINGA_TOO_LARGE : GEMINGA_CLOSED, sent.error().text);
  });
}

int geminga_wait_for_room(geminga_publisher* publisher, size_t size, int count) {
  return guarded<int>(nullptr, 0, [&] { return publisher->publisher.wait_for_room(size, timeout_of(count)) ? 1 : 0; });
}

const geminga_message* geminga_receive(geminga_subscriber* subscriber, int count) {
  return guarded<const geminga_message*>(
      nullptr, nullptr, [&] { return shown(*subscriber, subscriber->subscriber.receive(timeout_of(count))); });
}

void geminga_on_message(geminga_subscriber* subscriber, geminga_on_message_call call, void* context) {
  subscriber->subscriber.on_message([subscriber, call, context](geminga::Message message) {
    const geminga_message given{static_cast<std::uint64_t>(message.life), message.sequence, message.missed,
                                message.payload.data(), message.payload.size()};
    call(context, subscriber, &given);
  });
}

void geminga_on_event(geminga_node* node, geminga_on_event_call call, void* context) {
  if (call == nullptr) return node->node.on_event(nullptr);
  node->node.on_event(
      [teller = Teller(call, context)](const geminga::ChannelEvent& event) { std::visit(teller, event); });
}

void geminga_on_log(geminga_node* node, geminga_on_log_call call, void* context) {
  if (call == nullptr) return node->node.on_log(nullptr);
  node->node.on_log([call, context](std::string_view line) { call(context, std::string(line).c_str()); });
}

uint32_t geminga_publisher_number(const geminga_publisher* publisher) { return publisher->publisher.number(); }
uint32_t geminga_subscriber_number(const geminga_subscriber* subscriber) { return subscriber->subscriber.number(); }
uint64_t geminga_publisher_life(const geminga_publisher* publisher) {
  return static_cast<std::uint64_t>(publisher->publisher.life());
}
uint64_t geminga_subscriber_life(const geminga_subscriber* subscriber) {
  return static_cast<std::uint64_t>(subscriber->subscriber.life());
}
uint64_t geminga_sent(const geminga_publisher* publisher) { return publisher->publisher.count().sent; }
uint64_t geminga_left_out(const geminga_publisher* publisher) { return publisher->publisher.count().left_out; }
uint64_t geminga_received(const geminga_subscriber* subscriber) { return subscriber->subscriber.count().received; }
uint64_t geminga_missed(const geminga_subscriber* subscriber) { return subscriber->subscriber.count().missed; }
uint64_t geminga_dropped(const geminga_subscriber* subscriber) { return subscriber->subscriber.count().dropped; }

uint32_t geminga_text_identity(const char* text) { return geminga::id32(geminga::TextIdentity{text_of(text)}); }
uint32_t geminga_concept_identity(const char* concept_iri, const char* representation_iri) {
  return geminga::id32(geminga::SemanticIdentity{text_of(concept_iri), text_of(representation_iri)});
}

}  // extern "C"
