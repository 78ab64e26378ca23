#include "geminga/client.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "base/text.hpp"
#include "client/channels/engine.hpp"
#include "client/cpp/blocking_session.hpp"
#include "client/cpp/deadline.hpp"
#include "client/cpp/record.hpp"
#include "client/cpp/stated_endpoints.hpp"
#include "discovery/gcnp/request.hpp"

namespace geminga {

std::string_view Record::operator[](std::string_view key) const {
  const auto field = std::ranges::find(fields, key, &std::pair<std::string, std::string>::first);
  return field == fields.end() ? std::string_view() : field->second;
}

class Client::State {
 public:
  explicit State(std::chrono::milliseconds timeout) : session(timeout) {}
  client::BlockingSession session;
  Welcome welcome;
  std::map<std::uint32_t, bool> is_publication;  ///< of each request, by its number

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

Result<Client, ClientError> Client::connect(const ClientOptions& options) {
  const auto endpoints = client::stated_endpoints(options.connect);
  if (!endpoints) return std::unexpected(endpoints.error());
  auto state = std::make_unique<State>(options.timeout);
  if (auto connected = state->session.connect(*endpoints); !connected) return std::unexpected(connected.error());
  auto hello = state->session.hello(options);
  if (!hello) return std::unexpected(hello.error());
  state->welcome = client::welcome_of(*hello);
  return Client(std::move(state));
}

const Welcome& Client::welcome() const { return state_->welcome; }

Result<std::uint32_t, ClientError> Client::publish(const NamedPublication& publication) {
  return state_->create(gcnp::PubCreate{publication});
}

Result<std::uint32_t, ClientError> Client::subscribe(const NamedSubscription& subscription) {
  return state_->create(gcnp::SubCreate{subscription});
}

Result<void, ClientError> Client::modify(std::uint32_t request, const PublicationChange& change) {
  return state_->send(request, change);
}

Result<void, ClientError> Client::modify(std::uint32_t request, const SubscriptionChange& change) {
  return state_->send(request, change);
}

Result<void, ClientError> Client::withdraw(std::uint32_t request) {
  const auto stated = state_->is_publication.find(request);
  if (stated == state_->is_publication.end()) {
    return std::unexpected(
        ClientError{ClientError::Kind::wrong_use, "there is no request " + std::to_string(request) + " to withdraw"});
  }
  const auto remove = stated->second ? gcnp::Request(gcnp::PubRemove{}) : gcnp::Request(gcnp::SubRemove{});
  if (auto sent = state_->send(request, remove); !sent) return sent;
  state_->is_publication.erase(stated);
  return {};
}

Result<std::optional<Event>, ClientError> Client::next_event(std::chrono::milliseconds timeout) {
  return state_->session.next_event(client::deadline_after(timeout));
}

Result<std::optional<Event>, ClientError> Client::poll() {
  return state_->session.next_event(client::Clock::time_point::min());
}

int Client::file_descriptor() const { return state_->session.file_descriptor(); }

Result<void, ClientError> Client::describe(const std::optional<std::string>& expression, const Attributes& attributes) {
  return state_->send(0, gcnp::Describe{expression, attributes});
}

Result<Answer, ClientError> Client::query(std::string_view kind,
                                          const std::vector<std::pair<std::string, std::string>>& parameters) {
  gcnp::Statement statement{state_->session.next_number(), "query", std::string(kind), {}};
  for (const auto& [key, value] : parameters) statement.parameters.push_back({key, value});
  const auto messages = state_->session.query(statement);
  if (!messages) return std::unexpected(messages.error());
  Answer answer;
  for (const auto& message : *messages) answer.records.push_back(client::record_of(message));
  answer.end = std::move(answer.records.back());
  answer.records.pop_back();
  return answer;
}

}  // namespace geminga
