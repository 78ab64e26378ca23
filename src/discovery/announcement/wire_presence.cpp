#include "discovery/announcement/wire_presence.hpp"

#include <algorithm>
#include <ranges>
#include <span>
#include <string>
#include <utility>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

std::string octets_of(const Witness& witness) {
  if (witness.heard.empty()) return {};
  const auto count = std::min(witness.heard.size(), max_participants + 1);
  std::string octets(witness_bytes(count), '\0');
  octets[0] = static_cast<char>(witness.members & 0xff);
  octets[1] = static_cast<char>(witness.members >> 8);
  for (std::size_t i = 0; i < count; ++i) {
    auto& octet = octets[2 + i / 4];
    octet = static_cast<char>(static_cast<std::uint8_t>(octet) | std::to_underlying(witness.heard[i]) << (i % 4 * 2));
  }
  return octets;
}

bool read_witness(const std::string& octets, Witness& witness) {
  if (octets.empty()) return true;
  constexpr std::size_t most = witness_bytes(max_participants + 1);
  if (octets.size() < witness_bytes(1) || octets.size() > most) return false;
  const std::span all(reinterpret_cast<const std::uint8_t*>(octets.data()), octets.size());
  witness.members = static_cast<std::uint16_t>(all[0] | all[1] << 8);
  witness.heard.assign_octets(all.subspan(2));
  return true;
}

bool read_named(const google::protobuf::RepeatedField<std::uint32_t>& ids, std::vector<ParticipantId>& named) {
  if (std::cmp_greater(ids.size(), max_named)) return false;
  for (const auto id : ids) {
    if (id == 0) return false;
    named.push_back(ParticipantId{id});
  }
  return true;
}

bool read_introductions(const wire::Announcement& message, std::vector<Introduction>& introductions) {
  if (std::cmp_greater(message.introductions_size(), max_introductions)) return false;
  for (const wire::Introduction& one : message.introductions()) {
    const base::Address address{{one.address().begin(), one.address().end()}, {}};
    if (one.participant() == 0 || (one.address().size() != 4 && one.address().size() != 16)) return false;
    if (address.scope() == base::AddressScope::unspecified || address.scope() == base::AddressScope::multicast)
      return false;
    introductions.push_back({ParticipantId{one.participant()}, address.text()});
  }
  return true;
}

}  // namespace

void write_presence(const Announcement& presence, wire::Announcement& message) {
  message.set_witness(octets_of(presence.witness));
  for (const auto id : presence.lacks | std::views::take(max_named)) message.add_lacks(std::to_underlying(id));
  for (const auto id : presence.doubts | std::views::take(max_named)) message.add_doubts(std::to_underlying(id));
  for (const Introduction& one : presence.introductions | std::views::take(max_introductions)) {
    const auto address = base::parse_address(one.address);
    if (!address) continue;
    wire::Introduction& written = *message.add_introductions();
    written.set_participant(std::to_underlying(one.participant));
    written.set_address(std::string(address->octets.begin(), address->octets.end()));
  }
}

bool read_presence(const wire::Announcement& message, Announcement& presence) {
  return read_witness(message.witness(), presence.witness) && read_named(message.lacks(), presence.lacks) &&
         read_named(message.doubts(), presence.doubts) && read_introductions(message, presence.introductions);
}

}  // namespace geminga::announcement
