#include "reasoning/syntax/graph/rdf_xml.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {
namespace {

struct Range {
  char32_t first, last;
};

/// NameStartChar of XML 1.0, section 2.3, without the colon.
constexpr std::array<Range, 15> name_starts{{{'A', 'Z'},
                                             {'_', '_'},
                                             {'a', 'z'},
                                             {0xc0, 0xd6},
                                             {0xd8, 0xf6},
                                             {0xf8, 0x2ff},
                                             {0x370, 0x37d},
                                             {0x37f, 0x1fff},
                                             {0x200c, 0x200d},
                                             {0x2070, 0x218f},
                                             {0x2c00, 0x2fef},
                                             {0x3001, 0xd7ff},
                                             {0xf900, 0xfdcf},
                                             {0xfdf0, 0xfffd},
                                             {0x10000, 0xeffff}}};
/// The characters of NameChar beyond those of NameStartChar.
constexpr std::array<Range, 6> name_continuations{
    {{'-', '-'}, {'.', '.'}, {'0', '9'}, {0xb7, 0xb7}, {0x300, 0x36f}, {0x203f, 0x2040}}};

bool is_in(char32_t character, std::span<const Range> ranges) {
  return std::ranges::any_of(ranges,
                             [&](const Range& range) { return character >= range.first && character <= range.last; });
}

/// The beginning of the longest local name of an XML element at the end of an IRI; its size if there is none.
std::size_t local_name_of(std::string_view iri) {
  std::size_t begin = iri.size();
  for (std::size_t at = 0; at < iri.size(); at += base::character_bytes(static_cast<unsigned char>(iri[at]))) {
    const char32_t character = base::character_at(iri.data() + at);
    const bool is_start = is_in(character, name_starts);
    if (is_start) {
      begin = std::min(begin, at);
    } else if (!is_in(character, name_continuations)) {
      begin = iri.size();
    }
  }
  return begin;
}

/// Whether a word of rdf: is no name of an element that a triple needs (RDF/XML, section 7.2.4 and following).
bool is_reserved(std::string_view namespace_name, std::string_view local) {
  static const std::set<std::string_view> words{"Description", "RDF",       "ID",        "about",
                                                "bagID",       "parseType", "resource",  "nodeID",
                                                "li",          "datatype",  "aboutEach", "aboutEachPrefix"};
  return namespace_name == syntax::rdf_namespace && words.contains(local);
}

/// Such prefixes belong to XML itself.
bool begins_with_xml(std::string_view prefix) {
  const auto is = [&](std::size_t at, char small) { return prefix[at] == small || prefix[at] == small - 'a' + 'A'; };
  return prefix.size() >= 3 && is(0, 'x') && is(1, 'm') && is(2, 'l');
}

/// The prefixes of a document: those given, and made ones for the namespaces of properties that have none.
class Elements {
 public:
  Elements(Triples triples, const Prefixes& given) {
    std::map<std::string_view, std::set<std::string_view>> meanings;
    for (const auto& [prefix, name] : given) {
      const bool is_prefix = prefix.empty() || (local_name_of(prefix) == 0 && !begins_with_xml(prefix));
      if (is_prefix && !name.empty() && name != xml_namespace) meanings[prefix].insert(name);
    }
    for (const auto& [prefix, names] : meanings) {
      if (names.size() == 1) prefixes_.emplace(*names.begin(), prefix);
      taken_.insert(std::string(prefix));
    }
    // The empty prefix is none of attributes.
    const auto rdf = prefixes_.find(std::string(syntax::rdf_namespace));
    if (rdf == prefixes_.end() || rdf->second.empty()) prefixes_[std::string(syntax::rdf_namespace)] = free("rdf");
    std::unordered_set<std::string_view> predicates;
    for (const raptor_statement* triple : triples) {
      const std::string_view predicate = text_of(*triple->predicate);
      if (!predicates.insert(predicate).second) continue;
      const std::size_t local = local_name_of(predicate);
      if (local != predicate.size() && !is_reserved(predicate.substr(0, local), predicate.substr(local)) &&
          !find(predicate))
        prefixes_.emplace(predicate.substr(0, local), free("ns1"));
    }
  }

  /// `prefix:local`; nothing for a name that no element can have with these prefixes.
  [[nodiscard]] std::optional<std::string> find(std::string_view iri) const {
    const std::size_t local = local_name_of(iri);
    // A namespace may end within the name: obo:BFO_1 where the longest name is the same, or dir:a.b.
    for (std::size_t at = local; at < iri.size(); ++at) {
      const auto found = prefixes_.find(iri.substr(0, at));
      if (found == prefixes_.end() || local_name_of(iri.substr(at)) != 0) continue;
      if (is_reserved(found->first, iri.substr(at))) return std::nullopt;
      return found->second + (found->second.empty() ? "" : ":") + std::string(iri.substr(at));
    }
    return std::nullopt;
  }

  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& prefixes() const { return prefixes_; }
  /// Of the words of RDF, with the colon.
  [[nodiscard]] std::string rdf() const { return prefixes_.find(syntax::rdf_namespace)->second + ':'; }

 private:
  static constexpr std::string_view xml_namespace = "http://www.w3.org/XML/1998/namespace";

  /// A prefix that has no meaning yet.
  std::string free(std::string prefix) {
    for (std::size_t number = 1; !taken_.insert(prefix).second; ++number) prefix = "ns" + std::to_string(number);
    return prefix;
  }

  std::map<std::string, std::string, std::less<>> prefixes_;  ///< by namespace
  std::set<std::string> taken_;
};

class RdfXml {
 public:
  RdfXml(Triples sorted, const Prefixes& prefixes)
      : nodes_(sorted, false), elements_(sorted, prefixes), rdf_(elements_.rdf()) {}

  std::expected<std::string, std::string> write() {
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<" + rdf_ + "RDF";
    std::map<std::string_view, std::string_view> declared;
    for (const auto& [name, prefix] : elements_.prefixes()) declared.emplace(prefix, name);
    for (const auto& [prefix, name] : declared) {
      text_ += "\n    ";
      attribute(prefix.empty() ? "xmlns" : "xmlns:" + std::string(prefix), name);
    }
    text_ += ">\n";
    for (Triples root = nodes_.next_root(); !root.empty() && !problem_; root = nodes_.next_root()) {
      const raptor_term& subject = *root.front()->subject;
      text_ += '\n';
      node(subject, !is_blank(subject) || nodes_.is_referred_to(subject), root, 0);
    }
    text_ += "\n</" + rdf_ + "RDF>\n";
    if (problem_) return std::unexpected(*problem_);
    return std::move(text_);
  }

 private:
  const std::optional<std::string>& element_of(std::string_view iri) {
    const auto known = known_.find(iri);
    return known != known_.end() ? known->second : known_.emplace(iri, elements_.find(iri)).first->second;
  }

  /// A node element, without a name for a blank node that stands in its place.
  void node(const raptor_term& subject, bool is_named, Triples triples, std::size_t depth) {
    const raptor_statement* type = nullptr;
    std::string element = rdf_ + "Description";
    for (const raptor_statement* triple : triples) {
      if (text_of(*triple->predicate) != rdf_type || !is_iri(*triple->object)) continue;
      const auto& found = element_of(text_of(*triple->object));
      if (!found) continue;
      type = triple;
      element = *found;
      break;
    }
    line(2 * depth);
    text_ += '<' + element;
    if (is_named) reference(subject, "about");
    if (triples.size() == (type == nullptr ? 0U : 1U)) {
      text_ += "/>\n";
      return;
    }
    text_ += ">\n";
    for (const raptor_statement* triple : triples) {
      if (triple != type) property(*triple, depth);
    }
    line(2 * depth);
    text_ += "</" + element + ">\n";
  }

  void property(const raptor_statement& triple, std::size_t depth) {
    const auto& element = element_of(text_of(*triple.predicate));
    if (!element)
      return fail("the property " + base::printable(text_of(*triple.predicate), 100) +
                  " has no name that an XML element can have: write --to turtle or ntriples");
    const raptor_term& object = *triple.object;
    line(2 * depth + 1);
    text_ += '<' + *element;
    if (is_literal(object)) {
      literal(object);
    } else if (is_iri(object)) {
      reference(object, "resource");
      text_ += "/>\n";
      return;
    } else {
      switch (nodes_.place(object, depth)) {
        case PlacedNodes::Place::labelled:
          reference(object, "resource");
          text_ += "/>\n";
          return;
        case PlacedNodes::Place::list:
          text_ += ' ';
          attribute(rdf_ + "parseType", "Collection");
          text_ += ">\n";
          for (const raptor_term* member : nodes_.members(object)) this->member(*member, depth + 1);
          break;
        case PlacedNodes::Place::nested:
          text_ += ">\n";
          node(object, false, nodes_.triples(object), depth + 1);
      }
      line(2 * depth + 1);
    }
    text_ += "</" + *element + ">\n";
  }

  void member(const raptor_term& term, std::size_t depth) {
    // A list in a list is nested nodes: only a property can say that its value is a list.
    const bool is_named = is_iri(term) || nodes_.place(term, depth, false) == PlacedNodes::Place::labelled;
    node(term, is_named, is_named ? Triples() : nodes_.triples(term), depth);
  }

  void literal(const raptor_term& term) {
    const raptor_term_literal_value& value = term.value.literal;
    if (value.language_len != 0) {
      text_ += ' ';
      attribute("xml:lang", {reinterpret_cast<const char*>(value.language), value.language_len});
    } else if (value.datatype != nullptr) {
      std::size_t size = 0;
      const unsigned char* name = raptor_uri_as_counted_string(value.datatype, &size);
      text_ += ' ';
      attribute(rdf_ + "datatype", {reinterpret_cast<const char*>(name), size});
    }
    text_ += '>';
    escaped(text_of(term), false);
  }

  void reference(const raptor_term& term, std::string_view word) {
    text_ += ' ';
    attribute(rdf_ + (is_blank(term) ? "nodeID" : std::string(word)), text_of(term));
  }

  void attribute(const std::string& name, std::string_view value) {
    (text_ += name) += "=\"";
    escaped(value, true);
    text_ += '"';
  }

  /// White space in attributes, and a carriage return anywhere, would be read as something else (XML 1.0, sections 2.11
  /// and 3.3.3). Other control characters cannot be in XML at all (section 2.2).
  void escaped(std::string_view value, bool is_attribute) {
    for (const char c : value) {
      const auto octet = static_cast<unsigned char>(c);
      if (c == '&') {
        text_ += "&amp;";
      } else if (c == '<') {
        text_ += "&lt;";
      } else if (c == '>') {
        text_ += "&gt;";
      } else if (c == '\r' || (is_attribute && (c == '\n' || c == '\t' || c == '"'))) {
        text_ += "&#" + std::to_string(octet) + ';';
      } else if (octet < 0x20 && c != '\n' && c != '\t') {
        return fail("a text has the control character " + std::to_string(octet) +
                    ", which no XML can have: write --to turtle or ntriples");
      } else {
        text_ += c;
      }
    }
  }

  void fail(std::string problem) {
    if (!problem_) problem_ = std::move(problem);
  }

  void line(std::size_t depth) { text_.append(2 * (depth + 1), ' '); }

  PlacedNodes nodes_;
  Elements elements_;
  std::unordered_map<std::string_view, std::optional<std::string>> known_;  ///< elements by IRI
  std::string rdf_;
  std::string text_;
  std::optional<std::string> problem_;
};

}  // namespace

std::expected<std::string, std::string> write_rdf_xml(Triples sorted, const Prefixes& prefixes) {
  return RdfXml(sorted, prefixes).write();
}

}  // namespace geminga::graph
