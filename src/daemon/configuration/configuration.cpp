#include "daemon/configuration/configuration.hpp"

#include <net/if.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/address.hpp"
#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/limits.hpp"
#include "env/asio/socket_file.hpp"

namespace geminga::daemon {
namespace {

constexpr std::uint16_t default_port = 4717;
/// The most participants of --adopt-from.
constexpr std::size_t max_publishers = 16;
/// The folder of what is adopted, in the state folder.
constexpr const char* adopted_name = "adopted";
/// The peer that stands for every host with the team's key.
constexpr std::string_view any_peer = "*";
constexpr std::array<std::pair<std::string_view, base::LogLevel>, 4> log_levels{{{"debug", base::LogLevel::debug},
                                                                                 {"info", base::LogLevel::info},
                                                                                 {"warning", base::LogLevel::warning},
                                                                                 {"error", base::LogLevel::error}}};

constexpr std::array<std::pair<std::string_view, CageWish>, 3> cage_wishes{
    {{"wanted", CageWish::wanted}, {"required", CageWish::required}, {"none", CageWish::none}}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_interface_name(std::string_view name) {
  return !name.empty() && name.size() < IFNAMSIZ && !base::has_control_character(name);
}

bool is_prefix_name(std::string_view name) {
  return !name.empty() && name.size() <= max_prefix_name_bytes && is_letter(name.front()) &&
         std::ranges::all_of(name,
                             [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

/// Whether a text has a scheme and can stand between angle brackets (IRIREF of Turtle 1.1).
bool is_iri(std::string_view text) {
  const auto colon = text.find(':');
  return text.size() <= max_prefix_iri_bytes && colon != std::string_view::npos && colon > 0 &&
         is_letter(text.front()) && base::is_valid_utf8(text) && !base::has_control_character(text) &&
         text.find_first_of(" <>\"{}|^`\\") == std::string_view::npos;
}

class Resolver {
 public:
  explicit Resolver(const std::vector<const Layer*>& layers) : layers_(layers) {}

  std::expected<Configuration, std::vector<std::string>> resolve(const std::string& host_name) {
    read_texts(host_name);
    result_.is_strict = read_truth("strict");
    result_.diagnoses = read_truth("diagnose");
    result_.relay = read_truth("relay");
    result_.air.are_peers_links = result_.relay;
    read_prefixes();
    read_gcnp();
    read_air();
    read_sealing();
    admit_guests();
    read_interval();
    read_logging();
    read_cage();
    if (!errors_.empty()) return std::unexpected(std::move(errors_));
    return std::move(result_);
  }

 private:
  /// The values in the strongest layer that states the key, or null.
  [[nodiscard]] const std::vector<Stated>* stated(std::string_view key) const {
    for (const Layer* layer : layers_) {
      const auto found = layer->values.find(key);
      if (found != layer->values.end()) return &found->second;
    }
    return nullptr;
  }

  [[nodiscard]] const Stated* single(std::string_view key) const {
    const auto* values = stated(key);
    return values == nullptr || values->empty() ? nullptr : &values->front();
  }

  [[nodiscard]] const std::vector<Stated>& list(std::string_view key, std::size_t most) {
    static const std::vector<Stated> none;
    const auto* values = stated(key);
    if (values == nullptr) return none;
    if (values->size() > most) {
      fail(values->back(), "more than " + std::to_string(most) + " values");
      return none;
    }
    return *values;
  }

  void fail(const Stated& at, const std::string& what) { errors_.push_back(at.origin + ": " + what); }
  void refuse(const Stated& value, const std::string& why) {
    fail(value, '\'' + base::printable(value.text) + "' " + why);
  }

  void read_texts(const std::string& host_name) {
    for (const Stated& ontology : list("ontology", max_values)) {
      if (ontology.text.empty()) {
        fail(ontology, "an empty path: name a file or a folder");
      } else {
        result_.ontologies.push_back(ontology.text);
      }
    }
    if (announcement::is_valid_name(host_name)) result_.name = host_name;
    read_name("name", result_.name);
    read_name("group", result_.group);
    if (const Stated* description = single("describe")) {
      result_.description = description->text;
      if (description->text.size() > max_description_bytes) {
        fail(*description, "more than " + std::to_string(max_description_bytes) + " octets");
      }
    }
    if (const Stated* folder = single("state-folder")) {
      if (folder->text.empty()) fail(*folder, "an empty path: name a folder");
      result_.state_folder = folder->text;
    }
    read_publishers();
  }

  /// Each is also the name of a folder.
  void read_publishers() {
    for (const Stated& publisher : list("adopt-from", max_publishers)) {
      if (!announcement::is_valid_name(publisher.text) || publisher.text.starts_with('.')) {
        refuse(publisher, "is no participant whose ontologies could be adopted: use a name without '.' in front");
      } else if (result_.state_folder.empty()) {
        fail(publisher, "there is no place for adopted ontologies: give --state-folder, too");
      } else if (std::ranges::find(result_.adopted.publishers, publisher.text) == result_.adopted.publishers.end()) {
        result_.adopted.folder = (std::filesystem::path(result_.state_folder) / adopted_name).string();
        result_.adopted.publishers.push_back(publisher.text);
      }
    }
  }

  bool read_truth(std::string_view key) {
    const Stated* truth = single(key);
    if (truth == nullptr) return false;
    if (truth->text != "true" && truth->text != "false") refuse(*truth, "is no truth value: use true or false");
    return truth->text == "true";
  }

  void read_prefixes() {
    for (const Layer* layer : layers_) {
      for (const auto& [name, iri] : layer->prefixes) {
        if (!is_prefix_name(name)) {
          fail(iri, '\'' + base::printable(name) + "' is no prefix: a letter, then letters, digits, '-' and '_'");
        } else if (!is_iri(iri.text)) {
          refuse(iri, "is no IRI");
        } else if (result_.prefixes.size() == max_prefixes) {
          fail(iri, "more than " + std::to_string(max_prefixes) + " prefixes");
          return;
        } else {
          result_.prefixes.emplace(name, iri.text);
        }
      }
    }
  }

  void read_name(std::string_view key, std::string& name) {
    const Stated* given = single(key);
    if (given == nullptr) return;
    if (!announcement::is_valid_name(given->text)) {
      refuse(*given, "is no name: 1 to " + std::to_string(max_name_bytes) +
                         " octets of UTF-8 without control characters, '/' and ','");
    }
    name = given->text;
  }

  void read_gcnp() {
    if (const Stated* path = single("gcnp-socket")) {
      if (path->text.empty() || path->text.size() > env::max_socket_path_bytes ||
          base::has_control_character(path->text)) {
        refuse(*path, "is no path of a socket: use 1 to " + std::to_string(env::max_socket_path_bytes) + " octets");
      }
      result_.gcnp_socket = path->text;
    }
    if (stated("gcnp") == nullptr) {
      result_.gcnp = {{{"127.0.0.1", default_port}, false}, {{"::1", default_port}, true}};
      return;
    }
    const auto& given = list("gcnp", max_addresses);
    const bool is_off = given.size() == 1 && given.front().text == "none";
    for (const Stated& text : given) {
      if (!is_off) read_gcnp_address(text);
    }
    if (is_off && result_.gcnp_socket.empty()) {
      fail(given.front(), "nobody could reach the daemon without TCP: give --gcnp-socket PATH, too");
    }
    if (given.empty() && errors_.empty()) errors_.emplace_back("gcnp: an empty list: nobody could reach the daemon");
  }

  void read_gcnp_address(const Stated& text) {
    const auto endpoint = env::parse_endpoint(text.text);
    if (!endpoint) {
      fail(text, endpoint.error());
    } else if (!env::is_loopback(endpoint->address)) {
      fail(text, env::to_string(*endpoint) + " is not on this host alone: GCNP is local, use 127.0.0.1 or [::1]");
    } else if (std::ranges::none_of(result_.gcnp, [&](const auto& known) { return known.endpoint == *endpoint; })) {
      result_.gcnp.push_back({*endpoint, false});
    }
  }

  void read_air() {
    env::AirSettings& air = result_.air;
    air.port = default_port;
    if (const Stated* port = single("port")) {
      const auto number = base::parse_number<std::uint16_t>(port->text);
      if (!number || *number == 0) {
        refuse(*port, "is no port: use a number from 1 to 65535");
      } else {
        air.port = *number;
      }
    }
    air.groups = {"239.192.47.17", "ff02::4717"};
    if (stated("multicast") != nullptr) read_groups();
    for (const Stated& name : list("interface", max_values)) {
      if (!is_interface_name(name.text)) {
        refuse(name, "is no name of an interface: see ip link");
      } else if (std::ranges::find(air.interfaces, name.text) == air.interfaces.end()) {
        air.interfaces.push_back(name.text);
      }
    }
    for (const Stated& text : list("announce-address", env::max_announced_addresses)) read_announced(text);
    for (const Stated& text : list("peer", env::max_unicast_peers)) {
      if (text.text == any_peer) {
        any_peer_ = text;
        continue;
      }
      const auto peer = env::parse_host_port(text.text, air.port);
      if (!peer) {
        fail(text, peer.error());
      } else if (env::is_multicast(peer->host)) {
        fail(text, peer->host + " is a multicast group: use --multicast");
      } else if (std::ranges::find(air.peers, *peer) == air.peers.end()) {
        air.peers.push_back(*peer);
      }
    }
  }

  /// `ADDRESS`, or `INTERFACE=ADDRESS`.
  void read_announced(const Stated& text) {
    const std::size_t equals = std::min(text.text.find('='), text.text.size());
    const bool is_named = equals < text.text.size();
    const std::string interface = is_named ? text.text.substr(0, equals) : "";
    if (is_named && !is_interface_name(interface)) return refuse(text, "names no interface before '=': see ip link");
    const auto address = env::parse_address(is_named ? text.text.substr(equals + 1) : text.text);
    if (!address) return fail(text, address.error());
    if (env::is_multicast(*address) || env::is_loopback(*address) ||
        base::address_scope(*address) == base::AddressScope::unspecified)
      return fail(text, *address + " is no address at which others can reach this host");
    result_.air.announced.push_back({.interface = interface, .address = *address});
  }

  void read_groups() {
    result_.air.groups.clear();
    for (const Stated& text : list("multicast", max_addresses)) {
      const auto group = env::parse_address(text.text);
      if (!group) {
        fail(text, group.error());
      } else if (!env::is_multicast(*group)) {
        fail(text, *group + " is no multicast group: use one of 239.0.0.0/8 or ff02::/16");
      } else if (std::ranges::find(result_.air.groups, *group) == result_.air.groups.end()) {
        result_.air.groups.push_back(*group);
      }
    }
  }

  void read_sealing() {
    for (const Stated& file : list("key-file", sealing::max_keys)) {
      if (file.text.empty()) {
        fail(file, "an empty path: name a key file");
      } else {
        result_.key_files.push_back(file.text);
      }
    }
    if (!result_.key_files.empty()) result_.sealing.mode = sealing::Mode::encrypted;
    const Stated* word = single("sealing");
    if (word == nullptr) return;
    const auto mode = sealing::read_mode(word->text);
    if (!mode) {
      refuse(*word, "is no mode: use encrypted, authenticated, mixed, prepared or plain");
    } else if (*mode == sealing::Mode::plain && !result_.key_files.empty()) {
      fail(*word, "plain with a key: leave the key files out, or say prepared");
    } else if (*mode != sealing::Mode::plain && result_.key_files.empty()) {
      fail(*word, word->text + " without a key: give --key-file, too");
    } else {
      result_.sealing.mode = *mode;
      result_.says_plain = *mode == sealing::Mode::plain;
    }
  }

  /// Admits peers without a name where every datagram that is heard is sealed.
  void admit_guests() {
    const bool is_sealed = result_.sealing.mode >= sealing::Mode::authenticated;
    result_.admits_any_peer = any_peer_.has_value();
    const bool is_asked = any_peer_ || !result_.air.peers.empty();
    if (is_sealed) result_.air.admission = is_asked ? env::Admission::asked : env::Admission::sealed;
    if (!any_peer_ || is_sealed) return;
    fail(*any_peer_, "'*' admits whoever has the team's key: give --key-file, and no --sealing but authenticated");
  }

  void read_interval() {
    const Stated* text = single("interval");
    if (text == nullptr) return;
    double seconds = 0;
    const char* end = text->text.data() + text->text.size();
    const auto [stop, error] = std::from_chars(text->text.data(), end, seconds, std::chars_format::fixed);
    const bool is_number = error == std::errc() && stop == end && std::isfinite(seconds);
    if (!is_number || seconds < std::chrono::duration<double>(announcement::min_interval).count() ||
        seconds > std::chrono::duration<double>(announcement::max_interval).count()) {
      refuse(*text, "is no interval: use 0.05 to 60 seconds");
      return;
    }
    result_.interval = std::chrono::milliseconds(std::llround(seconds * 1000));
  }

  void read_logging() {
    if (const Stated* level = single("log-level")) {
      const auto* const found = std::ranges::find(log_levels, level->text, [](const auto& pair) { return pair.first; });
      if (found == log_levels.end()) {
        refuse(*level, "is no level: use debug, info, warning or error");
      } else {
        result_.log_level = found->second;
      }
    }
    if (const Stated* format = single("log-format")) {
      if (format->text != "text" && format->text != "json") {
        refuse(*format, "is no format: use text or json");
      }
      result_.log_format = format->text == "json" ? LogFormat::json : LogFormat::text;
    }
  }

  void read_cage() {
    const Stated* wish = single("cage");
    if (wish == nullptr) return;
    const auto* const found = std::ranges::find(cage_wishes, wish->text, [](const auto& pair) { return pair.first; });
    if (found == cage_wishes.end()) return refuse(*wish, "is no wish for a cage: use wanted, required or none");
    result_.cage = found->second;
  }

  const std::vector<const Layer*>& layers_;
  Configuration result_;
  std::optional<Stated> any_peer_;
  std::vector<std::string> errors_;
};

}  // namespace

std::expected<Configuration, std::vector<std::string>> resolve(const std::vector<const Layer*>& layers,
                                                               const std::string& host_name) {
  return Resolver(layers).resolve(host_name);
}

std::string_view to_string(base::LogLevel level) {
  return std::ranges::find(log_levels, level, [](const auto& pair) { return pair.second; })->first;
}

}  // namespace geminga::daemon
