#include "geminga/node.hpp"

#include <utility>

#include "client/channels/engine.hpp"
#include "client/cpp/deadline.hpp"
#include "client/cpp/stated_endpoints.hpp"

namespace geminga {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// The time between two calls of process() by send(), so that its cost is that of sending.
constexpr milliseconds upkeep_interval{1};
/// The longest wait of a clean end: for consumers that take what waits for them, and for the daemon's goodbye.
constexpr milliseconds goodbye_patience{60'000};

}  // namespace

class NodeState {
 public:
  NodeState(client::DaemonLink::Options options, client::Log::Write log) : engine(std::move(options), std::move(log)) {}

  bool process() {
    last_upkeep = Clock::now();
    return engine.process();
  }
  /// Calls process(), but not more often than is of use.
  void keep_up() {
    if (Clock::now() - last_upkeep < upkeep_interval) return;
    process();
    remind();
  }
  /// Makes the descriptor readable for a program that polls it, because a call has read messages that it does not know
  /// of.
  void remind() {
    if (is_polled) engine.news().remind();
  }
  /// Drives the engine until `is_done` or the deadline. Whether it is done.
  template <typename IsDone>
  bool run_until(const IsDone& is_done, Clock::time_point deadline) {
    bool done = false;
    do {
      process();
      done = is_done();
    } while (!done && wait(deadline));
    remind();
    return done;
  }
  /// Waits for something to do. False if the deadline comes first.
  [[nodiscard]] bool wait(Clock::time_point deadline) const {
    return client::wait_until_ready(engine.descriptor(), POLLIN, deadline);
  }

  /// Waits until this holds of the request. Null if a callback has withdrawn the request meanwhile.
  template <typename IsSettled>
  const client::Session::Request* settled(ChannelNumber number, const IsSettled& is_settled) {
    run_until(
        [&] {
          const auto* request = engine.find(number);
          return engine.is_without_daemon() || request == nullptr || is_settled(*request);
        },
        client::deadline_after(timeout));
    return engine.find(number);
  }
  /// Waits for the answer to a create. The error is a refusal, after which the request is gone.
  Result<void, ClientError> answer(ChannelNumber number) {
    const auto* request = settled(number, [](const auto& one) { return one.state != client::Session::State::asked; });
    if (request == nullptr || request->state != client::Session::State::refused) return {};
    const Error refusal = request->refusal.value_or(Error{});
    engine.withdraw(number);
    return Failure(ClientError{ClientError::Kind::refused, refusal.text, refusal.code});
  }
  Result<void, ClientError> modify(ChannelNumber number, const client::Session::Change& change, Wait wait) {
    if (auto asked = engine.modify(number, change); !asked || wait == Wait::for_nothing) return asked;
    const auto* request = settled(number, [](const auto& one) { return one.open_changes == 0; });
    if (request == nullptr || request->open_changes > 0 || !request->last_change) return {};
    const Error& refusal = *request->last_change;
    return Failure(ClientError{ClientError::Kind::refused, refusal.text, refusal.code});
  }
  void withdraw(ChannelNumber number) {
    engine.withdraw(number);
    run_until([&] { return engine.find(number) == nullptr; }, client::deadline_after(goodbye_patience));
  }
  void close() {
    if (!std::exchange(is_closed, true)) engine.withdraw_all();
    run_until([&] { return engine.has_ended(); }, client::deadline_after(goodbye_patience));
  }
  [[nodiscard]] bool has_ended(ChannelNumber number) const {
    const auto* request = engine.find(number);
    return request == nullptr || request->state == client::Session::State::refused;
  }

  client::Engine engine;
  milliseconds timeout{};
  bool is_closed = false;
  bool is_polled = false;  ///< the program waits at the descriptor itself
  Clock::time_point last_upkeep{};
};

Publisher::Publisher(Publisher&& other) noexcept : node_(std::exchange(other.node_, nullptr)), number_(other.number_) {}
Publisher& Publisher::operator=(Publisher&& other) noexcept {
  std::swap(node_, other.node_);
  std::swap(number_, other.number_);
  return *this;
}
Publisher::~Publisher() {
  if (node_ != nullptr && node_->engine.find(number_) != nullptr) withdraw();
}

Result<void, SendError> Publisher::send(std::span<const std::byte> payload) {
  node_->keep_up();
  auto* publisher = node_->engine.publisher(number_);
  if (publisher == nullptr || has_ended()) {
    return Failure(SendError{SendError::Kind::closed, "the publisher was withdrawn or refused"});
  }
  return publisher->send(payload);
}

bool Publisher::has_room(std::size_t payload_bytes) const {
  const auto* publisher = node_->engine.publisher(number_);
  return publisher == nullptr || publisher->has_room(payload_bytes);
}

bool Publisher::wait_for_room(std::size_t payload_bytes, milliseconds timeout) {
  if (has_room(payload_bytes)) return true;
  return node_->run_until([&] { return has_room(payload_bytes); }, client::deadline_after(timeout));
}

Life Publisher::life() const {
  const auto* publisher = node_->engine.publisher(number_);
  return publisher == nullptr ? no_life : publisher->life();
}

SendCount Publisher::count() const {
  const auto* publisher = node_->engine.publisher(number_);
  return publisher == nullptr ? SendCount{} : publisher->count();
}

Result<void, ClientError> Publisher::modify(const PublicationChange& change, Wait wait) {
  return node_->modify(number_, change, wait);
}

void Publisher::withdraw() { node_->withdraw(number_); }
void Publisher::begin_withdraw() { node_->engine.withdraw(number_); }
bool Publisher::has_ended() const { return node_->has_ended(number_); }

Subscriber::Subscriber(Subscriber&& other) noexcept
    : node_(std::exchange(other.node_, nullptr)), number_(other.number_) {}
Subscriber& Subscriber::operator=(Subscriber&& other) noexcept {
  std::swap(node_, other.node_);
  std::swap(number_, other.number_);
  return *this;
}
Subscriber::~Subscriber() {
  if (node_ != nullptr) withdraw();
}

std::optional<Message> Subscriber::poll() {
  node_->engine.news().has_looked(number_);
  auto* subscriber = node_->engine.subscriber(number_);
  return subscriber == nullptr ? std::nullopt : subscriber->take();
}

std::optional<Message> Subscriber::receive(milliseconds timeout) {
  std::optional<Message> message = poll();
  if (message) {
    node_->keep_up();
    return message;
  }
  node_->run_until([&] { return (message = poll()).has_value() || has_ended(); }, client::deadline_after(timeout));
  return message;
}

void Subscriber::on_message(std::function<void(Message)> receive) {
  node_->engine.news().on_messages(number_, std::move(receive));
}

Life Subscriber::life() const {
  const auto* subscriber = node_->engine.subscriber(number_);
  return subscriber == nullptr ? no_life : subscriber->life();
}

ReceiveCount Subscriber::count() const {
  const auto* subscriber = node_->engine.subscriber(number_);
  return subscriber == nullptr ? ReceiveCount{} : subscriber->count();
}

Result<void, ClientError> Subscriber::modify(const SubscriptionChange& change, Wait wait) {
  return node_->modify(number_, change, wait);
}

void Subscriber::withdraw() { node_->engine.withdraw(number_); }
bool Subscriber::has_ended() const { return node_->has_ended(number_); }

Node::Node(std::unique_ptr<NodeState> state) : state_(std::move(state)) {}
Node::Node(Node&&) noexcept = default;
Node& Node::operator=(Node&& other) noexcept {
  std::swap(state_, other.state_);  // the other one's destructor withdraws what was here
  return *this;
}
Node::~Node() {
  if (state_) state_->close();
}

Result<Node, ClientError> Node::open(const ClientOptions& options) {
  auto places = client::stated_endpoints(options.connect);
  if (!places) return Failure(std::move(places.error()));
  auto state = std::make_unique<NodeState>(
      client::DaemonLink::Options{std::move(*places), options.name, options.timeout, options.room}, options.log);
  state->timeout = options.timeout;
  return Node(std::move(state));
}

Result<Publisher, ClientError> Node::publish(const NamedPublication& publication, Wait wait) {
  const auto number = state_->engine.publish(publication);
  if (!number) return Failure(number.error());
  if (wait == Wait::for_answer) {
    if (auto answer = state_->answer(*number); !answer) return Failure(answer.error());
  }
  return Publisher(*state_, *number);
}

Result<Subscriber, ClientError> Node::subscribe(const NamedSubscription& subscription, Conversions conversions,
                                                Wait wait) {
  const auto number = state_->engine.subscribe(subscription, std::move(conversions));
  if (!number) return Failure(number.error());
  if (wait == Wait::for_answer) {
    if (auto answer = state_->answer(*number); !answer) return Failure(answer.error());
  }
  return Subscriber(*state_, *number);
}

std::optional<ChannelEvent> Node::next_event(milliseconds timeout) {
  std::optional<ChannelEvent> event = state_->engine.news().next_event();
  if (event) return event;
  state_->run_until([&] { return (event = state_->engine.news().next_event()).has_value(); },
                    client::deadline_after(timeout));
  return event;
}

void Node::on_log(std::function<void(std::string_view)> write) { state_->engine.on_log(std::move(write)); }
void Node::on_event(std::function<void(const ChannelEvent&)> tell) { state_->engine.news().on_events(std::move(tell)); }
bool Node::is_connected() const { return state_->engine.is_connected(); }
int Node::descriptor() const {
  state_->is_polled = true;
  return state_->engine.descriptor();
}
void Node::process() {
  state_->process();
  state_->engine.news().will_look();
}

void Node::wait(milliseconds timeout) {
  const bool had_news = state_->engine.news().is_any();
  const bool has_come = state_->process();
  if (!had_news && !has_come && state_->wait(client::deadline_after(timeout))) state_->process();
  state_->engine.news().will_look();
}

void Node::run_for(milliseconds duration) {
  state_->run_until([] { return false; }, client::deadline_after(duration));
}

void Node::close() { state_->close(); }

void Node::begin_close() {
  if (!std::exchange(state_->is_closed, true)) state_->engine.withdraw_all();
}

bool Node::has_ended() { return state_->engine.has_ended(); }

}  // namespace geminga
