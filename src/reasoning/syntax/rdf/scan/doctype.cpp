// Reads the internal subset of a DOCTYPE (XML 1.0, section 2.8) as far as it declares entities, and refuses the rest.
#include "reasoning/syntax/rdf/scan/doctype.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace geminga::rdf {
namespace {

constexpr std::string_view space = " \t\r\n";

struct Entity {
  std::string_view value;
  std::size_t place = 0;
  std::size_t bytes = 0;
  enum class Measure { unknown, open, known } measure = Measure::unknown;
};
using Entities = std::map<std::string_view, Entity>;

class SubsetReader {
 public:
  SubsetReader(std::string_view bytes, std::size_t place, const syntax::FileLimits& limits)
      : bytes_(bytes), limits_(limits), place_(place) {}

  std::optional<ScanProblem> read() {
    place_ += 9;  // <!DOCTYPE
    const std::size_t open = bytes_.find_first_of("[>", place_);
    if (open == std::string_view::npos) return fail("has a DOCTYPE without end");
    if (bytes_.substr(place_, open - place_).find_first_of("'\"") != std::string_view::npos)
      return fail("names an external DTD, which is never read: remove it from the DOCTYPE");
    place_ = open + 1;
    if (bytes_[open] == '>') return std::nullopt;
    while (!problem_ && declaration()) {
    }
    for (auto& [name, entity] : entities_) {
      if (!problem_) measure(name, entity, 0);
    }
    return std::move(problem_);
  }

  [[nodiscard]] std::size_t end() const { return place_; }
  [[nodiscard]] const Entities& entities() const { return entities_; }

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
    if (rest.starts_with('%')) return fail("uses a parameter entity, which is never expanded: remove it"), false;
    return fail("declares more than entities in its DOCTYPE: remove the DTD"), false;
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
    if (bytes_[name] == '%') return fail("declares a parameter entity, which is never expanded: remove it"), false;
    const std::size_t name_end = std::min(bytes_.find_first_of(space, name), bytes_.size());
    const std::size_t quote = bytes_.find_first_not_of(space, name_end);
    if (quote == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    if (bytes_[quote] != '"' && bytes_[quote] != '\'')
      return fail("declares an external entity, which is never read: remove it"), false;
    const std::size_t close = bytes_.find(bytes_[quote], quote + 1);
    if (close == std::string_view::npos) return fail("has an entity without end"), false;
    const std::string_view value = bytes_.substr(quote + 1, close - quote - 1);
    if (value.find('<') != std::string_view::npos || value.find("&#") != std::string_view::npos)
      return fail("declares an entity that holds markup or character references: write its text out"), false;
    entities_.try_emplace(bytes_.substr(name, name_end - name), Entity{value, begin});  // the first one binds
    if (entities_.size() > limits_.entities)
      return fail("declares more than " + std::to_string(limits_.entities) + " entities"), false;
    place_ = bytes_.find('>', close);
    if (place_ == std::string_view::npos) return fail("has a DOCTYPE without end"), false;
    ++place_;
    return true;
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
      const auto inner = entities_.find(entity.value.substr(at + 1, close - at - 1));
      if (inner != entities_.end()) entity.bytes += measure(inner->first, inner->second, depth + 1);
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
  std::optional<ScanProblem> problem_;
};

}  // namespace

std::expected<Doctype, ScanProblem> Doctype::read(std::string_view bytes, std::size_t place,
                                                  const syntax::FileLimits& limits) {
  SubsetReader reader(bytes, place, limits);
  if (auto problem = reader.read()) return std::unexpected(std::move(*problem));
  Doctype doctype;
  doctype.end_ = reader.end();
  for (const auto& [name, entity] : reader.entities())
    doctype.entities_.emplace(name, Doctype::Entity{entity.value, entity.bytes});
  return doctype;
}

std::size_t Doctype::expanded_bytes(std::string_view name) const {
  const auto found = entities_.find(name);
  return found == entities_.end() ? 1 : found->second.bytes;
}

std::optional<std::string_view> Doctype::value_of(std::string_view name) const {
  const auto found = entities_.find(name);
  return found == entities_.end() ? std::nullopt : std::optional(found->second.value);
}

std::optional<std::string> expanded(std::string_view written, const Doctype* doctype) {
  constexpr std::array<std::pair<std::string_view, char>, 5> of_xml{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  std::string out;
  for (;;) {
    const std::size_t open = std::min(written.find('&'), written.size());
    out += written.substr(0, open);
    if (open == written.size()) return out;
    const std::size_t close = written.find(';', open);
    if (close == std::string_view::npos) return std::nullopt;
    const std::string_view name = written.substr(open + 1, close - open - 1);
    const auto* const known = std::ranges::find(of_xml, name, &std::pair<std::string_view, char>::first);
    const auto value = doctype == nullptr ? std::nullopt : doctype->value_of(name);
    if (known != of_xml.end()) {
      out += known->second;
    } else if (const auto inner = value ? expanded(*value, doctype) : std::nullopt) {
      out += *inner;
    } else {
      return std::nullopt;
    }
    written.remove_prefix(close + 1);
  }
}

}  // namespace geminga::rdf
