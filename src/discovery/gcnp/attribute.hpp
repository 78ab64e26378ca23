// Attributes beside keys: how each is written, and which key a mistyped word was meant to be.
#ifndef GEMINGA_DISCOVERY_GCNP_ATTRIBUTE_HPP
#define GEMINGA_DISCOVERY_GCNP_ATTRIBUTE_HPP

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geminga/attribute.hpp"

namespace geminga::gcnp {

/// The key from which `word` differs by one slip: one letter that is wrong, missing, too many or of the other case, or
/// two swapped. Of several keys the first.
[[nodiscard]] std::optional<std::string_view> mistyped_key(std::string_view word,
                                                           std::span<const std::string_view> keys);

/// The attribute that a parameter of the daemon's lines states: the text behind `attr.`, or the key itself; nothing if
/// the key is reserved. Every other key is an attribute, so that a daemon may say more than its client knows.
[[nodiscard]] std::optional<std::string_view> shown_attribute(std::string_view key);

/// The key under which the daemon shows an attribute: its name, or `attr.NAME` if that could be taken for a key.
[[nodiscard]] std::string shown_key(std::string_view attribute);
/// The key under which a client states an attribute: its name if no statement takes it for a key or a mistyped one,
/// else `attr.NAME`.
[[nodiscard]] std::string stated_key(std::string_view attribute);

}  // namespace geminga::gcnp

#endif
