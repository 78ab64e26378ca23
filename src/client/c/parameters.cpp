#include "client/c/parameters.hpp"

#include <string>
#include <utility>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"

namespace geminga::client {
namespace {

std::expected<gcnp::Statement, Error> statement_of(std::string_view command, std::string_view parameters) {
  auto statement = gcnp::parse("1 " + std::string(command) + ' ' + std::string(parameters));
  if (!statement) return std::unexpected(std::move(statement.error().error));
  return std::move(*statement);
}

template <typename Request>
std::expected<Request, Error> read(const gcnp::Statement& statement) {
  auto request = gcnp::read_request(statement);
  if (!request) return std::unexpected(std::move(request.error()));
  return std::get<Request>(std::move(*request));
}

}  // namespace

std::expected<NamedPublication, Error> read_publication(std::string_view parameters) {
  auto statement = statement_of("pub create", parameters);
  if (!statement) return std::unexpected(std::move(statement.error()));
  const bool has_port = statement->has("port");
  if (!has_port) statement->parameters.push_back({"port", "1"});
  auto create = read<gcnp::PubCreate>(*statement);
  if (!create) return std::unexpected(std::move(create.error()));
  if (!has_port) create->publication.port = 0;
  return std::move(create->publication);
}

std::expected<NamedSubscription, Error> read_subscription(std::string_view parameters) {
  const auto statement = statement_of("sub create", parameters);
  if (!statement) return std::unexpected(statement.error());
  auto create = read<gcnp::SubCreate>(*statement);
  if (!create) return std::unexpected(std::move(create.error()));
  return std::move(create->subscription);
}

std::expected<PublicationChange, Error> read_publication_change(std::string_view parameters) {
  const auto statement = statement_of("pub modify", parameters);
  if (!statement) return std::unexpected(statement.error());
  return read<gcnp::PubModify>(*statement);
}

std::expected<SubscriptionChange, Error> read_subscription_change(std::string_view parameters) {
  const auto statement = statement_of("sub modify", parameters);
  if (!statement) return std::unexpected(statement.error());
  return read<gcnp::SubModify>(*statement);
}

}  // namespace geminga::client
