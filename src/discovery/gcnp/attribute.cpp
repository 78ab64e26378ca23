#include "discovery/gcnp/attribute.hpp"

#include <algorithm>
#include <array>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "discovery/gcnp/reserved.hpp"

namespace geminga {
namespace {

constexpr std::array<std::string_view, 1> prefix_word{attribute_prefix.substr(0, attribute_prefix.size() - 1)};

/// Whether the word begins with a mistyped `attr.`.
bool has_mistyped_prefix(std::string_view word) {
  const auto dot = word.find('.');
  return dot != std::string_view::npos && gcnp::mistyped_key(word.substr(0, dot), prefix_word).has_value();
}

std::string escape(std::string_view word) {
  return "; an attribute of this name is written " + std::string(attribute_prefix) + std::string(word);
}

}  // namespace

Result<std::string, Error> attribute_name(std::string_view written) {
  const auto refuse = [](std::string text) { return Failure(Error{ErrorCode::malformed, std::move(text)}); };
  if (written.starts_with(attribute_prefix)) {
    if (written.size() == attribute_prefix.size()) return refuse("the name of an attribute is missing behind attr.");
    return std::string(written.substr(attribute_prefix.size()));
  }
  const std::string word = base::printable(written, 64);
  if (gcnp::is_reserved(written)) return refuse(word + " is reserved and means nothing here" + escape(word));
  if (const auto key = gcnp::mistyped_key(written, gcnp::reserved_keys)) {
    return refuse(word + " is no key: did you mean " + std::string(*key) + "?" + escape(word));
  }
  if (has_mistyped_prefix(written)) {
    const std::string meant = std::string(attribute_prefix) + word.substr(word.find('.') + 1);
    return refuse(word + " is no key: did you mean " + meant + "?" + escape(word));
  }
  return std::string(written);
}

namespace gcnp {

std::optional<std::string_view> mistyped_key(std::string_view word, std::span<const std::string_view> keys) {
  const auto key = std::ranges::find_if(
      keys, [word](std::string_view one) { return word != one && base::edit_distance(word, one, 1) <= 1; });
  return key == keys.end() ? std::nullopt : std::optional(*key);
}

std::optional<std::string_view> shown_attribute(std::string_view key) {
  if (key.starts_with(attribute_prefix)) return key.substr(attribute_prefix.size());
  return is_reserved(key) || is_key_of_lines(key) ? std::nullopt : std::optional(key);
}

std::string shown_key(std::string_view attribute) {
  const bool is_bare =
      !is_reserved(attribute) && !is_key_of_lines(attribute) && !attribute.starts_with(attribute_prefix);
  return std::string(is_bare ? "" : attribute_prefix) + std::string(attribute);
}

std::string stated_key(std::string_view attribute) {
  const bool is_like_a_key = is_key_of_requests(attribute) || mistyped_key(attribute, keys_of_requests);
  const bool is_bare = !attribute.starts_with(attribute_prefix) && !is_like_a_key && attribute_name(attribute);
  return std::string(is_bare ? "" : attribute_prefix) + std::string(attribute);
}

}  // namespace gcnp
}  // namespace geminga
