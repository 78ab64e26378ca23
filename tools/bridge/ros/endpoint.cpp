#include "bridge/ros/endpoint.hpp"

#include <array>
#include <charconv>

#include "base/text.hpp"
#include "bridge/ros/names.hpp"

namespace geminga::bridge {
namespace {

constexpr std::array<std::string_view, 2> reliabilities{"best_effort", "reliable"};
constexpr std::array<std::string_view, 4> durabilities{"volatile", "transient_local", "transient", "persistent"};
constexpr std::array<std::string_view, 3> livelinesses{"automatic", "manual_by_participant", "manual_by_topic"};

/// The group of the discovery of DDS, and its port in a domain (RTPS 2.5, sections 9.6.1.1 and 9.6.2).
constexpr const char* discovery_group = "239.255.0.1";
std::uint16_t discovery_port(std::uint32_t domain) { return static_cast<std::uint16_t>(7400 + 250 * domain); }

template <typename Kind, std::size_t count>
std::string word(Kind kind, const std::array<std::string_view, count>& words) {
  return std::string(words.at(static_cast<std::size_t>(kind)));
}

std::string seconds(std::chrono::nanoseconds duration) {
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::chrono::duration<double>(duration).count()).ptr;
  return {text.data(), end};
}

Attributes attributes_of(const Endpoint& endpoint, const RosTopic& topic, const std::string& type,
                         std::uint32_t domain) {
  Attributes attributes{{std::string(bridge_attribute), "dds"},
                        {"topic", topic.name},
                        {"type", type},
                        {"domain", std::to_string(domain)},
                        {"dds.topic", endpoint.topic},
                        {"reliability", word(endpoint.qos.reliability, reliabilities)},
                        {"durability", word(endpoint.qos.durability, durabilities)},
                        {"liveliness", word(endpoint.qos.liveliness, livelinesses)},
                        {"ownership", endpoint.qos.is_exclusive ? "exclusive" : "shared"}};
  if (endpoint.qos.deadline) attributes["deadline"] = seconds(*endpoint.qos.deadline) + " s";
  if (!endpoint.host.empty()) attributes["dds.host"] = base::printable(endpoint.host, 100);
  if (!endpoint.process.empty()) attributes["dds.process"] = base::printable(endpoint.process, 100);
  return attributes;
}

/// `KEY in (the kinds from `least` on)`; empty where any will do.
template <typename Kind, std::size_t count>
std::string at_least(std::string_view key, Kind least, const std::array<std::string_view, count>& words) {
  const auto from = static_cast<std::size_t>(least);
  if (from == 0) return {};
  if (from + 1 == count) return " and " + std::string(key) + " = " + std::string(words.at(from));
  std::string set;
  for (std::size_t at = from; at < count; ++at) set += (set.empty() ? "" : ", ") + std::string(words.at(at));
  return " and " + std::string(key) + " in (" + set + ")";
}

/// The condition that a writer has to meet (OMG DDS 1.4, section 2.2.3: requested and offered).
std::string condition(const Endpoint& reader, const RosTopic& topic, std::uint32_t domain) {
  std::string where = "topic = '" + topic.name + "' and domain = " + std::to_string(domain);
  where += at_least("reliability", reader.qos.reliability, reliabilities);
  where += at_least("durability", reader.qos.durability, durabilities);
  where += at_least("liveliness", reader.qos.liveliness, livelinesses);
  if (reader.qos.deadline) where += " and deadline <= " + seconds(*reader.qos.deadline) + " s";
  return where + " and ownership = " + (reader.qos.is_exclusive ? "exclusive" : "shared");
}

/// Whether a name can be an attribute and stand in a condition as it is.
bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= max_topic_bytes && base::is_valid_utf8(text) &&
         !base::has_control_character(text) && text.find_first_of("'\"\\") == std::string_view::npos;
}

}  // namespace

std::expected<Foreign, std::string_view> foreign_of(const Endpoint& endpoint, std::uint32_t domain, bool has_plumbing) {
  if (!is_name(endpoint.topic) || !is_name(endpoint.type)) {
    return std::unexpected("readers and writers whose topic or type is no name");
  }
  const RosTopic topic = ros_topic(endpoint.topic);
  if (topic.part == RosPart::reply || (!has_plumbing && is_ros_plumbing(topic))) return std::unexpected("");
  const auto ros = ros_type(endpoint.type);
  const std::string type = ros.value_or(endpoint.type);
  const bool is_service = topic.part == RosPart::request;
  const ChannelMode mode = is_service ? ChannelMode::one_to_one : ChannelMode::one_to_many_stream;
  Foreign foreign{NamedPublication{}, ros.value_or("")};
  if (endpoint.is_writer != is_service) {
    foreign.stated = NamedPublication{.identity = TextIdentity{type},
                                      .mode = mode,
                                      .address = discovery_group,
                                      .port = discovery_port(domain),
                                      .protocol = "dds",
                                      .priority = 0,
                                      .attributes = attributes_of(endpoint, topic, type, domain)};
    return foreign;
  }
  NamedSubscription request;
  request.identity = TextIdentity{type};
  request.mode = mode;
  request.weakest = Degree::equivalent;
  request.protocols = {"dds"};
  request.limit = 0;
  request.where = is_service ? "topic = '" + topic.name + "' and domain = " + std::to_string(domain)
                             : condition(endpoint, topic, domain);
  request.attributes = attributes_of(endpoint, topic, type, domain);
  foreign.stated = std::move(request);
  return foreign;
}

}  // namespace geminga::bridge
