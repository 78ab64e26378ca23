// A reader or writer of DDS, and the service or request that it becomes.
#ifndef GEMINGA_BRIDGE_ROS_ENDPOINT_HPP
#define GEMINGA_BRIDGE_ROS_ENDPOINT_HPP

#include <chrono>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "bridge/team/foreign_services.hpp"

namespace geminga::bridge {

/// The policies by which a reader and a writer can fail to meet (OMG DDS 1.4, section 2.2.3). Kinds ascend: a writer
/// meets a reader that asks for the same or less.
struct Qos {
  enum class Reliability : std::uint8_t { best_effort, reliable };
  enum class Durability : std::uint8_t { volatile_, transient_local, transient, persistent };
  enum class Liveliness : std::uint8_t { automatic, manual_by_participant, manual_by_topic };
  Reliability reliability = Reliability::best_effort;
  Durability durability = Durability::volatile_;
  Liveliness liveliness = Liveliness::automatic;
  std::optional<std::chrono::nanoseconds> deadline{};  ///< nothing: infinite
  bool is_exclusive = false;                           ///< ownership
};

struct Endpoint {
  std::string topic;  ///< as DDS has it
  std::string type;   ///< as DDS has it
  bool is_writer = false;
  Qos qos{};
  std::string host{};     ///< the participant's host as it says; empty: it does not say
  std::string process{};  ///< the participant's program
};

/// The highest domain (RTPS 2.5, section 9.6.1.1: ports end there).
inline constexpr std::uint32_t max_domain = 232;
/// The longest name of a topic or type that is taken: a condition with it and all policies fits into max_where_bytes.
inline constexpr std::size_t max_topic_bytes = 150;

/// A writer becomes a publication and a reader a subscription, with mode otm/stream. Of a service of ROS 2 the reader
/// of the requests becomes a publication and their writer a subscription, with mode oto; replies become nothing. The
/// protocol is dds; the identity is the type, as text and, of a type of ROS 2, as the name of a concept; address and
/// port are where participants of the domain meet. A reader's topic and policies are its `where`.
///
/// The error is the reason by which it is counted; an empty one: it is no service at all.
[[nodiscard]] std::expected<Foreign, std::string_view> foreign_of(const Endpoint& endpoint, std::uint32_t domain,
                                                                  bool has_plumbing);

}  // namespace geminga::bridge

#endif
