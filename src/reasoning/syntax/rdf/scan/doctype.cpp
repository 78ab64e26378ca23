// Reads the internal subset of a DOCTYPE (XML 1.0, section 2.8) as far as it declares entities. What it says of other
// files and of elements is cut out.
#include "reasoning/syntax/rdf/scan/doctype.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace geminga::rdf {
namespace {

constexpr std::string_view space = " \t\r\n";
constexpr std::array<std::pair<std::string_view, char>, 5> entities_of_xml{
    {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};

/// Whether XML itself gives a reference its meaning.
bool is_of_xml(std::string_view name) {
  return name.starts_with('#') ||
         std::ranges::any_of(entities_of_xml, [&](const auto& known) { return known.first == name; });
}

/// The character of a reference `#252` or `#xFC`; nothing where it names none that XML has (XML 1.0, section 4.1).
std::optional<char32_t> character_of(std::string_view reference) {
  if (!reference.starts_with('#')) return std::nullopt;
  const bool is_hexadecimal = reference.starts_with("#x");
  const std::string_view digits = reference.substr(is_hexadecimal ? 2 : 1);
  std::uint32_t number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, is_hexadecimal ? 16 : 10);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  const bool is_white_space = number == '\t' || number == '\n' || number == '\r';
  const bool is_character = (number >= 0x20 && number < 0xd800) || (number >= 0xe000 && number < 0xfffe) ||
                            (number >= 0x10000 && number <= 0x10ffff);
  return is_white_space || is_character ? std::optional(static_cast<char32_t>(number)) : std::nullopt;
}

/// Whether a reference to an entity of this value can begin no element and no reference that the value does not show.
/// The characters of its references are put in place before it is read where it is used (XML 1.0, section 4.5).
bool is_plain(std::string_view value) {
  if (value.find('<') != std::string_view::npos) return false;
  for (std::size_t at = value.find("&#"); at != std::string_view::npos; at = value.find("&#", at + 1)) {
    const std::size_t close = std::min(value.find(';', at), value.size());
    const auto character = close == value.size() ? std::nullopt : character_of(value.substr(at + 1, close - at - 1));
    if (!character || *character == '<' || *character == '&') return false;
  }
  return true;
}

struct Entity {
  std::string_view value;
  std::size_t place = 0;
  std::size_t bytes = 0;
  bool is_elsewhere = false;  ///< another file declares it, or one that it refers to
  enum class Measure { unknown, open, known } measure = Measure::unknown;
};
using Entities = std::map<std::string_view, Entity>;

class SubsetReader {
 public:
  SubsetReader(std::string_view bytes, std::size_t place, const syntax::FileLimits& limits)
      : bytes_(bytes), limits_(limits), place_(place) {}

  std::optional<ScanProblem> read() {
    place_ += 9;  // <!DOCTYPE
    const std::size_t name = std::min(bytes_.find_first_not_of(space, place_), bytes_.size());
    const std::size_t name_end = std::min(bytes_.find_first_of(" \t\r\n[>", name), bytes_.size());
    const std::size_t open = find_unquoted("[>", name_end);
    if (open == std::string_view::npos) return fail("has a DOCTYPE without end");
    if (bytes_.substr(name_end, open - name_end).find_first_of("'\"") != std::string_view::npos) {
      cut(name_end, open);
      names_other_files_ = true;
    }
    place_ = open + 1;
    if (bytes_[open] == '>') return std::nullopt;
    while (!problem_ && declaration()) {
    }
    for (auto& [declared, entity] : entities_) {
      if (!problem_) measure(declared, entity, 0);
    }
    return std::move(problem_);
  }

  [[nodiscard]] std::size_t end() const { return place_; }
  [[nodiscard]] const Entities& entities() const { return entities_; }
  [[nodiscard]] bool names_other_files() const { return names_other_files_; }
  [[nodiscard]] std::vector<Rewrite> take_cuts() { return std::move(cuts_); }

 private:
  /// Reads one declaration; false behind the last.
  bool declaration() {
    place_ = bytes_.find_first_not_of(space, place_);
    if (place_ == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    const std::string_view rest = bytes_.substr(place_);
    if (rest.starts_with(']')) {
      const std::size_t close = bytes_.find('>', place_);
      place_ = close == std::string_view::npos ? bytes_.size() : close + 1;
      return false;
    }
    if (rest.starts_with("<!--")) return skip_behind("-->");
    if (rest.starts_with("<?")) return skip_behind("?>");
    if (rest.starts_with("<!ENTITY")) return entity();
    if (rest.starts_with('%')) return parameter_reference();
    for (const std::string_view word : {"<!ELEMENT", "<!NOTATION", "<!ATTLIST"}) {
      if (!rest.starts_with(word)) continue;
      const std::size_t close = find_unquoted(">", place_);
      if (close == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
      if (word == "<!ATTLIST" && bytes_.substr(place_, close - place_).find_first_of("'\"") != std::string_view::npos)
        return fail("declares a default value of an attribute in its DOCTYPE: write it where it belongs"), false;
      cut(place_, close + 1);
      place_ = close + 1;
      return true;
    }
    return fail("declares something in its DOCTYPE that XML does not have"), false;
  }

  /// The first of these characters that stands in no quotation marks.
  [[nodiscard]] std::size_t find_unquoted(std::string_view characters, std::size_t from) const {
    const std::string both = std::string(characters) + "'\"";
    std::size_t at = bytes_.find_first_of(both, from);
    while (at != std::string_view::npos && (bytes_[at] == '"' || bytes_[at] == '\'')) {
      at = bytes_.find(bytes_[at], at + 1);
      if (at != std::string_view::npos) at = bytes_.find_first_of(both, at + 1);
    }
    return at;
  }

  /// Cuts out everything between two places but the ends of lines.
  void cut(std::size_t begin, std::size_t end) {
    while (begin < end) {
      const std::size_t line = std::min(bytes_.find('\n', begin), end);
      if (line > begin) cuts_.push_back({begin, line - begin, {}});
      begin = line + 1;
    }
  }

  /// %name; stands for declarations of another file.
  bool parameter_reference() {
    const std::size_t close = bytes_.find(';', place_);
    const std::string_view name = bytes_.substr(place_ + 1, std::min(close, bytes_.size()) - place_ - 1);
    if (close == std::string_view::npos || !parameters_.contains(name))
      return fail("uses a parameter entity that it does not declare"), false;
    cut(place_, close + 1);
    names_other_files_ = true;
    place_ = close + 1;
    return true;
  }

  bool skip_behind(std::string_view end) {
    const std::size_t found = bytes_.find(end, place_);
    place_ = found == std::string_view::npos ? bytes_.size() : found + end.size();
    return true;
  }

  /// <!ENTITY name "value">
  bool entity() {
    const std::size_t begin = place_;
    const std::size_t name = bytes_.find_first_not_of(space, place_ + 8);
    if (name == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    if (bytes_[name] == '%') return parameter(begin, name + 1);
    const std::size_t name_end = std::min(bytes_.find_first_of(space, name), bytes_.size());
    const std::size_t quote = bytes_.find_first_not_of(space, name_end);
    if (quote == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    if (bytes_[quote] != '"' && bytes_[quote] != '\'') {
      entities_.try_emplace(bytes_.substr(name, name_end - name),
                            Entity{.value = {}, .place = begin, .bytes = 1, .is_elsewhere = true});
      return end_elsewhere(begin, quote);
    }
    const std::size_t close = bytes_.find(bytes_[quote], quote + 1);
    if (close == std::string_view::npos) return fail("has an entity without end"), false;
    const std::string_view value = bytes_.substr(quote + 1, close - quote - 1);
    if (!is_plain(value))
      return fail("declares an entity that holds markup, or a character reference that makes some: write its text out"),
             false;
    entities_.try_emplace(bytes_.substr(name, name_end - name), Entity{value, begin});  // the first one binds
    place_ = bytes_.find('>', close);
    return end_entity();
  }

  /// Behind the last declaration of an entity, whose > is at the place.
  bool end_entity() {
    if (place_ == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    if (entities_.size() + parameters_.size() > limits_.entities)
      return fail("declares more than " + std::to_string(limits_.entities) + " entities"), false;
    ++place_;
    return true;
  }

  /// <!ENTITY name SYSTEM "file">
  bool end_elsewhere(std::size_t begin, std::size_t word) {
    const std::string_view rest = bytes_.substr(word);
    if (!rest.starts_with("SYSTEM") && !rest.starts_with("PUBLIC"))
      return fail("declares an entity without a value"), false;
    place_ = find_unquoted(">", word);
    if (place_ != std::string_view::npos) cut(begin, place_ + 1);
    return end_entity();
  }

  /// <!ENTITY % name SYSTEM "file">
  bool parameter(std::size_t begin, std::size_t behind) {
    const std::size_t name = std::min(bytes_.find_first_not_of(space, behind), bytes_.size());
    const std::size_t name_end = std::min(bytes_.find_first_of(space, name), bytes_.size());
    const std::size_t value = bytes_.find_first_not_of(space, name_end);
    if (value == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    if (bytes_[value] == '"' || bytes_[value] == '\'')
      return fail("declares a parameter entity, which is never expanded: remove it"), false;
    parameters_.emplace(bytes_.substr(name, name_end - name));
    return end_elsewhere(begin, value);
  }

  /// The size of an entity with those that it refers to. The depth has a limit of its own, because an expansion of
  /// `entity_bytes` can be nested as deep as there are entities.
  std::size_t measure(std::string_view name, Entity& entity, std::size_t depth) {
    if (problem_ || entity.measure == Entity::Measure::known) return entity.bytes;
    if (entity.measure == Entity::Measure::open || depth > max_depth) {
      place_ = entity.place;
      fail("declares the entity " + base::printable(name) + " by itself, or too deep");
      return 0;
    }
    entity.measure = Entity::Measure::open;
    entity.bytes = entity.value.size();
    for (std::size_t at = entity.value.find('&'); at != std::string_view::npos; at = entity.value.find('&', at + 1)) {
      const std::size_t close = entity.value.find(';', at);
      if (close == std::string_view::npos) break;
      const std::string_view inner_name = entity.value.substr(at + 1, close - at - 1);
      const auto inner = entities_.find(inner_name);
      if (inner != entities_.end()) {
        entity.bytes += measure(inner->first, inner->second, depth + 1);
        entity.is_elsewhere = entity.is_elsewhere || inner->second.is_elsewhere;
      } else if (names_other_files_ && !is_of_xml(inner_name)) {
        entity.is_elsewhere = true;
      }
      if (entity.bytes > limits_.entity_bytes) {
        place_ = entity.place;
        fail("declares the entity " + base::printable(name) + ", which expands to more than " +
             std::to_string(limits_.entity_bytes) + " bytes");
        return 0;
      }
    }
    if (entity.bytes > limits_.entity_bytes) {
      place_ = entity.place;
      fail("declares the entity " + base::printable(name) + ", which is larger than " +
           std::to_string(limits_.entity_bytes) + " bytes");
    }
    entity.measure = Entity::Measure::known;
    return entity.bytes;
  }

  std::optional<ScanProblem> fail(std::string text) {
    if (!problem_) problem_ = ScanProblem{line_of(bytes_, std::min(place_, bytes_.size())), std::move(text)};
    return problem_;
  }

  static constexpr std::size_t max_depth = 16;

  std::string_view bytes_;
  const syntax::FileLimits& limits_;
  std::size_t place_;
  Entities entities_;
  std::set<std::string_view> parameters_;  ///< those that stand for other files
  std::vector<Rewrite> cuts_;
  bool names_other_files_ = false;
  std::optional<ScanProblem> problem_;
};

}  // namespace

std::expected<Doctype, ScanProblem> Doctype::read(std::string_view bytes, std::size_t place,
                                                  const syntax::FileLimits& limits) {
  SubsetReader reader(bytes, place, limits);
  if (auto problem = reader.read()) return std::unexpected(std::move(*problem));
  Doctype doctype;
  doctype.end_ = reader.end();
  doctype.names_other_files_ = reader.names_other_files();
  for (const auto& [name, entity] : reader.entities())
    doctype.entities_.emplace(name, Doctype::Entity{entity.value, entity.bytes, entity.is_elsewhere});
  const auto is_elsewhere = [](const auto& declared) { return declared.second.is_elsewhere; };
  doctype.names_other_entities_ = std::ranges::any_of(doctype.entities_, is_elsewhere);
  doctype.cuts_ = reader.take_cuts();
  return doctype;
}

bool Doctype::is_elsewhere(std::string_view name) const {
  const auto found = entities_.find(name);
  if (found != entities_.end()) return found->second.is_elsewhere;
  return names_other_files_ && !is_of_xml(name);
}

std::size_t Doctype::expanded_bytes(std::string_view name) const {
  const auto found = entities_.find(name);
  return found == entities_.end() ? 1 : found->second.bytes;
}

std::optional<std::string_view> Doctype::value_of(std::string_view name) const {
  const auto found = entities_.find(name);
  if (found == entities_.end() || found->second.is_elsewhere) return std::nullopt;
  return found->second.value;
}

std::optional<std::string> expanded(std::string_view written, const Doctype* doctype) {
  std::string out;
  for (;;) {
    const std::size_t open = std::min(written.find('&'), written.size());
    out += written.substr(0, open);
    if (open == written.size()) return out;
    const std::size_t close = written.find(';', open);
    if (close == std::string_view::npos) return std::nullopt;
    const std::string_view name = written.substr(open + 1, close - open - 1);
    const auto* const known = std::ranges::find(entities_of_xml, name, &std::pair<std::string_view, char>::first);
    const auto value = doctype == nullptr ? std::nullopt : doctype->value_of(name);
    if (known != entities_of_xml.end()) {
      out += known->second;
    } else if (const auto character = character_of(name)) {
      base::append_character(*character, out);
    } else if (const auto inner = value ? expanded(*value, doctype) : std::nullopt) {
      out += *inner;
    } else {
      return std::nullopt;
    }
    written.remove_prefix(close + 1);
  }
}

}  // namespace geminga::rdf
