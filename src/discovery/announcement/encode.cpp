// Writing announcements, and splitting a state that is too large for one datagram.
#include <algorithm>
#include <optional>
#include <ranges>
#include <utility>

#include "base/assert.hpp"
#include "base/utf8.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/fault.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/wire_entry.hpp"
#include "discovery/announcement/wire_presence.hpp"
#include "discovery/announcement/wire_relay.hpp"

namespace geminga::announcement {
namespace {

/// The most octets that `part` and `part_count` take: a tag and a number below 2^14 each.
constexpr std::size_t part_fields_bytes = 6;

/// The fields of every kind.
wire::Announcement beginning_of(const Announcement& announcement) {
  wire::Announcement header;
  header.set_format(format_major << 24 | format_magic);
  header.set_minor(format_minor);
  switch (announcement.kind) {
    case Kind::state:
      header.set_kind(wire::KIND_STATE);
      break;
    case Kind::claim:
      header.set_kind(wire::KIND_CLAIM);
      break;
    case Kind::goodbye:
      header.set_kind(wire::KIND_GOODBYE);
      break;
    case Kind::presence:
      header.set_kind(wire::KIND_PRESENCE);
      break;
    case Kind::change:
      header.set_kind(wire::KIND_CHANGE);
      break;
    case Kind::inquiry:
      header.set_kind(wire::KIND_INQUIRY);
      break;
    case Kind::diagnosis:
      header.set_kind(wire::KIND_DIAGNOSIS);
      break;
    case Kind::relayed:
      header.set_kind(wire::KIND_RELAYED);
      break;
  }
  header.set_participant(std::to_underlying(announcement.participant));
  header.set_boot(std::to_underlying(announcement.boot));
  header.set_link(announcement.link);
  header.set_doublings(announcement.doublings);
  header.set_revision(announcement.revision);
  return header;
}

std::string group_of(const Announcement& announcement) {
  return std::string(base::first_characters(announcement.group, max_name_bytes));
}

/// The fields that are the same in every part.
wire::Announcement header_of(const Announcement& announcement) {
  auto header = beginning_of(announcement);
  header.set_group(group_of(announcement));
  header.set_interval_ms(static_cast<std::uint32_t>(announcement.interval / std::chrono::milliseconds(1)));
  header.set_name(std::string(base::first_characters(announcement.name, max_name_bytes)));
  header.set_ontology_digest(announcement.ontology_digest);
  header.set_lasting(announcement.lasting);
  for (const auto& address : announcement.addresses) {
    if (header.addresses_size() == static_cast<int>(max_addresses)) break;
    if (auto octets = address_octets(address); !octets.empty()) header.add_addresses(std::move(octets));
  }
  return header;
}

/// The fields that a presence and a change begin with. Receivers take the others from the state.
wire::Announcement short_header_of(const Announcement& announcement) {
  auto message = beginning_of(announcement);
  if (announcement.group != default_group) message.set_group(group_of(announcement));
  message.set_sequence(announcement.sequence);
  return message;
}

wire::Announcement presence_of(const Announcement& announcement) {
  auto message = short_header_of(announcement);
  write_presence(announcement, message);
  return message;
}

/// Fills one datagram after the other with services, in their order.
class Packer {
 public:
  /// `base_bytes`: the octets of a datagram without any service.
  explicit Packer(std::size_t base_bytes) : base_bytes_(base_bytes) { parts_.emplace_back(); }

  /// The participant's own entry. To be called first.
  void describe(const PeerState& self) {
    Part& part = parts_.front();
    part.description.emplace();
    for (const NumberedPublication& entry : self.publications) part.description = to_wire(entry, part.terms);
    closed_bytes_ += framed_bytes(2, part.description->ByteSizeLong());
    is_empty_ = false;
  }
  void add(const PeerState& peer, const NumberedPublication& entry) {
    put(peer, [&](wire::Peer& to, TermTable& terms) {
      auto message = to_wire(entry, terms);
      const auto bytes = framed_bytes(1, message.ByteSizeLong());
      *to.add_publications() = std::move(message);
      return bytes;
    });
  }
  void add(const PeerState& peer, const NumberedSubscription& entry) {
    put(peer, [&](wire::Peer& to, TermTable& terms) {
      auto message = to_wire(entry, terms);
      const auto bytes = framed_bytes(1, message.ByteSizeLong());
      *to.add_subscriptions() = std::move(message);
      return bytes;
    });
  }
  void add_withheld(const PeerState& peer, std::uint32_t number) {
    put(peer, [number](wire::Peer& to, TermTable&) {
      to.add_withheld(number);
      return to.ByteSizeLong();
    });
  }
  void add_removed(const PeerState& peer, std::uint32_t number) {
    put(peer, [number](wire::Peer& to, TermTable&) {
      to.add_removed(number);
      return to.ByteSizeLong();
    });
  }

  struct Part {
    std::optional<wire::Publication> description;
    std::vector<wire::Peer> peers;
    TermTable terms;
  };
  [[nodiscard]] std::vector<Part> take() { return std::move(parts_); }

 private:
  /// Writes one entry into this part, or into the next part if it does not fit.
  template <typename Write>
  void put(const PeerState& peer, const Write& write) {
    if (try_put(peer, write)) return;
    if (is_empty_) return;  // larger than any datagram: check() has refused it before
    parts_.emplace_back();
    closed_bytes_ = 0;
    open_bytes_ = 0;
    is_empty_ = true;
    if (!try_put(peer, write)) parts_.back() = Part{};
  }

  template <typename Write>
  bool try_put(const PeerState& peer, const Write& write) {
    auto& part = parts_.back();
    const auto mark = part.terms.mark();
    const auto id = std::to_underlying(peer.id);
    const bool is_new_peer = part.peers.empty() || part.peers.back().id() != id;
    auto closed = closed_bytes_;
    auto open = open_bytes_;
    if (is_new_peer) {
      if (!part.peers.empty()) closed += framed_bytes(2, open);
      auto& added = part.peers.emplace_back();
      added.set_id(id);
      added.set_name(std::string(base::first_characters(peer.name, max_name_bytes)));
      open = added.ByteSizeLong();
    }
    // A peer of its own takes the message first: if it does not fit, the part is as it was.
    wire::Peer entry;
    open += write(entry, part.terms);
    const auto bytes = base_bytes_ + part.terms.bytes() + closed + framed_bytes(2, open);
    if (bytes > (is_empty_ ? max_datagram_bytes : max_said_bytes)) {
      part.terms.go_back(mark);
      if (is_new_peer) part.peers.pop_back();
      return false;
    }
    part.peers.back().MergeFrom(entry);
    closed_bytes_ = closed;
    open_bytes_ = open;
    is_empty_ = false;
    return true;
  }

  std::size_t base_bytes_;
  std::vector<Part> parts_;
  std::size_t closed_bytes_ = 0;  ///< of all peers but the last one of this part
  std::size_t open_bytes_ = 0;    ///< of the last one's content
  bool is_empty_ = true;
};

std::vector<Packer::Part> pack(const Announcement& announcement, std::size_t base_bytes) {
  Packer packer(base_bytes);
  std::size_t services = 0;
  const auto is_room = [&services] { return services++ < max_services_per_participant; };
  for (const auto& peer : announcement.peers) {
    if (peer.id == PeerId{}) {
      if (is_room()) packer.describe(peer);
      continue;
    }
    for (const auto& entry : peer.publications) {
      if (!find_fault(entry.publication) && is_room()) packer.add(peer, entry);
    }
    for (const auto& entry : peer.subscriptions) {
      if (!find_fault(entry.subscription) && is_room()) packer.add(peer, entry);
    }
    for (const auto number : peer.withheld) {
      if (is_room()) packer.add_withheld(peer, number);
    }
    for (const auto number : peer.removed) packer.add_removed(peer, number);
  }
  return packer.take();
}

Datagram write(const wire::Announcement& message) {
  Datagram datagram(message.ByteSizeLong());
  GEMINGA_ASSERT(datagram.size() <= max_datagram_bytes);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(datagram.data()));
  return datagram;
}

Datagram write(wire::Announcement header, Packer::Part part) {
  for (const auto& name_space : part.terms.name_spaces()) header.add_namespaces(name_space);
  for (const auto& term : part.terms.terms()) {
    auto* to = header.add_terms();
    to->set_namespace_number(term.name_space);
    to->set_local(term.local);
  }
  if (part.description) *header.mutable_description() = std::move(*part.description);
  for (auto& peer : part.peers) *header.add_peers() = std::move(peer);
  return write(header);
}

/// Says as many presences as the testimony needs. Questions stand in the first one.
std::vector<Datagram> encode_presence(Announcement announcement) {
  std::vector<Datagram> datagrams;
  std::span<const Behind> behind(announcement.behind);
  do {
    auto message = presence_of(announcement);
    behind = behind.subspan(write_behind(behind, max_datagram_bytes, message));
    datagrams.push_back(write(message));
    announcement.lacks.clear();
    announcement.doubts.clear();
    announcement.introductions.clear();
    ++announcement.sequence;
  } while (!behind.empty());
  return datagrams;
}

Datagram write_word(const Announcement& announcement) {
  wire::Announcement message;
  message.set_format(format_major << 24 | format_magic);
  message.set_minor(format_minor);
  message.set_kind(wire::KIND_RELAYED);
  message.set_participant(std::to_underlying(announcement.participant));
  write_relayed(announcement.relayed, message);
  return write(message);
}

std::vector<Datagram> encode_change(const Announcement& announcement) {
  auto header = short_header_of(announcement);
  header.set_since(announcement.since);
  auto parts = pack(announcement, header.ByteSizeLong());
  if (parts.size() > 1) return {};
  return {write(std::move(header), std::move(parts.front()))};
}

/// The fields of an inquiry and a diagnosis, without padding and lines.
wire::Announcement exchange_of(const Announcement& announcement) {
  auto message = short_header_of(announcement);
  message.set_partner(std::to_underlying(announcement.partner));
  message.set_token(announcement.token);
  return message;
}

/// Fills the datagram up, so that the answer is not longer.
Datagram write_inquiry(const Announcement& announcement) {
  auto message = exchange_of(announcement);
  constexpr std::size_t frame = 4;  // the tag and the length of the padding
  message.set_padding(std::string(max_datagram_bytes - frame - message.ByteSizeLong(), '\0'));
  return write(message);
}

Datagram write_diagnosis(const Announcement& announcement) {
  auto message = exchange_of(announcement);
  for (const std::string& line : announcement.lines | std::views::take(fitting_lines(announcement)))
    message.add_lines(line);
  return write(message);
}

}  // namespace

std::size_t fitting_lines(const Announcement& diagnosis) {
  std::size_t octets = exchange_of(diagnosis).ByteSizeLong();
  std::size_t count = 0;
  for (const std::string& line : diagnosis.lines) {
    octets += framed_bytes(2, line.size());
    if (octets > max_datagram_bytes || count == max_diagnosis_lines || line.size() > max_diagnosis_line_bytes) break;
    ++count;
  }
  return count;
}

std::vector<Datagram> encode(const Announcement& announcement) {
  GEMINGA_ASSERT(announcement.participant != ParticipantId{});
  if (announcement.kind == Kind::presence) return encode_presence(announcement);
  if (announcement.kind == Kind::relayed) return {write_word(announcement)};
  if (announcement.kind == Kind::change) return encode_change(announcement);
  if (announcement.kind == Kind::inquiry) return {write_inquiry(announcement)};
  if (announcement.kind == Kind::diagnosis) return {write_diagnosis(announcement)};
  GEMINGA_ASSERT(announcement.interval >= min_interval && announcement.interval <= max_interval);
  auto header = header_of(announcement);
  // The sequence number grows with each part; sizes are computed with the greatest.
  header.set_sequence(announcement.sequence + max_parts);
  const auto base_bytes = header.ByteSizeLong();
  auto parts = pack(announcement, base_bytes);
  if (parts.size() > 1) parts = pack(announcement, base_bytes + part_fields_bytes);

  std::vector<Datagram> datagrams;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto part_header = header;
    part_header.set_sequence(announcement.sequence + i);
    if (parts.size() > 1) {
      part_header.set_part(static_cast<std::uint32_t>(i));
      part_header.set_part_count(static_cast<std::uint32_t>(parts.size()));
    }
    datagrams.push_back(write(std::move(part_header), std::move(parts[i])));
  }
  return datagrams;
}

}  // namespace geminga::announcement
