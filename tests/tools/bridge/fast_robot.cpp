// A program of Fast DDS as a robot with ROS 2 has it: `fast_robot DOMAIN (w|r) TOPIC` makes a writer or a reader of
// laser scans, says `there`, and keeps it until it is ended.
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <functional>
#include <iostream>
#include <string>

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

/// A type of which nothing is sent here: its name is all that discovery needs.
class Scan : public fast::TopicDataType {
 public:
  Scan() {
    setName("sensor_msgs::msg::dds_::LaserScan_");
    m_typeSize = 8;
    m_isGetKeyDefined = false;
  }
  bool serialize(void*, rtps::SerializedPayload_t*) override { return true; }
  bool deserialize(rtps::SerializedPayload_t*, void*) override { return true; }
  std::function<uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return 8U; };
  }
  void* createData() override { return new int(0); }
  void deleteData(void* data) override { delete static_cast<int*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  auto* factory = fast::DomainParticipantFactory::get_instance();
  auto* participant =
      factory->create_participant(static_cast<unsigned>(std::atoi(argv[1])), fast::PARTICIPANT_QOS_DEFAULT);
  if (participant == nullptr) return 2;
  const fast::TypeSupport type(new Scan());
  type.register_type(participant);
  auto* topic = participant->create_topic(argv[3], type.get_type_name(), fast::TOPIC_QOS_DEFAULT);
  if (std::strcmp(argv[2], "w") == 0) {
    participant->create_publisher(fast::PUBLISHER_QOS_DEFAULT)->create_datawriter(topic, fast::DATAWRITER_QOS_DEFAULT);
  } else {
    participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT)
        ->create_datareader(topic, fast::DATAREADER_QOS_DEFAULT);
  }
  std::cout << "there" << std::endl;
  int which = 0;
  sigwait(&ends, &which);
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return 0;
}
