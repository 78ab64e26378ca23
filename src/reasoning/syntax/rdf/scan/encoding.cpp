#include "reasoning/syntax/rdf/scan/encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"

namespace geminga::rdf {
namespace {

/// The characters 0x80 to 0x9f of windows-1252. Undefined ones stay control characters (WHATWG Encoding, section 9).
/// iconv(3) loads its tables from files, which the cage around the reader forbids.
constexpr std::array<std::uint16_t, 32> upper_controls{0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                       0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x008D, 0x017D, 0x008F,
                                                       0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                       0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178};

enum class Wide : std::uint8_t { no, little_endian, big_endian, other };

Wide width_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0"sv)) return Wide::other;
  if (bytes.starts_with("\xff\xfe")) return Wide::little_endian;
  if (bytes.starts_with("\xfe\xff")) return Wide::big_endian;
  if (bytes.size() < 4 || (bytes[0] == '\0') == (bytes[1] == '\0')) return Wide::no;
  if (bytes[2] == '\0' && bytes[3] == '\0') return Wide::other;
  if (bytes[0] == '\0') return bytes[2] == '\0' ? Wide::big_endian : Wide::no;
  return bytes[3] == '\0' ? Wide::little_endian : Wide::no;
}

/// The units of a text in UTF-16, one by one.
class Units {
 public:
  Units(std::string_view bytes, bool is_little) : bytes_(bytes), is_little_(is_little) {}
  [[nodiscard]] bool has_more() const { return place_ + 1 < bytes_.size(); }
  char32_t take() {
    const auto first = static_cast<unsigned char>(bytes_[place_]);
    const auto second = static_cast<unsigned char>(bytes_[place_ + 1]);
    place_ += 2;
    return is_little_ ? char32_t{first} | char32_t{second} << 8U : char32_t{first} << 8U | char32_t{second};
  }

 private:
  std::string_view bytes_;
  bool is_little_;
  std::size_t place_ = 0;
};

constexpr bool is_high(char32_t unit) { return unit >= 0xd800 && unit < 0xdc00; }
constexpr bool is_low(char32_t unit) { return unit >= 0xdc00 && unit < 0xe000; }

/// The next character; nothing where half of one stands alone.
std::optional<char32_t> next_character(Units& units) {
  const char32_t unit = units.take();
  if (is_low(unit)) return std::nullopt;
  if (!is_high(unit)) return unit;
  if (!units.has_more()) return std::nullopt;
  const char32_t low = units.take();
  if (!is_low(low)) return std::nullopt;
  return 0x10000 + ((unit - 0xd800) << 10U) + (low - 0xdc00);
}

/// Whether XML says that it is in windows-1252.
bool is_western(std::string_view bytes) {
  const std::string name = base::in_lower_case(declared_encoding(bytes).name);
  return name == "windows-1252" || name == "cp1252";
}

std::expected<syntax::FileBytes, syntax::LoadError> from_western(const std::string& path, std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 64);
  for (const char byte : bytes) append_windows_1252(static_cast<unsigned char>(byte), text);
  const DeclaredEncoding declared = declared_encoding(bytes);
  text.replace(declared.begin, declared.size, declared.size, ' ');
  auto copy = syntax::FileBytes::copy_of(text);
  if (!copy) return std::unexpected(syntax::LoadError{base::printable(path, 4096), 0, "is too large for the memory"});
  return std::move(*copy);
}

}  // namespace

void append_windows_1252(unsigned char byte, std::string& out) {
  base::append_character(byte >= 0x80 && byte < 0xa0 ? upper_controls[byte - 0x80] : byte, out);
}

std::expected<syntax::FileBytes, syntax::LoadError> decoded(const std::string& path, syntax::FileBytes bytes) {
  constexpr std::size_t chunk_bytes = std::size_t{1} << 16;
  const auto refuse = [&](std::uint32_t line, std::string text) {
    return std::unexpected(syntax::LoadError{base::printable(path, 4096), line, std::move(text), true});
  };
  const std::string_view wide = bytes.view();
  const Wide width = width_of(wide);
  if (width == Wide::no) return is_western(wide) ? from_western(path, wide) : std::move(bytes);
  if (width == Wide::other) return refuse(0, "is in UTF-32, which is not read: convert it to UTF-8");
  if (wide.size() % 2 != 0) return refuse(0, "is in UTF-16 and ends within a character");
  Units units(wide, width == Wide::little_endian);
  syntax::FileBytes text;
  std::string chunk;
  std::uint32_t line = 1;
  bool is_first = true;  // chunk
  while (units.has_more()) {
    const auto character = next_character(units);
    if (!character) return refuse(line, "is in UTF-16 and has half of a character");
    if (*character == U'\n') ++line;
    const bool is_mark = *character == 0xfeff && is_first && chunk.empty();
    if (!is_mark) base::append_character(*character, chunk);
    if (chunk.size() < chunk_bytes && units.has_more()) continue;
    if (is_first) {
      const DeclaredEncoding declared = declared_encoding(chunk);
      chunk.replace(declared.begin, declared.size, declared.size, ' ');
    }
    is_first = false;
    char* const room = text.room_for(chunk.size());
    if (room == nullptr) return refuse(0, "is too large for the memory");
    std::ranges::copy(chunk, room);
    text.take_room(chunk.size());
    chunk.clear();
  }
  text.give_back_room();
  return text;
}

}  // namespace geminga::rdf
