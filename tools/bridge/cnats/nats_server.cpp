#include "bridge/cnats/nats_server.hpp"

#include <utility>

#include "base/text.hpp"

namespace geminga::bridge {
namespace {

constexpr std::int64_t second_in_ms = 1000;

/// The words of libnats about the last failure on this thread, which may repeat the server's.
std::string reason_of(natsStatus status) {
  const char* text = nats_GetLastError(nullptr);
  return base::printable(text != nullptr && *text != '\0' ? text : natsStatus_GetText(status));
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
      bucket_("geminga_" + settings_.team),
      written_subject_((credentials_.domain.empty() ? "" : "$JS." + credentials_.domain + ".API.") + "$KV." + bucket_ +
                       '.'),
      kept_subject_("$KV." + bucket_ + '.'),
      keeper_(reactor, tally, *this),
      second_(reactor, [this] { on_second(); }) {
  keeper_.set_daemon(daemon);
}

NatsServer::~NatsServer() {
  disconnect();
  natsOptions_Destroy(options_);
  nats_CloseAndWait(2 * second_in_ms);  // no thread of the library is left that could call us
}

natsStatus NatsServer::set_options() {
  const std::string url =
      "nats://" + (settings_.host.find(':') == std::string::npos ? settings_.host : '[' + settings_.host + ']') + ':' +
      std::to_string(settings_.port);
  const std::string name = "geminga-" + settings_.team + '-' + settings_.site;
  natsStatus status = natsOptions_Create(&options_);
  const auto set = [&status](natsStatus result) {
    if (status == NATS_OK) status = result;
  };
  set(natsOptions_SetURL(options_, url.c_str()));
  set(natsOptions_SetName(options_, name.c_str()));
  set(natsOptions_SetNoEcho(options_, true));
  set(natsOptions_SetAllowReconnect(options_, false));  // it would give up after two refusals, and not say why
  set(natsOptions_SetTimeout(options_, second_in_ms));
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
  if (const natsStatus status = set_options(); status != NATS_OK) return std::unexpected(reason_of(status));
  on_second();
  return {};
}

natsStatus NatsServer::connect() {
  const std::string all = "geminga." + settings_.team + ".word.*";
  const auto on_message = [](natsConnection*, natsSubscription*, natsMsg* message, void* user) {
    static_cast<NatsServer*>(user)->on_message(message);
    natsMsg_Destroy(message);
  };
  const natsStatus status = natsConnection_Connect(&connection_, options_);
  return status == NATS_OK ? natsConnection_Subscribe(&subscription_, connection_, all.c_str(), on_message, this)
                           : status;
}

natsStatus NatsServer::open_bucket() {
  jsOptions options;
  natsStatus status = jsOptions_Init(&options);
  options.Wait = second_in_ms;
  if (!credentials_.domain.empty()) options.Domain = credentials_.domain.c_str();
  if (status == NATS_OK) status = natsConnection_JetStream(&stream_, connection_, &options);
  kvConfig bucket;
  kvConfig_Init(&bucket);
  bucket.Bucket = bucket_.c_str();
  bucket.Description = "the last words of a team of Geminga, sealed: tools/bridge/README.md";
  bucket.MaxValueSize = static_cast<std::int32_t>(keeping::max_kept_bytes);
  bucket.History = 1;
  bucket.TTL = std::chrono::nanoseconds(kept_time).count();
  bucket.StorageType = js_MemoryStorage;  // all that is kept is written again when the server is back
  kvStore* store = nullptr;
  if (status == NATS_OK) status = js_CreateKeyValue(&store, stream_, &bucket);
  // A bucket that its owner has made with other settings.
  if (status == NATS_ERR) status = js_KeyValue(&store, stream_, bucket_.c_str());
  kvStore_Destroy(store);
  return status;
}

void NatsServer::begin_keeping() {
  if (const natsStatus status = open_bucket(); status != NATS_OK) {
    tell_("the server keeps no words (" + reason_of(status) + "): newcomers are told by those that live");
    return jsCtx_Destroy(std::exchange(stream_, nullptr));
  }
  tell_("words are kept in the bucket " + bucket_);
  keeper_.begin();
}

void NatsServer::put(const std::string& participant, unsigned index, Word word) {
  if (natsConnection_Buffered(connection_) > max_unsent_kept_octets ||
      natsConnection_Publish(connection_, subject(participant, index).c_str(), word.data(),
                             static_cast<int>(word.size())) != NATS_OK) {
    tally_.count("words to keep that the server did not take in time");
  }
}

/// Purges the key, as `nats kv purge` does.
void NatsServer::remove(const std::string& participant, unsigned index) {
  natsMsg* message = nullptr;
  if (natsMsg_Create(&message, subject(participant, index).c_str(), nullptr, nullptr, 0) != NATS_OK) return;
  natsMsgHeader_Set(message, "KV-Operation", "PURGE");
  natsMsgHeader_Set(message, "Nats-Rollup", "sub");
  natsConnection_PublishMsg(connection_, message);
  natsMsg_Destroy(message);
}

void NatsServer::read() {
  natsSubscription_Destroy(std::exchange(reading_, nullptr));
  is_read_ = false;
  jsSubOptions how;
  jsSubOptions_Init(&how);
  how.Ordered = true;
  how.Config.DeliverPolicy = js_DeliverLastPerSubject;
  const auto on_kept = [](natsConnection*, natsSubscription*, natsMsg* message, void* user) {
    static_cast<NatsServer*>(user)->on_kept(message);
    natsMsg_Destroy(message);
  };
  const std::string all = kept_subject_ + '>';
  const natsStatus status = js_Subscribe(&reading_, stream_, all.c_str(), on_kept, this, nullptr, &how, nullptr);
  if (status != NATS_OK) tell_("the kept words cannot be read (" + reason_of(status) + ')');
}

/// On a thread of libnats.
void NatsServer::on_kept(natsMsg* message) {
  jsMsgMetaData* about = nullptr;
  if (natsMsg_GetMetaData(&about, message) == NATS_OK && about->NumPending == 0) is_read_ = true;
  jsMsgMetaData_Destroy(about);
  if (std::string_view(natsMsg_GetSubject(message)).starts_with(kept_subject_ + settings_.site + '.')) return;
  const int size = natsMsg_GetDataLength(message);
  keeper_.take(Word(reinterpret_cast<const std::byte*>(natsMsg_GetData(message)),
                    static_cast<std::size_t>(size < 0 ? 0 : size)));
}

void NatsServer::leave() {
  if (!is_up()) return;
  keeper_.leave();
  natsConnection_FlushTimeout(connection_, second_in_ms);
}

void NatsServer::disconnect() {
  keeper_.end();
  natsSubscription_Destroy(std::exchange(reading_, nullptr));
  jsCtx_Destroy(std::exchange(stream_, nullptr));
  if (connection_ != nullptr) natsConnection_Close(connection_);
  natsSubscription_Destroy(std::exchange(subscription_, nullptr));
  natsConnection_Destroy(std::exchange(connection_, nullptr));
}

bool NatsServer::is_up() const {
  return connection_ != nullptr && natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED;
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
  if (is_read_.exchange(false)) natsSubscription_Destroy(std::exchange(reading_, nullptr));
  if (is_up()) return;
  const std::string where = settings_.host + ':' + std::to_string(settings_.port);
  if (connection_ != nullptr) {
    const char* text = nullptr;
    const bool is_told = natsConnection_GetLastError(connection_, &text) != NATS_OK && text != nullptr && *text != '\0';
    tell_once("no words from " + where + " (" + base::printable(is_told ? text : "the connection ended") +
              "): trying again");
    disconnect();
  }
  if (const natsStatus status = connect(); status != NATS_OK) {
    tell_once("no words from " + where + " (" + reason_of(status) + "): trying again");
    return disconnect();
  }
  tell_once("carrying words by " + where + " as " + settings_.site);
  begin_keeping();
}

void NatsServer::tell_once(const std::string& line) {
  if (std::exchange(last_line_, line) != line) tell_(line);
}

void NatsServer::say(Word word) {
  if (!is_up()) return tally_.count("words while there is no server");
  if (natsConnection_Buffered(connection_) > max_unsent_octets) {
    return tally_.count("words that the server did not take in time");
  }
  if (natsConnection_Publish(connection_, own_.c_str(), word.data(), static_cast<int>(word.size())) != NATS_OK) {
    tally_.count("words that the server did not take in time");
  }
}

}  // namespace geminga::bridge
