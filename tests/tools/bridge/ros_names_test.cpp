// ROS 2's names in DDS, and readers and writers as requests and services.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/ros/endpoint.hpp"
#include "bridge/ros/names.hpp"
#include "identity/service_limits.hpp"

namespace geminga::bridge {
namespace {

using testing::Contains;
using testing::Pair;

TEST(RosNames, AreDecodedAsTheDesignOfRosSays) {
  struct Case {
    const char* dds;
    RosPart part;
    const char* name;
  };
  for (const auto& [dds, part, name] :
       {Case{"rt/camera/image", RosPart::topic, "/camera/image"}, Case{"rq/addRequest", RosPart::request, "/add"},
        Case{"rr/ns/addReply", RosPart::reply, "/ns/add"},
        Case{"rt/fib/_action/status", RosPart::topic, "/fib/_action/status"}, Case{"rq/add", RosPart::none, "rq/add"},
        Case{"rt/", RosPart::none, "rt/"}, Case{"rq/Request", RosPart::none, "rq/Request"},
        Case{"Square", RosPart::none, "Square"}, Case{"", RosPart::none, ""}}) {
    EXPECT_EQ(ros_topic(dds).part, part) << dds;
    EXPECT_EQ(ros_topic(dds).name, name) << dds;
  }
}

TEST(RosTypes, AreDecodedOrLeftAlone) {
  EXPECT_EQ(ros_type("sensor_msgs::msg::dds_::Image_"), "sensor_msgs/msg/Image");
  EXPECT_EQ(ros_type("example_interfaces::srv::dds_::AddTwoInts_Request_"), "example_interfaces/srv/AddTwoInts");
  EXPECT_EQ(ros_type("example_interfaces::srv::dds_::AddTwoInts_Response_"), "example_interfaces/srv/AddTwoInts");
  EXPECT_EQ(ros_type("p::msg::dds_::Odd_Request_"), "p/msg/Odd_Request") << "only services have requests";
  for (const char* other :
       {"", "ShapeType", "a::msg::dds_::_", "a::msg::dds_::B", "a::msg::B_", "a::b::dds_::C_", "::msg::dds_::C_",
        "<urn:x>::msg::dds_::C_", "a::msg::dds_::B C_", "a::a::msg::dds_::C_", "::::::::::::::::::::::::"}) {
    EXPECT_EQ(ros_type(other), std::nullopt) << other;
  }
}

Endpoint scan(bool is_writer) {
  return {.topic = "rt/scan", .type = "sensor_msgs::msg::dds_::LaserScan_", .is_writer = is_writer};
}

Foreign foreign(const Endpoint& endpoint) {
  auto made = foreign_of(endpoint, 7, false);
  EXPECT_TRUE(made) << made.error();
  return made.value_or(Foreign{NamedPublication{}, ""});
}

TEST(Writer, BecomesAPublicationWithTopicTypeDomainAndPolicies) {
  Endpoint writer = scan(true);
  writer.qos = {.reliability = Qos::Reliability::reliable,
                .durability = Qos::Durability::transient_local,
                .deadline = std::chrono::milliseconds(500)};
  const Foreign made = foreign(writer);
  EXPECT_EQ(made.concept_name, "sensor_msgs/msg/LaserScan");
  const auto& stated = std::get<NamedPublication>(made.stated);
  EXPECT_EQ(stated.identity, NamedIdentity(TextIdentity{"sensor_msgs/msg/LaserScan"}));
  EXPECT_EQ(stated.mode, ChannelMode::one_to_many_stream);
  EXPECT_EQ(stated.protocol, "dds");
  EXPECT_EQ(stated.port, 7400 + 7 * 250);
  for (const auto& [key, value] : {std::pair("topic", "/scan"), std::pair("domain", "7"),
                                   std::pair("type", "sensor_msgs/msg/LaserScan"), std::pair("reliability", "reliable"),
                                   std::pair("durability", "transient_local"), std::pair("deadline", "0.5 s")}) {
    EXPECT_THAT(stated.attributes, Contains(Pair(key, value)));
  }
}

TEST(Reader, AsksForItsTopicAndForThePoliciesThatItNeeds) {
  Endpoint reader = scan(false);
  EXPECT_EQ(std::get<NamedSubscription>(foreign(reader).stated).where,
            "topic = '/scan' and domain = 7 and ownership = shared");
  reader.qos = {.reliability = Qos::Reliability::reliable,
                .durability = Qos::Durability::transient,
                .deadline = std::chrono::seconds(1)};
  const auto stated = std::get<NamedSubscription>(foreign(reader).stated);
  EXPECT_EQ(stated.where,
            "topic = '/scan' and domain = 7 and reliability = reliable and durability in (transient, persistent) and "
            "deadline <= 1 s and ownership = shared");
  EXPECT_EQ(stated.protocols, std::vector<std::string>{"dds"});
}

TEST(ServiceOfRos, IsOfferedByTheReaderOfItsRequests) {
  Endpoint server{.topic = "rq/addRequest", .type = "p::srv::dds_::Add_Request_", .is_writer = false};
  const auto offered = std::get<NamedPublication>(foreign(server).stated);
  EXPECT_EQ(offered.mode, ChannelMode::one_to_one);
  EXPECT_THAT(offered.attributes, Contains(Pair("topic", "/add")));
  server.is_writer = true;
  EXPECT_EQ(std::get<NamedSubscription>(foreign(server).stated).where, "topic = '/add' and domain = 7");
  Endpoint reply{.topic = "rr/addReply", .type = "p::srv::dds_::Add_Response_", .is_writer = true};
  EXPECT_EQ(foreign_of(reply, 0, false).error(), "");
}

TEST(Plumbing, IsLeftOutUnlessWanted) {
  Endpoint logs{.topic = "rt/rosout", .type = "rcl_interfaces::msg::dds_::Log_", .is_writer = true};
  EXPECT_EQ(foreign_of(logs, 0, false).error(), "");
  EXPECT_TRUE(foreign_of(logs, 0, true));
  Endpoint parameters{.topic = "rq/node/get_parametersRequest",
                      .type = "rcl_interfaces::srv::dds_::GetParameters_Request_",
                      .is_writer = false};
  EXPECT_FALSE(foreign_of(parameters, 0, false));
}

TEST(HostileNames, AreCountedAndNothingOfThemIsStated) {
  const auto fails = [](const std::string& topic, const std::string& type) {
    const auto made = foreign_of({.topic = topic, .type = type, .is_writer = false}, 0, false);
    return !made && !made.error().empty();
  };
  EXPECT_TRUE(fails("rt/a' or '' = '", "T"));
  EXPECT_TRUE(fails("rt/\xff", "T"));
  EXPECT_TRUE(fails("rt/a", "T\x1b[2J"));
  EXPECT_TRUE(fails("", "T"));
  for (const std::size_t size : {max_topic_bytes - 1, max_topic_bytes, max_topic_bytes + 1}) {
    EXPECT_EQ(fails(std::string(size, 't'), "T"), size > max_topic_bytes) << size;
  }
  Endpoint longest{.topic = std::string(max_topic_bytes, 't'),
                   .type = "T",
                   .is_writer = false,
                   .qos = {.reliability = Qos::Reliability::reliable,
                           .durability = Qos::Durability::transient_local,
                           .liveliness = Qos::Liveliness::manual_by_participant,
                           .deadline = std::chrono::nanoseconds(1234567891),
                           .is_exclusive = true}};
  const auto made = foreign_of(longest, max_domain, false);
  EXPECT_LE(std::get<NamedSubscription>(made->stated).where.size(), max_where_bytes);
}

}  // namespace
}  // namespace geminga::bridge
