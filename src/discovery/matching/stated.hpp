// What a publication says under a key, as `where` and `prefer` name it.
#ifndef GEMINGA_DISCOVERY_MATCHING_STATED_HPP
#define GEMINGA_DISCOVERY_MATCHING_STATED_HPP

#include <optional>
#include <string>
#include <string_view>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// The attribute behind `attr.`, otherwise a field of the service, otherwise an attribute; nothing where it says
/// nothing. WHERE.md lists the fields. A field that is no text is written into `room`, which the value then borrows;
/// else it borrows the publication.
[[nodiscard]] std::optional<std::string_view> stated_under(std::string_view key,
                                                           const registry::PublicationEntry& publication,
                                                           std::string& room);

}  // namespace geminga::matching

#endif
