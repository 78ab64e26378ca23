#include "bridge/cyclone/domain.hpp"

#include <array>
#include <utility>

#include "base/text.hpp"

namespace geminga::bridge {
namespace {

/// Samples that are taken at once.
constexpr std::size_t batch = 64;

std::string key_of(const dds_guid_t& guid) {
  std::string key;
  for (const std::uint8_t octet : guid.v) key += base::to_hex(octet, 2);
  return key;
}

std::string text(const char* given) { return given == nullptr ? std::string() : std::string(given); }

/// A property of a participant; empty where it has none.
std::string property(const dds_qos_t* qos, const char* name) {
  char* value = nullptr;
  if (qos == nullptr || !dds_qget_prop(qos, name, &value) || value == nullptr) return {};
  std::string copy(value);
  dds_free(value);
  return copy;
}

Qos qos_of(const dds_qos_t* given) {
  Qos qos;
  if (given == nullptr) return qos;
  dds_duration_t duration = 0;
  dds_reliability_kind_t reliability{};
  if (dds_qget_reliability(given, &reliability, &duration) && reliability == DDS_RELIABILITY_RELIABLE) {
    qos.reliability = Qos::Reliability::reliable;
  }
  dds_durability_kind_t durability{};
  if (dds_qget_durability(given, &durability)) qos.durability = static_cast<Qos::Durability>(durability);
  dds_liveliness_kind_t liveliness{};
  if (dds_qget_liveliness(given, &liveliness, &duration)) qos.liveliness = static_cast<Qos::Liveliness>(liveliness);
  if (dds_qget_deadline(given, &duration) && duration != DDS_INFINITY)
    qos.deadline = std::chrono::nanoseconds(duration);
  dds_ownership_kind_t ownership{};
  if (dds_qget_ownership(given, &ownership)) qos.is_exclusive = ownership == DDS_OWNERSHIP_EXCLUSIVE;
  return qos;
}

/// Calls `take` for each sample that waits.
template <typename Sample, typename Take>
void take_all(dds_entity_t reader, Take take) {
  std::array<void*, batch> samples{};
  std::array<dds_sample_info_t, batch> notes{};
  while (true) {
    samples.fill(nullptr);
    const dds_return_t count = dds_take(reader, samples.data(), notes.data(), batch, batch);
    if (count <= 0) return;
    for (std::size_t at = 0; at < static_cast<std::size_t>(count); ++at) {
      take(*static_cast<const Sample*>(samples.at(at)), notes.at(at).instance_state == DDS_IST_ALIVE);
    }
    dds_return_loan(reader, samples.data(), count);
  }
}

}  // namespace

std::expected<std::unique_ptr<Domain>, std::string> Domain::join(std::uint32_t number, Tally& tally, Told told) {
  const dds_entity_t participant = dds_create_participant(number, nullptr, nullptr);
  if (participant < 0) {
    return std::unexpected("domain " + std::to_string(number) + " cannot be joined: " + dds_strretcode(-participant) +
                           ": see whether an interface is up and what $CYCLONEDDS_URI says");
  }
  return std::unique_ptr<Domain>(new Domain(participant, tally, std::move(told)));
}

Domain::Domain(dds_entity_t participant, Tally& tally, Told told)
    : participant_(participant),
      participants_(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr)),
      writers_(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr)),
      readers_(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, nullptr, nullptr)),
      tally_(tally),
      told_(std::move(told)) {
  dds_guid_t guid{};
  if (dds_get_guid(participant, &guid) == DDS_RETCODE_OK) own_ = key_of(guid);
}

Domain::~Domain() { dds_delete(participant_); }

void Domain::look() {
  take_all<dds_builtintopic_participant_t>(participants_,
                                           [this](const auto& sample, bool is_alive) { take(sample, is_alive); });
  for (const bool is_writer : {true, false}) {
    take_all<dds_builtintopic_endpoint_t>(
        is_writer ? writers_ : readers_,
        [this, is_writer](const auto& sample, bool is_alive) { take(sample, is_alive, is_writer); });
  }
}

void Domain::take(const dds_builtintopic_participant_t& sample, bool is_alive) {
  const std::string key = key_of(sample.key);
  if (!is_alive) {
    names_.erase(key);
    return;
  }
  if (names_.size() >= max_dds_participants && !names_.contains(key)) {
    return tally_.count("participants over the limit, whose hosts stay unknown");
  }
  const Names& names = names_[key] = {property(sample.qos, "__Hostname"), property(sample.qos, "__ProcessName")};
  for (auto& [endpoint_key, known] : endpoints_) {
    if (known.participant != key) continue;
    known.endpoint.host = names.host;
    known.endpoint.process = names.process;
    told_.found(endpoint_key, known.endpoint);
  }
}

void Domain::take(const dds_builtintopic_endpoint_t& sample, bool is_alive, bool is_writer) {
  const std::string key = key_of(sample.key);
  if (!is_alive) {
    if (endpoints_.erase(key) > 0) told_.gone(key);
    return;
  }
  Known known{{.topic = text(sample.topic_name),
               .type = text(sample.type_name),
               .is_writer = is_writer,
               .qos = qos_of(sample.qos),
               .host = {},
               .process = {}},
              key_of(sample.participant_key)};
  if (known.participant == own_) return;
  if (endpoints_.size() >= max_endpoints && !endpoints_.contains(key)) {
    return tally_.count("readers and writers over the limit");
  }
  if (const auto names = names_.find(known.participant); names != names_.end()) {
    known.endpoint.host = names->second.host;
    known.endpoint.process = names->second.process;
  }
  const Known& kept = endpoints_.insert_or_assign(key, std::move(known)).first->second;
  told_.found(key, kept.endpoint);
}

}  // namespace geminga::bridge
