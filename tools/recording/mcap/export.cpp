#include "recording/mcap/export.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "recording/mcap/writer.hpp"

namespace geminga::recording::mcap {
namespace {

/// A channel, and the members of its messages beside `event`, `time` and `at`.
struct Topic {
  std::string_view name;
  std::string_view members;  ///< of the properties of a JSON schema (https://json-schema.org/draft/2020-12)
};

constexpr std::string_view of_record =
    R"("kind":{"type":"string"},"record":{"type":"object"},"key":{"type":"string"},"reason":{"type":"string"})";
constexpr std::string_view of_participant =
    R"("kind":{"type":"string"},"record":{"type":"object","properties":{"id":{"type":"string"},"name":{"type":"string"},)"
    R"("heard":{"type":"number"},"interval":{"type":"number"},"loss":{"type":"number"},)"
    R"("loss_least":{"type":"number"}}},)"
    R"("key":{"type":"string"},"reason":{"type":"string"})";
constexpr std::string_view of_heard =
    R"("records":{"type":"array","items":{"type":"object","properties":{"id":{"type":"string"},)"
    R"("heard":{"type":"number"},"loss":{"type":"number"},"loss_least":{"type":"number"}}}})";
constexpr std::string_view of_answer =
    R"("kind":{"type":"string"},"subscription":{"type":"string"},)"
    R"("records":{"type":"array","items":{"type":"object"}},"end":{"type":"object"})";
constexpr std::string_view of_recording =
    R"("participant":{"type":"string"},"name":{"type":"string"},"ontology":{"type":"string"},)"
    R"("rounds":{"type":"integer"},"text":{"type":"string"},"reason":{"type":"string"})";

constexpr std::array<Topic, 12> topics{{{"participants", of_participant},
                                        {"services", of_record},
                                        {"requests", of_record},
                                        {"heard", of_heard},
                                        {"why", of_answer},
                                        {"match", of_answer},
                                        {"status", of_answer},
                                        {"ontology", of_answer},
                                        {"security", of_answer},
                                        {"interfaces", of_answer},
                                        {"peers", of_answer},
                                        {"recording", of_recording}}};

std::string_view topic_of(const Event& event) {
  if (const auto* present = std::get_if<Present>(&event)) return present->record.kind;
  if (const auto* gone = std::get_if<Gone>(&event)) return gone->kind;
  if (std::holds_alternative<Heard>(event)) return "heard";
  const auto* answered = std::get_if<Answered>(&event);
  return answered == nullptr ? "recording" : std::string_view(answered->kind);
}

std::string schema_of(const Topic& topic) {
  return R"({"$schema":"https://json-schema.org/draft/2020-12/schema","type":"object","properties":{)"
         R"("event":{"type":"string"},"time":{"type":"string","format":"date-time"},"at":{"type":"number"},)" +
         std::string(topic.members) + R"(},"required":["event","time","at"]})";
}

Timestamp nanoseconds(Time time) {
  return static_cast<Timestamp>(std::chrono::nanoseconds(time.time_since_epoch()).count());
}

}  // namespace

std::expected<std::uint64_t, Finding> export_recording(Reader& reader, std::ostream& out) {
  Writer writer(out, "geminga-query");
  std::array<std::uint16_t, topics.size()> channels{};
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const std::string name(topics[i].name);
    channels[i] = writer.add_channel("/geminga/" + name, "geminga.recording." + name, schema_of(topics[i]));
  }
  std::uint64_t count = 0;
  std::optional<Time> begin;
  while (true) {
    auto entry = reader.next();
    if (!entry || !*entry) {
      writer.finish();
      if (!entry) return std::unexpected(std::move(entry.error()));
      return count;
    }
    if (!begin) begin = (*entry)->time - (*entry)->at;
    const auto topic = std::find_if(topics.begin(), topics.end(),
                                    [&](const Topic& one) { return one.name == topic_of((*entry)->event); });
    if (topic == topics.end()) continue;  // an answer of a kind that this version does not know
    std::string message = line_of(**entry);
    message.pop_back();
    // The clock of the host may have jumped; the order of messages is that of the clock that did not.
    writer.write(channels[static_cast<std::size_t>(topic - topics.begin())], nanoseconds(*begin + (*entry)->at),
                 nanoseconds((*entry)->time), message);
    ++count;
  }
}

}  // namespace geminga::recording::mcap
