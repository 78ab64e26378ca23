#include "discovery/gcnp/channel_keyring.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "discovery/gcnp/life.hpp"

namespace geminga::gcnp {
namespace {

void append_hex(std::string& text, const ChannelKey::Secret& secret) {
  for (const unsigned char octet : secret) text += base::to_hex(octet, 2);
}

template <typename Number>
bool read_hex(std::string_view text, Number& number) {
  if (text.size() != 2 * sizeof number) return false;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  return error == std::errc{} && end == text.data() + text.size();
}

bool read_secret(std::string_view text, ChannelKey::Secret& secret) {
  if (text.size() != 2 * secret.size()) return false;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    if (!read_hex(text.substr(2 * i, 2), secret.at(i))) return false;
  }
  return true;
}

/// Takes the text up to `end`, and leaves what is behind it.
std::string_view next(std::string_view& rest, char end) {
  const auto at = std::min(rest.find(end), rest.size());
  const std::string_view word = rest.substr(0, at);
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return word;
}

std::optional<ChannelKey> read_key(std::string_view text) {
  ChannelKey key;
  const std::string_view id = next(text, ':');
  const std::string_view forward = next(text, ':');
  if (!read_hex(id, key.id) || !read_secret(forward, key.forward) || !read_secret(text, key.back)) return std::nullopt;
  return key;
}

std::unexpected<Error> unreadable(std::string_view key) {
  return std::unexpected(Error{ErrorCode::malformed,
                               "the daemon sent the keys of a channel whose " + std::string(key) + " cannot be read"});
}

}  // namespace

Statement to_statement(std::uint32_t request, const ChannelKeyring& keyring) {
  Statement statement{.id = request, .command = "pub", .subcommand = std::string(keys_subcommand), .parameters = {}};
  statement.parameters = {{"life", to_string(keyring.life)}, {"mode", keyring.mode}};
  if (keyring.ring.empty()) return statement;
  std::string ring;
  for (const ChannelKey& key : keyring.ring) {
    if (!ring.empty()) ring += ',';
    ring += base::to_hex(key.id, 4) + ':';
    append_hex(ring, key.forward);
    ring += ':';
    append_hex(ring, key.back);
  }
  statement.parameters.push_back({"ring", std::move(ring)});
  return statement;
}

std::expected<ChannelKeyring, Error> read_channel_keyring(const Statement& statement) {
  ChannelKeyring keyring;
  const auto life = read_life(statement.value("life").value_or(""));
  if (!life) return unreadable("life");
  keyring.life = *life;
  keyring.mode = statement.value("mode").value_or("");
  if (keyring.mode.empty()) return unreadable("mode");
  std::string_view rest = statement.value("ring").value_or("");
  while (!rest.empty()) {
    auto key = read_key(next(rest, ','));
    if (!key || keyring.ring.size() == max_channel_keys) return unreadable("ring");
    keyring.ring.push_back(*key);
  }
  if (keyring.ring.empty() != (keyring.mode == "plain")) return unreadable("ring");
  return keyring;
}

}  // namespace geminga::gcnp
