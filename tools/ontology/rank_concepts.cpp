#include "rank_concepts.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using syntax::Word;

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  if (lower >= 'a' && lower <= 'f') return lower - 'a' + 10;
  return std::nullopt;
}

std::string decoded(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto high = at + 2 < text.size() && text[at] == '%' ? hex_digit(text[at + 1]) : std::nullopt;
    const auto low = high ? hex_digit(text[at + 2]) : std::nullopt;
    if (low) at += 2;
    out += low ? static_cast<char>((*high << 4U) | *low) : text[at];
  }
  return std::string(base::trimmed(out));
}

/// Document and name of an IRI.
std::pair<std::string_view, std::string_view> parts(std::string_view iri) {
  const std::size_t hash = iri.find('#');
  const std::size_t cut = hash != std::string_view::npos ? hash : iri.rfind('/');
  if (cut == std::string_view::npos) return {{}, iri};
  std::string_view document = iri.substr(0, cut);
  while (document.ends_with('/')) document.remove_suffix(1);
  return {document, iri.substr(cut + 1)};
}

/// A file's name without its ending, and a name in it.
std::string key_of(std::string_view file, std::string_view name) {
  for (const std::string_view ending : {".owl", ".rdf", ".rdfs", ".ttl", ".xml", ".daml", ".n3", ".nt"}) {
    if (!file.ends_with(ending) || file.size() == ending.size()) continue;
    file.remove_suffix(ending.size());
    break;
  }
  return decoded(file) + '#' + decoded(name);
}

/// What XML Schema derives from what (XML Schema 1.1 part 2, section 3).
constexpr std::array<std::pair<std::string_view, std::string_view>, 27> datatypes{{
    {"decimal", "number"},
    {"float", "number"},
    {"double", "number"},
    {"integer", "decimal"},
    {"nonPositiveInteger", "integer"},
    {"negativeInteger", "nonPositiveInteger"},
    {"long", "integer"},
    {"int", "long"},
    {"short", "int"},
    {"byte", "short"},
    {"nonNegativeInteger", "integer"},
    {"unsignedLong", "nonNegativeInteger"},
    {"unsignedInt", "unsignedLong"},
    {"unsignedShort", "unsignedInt"},
    {"unsignedByte", "unsignedShort"},
    {"positiveInteger", "nonNegativeInteger"},
    {"normalizedString", "string"},
    {"token", "normalizedString"},
    {"language", "token"},
    {"Name", "token"},
    {"NCName", "Name"},
    {"NMTOKEN", "token"},
    {"dateTime", "instant"},
    {"dateTimeStamp", "dateTime"},
    {"date", "instant"},
    {"time", "instant"},
    {"gYear", "instant"},
}};

}  // namespace

std::string last_two_parts(std::string_view iri) {
  const auto [document, name] = parts(base::trimmed(iri));
  return key_of(document.substr(document.rfind('/') + 1), name);
}

ConceptNames::ConceptNames(CollectionClasses classes) : classes_(std::move(classes)) {
  thing_ = classes_.add(iri_of(Word::owl_thing));
  add_datatypes();
  known_ = classes_.iris.size();
  index();
  join_documents();
}

void ConceptNames::add_datatypes() {
  const auto number = [&](std::string_view name) {
    const std::uint32_t at = classes_.add(std::string(syntax::xsd_namespace) + std::string(name));
    classes_.is_declared[at] = true;
    return at;
  };
  for (const auto& [sub, super] : datatypes) {
    const std::uint32_t below = number(sub);
    classes_.inclusions.emplace_back(below, number(super));
  }
}

void ConceptNames::index() {
  for (std::uint32_t number = 0; number < classes_.iris.size(); ++number) {
    const std::string key = last_two_parts(classes_.iris[number]);
    by_key_[key].push_back(number);
    by_lower_key_[base::in_lower_case(key)].push_back(number);
  }
  // A file may call itself otherwise than the collection calls it.
  const auto is_declared = [&](std::uint32_t number) { return classes_.is_declared[number]; };
  for (const auto& [file, number] : classes_.declared_in) {
    const std::string key = key_of(file, parts(classes_.iris[number]).second);
    for (auto* index : {&by_key_, &by_lower_key_}) {
      std::vector<std::uint32_t>& named = (*index)[index == &by_key_ ? key : base::in_lower_case(key)];
      if (std::ranges::none_of(named, is_declared)) named.push_back(number);
    }
  }
}

void ConceptNames::join_documents() {
  // How many declared classes each document has, and how many any two of them share by name.
  std::map<std::string_view, std::size_t> size;
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> shared;
  const auto document_of = [&](std::uint32_t number) { return parts(classes_.iris[number]).first; };
  constexpr std::size_t max_documents = 16;  // of one file name
  for (const auto& [key, numbers] : by_key_) {
    std::vector<std::string_view> documents;
    for (const std::uint32_t number : numbers) {
      if (!classes_.is_declared[number]) continue;
      ++size[document_of(number)];
      if (documents.size() < max_documents) documents.push_back(document_of(number));
    }
    for (std::size_t a = 0; a < documents.size(); ++a) {
      for (std::size_t b = a + 1; b < documents.size(); ++b) ++shared[std::minmax(documents[a], documents[b])];
    }
  }
  const auto are_one = [&](std::uint32_t a, std::uint32_t b) {
    const auto found = shared.find(std::minmax(document_of(a), document_of(b)));
    const std::size_t smaller = std::min(size[document_of(a)], size[document_of(b)]);
    return found != shared.end() && 5 * found->second >= 4 * smaller;
  };
  const auto equate = [&](std::uint32_t a, std::uint32_t b) {
    classes_.inclusions.emplace_back(a, b);
    classes_.inclusions.emplace_back(b, a);
  };
  for (const auto& [key, numbers] : by_key_) {
    std::vector<std::uint32_t> declared;
    std::ranges::copy_if(numbers, std::back_inserter(declared),
                         [&](std::uint32_t number) { return classes_.is_declared[number]; });
    if (declared.empty()) continue;
    const bool is_one = std::ranges::all_of(
        declared, [&](std::uint32_t other) { return other == declared.front() || are_one(declared.front(), other); });
    if (!is_one) continue;
    for (const std::uint32_t number : numbers) {
      if (number != declared.front()) equate(declared.front(), number);
    }
  }
}

signature::Concept ConceptNames::find(std::string_view type) {
  if (type.empty()) return signature::Concept{thing_};
  if (const auto exact = classes_.number_of.find(std::string(type)); exact != classes_.number_of.end())
    return signature::Concept{exact->second};
  const std::string key = last_two_parts(type);
  const auto choose = [&](const std::vector<std::uint32_t>& numbers) {
    const auto declared =
        std::ranges::find_if(numbers, [&](std::uint32_t number) { return classes_.is_declared[number]; });
    return signature::Concept{declared == numbers.end() ? numbers.front() : *declared};
  };
  if (const auto found = by_key_.find(key); found != by_key_.end()) return choose(found->second);
  const std::string lower = base::in_lower_case(key);
  if (const auto found = by_lower_key_.find(lower); found != by_lower_key_.end()) return choose(found->second);
  const std::uint32_t number = classes_.add(type);
  by_key_[key].push_back(number);
  by_lower_key_[lower].push_back(number);
  return signature::Concept{number};
}

const std::string& ConceptNames::iri(signature::Concept of) const {
  return classes_.iris[static_cast<std::size_t>(of)];
}

bool ConceptNames::is_unknown(signature::Concept of) const { return static_cast<std::size_t>(of) >= known_; }

signature::Hierarchy ConceptNames::hierarchy() const {
  std::vector<signature::Inclusion> inclusions;
  inclusions.reserve(classes_.inclusions.size());
  for (const auto& [sub, super] : classes_.inclusions)
    inclusions.emplace_back(signature::Concept{sub}, signature::Concept{super});
  return {static_cast<std::uint32_t>(classes_.iris.size()), inclusions, signature::Concept{thing_}};
}

}  // namespace geminga::ontology
