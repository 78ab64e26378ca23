// Printing in the manner of the Manchester syntax.
#include "reasoning/owl/print.hpp"

#include <algorithm>
#include <array>

namespace geminga::owl {
namespace {

constexpr std::string_view every_value = "http://www.w3.org/2000/01/rdf-schema#Literal";

/// The words of the Manchester syntax for facets.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> facets{{
    {"http://www.w3.org/2001/XMLSchema#maxInclusive", "<="},
    {"http://www.w3.org/2001/XMLSchema#maxExclusive", "<"},
    {"http://www.w3.org/2001/XMLSchema#minInclusive", ">="},
    {"http://www.w3.org/2001/XMLSchema#minExclusive", ">"},
    {"http://www.w3.org/2001/XMLSchema#length", "length"},
    {"http://www.w3.org/2001/XMLSchema#minLength", "minLength"},
    {"http://www.w3.org/2001/XMLSchema#maxLength", "maxLength"},
    {"http://www.w3.org/2001/XMLSchema#pattern", "pattern"},
    {"http://www.w3.org/1999/02/22-rdf-syntax-ns#langRange", "langRange"},
}};

constexpr std::string_view swrl_built_ins = "http://www.w3.org/2003/11/swrlb#";
/// The signs of built-ins that compare two values.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> comparisons{{
    {"equal", "="},
    {"notEqual", "!="},
    {"lessThan", "<"},
    {"lessThanOrEqual", "<="},
    {"greaterThan", ">"},
    {"greaterThanOrEqual", ">="},
}};

constexpr std::string_view swrl_variables = "urn:swrl:var#";

/// "?x" for "urn:swrl:var#x".
std::string variable_name(std::string_view iri) {
  const std::size_t end = iri.find_last_of("#/:?");
  return "?" + std::string(end == std::string_view::npos ? iri : iri.substr(end + 1));
}

/// The word of a restriction; empty for any other term.
std::string_view word_of_restriction(TermKind kind) {
  switch (kind) {
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
      return "some";
    case TermKind::object_all_values_from:
    case TermKind::data_all_values_from:
      return "only";
    case TermKind::object_has_value:
    case TermKind::data_has_value:
      return "value";
    case TermKind::object_has_self:
      return "Self";
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
      return "min";
    case TermKind::object_max_cardinality:
    case TermKind::data_max_cardinality:
      return "max";
    case TermKind::object_exact_cardinality:
    case TermKind::data_exact_cardinality:
      return "exactly";
    default:
      return {};
  }
}

bool is_cardinality(TermKind kind) {
  return (kind >= TermKind::object_min_cardinality && kind <= TermKind::object_exact_cardinality) ||
         (kind >= TermKind::data_min_cardinality && kind <= TermKind::data_exact_cardinality);
}

std::string quoted_on_one_line(std::string_view written) {
  constexpr std::string_view controls = "\n\r\t";
  constexpr std::string_view control_letters = "nrt";
  std::string text;
  for (const char character : quoted(written)) {
    const std::size_t control = controls.find(character);
    if (control == std::string_view::npos) {
      text += character;
    } else {
      text.append(1, '\\').append(1, control_letters[control]);
    }
  }
  return text;
}

/// Prints terms of one source. Depth is bounded by SourceLimits::nesting.
class Printer {
 public:
  Printer(const Ontology& source, const ShortName& short_name, PrintStyle style)
      : source_(source), short_name_(short_name), style_(style) {}

  std::string term(TermId id);
  std::string axiom(const Axiom& axiom);

 private:
  /// Terms may share their parts, so that a few lines of a file can mean a text without end.
  [[nodiscard]] bool is_cut() const { return style_ == PrintStyle::reading && printed_ > max_printed_terms; }
  std::string nested(TermId id);
  std::string joined(std::span<const TermId> terms, std::string_view between);
  std::string literal(const Term& literal);
  /// And, or, not, and enumerations.
  std::string combination(const Term& term);
  std::string restriction(const Term& term, std::string_view word);
  std::string facet(const Term& term);
  std::string listed(const Axiom& axiom, std::string_view pair_word);
  std::string atoms(std::span<const TermId> atoms);
  std::string atom(const Term& atom);
  std::string applied(std::string predicate, std::span<const TermId> arguments);
  std::string variable(std::string_view iri);
  std::string rule_argument(TermId id);

  const Ontology& source_;
  const ShortName& short_name_;
  PrintStyle style_;
  std::size_t printed_ = 0;  ///< terms
};

std::string Printer::nested(TermId id) {
  const Term inner = source_.term(id);
  const bool is_bare = inner.arguments.empty() || inner.kind == TermKind::literal ||
                       inner.kind == TermKind::object_one_of || inner.kind == TermKind::data_one_of ||
                       inner.kind == TermKind::object_inverse_of || inner.kind == TermKind::datatype_restriction ||
                       inner.kind == TermKind::facet;
  return is_bare ? term(id) : "(" + term(id) + ")";
}

std::string Printer::joined(std::span<const TermId> terms, std::string_view between) {
  std::string text;
  for (const TermId id : terms) {
    if (!text.empty()) text += between;
    text += nested(id);
    if (is_cut()) break;
  }
  return text;
}

std::string Printer::literal(const Term& term) {
  std::string text =
      style_ == PrintStyle::reading ? quoted_on_one_line(source_.name(term.name)) : quoted(source_.name(term.name));
  if (term.arguments.size() == 2) return text + "@" + std::string(source_.name_of(term.arguments[1]));
  const std::string_view datatype = source_.name_of(term.arguments[0]);
  if (datatype == "http://www.w3.org/2001/XMLSchema#string") return text;
  return text + "^^" + short_name_(datatype);
}

std::string Printer::facet(const Term& term) {
  const auto* const found =
      std::ranges::find(facets, source_.name(term.name), &std::pair<std::string_view, std::string_view>::first);
  const std::string word = found == facets.end() ? short_name_(source_.name(term.name)) : std::string(found->second);
  return word + " " + nested(term.arguments[0]);
}

std::string Printer::term(TermId id) {
  const Term term = source_.term(id);
  ++printed_;
  if (is_cut()) return "...";
  if (const std::string_view word = word_of_restriction(term.kind); !word.empty()) return restriction(term, word);
  switch (term.kind) {
    case TermKind::named_class:
    case TermKind::object_property:
    case TermKind::data_property:
    case TermKind::annotation_property:
    case TermKind::datatype:
    case TermKind::individual:
      return short_name_(source_.name(term.name));
    case TermKind::anonymous_individual:
      if (style_ == PrintStyle::document) return short_name_(source_.name(term.name));
      [[fallthrough]];
    case TermKind::language_tag:
      return std::string(source_.name(term.name));
    case TermKind::literal:
      return literal(term);
    case TermKind::object_inverse_of:
      return "inverse " + nested(term.arguments[0]);
    case TermKind::object_property_chain:
      return joined(term.arguments, " o ");
    case TermKind::datatype_restriction:
      return nested(term.arguments[0]) + "[" + joined(term.arguments.subspan(1), ", ") + "]";
    case TermKind::facet:
      return facet(term);
    case TermKind::variable:
      return variable(source_.name(term.name));
    case TermKind::atom_list:
      return atoms(term.arguments);
    default:
      return term.kind < TermKind::variable ? combination(term) : atom(term);
  }
}

std::string Printer::combination(const Term& term) {
  const auto arguments = term.arguments;
  switch (term.kind) {
    case TermKind::object_intersection_of:
      return arguments.empty() ? short_name_(owl_thing) : joined(arguments, " and ");
    case TermKind::object_union_of:
      return arguments.empty() ? short_name_(owl_nothing) : joined(arguments, " or ");
    case TermKind::data_intersection_of:
      return arguments.empty() ? short_name_(every_value) : joined(arguments, " and ");
    case TermKind::data_union_of:
      return arguments.empty() ? "not " + short_name_(every_value) : joined(arguments, " or ");
    case TermKind::object_complement_of:
    case TermKind::data_complement_of:
      return "not " + nested(arguments[0]);
    default:  // an enumeration
      if (arguments.empty() && style_ == PrintStyle::document)
        return term.kind == TermKind::object_one_of ? short_name_(owl_nothing) : "not " + short_name_(every_value);
      return "{" + joined(arguments, ", ") + "}";
  }
}

std::string Printer::restriction(const Term& term, std::string_view word) {
  // Part by part: if there is not room for everything, the beginning is printed.
  std::string text = nested(term.arguments[0]).append(" ").append(word);
  if (is_cardinality(term.kind)) text.append(" ").append(std::to_string(term.number));
  if (term.arguments.size() == 2) text.append(" ").append(nested(term.arguments[1]));
  return text;
}

/// A document names a variable so that it is read as the same one again.
std::string Printer::variable(std::string_view iri) {
  if (style_ == PrintStyle::reading) return variable_name(iri);
  const bool is_short = iri.starts_with(swrl_variables) && is_plain_local_name(iri.substr(swrl_variables.size()));
  return is_short ? variable_name(iri) : "?<" + std::string(iri) + ">";
}

std::string Printer::rule_argument(TermId id) {
  if (style_ == PrintStyle::document) return term(id);
  const Term value = source_.term(id);
  const bool is_number = value.kind == TermKind::literal && value.arguments.size() == 1 &&
                         source_.name_of(value.arguments[0]) == "http://www.w3.org/2001/XMLSchema#integer" &&
                         source_.is_well_typed(id);
  return is_number ? std::string(source_.name(value.name)) : term(id);
}

std::string Printer::applied(std::string predicate, std::span<const TermId> arguments) {
  predicate += '(';
  for (std::size_t at = 0; at < arguments.size() && !is_cut(); ++at) {
    if (at > 0) predicate += ", ";
    predicate += rule_argument(arguments[at]);
  }
  return predicate += ')';
}

std::string Printer::atoms(std::span<const TermId> atoms) {
  std::string text;
  for (const TermId atom : atoms) {
    if (!text.empty()) text += ", ";
    text += term(atom);
    if (is_cut()) break;
  }
  return text;
}

std::string Printer::atom(const Term& atom) {
  const auto arguments = atom.arguments;
  const auto between = [&](std::string_view word) {
    std::string text = rule_argument(arguments[0]).append(" ").append(word).append(" ");
    return text += rule_argument(arguments[1]);
  };
  switch (atom.kind) {
    case TermKind::same_individual_atom:
      return style_ == PrintStyle::document ? applied("SameAs", arguments) : between("=");
    case TermKind::different_individuals_atom:
      return style_ == PrintStyle::document ? applied("DifferentFrom", arguments) : between("!=");
    case TermKind::built_in_atom: {
      const std::string_view iri = source_.name(atom.name);
      if (style_ == PrintStyle::document) return applied(short_name_(iri), arguments);
      const bool is_of_swrl = iri.starts_with(swrl_built_ins);
      const std::string_view word = is_of_swrl ? iri.substr(swrl_built_ins.size()) : std::string_view();
      const auto* const found =
          std::ranges::find(comparisons, word, &std::pair<std::string_view, std::string_view>::first);
      if (found != comparisons.end() && arguments.size() == 2) return between(found->second);
      return applied(is_of_swrl ? "swrlb:" + std::string(word) : short_name_(iri), arguments);
    }
    default:
      return applied(nested(arguments[0]), arguments.subspan(1));
  }
}

std::string Printer::listed(const Axiom& axiom, std::string_view pair_word) {
  if (axiom.arguments.size() == 2) {
    return nested(axiom.arguments[0]) + " " + std::string(pair_word) + " " + nested(axiom.arguments[1]);
  }
  return std::string(to_string(axiom.kind)) + ": " + joined(axiom.arguments, ", ");
}

std::string Printer::axiom(const Axiom& axiom) {
  const auto arguments = axiom.arguments;
  const auto between = [&](std::string_view word) {
    std::string text = term(arguments[0]).append(" ").append(word).append(" ");
    return text += term(arguments[1]);
  };
  switch (axiom.kind) {
    case AxiomKind::sub_class_of:
      return between("SubClassOf");
    case AxiomKind::equivalent_classes:
      return arguments.size() == 2 ? between("EquivalentTo") : listed(axiom, "");
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties:
      return listed(axiom, "EquivalentTo");
    case AxiomKind::disjoint_classes:
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::disjoint_data_properties:
      return listed(axiom, "DisjointWith");
    case AxiomKind::disjoint_union:
      return term(arguments[0]) + " DisjointUnionOf " + joined(arguments.subspan(1), ", ");
    case AxiomKind::sub_object_property_of:
    case AxiomKind::sub_data_property_of:
      return between("SubPropertyOf");
    case AxiomKind::inverse_object_properties:
      return between("InverseOf");
    case AxiomKind::object_property_domain:
    case AxiomKind::data_property_domain:
      return between("Domain");
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_range:
      return between("Range");
    case AxiomKind::datatype_definition:
      return between("EquivalentTo");
    case AxiomKind::has_key:
      return term(arguments[0]) + " HasKey " + joined(arguments.subspan(1), ", ");
    case AxiomKind::same_individual:
      return listed(axiom, "SameAs");
    case AxiomKind::different_individuals:
      return listed(axiom, "DifferentFrom");
    case AxiomKind::dl_safe_rule: {
      std::string text = term(arguments[0]);
      text += text.empty() ? "-> " : " -> ";
      return text += term(arguments[1]);
    }
    case AxiomKind::class_assertion:
      return term(arguments[1]) + " Type " + term(arguments[0]);
    case AxiomKind::object_property_assertion:
    case AxiomKind::data_property_assertion:
      return term(arguments[1]) + " Fact " + term(arguments[0]) + " " + term(arguments[2]);
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion:
      return term(arguments[1]) + " Fact not " + term(arguments[0]) + " " + term(arguments[2]);
    default:
      return std::string(to_string(axiom.kind)) + ": " + joined(arguments, ", ");
  }
}

}  // namespace

bool is_plain_local_name(std::string_view name) {
  const auto is_plain = [](char c) {
    const auto octet = static_cast<unsigned char>(c);
    return octet >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  return !name.empty() && name.front() != '.' && name.front() != '-' && name.back() != '.' &&
         std::ranges::all_of(name, is_plain);
}

std::string print(const Ontology& source, TermId term, const ShortName& short_name, PrintStyle style) {
  return Printer(source, short_name, style).term(term);
}

std::string print(const Ontology& source, const Axiom& axiom, const ShortName& short_name) {
  return Printer(source, short_name, PrintStyle::reading).axiom(axiom);
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') result += '\\';
    result += character;
  }
  return result += '"';
}

std::string shorten(std::string_view iri, std::span<const std::pair<std::string_view, std::string_view>> prefixes) {
  const std::pair<std::string_view, std::string_view>* best = nullptr;
  for (std::size_t at = 0; at < prefixes.size(); ++at) {
    const auto& prefix = prefixes[at];
    if (prefix.second.empty() || !iri.starts_with(prefix.second)) continue;
    const bool is_shared = (at > 0 && prefixes[at - 1].first == prefix.first) ||
                           (at + 1 < prefixes.size() && prefixes[at + 1].first == prefix.first);
    if (is_shared) continue;
    if (!is_plain_local_name(iri.substr(prefix.second.size()))) continue;
    // A named prefix is preferred to the empty one, which means something else in every file.
    const bool is_better = best == nullptr || prefix.second.size() > best->second.size() ||
                           (prefix.second.size() == best->second.size() && best->first.empty());
    if (is_better) best = &prefix;
  }
  if (best == nullptr) return "<" + std::string(iri) + ">";
  std::string name;
  name.reserve(best->first.size() + 1 + iri.size() - best->second.size());
  return name.append(best->first).append(":").append(iri.substr(best->second.size()));
}

}  // namespace geminga::owl
