#include "bridge/mosquitto/mqtt_server.hpp"

#include <fcntl.h>
#include <mosquitto.h>
#include <mqtt_protocol.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace geminga::bridge {
namespace {

/// The time without a message after which either side asks whether the other is there.
constexpr int keepalive_seconds = 10;
constexpr std::chrono::seconds longest_pause{16};
/// Packets that are read before other work has its turn.
constexpr int packets_at_once = 64;
constexpr const char* there = "there";

std::string reason_of(int result) {
  return result == MOSQ_ERR_ERRNO ? std::strerror(errno) : mosquitto_strerror(result);
}

}  // namespace

MqttServer::MqttServer(client::Reactor& reactor, WordSettings settings, Version version, Tally& tally, Told told)
    : reactor_(reactor),
      settings_(std::move(settings)),
      version_(version),
      tally_(tally),
      told_(std::move(told)),
      second_(reactor, [this] { on_second(); }),
      again_(reactor, [this] { connect(); }),
      keeper_(reactor, tally, *this),
      read_(reactor, [this] { end_reading(); }) {
  mosquitto_lib_init();
}

MqttServer::~MqttServer() {
  watch_.stop();
  if (client_ != nullptr) mosquitto_destroy(client_);
  mosquitto_lib_cleanup();
}

std::expected<void, std::string> MqttServer::start() {
  const std::string name = "geminga-" + settings_.team + '-' + settings_.site;
  client_ = mosquitto_new(name.c_str(), true, this);
  if (client_ == nullptr) return std::unexpected(std::strerror(errno));
  mosquitto_connect_callback_set(
      client_, [](mosquitto*, void* user, int code) { static_cast<MqttServer*>(user)->on_connect(code); });
  mosquitto_message_callback_set(client_, [](mosquitto*, void* user, const mosquitto_message* message) {
    static_cast<MqttServer*>(user)->on_message(*message);
  });
  mosquitto_publish_callback_set(client_, [](mosquitto*, void* user, int) {
    auto& self = *static_cast<MqttServer*>(user);
    if (self.unsent_ > 0) --self.unsent_;
  });
  const std::string own = topic("site", settings_.site);
  if (version_ == Version::v5) mosquitto_int_option(client_, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5);
  int result = mosquitto_will_set(client_, own.c_str(), 0, nullptr, 1, true);
  if (result == MOSQ_ERR_SUCCESS && !settings_.user.empty()) {
    result = mosquitto_username_pw_set(client_, settings_.user.c_str(), settings_.password.c_str());
  }
  if (result == MOSQ_ERR_SUCCESS && settings_.is_secure) {
    const char* file = settings_.ca_file.empty() ? nullptr : settings_.ca_file.c_str();
    const bool has_own = !settings_.certificate.empty();
    result = mosquitto_tls_set(client_, file, file == nullptr ? "/etc/ssl/certs" : nullptr,
                               has_own ? settings_.certificate.c_str() : nullptr,
                               has_own ? settings_.certificate_key.c_str() : nullptr, nullptr);
  }
  if (result != MOSQ_ERR_SUCCESS) return std::unexpected(reason_of(result));
  connect();
  return {};
}

void MqttServer::connect() {
  const int result = mosquitto_connect_async(client_, settings_.host.c_str(), settings_.port, keepalive_seconds);
  if (result != MOSQ_ERR_SUCCESS) return lose(reason_of(result));
  copy_ = client::Socket(::fcntl(mosquitto_socket(client_), F_DUPFD_CLOEXEC, 0));
  watch_ = reactor_.watch(copy_, [this](client::Reactor::Ready ready) {
    // A step may lose the connection, and the next one is of another.
    if (ready.can_write) step(mosquitto_loop_write(client_, packets_at_once));
    if (ready.can_read && copy_.is_open()) step(mosquitto_loop_read(client_, packets_at_once));
  });
  watch_.want(true, true);
  second_.set(reactor_.now() + std::chrono::seconds(1));
}

void MqttServer::step(int result) {
  if (result != MOSQ_ERR_SUCCESS) return lose(reason_of(result));
  watch_.want(true, mosquitto_want_write(client_));
}

void MqttServer::lose(const std::string& why) {
  watch_.stop();
  copy_.close();
  second_.set(base::never);
  is_up_ = false;
  keeper_.end();
  read_of_.clear();
  unsent_ = 0;
  sites_.clear();
  tell_once("no words from " + settings_.host + ':' + std::to_string(settings_.port) + " (" + why + "): trying again");
  again_.set(reactor_.now() + pause_);
  pause_ = std::min(pause_ * 2, longest_pause);
}

void MqttServer::on_connect(int code) {
  if (code != 0) {
    const char* why = version_ == Version::v5 ? mosquitto_reason_string(code) : mosquitto_connack_string(code);
    return tell_once("the server does not take us: " + std::string(why));
  }
  pause_ = std::chrono::seconds(1);
  last_line_.clear();
  is_up_ = true;
  const std::string own = topic("site", settings_.site);
  mosquitto_publish(client_, nullptr, own.c_str(), static_cast<int>(std::strlen(there)), there, 1, true);
  for (const char* kind : {"word", "site"}) mosquitto_subscribe(client_, nullptr, topic(kind, "+").c_str(), 0);
  told_.log("carrying words by " + settings_.host + ':' + std::to_string(settings_.port) + " as " + settings_.site);
  keeper_.begin();
}

void MqttServer::on_message(const mosquitto_message& message) {
  const std::string words = topic("word", "");
  const std::string sites = topic("site", "");
  const std::string kept = topic("kept", "");
  const std::string from(message.topic);
  const Word payload(static_cast<const std::byte*>(message.payload), static_cast<std::size_t>(message.payloadlen));
  if (from.starts_with(words)) return on_word(from.substr(words.size()), payload, message.retain);
  if (from.starts_with(kept)) return on_kept(from, payload);
  if (!from.starts_with(sites)) return tally_.count("messages that nobody has asked for");
  on_site(from.substr(sites.size()), !payload.empty());
}

void MqttServer::on_word(std::string_view site, Word payload, bool is_retained) {
  if (site == settings_.site) return;
  // A word that a server has kept proves nothing and may be old. Those that it is to keep are given in another way.
  if (is_retained) return tally_.count("words that the server had kept");
  told_.word(payload);
}

void MqttServer::on_site(const std::string& site, bool is_there) {
  if (site == settings_.site) return;
  if (!is_there) {
    if (sites_.erase(site) > 0) ask_for_kept(site);
  } else if (sites_.size() < max_sites) {
    sites_.insert(site);
  }
}

void MqttServer::on_kept(const std::string& topic_of_word, Word payload) {
  const std::string kept = topic("kept", "");
  const std::string site = topic_of_word.substr(kept.size(), topic_of_word.find('/', kept.size()) - kept.size());
  if (site == settings_.site || payload.empty()) return;
  // The server has told of all sites before, and of each before its words.
  const bool is_left = !sites_.contains(site) && sites_.size() < max_sites;
  if (is_left) return retain(topic_of_word, {});
  if (read_of_.contains("+")) keeper_.take(payload);
}

void MqttServer::put(const std::string& participant, unsigned index, Word word) {
  if (unsent_ >= max_unsent_kept) return tally_.count("words to keep that the server did not take in time");
  retain(topic("kept", settings_.site) + '/' + participant + '/' + std::to_string(index), word);
}

void MqttServer::remove(const std::string& participant, unsigned index) {
  retain(topic("kept", settings_.site) + '/' + participant + '/' + std::to_string(index), {});
}

void MqttServer::retain(const std::string& where, Word payload) {
  mosquitto_property* properties = nullptr;
  if (version_ == Version::v5 && !payload.empty()) {
    mosquitto_property_add_int32(&properties, MQTT_PROP_MESSAGE_EXPIRY_INTERVAL,
                                 static_cast<std::uint32_t>(kept_time.count()));
  }
  ++unsent_;
  const int result = mosquitto_publish_v5(client_, nullptr, where.c_str(), static_cast<int>(payload.size()),
                                          payload.data(), 0, true, properties);
  mosquitto_property_free_all(&properties);
  if (is_up_) watch_.want(true, true);
  if (result != MOSQ_ERR_SUCCESS) tally_.count("words to keep that the server did not take in time");
}

void MqttServer::read() { ask_for_kept("+"); }

void MqttServer::ask_for_kept(const std::string& site) {
  if (!is_up_) return;
  mosquitto_subscribe(client_, nullptr, (topic("kept", site) + "/+/+").c_str(), 0);
  read_of_.insert(site);
  read_.set(reactor_.now() + reading_time);
}

void MqttServer::end_reading() {
  for (const std::string& site : std::exchange(read_of_, {})) {
    if (is_up_) mosquitto_unsubscribe(client_, nullptr, (topic("kept", site) + "/+/+").c_str());
  }
  if (is_up_) watch_.want(true, true);
}

void MqttServer::on_second() {
  second_.set(reactor_.now() + std::chrono::seconds(1));
  step(mosquitto_loop_misc(client_));
  if (is_up_) tell_sites();
}

void MqttServer::say(Word word) {
  if (!is_up_) return tally_.count("words while there is no server");
  if (unsent_ >= max_unsent_words) return tally_.count("words that the server did not take in time");
  const std::string own = topic("word", settings_.site);
  ++unsent_;
  step(mosquitto_publish(client_, nullptr, own.c_str(), static_cast<int>(word.size()), word.data(), 0, false));
}

void MqttServer::leave() {
  if (!is_up_) return;
  keeper_.leave();
  const std::string own = topic("site", settings_.site);
  mosquitto_publish(client_, nullptr, own.c_str(), 0, nullptr, 1, true);
  mosquitto_loop_write(client_, packets_at_once);
  mosquitto_disconnect(client_);
  mosquitto_loop_write(client_, packets_at_once);
  is_up_ = false;
}

void MqttServer::tell_once(const std::string& line) {
  if (std::exchange(last_line_, line) != line) told_.log(line);
}

void MqttServer::tell_sites() {
  if (std::exchange(told_sites_, sites_.size()) == sites_.size()) return;
  told_.log("other sites on the server: " + std::to_string(sites_.size()));
}

}  // namespace geminga::bridge
