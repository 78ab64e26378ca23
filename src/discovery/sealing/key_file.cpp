#include "discovery/sealing/key_file.hpp"

#include <sodium.h>

#include <array>
#include <optional>

#include "base/text.hpp"

namespace geminga::sealing {
namespace {

constexpr int codec = sodium_base64_VARIANT_ORIGINAL;
constexpr std::string_view opening = "key ";
constexpr std::string_view form = "a key file has comments, which begin with #, and one line: key ID SECRET";
constexpr std::string_view way_out = ": make one with gemingad --generate-key FILE";

std::unexpected<KeyFileError> failure(std::size_t line, std::string_view what) {
  return std::unexpected(KeyFileError{line, std::string(what) + std::string(way_out)});
}

/// `key ID SECRET`
std::expected<Key, KeyFileError> read_line(std::string_view line, std::size_t number) {
  if (!line.starts_with(opening)) return failure(number, form);
  line.remove_prefix(opening.size());
  const auto space = line.find(' ');
  if (space == std::string_view::npos) return failure(number, form);
  const std::string_view id = line.substr(0, space);
  const std::string_view coded = line.substr(space + 1);
  Key::Secret secret{};
  std::size_t size = 0;
  const char* end = nullptr;
  const int decoded =
      sodium_base642bin(secret.data(), secret.size(), coded.data(), coded.size(), nullptr, &size, &end, codec);
  const bool is_whole = decoded == 0 && size == secret.size() && end == coded.data() + coded.size();
  Key key(secret);
  sodium_memzero(secret.data(), secret.size());
  if (!is_whole) {
    return failure(number, "the secret is not " + std::to_string(key_bytes) + " octets in base64");
  }
  // A lost or changed character gives another key, and nobody would be heard.
  if (to_string(key.id()) != id) {
    return failure(number, "the secret is not that of the key " + base::printable(id, 16) + ": it was changed");
  }
  return key;
}

}  // namespace

std::expected<Key, KeyFileError> read_key(std::string_view text) {
  std::optional<Key> key;
  std::size_t number = 0;
  if (text.size() > max_key_file_bytes)
    return failure(1, "longer than " + std::to_string(max_key_file_bytes) + " octets");
  while (!text.empty()) {
    ++number;
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = base::trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    if (key) return failure(number, "a second key: give each key a file of its own");
    auto read = read_line(line, number);
    if (!read) return read;
    key = std::move(*read);
  }
  if (!key) return failure(number == 0 ? 1 : number, "there is no key in it");
  return *key;
}

std::string write_key(const Key::Secret& secret) {
  std::array<char, sodium_base64_ENCODED_LEN(key_bytes, codec)> coded{};
  sodium_bin2base64(coded.data(), coded.size(), secret.data(), secret.size(), codec);
  std::string text =
      "# A key of a Geminga team. Whoever can read it can hear the team and speak in its name.\n"
      "# Each host of the team has a copy, with mode 0600: gemingad --key-file FILE\n";
  text += std::string(opening) + to_string(Key(secret).id()) + ' ' + coded.data() + '\n';
  sodium_memzero(coded.data(), coded.size());
  return text;
}

}  // namespace geminga::sealing
