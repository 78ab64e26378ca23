// The messages between sites, as octets and back. SUMMARY.md is the specification, summary.proto the schema.
#ifndef GEMINGA_DISCOVERY_SUMMARY_MESSAGE_HPP
#define GEMINGA_DISCOVERY_SUMMARY_MESSAGE_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/summary/topic.hpp"

namespace geminga::summary {

enum class Kind : std::uint8_t {
  question,   ///< to all: who offers this, and how much?
  answer,     ///< to all that are interested: how much a site offers; said again when that changes
  expansion,  ///< to one site: which services are these?
  listing,    ///< to the site that asked: the announcements of those that offer them
};

struct Message {
  Kind kind = Kind::question;
  SiteId site{};  ///< the sender; never 0
  Topic topic;
  std::uint64_t digest = 0;  ///< of the sender's ontology, and of the topic if that is a rank; 0: none
  unsigned magnitude = 0;    ///< of an answer: of its services; of a question: of the sites that are known to answer
  std::uint32_t page = 0;    ///< of an expansion and a listing, from 0
  bool has_more = false;     ///< of a listing
  /// Of a listing: datagrams of announcement::encode(), which are read by announcement::decode() where they come in.
  std::vector<std::string> announcements{};
  friend bool operator==(const Message&, const Message&) = default;
};

/// Why octets were refused. Words are only ever appended.
enum class Fault : std::uint8_t {
  too_large,      ///< over max_message_bytes
  not_protobuf,   ///< cannot be parsed
  not_geminga,    ///< the magic number is missing
  other_version,  ///< another version
  bad_kind,       ///< unknown
  bad_site,       ///< 0
  bad_topic,  ///< none, a rank without digest, or an IRI that is empty, too long, no UTF-8 or has a control character
  bad_magnitude,  ///< over max_magnitude
  bad_listing,    ///< too many announcements, or one that is empty or too large
};
[[nodiscard]] std::string_view to_string(Fault fault);

/// Reads octets from anywhere. What is read is valid and within the named limits.
[[nodiscard]] std::expected<Message, Fault> decode(std::string_view octets);
/// Equal messages give equal octets. Requires that the message is within the limits; listings() makes such ones.
[[nodiscard]] std::string encode(const Message& message);

/// The announcements of a site about one topic as pages. A listing of nothing is one page without any. Announcements
/// over max_listed_bytes are left out.
[[nodiscard]] std::vector<Message> listings(SiteId site, const Topic& topic, std::uint64_t digest,
                                            const std::vector<std::string>& announcements);

}  // namespace geminga::summary

#endif
