#include "client/channels/engine.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "client/protocol/life.hpp"
#include "discovery/gcnp/channel_keyring.hpp"

namespace geminga {

std::string_view to_string(ProviderChange::What what) {
  switch (what) {
    case ProviderChange::What::added:
      return "added";
    case ProviderChange::What::modified:
      return "modified";
    case ProviderChange::What::removed:
      break;
  }
  return "removed";
}

}  // namespace geminga

namespace geminga::client {
namespace {

/// The largest datagram that IP carries.
constexpr std::size_t largest_datagram = 65'536;

ClientError wrong_use(std::string text) { return {ClientError::Kind::wrong_use, std::move(text)}; }

/// Whether a change concerns the sockets of a channel.
template <typename Change>
bool rewires(const Change& change) {
  return change.mode || change.port || change.address;
}

bool rewires(const Session::Change& change) {
  if (const auto* publication = std::get_if<PublicationChange>(&change)) {
    return rewires<PublicationChange>(*publication) || publication->protocol;
  }
  const auto& subscription = std::get<SubscriptionChange>(change);
  return rewires<SubscriptionChange>(subscription) || subscription.protocols;
}

bool states_life(const Attributes& attributes) { return attributes.contains(channel_attribute); }

}  // namespace

Welcome welcome_of(const gcnp::Statement& hello) {
  Welcome welcome;
  welcome.participant = participant_id(hello.value("participant").value_or("")).value_or(ParticipantId{});
  // `peer` is the peer's number, behind `PARTICIPANT/` where the daemon writes the whole word.
  const std::string_view word = hello.value("peer").value_or("");
  welcome.peer = PeerId{base::parse_number<std::uint32_t>(word.substr(word.rfind('/') + 1)).value_or(0)};
  welcome.participant_name = hello.value("participant_name").value_or("");
  welcome.ontology = hello.value("ontology").value_or("-");
  return welcome;
}

Engine::Engine(DaemonLink::Options options, Log::Write log, Reactor::Clock clock)
    : reactor_([this](std::string text) { tell(Problem{0, std::move(text)}); }, std::move(clock)),
      log_(reactor_, std::move(log)),
      news_(reactor_, log_),
      room_(largest_datagram),
      link_(reactor_, std::move(options), told()),
      session_([this](const gcnp::Statement& statement) {
        if (is_own_process()) link_.say(statement);
      }),
      settle_(reactor_, [this] {
        for (const auto& [number, publisher] : publishers_) publisher->on_settled();
        for (const auto& [number, subscriber] : subscribers_) subscriber->on_settled();
      }) {
  link_.start();
}

Engine::~Engine() {
  news_.on_events(nullptr);
  subscribers_.clear();
  publishers_.clear();
}

DaemonLink::Told Engine::told() {
  DaemonLink::Told told;
  told.up = [this](const gcnp::Statement& hello) { on_up(hello); };
  told.down = [this](const std::string& reason) { on_down(reason); };
  told.reply = [this](gcnp::Reply reply) { on_reply(std::move(reply)); };
  told.refused = [this](const std::string& text) {
    if (std::exchange(last_refusal_, text) != text) tell(Problem{0, text});
  };
  told.missing = [this](const std::string& where, const std::string& reason) { log_.on_no_daemon(where, reason); };
  return told;
}

bool Engine::process() {
  reactor_.process();
  end_finished();
  return news_.hand_out([this](ChannelNumber number) {
    auto* known = subscriber(number);
    return known == nullptr ? std::nullopt : known->take();
  });
}

Result<ChannelNumber, ClientError> Engine::publish(NamedPublication publication) {
  if (states_life(publication.attributes)) return Failure(wrong_use("the attribute channel is the library's own"));
  const ChannelNumber number = session_.next_number();
  auto opened = PublisherChannel::open(*this, number, publication);
  if (!opened) return Failure(wrong_use(std::move(opened.error())));
  if (auto fault = Session::fault(publication)) return Failure(wrong_use(std::move(fault->text)));
  if (mode_ == SealingMode::plain && link_.is_up()) (*opened)->set_keys(ChannelKeys());
  publishers_.emplace(number, std::move(*opened));
  session_.create(number, std::move(publication));
  return number;
}

Result<ChannelNumber, ClientError> Engine::subscribe(NamedSubscription subscription, Conversions conversions) {
  if (states_life(subscription.attributes)) return Failure(wrong_use("the attribute channel is the library's own"));
  const ChannelNumber number = session_.next_number();
  auto opened = SubscriberChannel::open(*this, number, subscription, std::move(conversions));
  if (!opened) return Failure(wrong_use(std::move(opened.error())));
  if (auto fault = Session::fault(subscription)) return Failure(wrong_use(std::move(fault->text)));
  if (mode_) (*opened)->on_daemon_keys(*mode_ != SealingMode::plain);
  subscribers_.emplace(number, std::move(*opened));
  session_.create(number, std::move(subscription));
  return number;
}

Result<void, ClientError> Engine::modify(ChannelNumber number, const Session::Change& change) {
  const auto* request = session_.find(number);
  if (request == nullptr || is_finishing(number)) {
    return Failure(wrong_use("the channel was withdrawn"));
  }
  if (request->state == Session::State::refused) return Failure(wrong_use("the channel was refused"));
  if (request->stated.index() != change.index()) return Failure(wrong_use("the change is of the other kind"));
  if (rewires(change))
    return Failure(wrong_use("mode, protocol, port and address stay: withdraw it and state it anew"));
  if (std::visit([](const auto& one) { return states_life(one.attributes); }, change)) {
    return Failure(wrong_use("the attribute channel is the library's own"));
  }
  if (auto asked = session_.modify(number, change); !asked) return Failure(wrong_use(std::move(asked.error().text)));
  return {};
}

void Engine::withdraw(ChannelNumber number) {
  if (subscribers_.erase(number) > 0) {
    news_.forget(number);
    session_.remove(number);
    return;
  }
  const auto found = publishers_.find(number);
  if (found == publishers_.end() || is_finishing(number)) return;
  if (!is_own_process()) {
    publishers_.erase(found);
    return session_.remove(number);
  }
  found->second->finish();
  finishing_.push_back(number);
  end_finished();
}

void Engine::end_finished() {
  std::erase_if(finishing_, [this](ChannelNumber number) {
    if (!publishers_.at(number)->is_finished()) return false;
    publishers_.erase(number);
    session_.remove(number);
    return true;
  });
}

void Engine::withdraw_all() {
  is_ending_ = true;
  if (!is_own_process()) {
    subscribers_.clear();
    publishers_.clear();
    finishing_.clear();
    return;
  }
  while (!subscribers_.empty()) withdraw(subscribers_.begin()->first);
  std::vector<ChannelNumber> numbers;
  for (const auto& [number, publisher] : publishers_) numbers.push_back(number);
  for (const ChannelNumber number : numbers) withdraw(number);
}

bool Engine::has_ended() {
  if (!is_ending_ || !publishers_.empty()) return false;
  if (!link_.is_up() || !is_own_process()) return true;
  link_.leave();
  return !link_.is_up();
}

PublisherChannel* Engine::publisher(ChannelNumber number) const {
  const auto found = publishers_.find(number);
  return found == publishers_.end() ? nullptr : found->second.get();
}

SubscriberChannel* Engine::subscriber(ChannelNumber number) const {
  const auto found = subscribers_.find(number);
  return found == subscribers_.end() ? nullptr : found->second.get();
}

void Engine::on_up(const gcnp::Statement& hello) {
  last_refusal_.clear();
  log_.on_daemon(link_.where());
  const auto mode =
      hello.value("keys") == "yes" ? client::sealing_mode(hello.value("sealing").value_or("")) : std::nullopt;
  on_mode(mode.value_or(SealingMode::plain));
  tell(Connected{welcome_of(hello)});
  settle_.set(reactor_.now() + settle_patience);
  session_.on_up();
}

void Engine::on_down(const std::string& reason) {
  settle_.set(base::never);
  session_.on_down();
  for (const auto& [number, publisher] : publishers_) publisher->on_daemon_gone();
  for (const auto& [number, subscriber] : subscribers_) subscriber->on_daemon_gone();
  tell(Disconnected{reason});
  if (is_ending_) link_.stop();
}

void Engine::on_mode(SealingMode mode) {
  mode_ = mode;
  const bool is_plain = mode == SealingMode::plain;
  for (const auto& [number, publisher] : publishers_) {
    if (is_plain) publisher->set_keys(ChannelKeys());
  }
  for (const auto& [number, subscriber] : subscribers_) {
    subscriber->on_daemon_keys(!is_plain);
    subscriber->on_mode();
  }
}

void Engine::on_keys(const gcnp::Statement& statement) {
  const auto stated = read_keys(statement);
  if (!stated) return tell(Problem{statement.id, "the daemon's keys of a channel cannot be read"});
  if (auto* known = publisher(statement.id); known != nullptr && known->life() == stated->life) {
    known->set_keys(stated->keys);
  } else if (auto* one = subscriber(statement.id)) {
    one->set_keys(stated->life, stated->keys);
  }
}

void Engine::on_statement(const gcnp::Statement& statement) {
  if (statement.command == "pub" && statement.subcommand == gcnp::keys_subcommand) return on_keys(statement);
  if (statement.command != "msg") return;
  if (statement.subcommand == "sealing") {
    if (const auto mode = client::sealing_mode(statement.value("mode").value_or(""))) on_mode(*mode);
  } else if (statement.subcommand == "pong") {
    for (const auto& settled : session_.on_pong()) on_settled(settled);
  }
}

void Engine::on_reply(gcnp::Reply reply) {
  if (const auto* statement = std::get_if<gcnp::Statement>(&reply)) return on_statement(*statement);
  const Event& event = std::get<Event>(reply);
  if (const auto* service = std::get_if<ServiceEvent>(&event.what)) {
    if (auto* known = subscriber(event.request)) known->on_event(*service);
  } else if (const auto* consumer = std::get_if<ConsumerEvent>(&event.what)) {
    if (auto* known = publisher(event.request)) known->on_event(*consumer);
  } else if (const auto settled = session_.on_error(event.request, std::get<Error>(event.what))) {
    tell(Problem{settled->number, settled->error->text});
    close_refused(settled->number);
  }
}

void Engine::on_settled(const Session::Settled& settled) {
  if (settled.error && settled.error->code == ErrorCode::not_ready && !settled.is_change) {
    return link_.drop(settled.error->text);
  }
  if (settled.error) {
    if (const auto* request = session_.find(settled.number)) log_.on_refused(request->stated, settled.error->text);
    tell(Refused{settled.number, *settled.error});
    close_refused(settled.number);
  } else if (settled.is_news) {
    tell(Accepted{settled.number});
  }
  auto* known = subscriber(settled.number);
  if (known == nullptr || settled.error) return;
  const auto& stated = std::get<NamedSubscription>(session_.find(settled.number)->stated);
  known->set_limit(stated.limit.value_or(stated.mode == ChannelMode::one_to_one ? 1 : 0));
}

void Engine::close_refused(ChannelNumber number) {
  const auto* request = session_.find(number);
  if (request == nullptr || request->state != Session::State::refused) return;
  if (auto* known = subscriber(number)) known->on_refused();
  if (auto* known = publisher(number)) known->on_refused();
}

void Engine::state_port(ChannelNumber channel, std::uint16_t port) {
  PublicationChange change;
  change.port = port;
  [[maybe_unused]] const auto asked = session_.modify(channel, change);
}

void Engine::state_attribute(ChannelNumber channel, const std::string& key, const std::string& value) {
  PublicationChange change;
  change.attributes[key] = value;
  if (session_.find(channel) == nullptr) return;
  [[maybe_unused]] const auto asked = session_.modify(channel, change);
}

}  // namespace geminga::client
