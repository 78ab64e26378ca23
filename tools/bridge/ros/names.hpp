// The names of ROS 2 in DDS: topics, services and types, mangled and plain (the ROS 2 design article "Topic and Service
// name mapping to DDS").
#ifndef GEMINGA_BRIDGE_ROS_NAMES_HPP
#define GEMINGA_BRIDGE_ROS_NAMES_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::bridge {

/// The part that an endpoint plays for ROS 2.
enum class RosPart : std::uint8_t {
  none,     ///< it is not ROS 2's
  topic,    ///< `rt/`: messages
  request,  ///< `rq/`: the requests of a service
  reply,    ///< `rr/`: its replies
};

struct RosTopic {
  RosPart part = RosPart::none;
  std::string name;  ///< e.g. `/camera/image`; of no ROS 2 topic the name as it is
};

/// `rt/camera/image` is the topic `/camera/image`; `rq/addRequest` and `rr/addReply` are the service `/add`.
[[nodiscard]] RosTopic ros_topic(std::string_view dds_topic);

/// `sensor_msgs::msg::dds_::Image_` is `sensor_msgs/msg/Image`, and `p::srv::dds_::Add_Request_` is `p/srv/Add`.
/// Nothing for what is no such name.
[[nodiscard]] std::optional<std::string> ros_type(std::string_view dds_type);

/// Whether every node of ROS 2 has it, so that it says nothing of the robot: parameters, logs, and ROS 2's own
/// discovery.
[[nodiscard]] bool is_ros_plumbing(const RosTopic& topic);

}  // namespace geminga::bridge

#endif
