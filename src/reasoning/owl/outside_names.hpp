// The names that classes have outside of Geminga: the annotations that state them. They mean nothing to the reasoner; a
// bridge names a class by them (tools/bridge/README.md).
#ifndef GEMINGA_REASONING_OWL_OUTSIDE_NAMES_HPP
#define GEMINGA_REASONING_OWL_OUTSIDE_NAMES_HPP

#include <string_view>

namespace geminga::owl {

/// The type of services that are of this class on DNS-SD, e.g. "_ipp._tcp".
inline constexpr std::string_view dns_service_type = "https://geminga.example/core#dnsServiceType";
/// The type of messages that are of this class in ROS 2, e.g. "sensor_msgs/msg/Image".
inline constexpr std::string_view message_type = "https://geminga.example/core#messageType";

/// Whether an annotation with this property gives a class a name from outside. A class is found by such a name as by a
/// label.
[[nodiscard]] constexpr bool is_outside_name(std::string_view property) {
  return property == dns_service_type || property == message_type;
}

}  // namespace geminga::owl

#endif
