#include "bridge/cnats/nats_server.hpp"

#include <utility>

namespace geminga::bridge {
namespace {

constexpr std::int64_t second_in_ms = 1000;

std::string reason_of(natsConnection* connection, natsStatus status) {
  const char* text = nullptr;
  if (connection != nullptr) (void)natsConnection_GetLastError(connection, &text);
  return text != nullptr && *text != '\0' ? text : natsStatus_GetText(status);
}

}  // namespace

NatsServer::NatsServer(client::Reactor& reactor, WordSettings settings, Credentials credentials, Tally& tally,
                       DaemonSocket& daemon, Tell tell)
    : reactor_(reactor),
      settings_(std::move(settings)),
      credentials_(std::move(credentials)),
      tally_(tally),
      daemon_(daemon),
      tell_(std::move(tell)),
      own_("geminga." + settings_.team + ".word." + settings_.site),
      second_(reactor, [this] { on_second(); }) {}

NatsServer::~NatsServer() {
  if (connection_ != nullptr) natsConnection_Close(connection_);
  natsSubscription_Destroy(subscription_);
  natsConnection_Destroy(connection_);
  natsOptions_Destroy(options_);
  nats_CloseAndWait(2 * second_in_ms);  // no thread of the library is left that could call us
}

natsStatus NatsServer::set_options() {
  const std::string url =
      "nats://" + (settings_.host.find(':') == std::string::npos ? settings_.host : '[' + settings_.host + ']') + ':' +
      std::to_string(settings_.port);
  const std::string name = "geminga-" + settings_.team + '-' + settings_.site;
  const auto nothing = [](natsConnection*, void*) {};
  natsStatus status = natsOptions_Create(&options_);
  const auto set = [&status](natsStatus result) {
    if (status == NATS_OK) status = result;
  };
  set(natsOptions_SetURL(options_, url.c_str()));
  set(natsOptions_SetName(options_, name.c_str()));
  set(natsOptions_SetNoEcho(options_, true));
  set(natsOptions_SetMaxReconnect(options_, -1));
  set(natsOptions_SetReconnectWait(options_, second_in_ms));
  set(natsOptions_SetRetryOnFailedConnect(options_, true, nothing, nullptr));
  set(natsOptions_SetPingInterval(options_, 5 * second_in_ms));
  set(natsOptions_SetWriteDeadline(options_, second_in_ms));
  if (!settings_.user.empty()) {
    set(natsOptions_SetUserInfo(options_, settings_.user.c_str(), settings_.password.c_str()));
  }
  if (!credentials_.file.empty()) {
    set(natsOptions_SetUserCredentialsFromFiles(options_, credentials_.file.c_str(), nullptr));
  }
  if (!credentials_.nkey.empty()) {
    set(natsOptions_SetNKeyFromSeed(options_, credentials_.nkey.c_str(), credentials_.nkey_seed.c_str()));
  }
  if (settings_.is_secure) set(natsOptions_SetSecure(options_, true));
  if (!settings_.ca_file.empty()) set(natsOptions_LoadCATrustedCertificates(options_, settings_.ca_file.c_str()));
  if (!settings_.certificate.empty()) {
    set(natsOptions_LoadCertificatesChain(options_, settings_.certificate.c_str(), settings_.certificate_key.c_str()));
  }
  return status;
}

std::expected<void, std::string> NatsServer::start() {
  natsStatus status = set_options();
  if (status != NATS_OK) return std::unexpected(natsStatus_GetText(status));
  status = natsConnection_Connect(&connection_, options_);
  if (status != NATS_OK && status != NATS_NOT_YET_CONNECTED) return std::unexpected(reason_of(connection_, status));
  const std::string all = "geminga." + settings_.team + ".word.*";
  const auto on_message = [](natsConnection*, natsSubscription*, natsMsg* message, void* user) {
    static_cast<NatsServer*>(user)->on_message(message);
    natsMsg_Destroy(message);
  };
  status = natsConnection_Subscribe(&subscription_, connection_, all.c_str(), on_message, this);
  if (status != NATS_OK) return std::unexpected(reason_of(connection_, status));
  on_second();
  return {};
}

/// On a thread of libnats.
void NatsServer::on_message(const natsMsg* message) {
  if (own_ == natsMsg_GetSubject(message)) return;
  const int size = natsMsg_GetDataLength(message);
  const auto given = daemon_.give(Word(reinterpret_cast<const std::byte*>(natsMsg_GetData(message)),
                                       static_cast<std::size_t>(size < 0 ? 0 : size)));
  if (given == DaemonSocket::Given::too_long) ++too_long_;
  if (given == DaemonSocket::Given::too_many) ++too_many_;
}

void NatsServer::on_second() {
  second_.set(reactor_.now() + std::chrono::seconds(1));
  for (auto left = too_long_.exchange(0); left > 0; --left) tally_.count("words of no size that a word has");
  for (auto left = too_many_.exchange(0); left > 0; --left) tally_.count("words over the limit of a second");
  const std::string where = settings_.host + ':' + std::to_string(settings_.port);
  const bool is_up = natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED;
  if (is_up && !was_up_) {
    last_line_.clear();
    tell_("carrying words by " + where + " as " + settings_.site);
  } else if (!is_up) {
    const std::string line =
        "no words from " + where + " (" + reason_of(connection_, NATS_NO_SERVER) + "): trying again";
    if (std::exchange(last_line_, line) != line) tell_(line);
  }
  was_up_ = is_up;
}

void NatsServer::say(Word word) {
  // A word that libnats keeps for a server that is away would be old when it comes.
  if (natsConnection_Status(connection_) != NATS_CONN_STATUS_CONNECTED) {
    return tally_.count("words while there is no server");
  }
  if (natsConnection_Buffered(connection_) > max_unsent_octets) {
    return tally_.count("words that the server did not take in time");
  }
  if (natsConnection_Publish(connection_, own_.c_str(), word.data(), static_cast<int>(word.size())) != NATS_OK) {
    tally_.count("words that the server did not take in time");
  }
}

}  // namespace geminga::bridge
