#include "bridge/ros/names.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace geminga::bridge {
namespace {

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// The text without this end; nothing where it ends otherwise, or has nothing before it.
std::optional<std::string_view> without_end(std::string_view text, std::string_view end) {
  if (text.size() <= end.size() || !text.ends_with(end)) return std::nullopt;
  return text.substr(0, text.size() - end.size());
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; parts.size() < 6;) {
    const auto next = text.find("::", at);
    parts.push_back(text.substr(at, next - at));
    if (next == std::string_view::npos) break;
    at = next + 2;
  }
  return parts;
}

}  // namespace

RosTopic ros_topic(std::string_view dds_topic) {
  struct Prefix {
    std::string_view before, behind;
    RosPart part;
  };
  static constexpr std::array<Prefix, 3> prefixes{
      {{"rt/", "", RosPart::topic}, {"rq/", "Request", RosPart::request}, {"rr/", "Reply", RosPart::reply}}};
  for (const auto& [before, behind, part] : prefixes) {
    if (!dds_topic.starts_with(before)) continue;
    const auto name = without_end(dds_topic.substr(before.size() - 1), behind);
    if (name && *name != "/") return {part, std::string(*name)};
  }
  return {RosPart::none, std::string(dds_topic)};
}

std::optional<std::string> ros_type(std::string_view dds_type) {
  const std::vector<std::string_view> parts = parts_of(dds_type);
  if (parts.size() != 4 || parts[2] != "dds_") return std::nullopt;
  if (parts[1] != "msg" && parts[1] != "srv" && parts[1] != "action") return std::nullopt;
  auto name = without_end(parts[3], "_");
  if (!name || !is_word(parts[0]) || !is_word(*name)) return std::nullopt;
  if (parts[1] != "msg") {
    for (const std::string_view end : {"_Request", "_Response"}) {
      if (const auto service = without_end(*name, end)) name = service;
    }
  }
  return std::string(parts[0]) + '/' + std::string(parts[1]) + '/' + std::string(*name);
}

bool is_ros_plumbing(const RosTopic& topic) {
  static constexpr std::array<std::string_view, 3> topics{"ros_discovery_info", "/rosout", "/parameter_events"};
  static constexpr std::array<std::string_view, 7> services{
      "/describe_parameters", "/get_parameter_types",  "/get_parameters",           "/list_parameters",
      "/set_parameters",      "/get_type_description", "/set_parameters_atomically"};
  if (topic.part == RosPart::none || topic.part == RosPart::topic)
    return std::ranges::find(topics, topic.name) != topics.end();
  return std::ranges::any_of(services, [&](std::string_view end) { return topic.name.ends_with(end); });
}

}  // namespace geminga::bridge
