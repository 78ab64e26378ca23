#include "ontology/ranking/concept_names.hpp"

#include <algorithm>
#include <array>
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

/// The document and the name in it that an IRI consists of.
std::pair<std::string_view, std::string_view> parts(std::string_view iri) {
  const std::size_t hash = iri.find('#');
  const std::size_t cut = hash != std::string_view::npos ? hash : iri.rfind('/');
  if (cut == std::string_view::npos) return {{}, iri};
  std::string_view document = iri.substr(0, cut);
  while (document.ends_with('/')) document.remove_suffix(1);
  return {document, iri.substr(cut + 1)};
}

/// `file#name`, the file without its ending.
std::string key_of(std::string_view file, std::string_view name) {
  for (const std::string_view ending : {".owl", ".rdf", ".rdfs", ".ttl", ".xml", ".daml", ".n3", ".nt"}) {
    if (!file.ends_with(ending) || file.size() == ending.size()) continue;
    file.remove_suffix(ending.size());
    break;
  }
  return decoded(file) + '#' + decoded(name);
}

/// Derived datatypes and those that they are derived from (XML Schema 1.1 part 2, section 3).
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

/// The numbers of class names that documents share.
class Documents {
 public:
  /// The most documents with one name that are compared. A name in more of them says little about any two.
  static constexpr std::size_t max_with_one_name = 64;

  Documents(const std::vector<std::string>& iris, const std::map<std::string, std::vector<std::uint32_t>>& by_name) {
    for (const auto& [name, numbers] : by_name) {
      for (const std::uint32_t number : numbers) ++size_[document_of(iris[number])];
      const std::size_t some = std::min(numbers.size(), max_with_one_name);
      for (std::size_t a = 0; a < some; ++a) {
        for (std::size_t b = a + 1; b < some; ++b)
          ++shared_[pair_of(document_of(iris[numbers[a]]), document_of(iris[numbers[b]]))];
      }
    }
  }

  /// Whether the documents of two IRIs are copies of one: four fifths of the classes of the smaller one are in the
  /// other, and they have the same file name, or enough classes that this is no accident.
  [[nodiscard]] bool are_one(std::string_view a, std::string_view b) const {
    constexpr std::size_t no_accident = 10;
    const std::string_view first = document_of(a);
    const std::string_view second = document_of(b);
    const auto found = shared_.find(pair_of(first, second));
    if (first == second || found == shared_.end()) return false;
    if (found->second < no_accident && file_of(first) != file_of(second)) return false;
    return 5 * found->second >= 4 * std::min(size_.find(first)->second, size_.find(second)->second);
  }

 private:
  using Pair = std::pair<std::string_view, std::string_view>;

  static std::string_view document_of(std::string_view iri) { return parts(iri).first; }
  static std::string file_of(std::string_view document) { return key_of(document.substr(document.rfind('/') + 1), {}); }
  static Pair pair_of(std::string_view a, std::string_view b) { return a < b ? Pair{a, b} : Pair{b, a}; }

  std::map<std::string_view, std::size_t> size_;
  std::map<Pair, std::size_t> shared_;
};

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
  // The IRI that a file gives itself may differ from the file's name, by which the collection knows it.
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
  std::map<std::string, std::vector<std::uint32_t>> declared_by_name;
  for (std::uint32_t number = 0; number < classes_.iris.size(); ++number) {
    if (classes_.is_declared[number]) declared_by_name[decoded(parts(classes_.iris[number]).second)].push_back(number);
  }
  const Documents documents(classes_.iris, declared_by_name);
  const auto equate = [&](std::uint32_t a, std::uint32_t b) {
    classes_.inclusions.emplace_back(a, b);
    classes_.inclusions.emplace_back(b, a);
  };
  for (const auto& [name, declared] : declared_by_name) {
    const std::size_t some = std::min(declared.size(), Documents::max_with_one_name);
    for (std::size_t a = 0; a < some; ++a) {
      for (std::size_t b = a + 1; b < some; ++b) {
        if (documents.are_one(classes_.iris[declared[a]], classes_.iris[declared[b]])) equate(declared[a], declared[b]);
      }
    }
  }
  // A name that is only mentioned means the declared class, where there is only one.
  for (const auto& [key, numbers] : by_key_) {
    const auto is_declared = [&](std::uint32_t number) { return classes_.is_declared[number]; };
    const auto first = std::ranges::find_if(numbers, is_declared);
    if (first == numbers.end()) continue;
    const bool is_one = std::ranges::all_of(numbers, [&](std::uint32_t other) {
      return !is_declared(other) || other == *first || documents.are_one(classes_.iris[*first], classes_.iris[other]);
    });
    for (const std::uint32_t number : numbers) {
      if (is_one && !is_declared(number)) equate(*first, number);
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
  return {static_cast<std::uint32_t>(classes_.iris.size()), inclusions, signature::Concept{thing_},
          static_cast<std::uint32_t>(classes_.iris.size() - known_)};
}

}  // namespace geminga::ontology
