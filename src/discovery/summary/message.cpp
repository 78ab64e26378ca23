#include "discovery/summary/message.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "discovery/summary/limits.hpp"
#include "discovery/summary/summary.pb.h"

namespace geminga::summary {
namespace {

constexpr std::uint32_t magic = 0x534d47;  // G M S
constexpr std::uint32_t version = 1;
/// The octets of a listing beside its announcements, and of each of them beside its own.
constexpr std::size_t header_bytes = 320;
constexpr std::size_t bytes_beside = 4;

using Failure = std::unexpected<Fault>;

std::optional<Kind> kind_of(wire::Kind kind) {
  switch (kind) {
    case wire::KIND_QUESTION:
      return Kind::question;
    case wire::KIND_ANSWER:
      return Kind::answer;
    case wire::KIND_EXPANSION:
      return Kind::expansion;
    case wire::KIND_LISTING:
      return Kind::listing;
    default:
      return std::nullopt;
  }
}

wire::Kind to_wire(Kind kind) { return static_cast<wire::Kind>(std::to_underlying(kind) + 1); }

std::optional<Topic> topic_of(const wire::Message& message) {
  if (message.concept_case() == wire::Message::kRank) {
    if (message.digest() == 0) return std::nullopt;
    return Topic{.digest = message.digest(), .rank = message.rank()};
  }
  const std::string& iri = message.iri();
  if (iri.empty() || iri.size() > max_iri_bytes || base::has_control_character(iri) || !base::is_valid_utf8(iri))
    return std::nullopt;
  return Topic{.digest = 0, .rank = 0, .iri = iri};
}

constexpr std::array<std::string_view, 9> words = {"too-large",     "not-protobuf",  "not-geminga",
                                                   "other-version", "bad-kind",      "bad-site",
                                                   "bad-topic",     "bad-magnitude", "bad-listing"};

}  // namespace

std::string_view to_string(Fault fault) { return words.at(std::to_underlying(fault)); }

std::expected<Message, Fault> decode(std::string_view octets) {
  if (octets.size() > max_message_bytes) return Failure(Fault::too_large);
  wire::Message wire;
  if (!wire.ParseFromArray(octets.data(), static_cast<int>(octets.size()))) return Failure(Fault::not_protobuf);
  if ((wire.format() & 0xffffff) != magic) return Failure(Fault::not_geminga);
  if (wire.format() >> 24 != version) return Failure(Fault::other_version);
  const auto kind = kind_of(wire.kind());
  if (!kind) return Failure(Fault::bad_kind);
  if (wire.site() == 0) return Failure(Fault::bad_site);
  auto topic = topic_of(wire);
  if (!topic) return Failure(Fault::bad_topic);
  Message message{.kind = *kind, .site = SiteId{wire.site()}, .topic = std::move(*topic), .digest = wire.digest()};
  if (*kind == Kind::question || *kind == Kind::answer) {
    if (wire.magnitude() > max_magnitude) return Failure(Fault::bad_magnitude);
    message.magnitude = wire.magnitude();
  }
  if (*kind == Kind::expansion || *kind == Kind::listing) message.page = wire.page();
  if (*kind != Kind::listing) return message;
  message.has_more = wire.has_more();
  if (wire.announcements_size() > static_cast<int>(max_listed)) return Failure(Fault::bad_listing);
  for (const std::string& one : wire.announcements()) {
    if (one.empty() || one.size() > max_listed_bytes) return Failure(Fault::bad_listing);
    message.announcements.push_back(one);
  }
  return message;
}

std::string encode(const Message& message) {
  wire::Message wire;
  wire.set_format(magic | version << 24);
  wire.set_kind(to_wire(message.kind));
  wire.set_site(std::to_underlying(message.site));
  if (message.topic.digest == 0) {
    wire.set_iri(message.topic.iri);
  } else {
    wire.set_rank(message.topic.rank);
  }
  wire.set_digest(message.digest);
  wire.set_magnitude(message.magnitude);
  wire.set_page(message.page);
  wire.set_has_more(message.has_more);
  for (const std::string& one : message.announcements) wire.add_announcements(one);
  return wire.SerializeAsString();
}

std::vector<Message> listings(SiteId site, const Topic& topic, std::uint64_t digest,
                              const std::vector<std::string>& announcements) {
  std::vector<Message> pages{
      {.kind = Kind::listing, .site = site, .topic = topic, .digest = digest, .page = 0, .announcements = {}}};
  std::size_t size = header_bytes;
  for (const std::string& one : announcements) {
    if (one.empty() || one.size() > max_listed_bytes) continue;
    const bool is_full =
        pages.back().announcements.size() == max_listed || size + one.size() + bytes_beside > max_message_bytes;
    if (is_full) {
      pages.back().has_more = true;
      Message next = pages.back();
      next.has_more = false;
      next.announcements.clear();
      ++next.page;
      pages.push_back(std::move(next));
      size = header_bytes;
    }
    pages.back().announcements.push_back(one);
    size += one.size() + bytes_beside;
  }
  return pages;
}

}  // namespace geminga::summary
