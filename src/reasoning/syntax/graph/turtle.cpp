#include "reasoning/syntax/graph/turtle.hpp"

#include <algorithm>
#include <optional>

#include "base/sorted.hpp"
#include "base/text.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {
namespace {

using Pairs = std::vector<std::pair<std::string_view, std::string_view>>;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_plain(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.'; }

/// Appends terms to a text, and remembers the first name that cannot be written.
class WrittenTerms {
 public:
  explicit WrittenTerms(Pairs prefixes) : prefixes_(std::move(prefixes)) {}

  std::string text;
  std::optional<std::string> problem;

  void iri(std::string_view name) {
    if (!prefixes_.empty()) {
      // Readers differ in what else a local name may have.
      const std::string found = owl::shorten(name, prefixes_);
      if (found.front() != '<' && std::ranges::all_of(found.substr(found.find(':') + 1), is_plain)) {
        text += found;
        return;
      }
    }
    if (!is_writable(name) && !problem)
      problem = "the name " + base::printable(name, 100) +
                " has a character that no IRI may have: write --to rdfxml, or mend the name";
    ((text += '<') += name) += '>';
  }

  void label(const raptor_term& blank) { (text += "_:") += text_of(blank); }

  /// In N-Triples a line feed is an escape, too.
  void literal(const raptor_term& term, bool is_turtle) {
    const std::string_view words = text_of(term);
    const std::string_view datatype = datatype_of(term);
    if (is_turtle && is_bare(words, datatype)) {
      text += words;
      return;
    }
    const bool is_long = is_turtle && words.contains('\n');
    const std::string_view quotes = is_long ? R"(""")" : R"(")";
    text += quotes;
    for (const char c : words) escaped(c, is_turtle, is_long);
    text += quotes;
    if (term.value.literal.language_len != 0) {
      (text += '@').append(reinterpret_cast<const char*>(term.value.literal.language), term.value.literal.language_len);
    } else if (!datatype.empty()) {
      text += "^^";
      iri(datatype);
    }
  }

  [[nodiscard]] static bool is_writable(std::string_view name) {
    return name.find_first_of(" <>\"{}|\\^`") == std::string_view::npos && !base::has_control_character(name);
  }

 private:
  static std::string_view datatype_of(const raptor_term& term) {
    std::size_t size = 0;
    const unsigned char* name = term.value.literal.datatype == nullptr
                                    ? nullptr
                                    : raptor_uri_as_counted_string(term.value.literal.datatype, &size);
    return name == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(name), size);
  }

  void escaped(char c, bool is_turtle, bool is_long) {
    switch (c) {
      case '"':
      case '\\':
        (text += '\\') += c;
        return;
      case '\n':
        text += is_long ? "\n" : "\\n";
        return;
      case '\r':
        text += "\\r";
        return;
      case '\t':
        text += is_turtle ? "\t" : "\\t";  // the OWL API reads the escape in Turtle as the letter t
        return;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
          text += "\\u00" + base::to_hex(static_cast<unsigned char>(c), 2);
        } else {
          text += c;
        }
    }
  }

  /// Whether a literal is read as the same without quotation marks (Turtle, section 2.5.2).
  static bool is_bare(std::string_view words, std::string_view datatype) {
    if (!datatype.starts_with(syntax::xsd_namespace)) return false;
    const std::string_view type = datatype.substr(syntax::xsd_namespace.size());
    if (type == "boolean") return words == "true" || words == "false";
    if (type != "integer" && type != "decimal" && type != "double") return false;
    const auto skip_digits = [&] {
      const std::size_t count = std::min(words.find_first_not_of("0123456789"), words.size());
      words.remove_prefix(count);
      return count != 0;
    };
    const auto skip_one_of = [&](std::string_view characters) {
      const bool is_there = !words.empty() && characters.contains(words.front());
      if (is_there) words.remove_prefix(1);
      return is_there;
    };
    (void)skip_one_of("+-");
    if (!skip_digits()) return false;
    if (type == "integer") return words.empty();
    if (!skip_one_of(".") || !skip_digits()) return false;
    if (type == "decimal") return words.empty();
    if (!skip_one_of("eE")) return false;
    (void)skip_one_of("+-");
    return skip_digits() && words.empty();
  }

  Pairs prefixes_;
};

/// The prefixes that Turtle can declare, sorted. One of two IRIs means neither.
Pairs declared(const Prefixes& given) {
  Pairs prefixes;
  for (const auto& [prefix, name] : given) {
    const bool is_prefix =
        prefix.empty() || (is_letter(prefix.front()) && prefix.back() != '.' && std::ranges::all_of(prefix, is_plain));
    if (is_prefix && WrittenTerms::is_writable(name)) prefixes.emplace_back(prefix, name);
  }
  base::sort_unique(prefixes);
  Pairs single;
  for (std::size_t at = 0; at < prefixes.size(); ++at) {
    const bool is_shared = (at > 0 && prefixes[at - 1].first == prefixes[at].first) ||
                           (at + 1 < prefixes.size() && prefixes[at + 1].first == prefixes[at].first);
    if (!is_shared) single.push_back(prefixes[at]);
  }
  return single;
}

/// One prefix for each IRI, the empty one if it is among them.
Pairs used(const Pairs& prefixes) {
  Pairs used;
  for (const auto& prefix : prefixes) {
    if (std::ranges::find(used, prefix.second, &Pairs::value_type::second) == used.end()) used.push_back(prefix);
  }
  return used;
}

class Turtle {
 public:
  Turtle(Triples sorted, const Pairs& prefixes) : nodes_(sorted, true), terms_(used(prefixes)) {
    for (const auto& [prefix, name] : prefixes) ((((terms_.text += "@prefix ") += prefix) += ": <") += name) += "> .\n";
  }

  std::expected<std::string, std::string> write() {
    for (Triples root = nodes_.next_root(); !root.empty() && !terms_.problem; root = nodes_.next_root()) {
      terms_.text += '\n';
      const raptor_term& subject = *root.front()->subject;
      if (is_blank(subject) && !nodes_.is_referred_to(subject)) {
        terms_.text += "[]";
      } else if (is_blank(subject)) {
        terms_.label(subject);
      } else {
        terms_.iri(text_of(subject));
      }
      predicates(root, 0);
      terms_.text += " .\n";
    }
    if (terms_.problem) return std::unexpected(*terms_.problem);
    return std::move(terms_.text);
  }

 private:
  static bool is_type(const raptor_statement& triple) { return text_of(*triple.predicate) == rdf_type; }

  /// Each on a line of its own; types come first.
  void predicates(Triples of_subject, std::size_t depth) {
    bool is_first = true;
    for (const bool are_types : {true, false}) {
      const raptor_statement* last = nullptr;
      for (const raptor_statement* triple : of_subject) {
        if (is_type(*triple) != are_types) continue;
        if (last != nullptr && raptor_term_equals(last->predicate, triple->predicate) != 0) {
          terms_.text += ", ";
        } else {
          if (!is_first) terms_.text += " ;";
          line(depth + 1);
          if (are_types) {
            terms_.text += 'a';
          } else {
            terms_.iri(text_of(*triple->predicate));
          }
          terms_.text += ' ';
        }
        object(*triple->object, depth + 1);
        last = triple;
        is_first = false;
      }
    }
  }

  void object(const raptor_term& term, std::size_t depth) {
    if (is_iri(term)) return text_of(term) == nil_ ? (void)(terms_.text += "()") : terms_.iri(text_of(term));
    if (is_literal(term)) return terms_.literal(term, true);
    switch (nodes_.place(term, depth)) {
      case PlacedNodes::Place::labelled:
        return terms_.label(term);
      case PlacedNodes::Place::list:
        return list(term, depth);
      case PlacedNodes::Place::nested:
        break;
    }
    terms_.text += '[';
    const Triples triples = nodes_.triples(term);
    if (!triples.empty()) {
      predicates(triples, depth);
      line(depth);
    }
    terms_.text += ']';
  }

  /// On one line if it is short and of names.
  void list(const raptor_term& head, std::size_t depth) {
    constexpr std::size_t short_list = 4;
    const std::vector<const raptor_term*> members = nodes_.members(head);
    const bool is_short =
        members.size() <= short_list && std::ranges::all_of(members, [](auto* member) { return is_iri(*member); });
    terms_.text += '(';
    for (const raptor_term* member : members) {
      if (is_short) {
        terms_.text += ' ';
      } else {
        line(depth + 1);
      }
      object(*member, depth + 1);
    }
    if (is_short) {
      terms_.text += ' ';
    } else {
      line(depth);
    }
    terms_.text += ')';
  }

  void line(std::size_t depth) { (terms_.text += '\n').append(4 * depth, ' '); }

  const std::string nil_ = std::string(syntax::rdf_namespace) + "nil";
  PlacedNodes nodes_;
  WrittenTerms terms_;
};

}  // namespace

std::expected<std::string, std::string> write_turtle(Triples sorted, const Prefixes& prefixes) {
  return Turtle(sorted, declared(prefixes)).write();
}

std::expected<std::string, std::string> write_n_triples(Triples sorted) {
  WrittenTerms terms({});
  for (const raptor_statement* triple : sorted) {
    for (const raptor_term* term : {triple->subject, triple->predicate, triple->object}) {
      if (is_iri(*term)) {
        terms.iri(text_of(*term));
      } else if (is_blank(*term)) {
        terms.label(*term);
      } else {
        terms.literal(*term, false);
      }
      terms.text += ' ';
    }
    terms.text += ".\n";
    if (terms.problem) return std::unexpected(*terms.problem);
  }
  return std::move(terms.text);
}

}  // namespace geminga::graph
