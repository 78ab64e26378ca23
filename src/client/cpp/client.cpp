#include "geminga/client.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <variant>

#include "base/text.hpp"
#include "client/cpp/session.hpp"
#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/request.hpp"

namespace geminga {
namespace {

using Kind = ClientError::Kind;

std::expected<std::vector<client::Endpoint>, ClientError> endpoints_of(const std::string& connect) {
  std::string text = connect;
  if (text.empty()) {
    const char* variable = std::getenv("GEMINGA_CONNECT");
    if (variable != nullptr) text = variable;
  }
  if (text.empty()) return client::usual_endpoints();
  const auto endpoint = client::endpoint(text);
  if (!endpoint) {
    return std::unexpected(ClientError{
        Kind::wrong_use, base::printable(text) +
                             " is no address of a daemon: write ADDRESS:PORT, [ADDRESS]:PORT or the path of a socket"});
  }
  return std::vector{*endpoint};
}

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

Record record_of(const gcnp::Statement& message) {
  Record record;
  record.kind = message.subcommand;
  // `why` tells of services too, but of none of their attributes.
  const bool is_service = message.subcommand != "why" && (message.has("service") || message.has("subscription"));
  for (const auto& parameter : message.parameters) {
    const auto attribute = is_service ? gcnp::shown_attribute(parameter.key) : std::nullopt;
    if (attribute) {
      record.attributes.emplace(*attribute, parameter.value.value_or(""));
    } else {
      record.fields.emplace_back(parameter.key, parameter.value.value_or(""));
    }
  }
  return record;
}

/// Now and a timeout, which may be as long as "for ever".
client::Clock::time_point deadline_after(std::chrono::milliseconds timeout) {
  const auto now = client::Clock::now();
  const auto longest = client::Clock::time_point::max() - now;
  return timeout < longest ? now + timeout : client::Clock::time_point::max();
}

}  // namespace

std::string_view Record::operator[](std::string_view key) const {
  const auto field = std::ranges::find(fields, key, &std::pair<std::string, std::string>::first);
  return field == fields.end() ? std::string_view() : field->second;
}

class Client::State {
 public:
  explicit State(std::chrono::milliseconds timeout) : session(timeout) {}
  client::Session session;
  Welcome welcome;
  std::map<std::uint32_t, bool> is_publication;  ///< of everything that is offered or asked for, by its number

  std::expected<void, ClientError> send(std::uint32_t number, const gcnp::Request& request) {
    return session.request(gcnp::to_statement(number, request));
  }
  std::expected<std::uint32_t, ClientError> create(const gcnp::Request& request) {
    const std::uint32_t number = session.next_number();
    if (auto sent = send(number, request); !sent) return std::unexpected(std::move(sent.error()));
    is_publication.emplace(number, std::holds_alternative<gcnp::PubCreate>(request));
    return number;
  }
};

Client::Client(std::unique_ptr<State> state) : state_(std::move(state)) {}
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&&) noexcept = default;
Client::~Client() = default;

std::expected<Client, ClientError> Client::connect(const ClientOptions& options) {
  const auto endpoints = endpoints_of(options.connect);
  if (!endpoints) return std::unexpected(endpoints.error());
  auto state = std::make_unique<State>(options.timeout);
  if (auto connected = state->session.connect(*endpoints); !connected) return std::unexpected(connected.error());
  auto hello = state->session.hello(options.name);
  if (!hello) return std::unexpected(hello.error());
  state->welcome = welcome_of(*hello);
  return Client(std::move(state));
}

const Welcome& Client::welcome() const { return state_->welcome; }

std::expected<std::uint32_t, ClientError> Client::publish(const NamedPublication& publication) {
  return state_->create(gcnp::PubCreate{publication});
}

std::expected<std::uint32_t, ClientError> Client::subscribe(const NamedSubscription& subscription) {
  return state_->create(gcnp::SubCreate{subscription});
}

std::expected<void, ClientError> Client::modify(std::uint32_t request, const PublicationChange& change) {
  return state_->send(request, change);
}

std::expected<void, ClientError> Client::modify(std::uint32_t request, const SubscriptionChange& change) {
  return state_->send(request, change);
}

std::expected<void, ClientError> Client::withdraw(std::uint32_t request) {
  const auto stated = state_->is_publication.find(request);
  if (stated == state_->is_publication.end()) {
    return std::unexpected(
        ClientError{Kind::wrong_use, "there is no request " + std::to_string(request) + " to withdraw"});
  }
  const auto remove = stated->second ? gcnp::Request(gcnp::PubRemove{}) : gcnp::Request(gcnp::SubRemove{});
  if (auto sent = state_->send(request, remove); !sent) return sent;
  state_->is_publication.erase(stated);
  return {};
}

std::expected<std::optional<Event>, ClientError> Client::next_event(std::chrono::milliseconds timeout) {
  return state_->session.next_event(deadline_after(timeout));
}

std::expected<std::optional<Event>, ClientError> Client::poll() {
  return state_->session.next_event(client::Clock::time_point::min());
}

int Client::file_descriptor() const { return state_->session.file_descriptor(); }

std::expected<Answer, ClientError> Client::query(std::string_view kind,
                                                 const std::vector<std::pair<std::string, std::string>>& parameters) {
  gcnp::Statement statement{state_->session.next_number(), "query", std::string(kind), {}};
  for (const auto& [key, value] : parameters) statement.parameters.push_back({key, value});
  const auto messages = state_->session.query(statement);
  if (!messages) return std::unexpected(messages.error());
  Answer answer;
  for (const auto& message : *messages) answer.records.push_back(record_of(message));
  answer.end = std::move(answer.records.back());
  answer.records.pop_back();
  return answer;
}

}  // namespace geminga
