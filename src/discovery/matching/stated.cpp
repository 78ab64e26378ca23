// The fields of a service, and its attributes.
#include "discovery/matching/stated.hpp"

#include <array>
#include <utility>

#include "geminga/attribute.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using Value = std::optional<std::string_view>;

Value stated(std::string_view text) { return text.empty() ? std::nullopt : Value(text); }

template <typename Kind>
const Kind* identity_as(const PublicationEntry& publication) {
  return std::get_if<Kind>(&publication.publication.identity);
}

/// Reads one field. A field that is no text is written into `room`, which the value then borrows.
using Reader = Value (*)(const PublicationEntry&, std::string& room);

/// The fields of a service, in the order of WHERE.md.
constexpr std::array<std::pair<std::string_view, Reader>, 13> fields{{
    {"mode", [](const PublicationEntry& p, std::string&) { return Value(to_string(p.publication.mode)); }},
    {"id",
     [](const PublicationEntry& p, std::string& room) {
       const auto* numeric = identity_as<NumericIdentity>(p);
       return numeric == nullptr ? Value() : Value(room = std::to_string(numeric->number));
     }},
    {"text",
     [](const PublicationEntry& p, std::string&) {
       const auto* text = identity_as<TextIdentity>(p);
       return text == nullptr ? Value() : Value(text->text);
     }},
    {"concept",
     [](const PublicationEntry& p, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(p);
       return semantic == nullptr ? Value() : Value(semantic->concept_iri);
     }},
    {"representation",
     [](const PublicationEntry& p, std::string&) {
       const auto* semantic = identity_as<SemanticIdentity>(p);
       return semantic == nullptr ? Value() : stated(semantic->representation_iri);
     }},
    {"address", [](const PublicationEntry& p, std::string&) { return stated(p.publication.address); }},
    {"port",
     [](const PublicationEntry& p, std::string& room) { return Value(room = std::to_string(p.publication.port)); }},
    {"protocol", [](const PublicationEntry& p, std::string&) { return stated(p.publication.protocol); }},
    {"priority",
     [](const PublicationEntry& p, std::string& room) { return Value(room = std::to_string(p.publication.priority)); }},
    {"participant",
     [](const PublicationEntry& p, std::string& room) { return Value(room = to_string(p.key.participant)); }},
    {"participant_name", [](const PublicationEntry& p, std::string&) { return stated(p.participant_name); }},
    {"peer", [](const PublicationEntry& p,
                std::string& room) { return Value(room = std::to_string(std::to_underlying(p.key.peer))); }},
    {"name", [](const PublicationEntry& p, std::string&) { return stated(p.peer_name); }},
}};

Value attribute_of(const PublicationEntry& publication, std::string_view name) {
  const auto& attributes = publication.publication.attributes;
  const auto at = attributes.find(name);
  return at == attributes.end() ? Value() : Value(at->second);
}

}  // namespace

Value stated_under(std::string_view key, const PublicationEntry& publication, std::string& room) {
  if (key.starts_with(attribute_prefix)) return attribute_of(publication, key.substr(attribute_prefix.size()));
  for (const auto& [name, read] : fields) {
    if (name == key) return read(publication, room);
  }
  return attribute_of(publication, key);
}

}  // namespace geminga::matching
