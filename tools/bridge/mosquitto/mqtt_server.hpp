// A server of MQTT that carries words, by libmosquitto.
#ifndef GEMINGA_BRIDGE_MOSQUITTO_MQTT_SERVER_HPP
#define GEMINGA_BRIDGE_MOSQUITTO_MQTT_SERVER_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "base/time.hpp"
#include "bridge/team/tally.hpp"
#include "bridge/words/keeper.hpp"
#include "bridge/words/word_options.hpp"
#include "client/channels/reactor.hpp"
#include "client/channels/socket.hpp"

struct mosquitto;
struct mosquitto_message;

namespace geminga::bridge {

/// Words that the server has not taken yet. One more is dropped and counted: the air would have lost it, too.
inline constexpr std::size_t max_unsent_words = 512;
/// Words to keep give way to those that are said.
inline constexpr std::size_t max_unsent_kept = max_unsent_words / 2;
/// Other sites that are known at a time. More are not counted.
inline constexpr std::size_t max_sites = 1024;

/// Says each word under `geminga/TEAM/word/SITE` with QoS 0 and without `retain`, and hears those of all other sites.
/// Under `geminga/TEAM/site/SITE` a retained message stands while the site is there; its last will takes it away.
///
/// Words that are kept are retained under `geminga/TEAM/kept/SITE/PARTICIPANT/INDEX`. A server of MQTT 5 forgets them
/// after kept_time; on any other the bridges that are there take away what a site has left whose last will came.
///
/// Connects again by itself, after 1 s and then twice as long each time, up to 16 s. Neither copies nor moves.
class MqttServer : public Shelf {
 public:
  struct Told {
    std::function<void(Word)> word;  ///< from another site
    std::function<void(const std::string& line)> log;
  };

  /// The versions of MQTT that it can speak.
  enum class Version : std::uint8_t { v3_1_1, v5 };

  /// Borrows reactor and tally.
  MqttServer(client::Reactor& reactor, WordSettings settings, Version version, Tally& tally, Told told);
  ~MqttServer() override;
  MqttServer(const MqttServer&) = delete;
  MqttServer& operator=(const MqttServer&) = delete;

  /// Begins to connect. The error is one line: what libmosquitto cannot use.
  [[nodiscard]] std::expected<void, std::string> start();
  /// Says a word, if the server is there.
  void say(Word word);
  /// Takes the daemon's frames.
  [[nodiscard]] Keeper& keeper() { return keeper_; }
  void put(const std::string& participant, unsigned index, Word word) override;
  void remove(const std::string& participant, unsigned index) override;
  void read() override;
  /// Takes the retained messages away and says goodbye, without waiting longer than for what the system takes at once.
  void leave();

 private:
  void connect();
  void step(int result);
  void lose(const std::string& why);
  void on_connect(int code);
  void on_message(const mosquitto_message& message);
  void on_word(std::string_view site, Word payload, bool is_retained);
  void on_kept(const std::string& topic, Word payload);
  void on_site(const std::string& site, bool is_there);
  /// Retains a message, or takes it away where it is empty.
  void retain(const std::string& topic, Word payload);
  /// Asks for the kept words of a site, or of all by `+`, for reading_time.
  void ask_for_kept(const std::string& site);
  void end_reading();
  void on_second();
  void tell_once(const std::string& line);
  void tell_sites();
  [[nodiscard]] std::string topic(const std::string& kind, const std::string& site) const {
    return "geminga/" + settings_.team + '/' + kind + '/' + site;
  }

  client::Reactor& reactor_;
  WordSettings settings_;
  Version version_;
  Tally& tally_;
  Told told_;
  mosquitto* client_ = nullptr;
  bool is_up_ = false;
  std::size_t unsent_ = 0;
  std::set<std::string> sites_;
  std::set<std::string> read_of_;  ///< sites whose kept words are asked for
  std::size_t told_sites_ = 0;
  std::string last_line_;
  std::chrono::seconds pause_{1};
  client::Socket copy_;  ///< of libmosquitto's descriptor
  client::Reactor::Watch watch_;
  client::Reactor::Timer second_;
  client::Reactor::Timer again_;
  Keeper keeper_;
  client::Reactor::Timer read_;  ///< ends the reading
};

}  // namespace geminga::bridge

#endif
