#include "discovery/sealing/greeting.hpp"

#include "base/assert.hpp"

namespace geminga::sealing {
namespace {

constexpr std::uint8_t key_count_bits = 0x0f;
constexpr std::uint8_t challenge_bit = 0x40;
constexpr std::uint8_t everybody_bit = 0x80;

class Writer {
 public:
  explicit Writer(std::span<std::byte> octets) : octets_(octets) {}
  void write(std::uint64_t number, std::size_t size) {
    for (std::size_t i = size; i-- > 0;) octets_[at_++] = static_cast<std::byte>(number >> (8 * i) & 0xff);
  }
  [[nodiscard]] std::size_t size() const { return at_; }

 private:
  std::span<std::byte> octets_;
  std::size_t at_ = 0;
};

/// Requires that there are enough octets for each read.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> octets) : octets_(octets) {}
  std::uint64_t read(std::size_t size) {
    std::uint64_t number = 0;
    for (; size > 0; --size) number = number << 8 | static_cast<std::uint8_t>(octets_[at_++]);
    return number;
  }

 private:
  std::span<const std::byte> octets_;
  std::size_t at_ = 0;
};

}  // namespace

std::size_t write_greeting(const Greeting& greeting, std::span<std::byte> octets) {
  GEMINGA_ASSERT(greeting.keys.size() <= max_keys && greeting.asked.size() <= max_asked);
  GEMINGA_ASSERT(greeting.echoes.size() <= max_echoes);
  GEMINGA_ASSERT(greeting.challenge || (greeting.asked.empty() && !greeting.calls_everybody));
  Writer writer(octets);
  writer.write(greeting.keys.size() | (greeting.challenge ? challenge_bit : 0U) |
                   (greeting.calls_everybody ? everybody_bit : 0U),
               1);
  writer.write(greeting.asked.size(), 1);
  writer.write(greeting.echoes.size(), 1);
  if (greeting.challenge) writer.write(static_cast<std::uint64_t>(*greeting.challenge), challenge_bytes);
  for (const KeyId key : greeting.keys) writer.write(static_cast<std::uint16_t>(key), listed_bytes);
  for (const SessionTag tag : greeting.asked) writer.write(static_cast<std::uint16_t>(tag), listed_bytes);
  for (const Challenge echo : greeting.echoes) writer.write(static_cast<std::uint64_t>(echo), challenge_bytes);
  return writer.size();
}

std::expected<ReadGreeting, Rejection> read_greeting(std::span<const std::byte> text) {
  const auto malformed = std::unexpected(Rejection::malformed);
  if (text.size() < greeting_head_bytes) return malformed;
  Reader reader(text);
  const auto flags = static_cast<std::uint8_t>(reader.read(1));
  const std::size_t keys = flags & key_count_bits;
  const std::size_t asked = reader.read(1);
  const std::size_t echoes = reader.read(1);
  const bool has_challenge = (flags & challenge_bit) != 0;
  const bool calls_everybody = (flags & everybody_bit) != 0;
  if ((flags & ~(key_count_bits | challenge_bit | everybody_bit)) != 0) return malformed;
  if (keys > max_keys || asked > max_asked || echoes > max_echoes) return malformed;
  if (!has_challenge && (asked > 0 || calls_everybody)) return malformed;
  ReadGreeting read{.greeting = {}, .size = greeting_bytes(keys, has_challenge, asked, echoes)};
  if (text.size() < read.size) return malformed;
  Greeting& greeting = read.greeting;
  greeting.calls_everybody = calls_everybody;
  if (has_challenge) greeting.challenge = Challenge(reader.read(challenge_bytes));
  for (std::size_t i = 0; i < keys; ++i) greeting.keys.push_back(KeyId(reader.read(listed_bytes)));
  for (std::size_t i = 0; i < asked; ++i) greeting.asked.push_back(SessionTag(reader.read(listed_bytes)));
  for (std::size_t i = 0; i < echoes; ++i) greeting.echoes.push_back(Challenge(reader.read(challenge_bytes)));
  return read;
}

}  // namespace geminga::sealing
