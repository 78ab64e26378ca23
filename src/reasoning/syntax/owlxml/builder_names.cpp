// IRIs in their three forms, entities, blank nodes, literals and facets.

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/blank_prefix.hpp"
#include "reasoning/owl/plain_literal.hpp"
#include "reasoning/syntax/owlxml/builder.hpp"

namespace geminga::owlxml {
namespace {

/// A scheme and a colon (RFC 3986, section 3.1).
bool is_absolute(std::string_view iri) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const std::size_t colon = iri.find(':');
  if (colon == 0 || colon == std::string_view::npos || !is_letter(iri.front())) return false;
  return std::ranges::all_of(iri.substr(0, colon), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  });
}

}  // namespace

Listener::Refusal Builder::check_iri(std::string_view iri) {
  if (iri.size() > limits_.iri_bytes)
    return beyond_limit("an IRI of more than " + std::to_string(limits_.iri_bytes) + " bytes");
  // The characters that would make the identity of a concept ambiguous. Others stand in published files.
  const auto is_forbidden = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '<' || c == '>';
  };
  if (std::ranges::any_of(iri, is_forbidden)) return "an IRI with an angle bracket or a control character";
  return std::nullopt;
}

// The base and the reference are put together as they are, which is what the OWL API writes and reads, and not as RFC
// 3986 has it (OWLXML.md).
Listener::Refusal Builder::full_iri(std::string_view written, std::string& iri) {
  iri.clear();
  if (!is_absolute(written) && !bases_.empty()) iri = bases_.back();
  iri += written;
  return check_iri(iri);
}

Listener::Refusal Builder::short_iri(std::string_view written, std::string& iri) {
  // A name without a colon has the empty prefix.
  const std::size_t colon = written.find(':');
  const std::string_view prefix = colon == std::string_view::npos ? std::string_view() : written.substr(0, colon);
  const std::string* known = head_.iri_of(prefix);
  if (known == nullptr) return document::Head::undeclared(prefix);
  return full_iri(*known + std::string(written.substr(colon == std::string_view::npos ? 0 : colon + 1)), iri);
}

Listener::Refusal Builder::entity(const Open& open, std::span<const Attribute> attributes) {
  std::string iri;
  bool is_named = false;
  for (const Attribute& attribute : attributes) {
    if (!attribute.space.empty()) continue;
    const bool is_full = attribute.name == "IRI";
    if (!is_full && attribute.name != "abbreviatedIRI") continue;
    if (auto refusal = is_full ? full_iri(attribute.value, iri) : short_iri(attribute.value, iri)) return refusal;
    is_named = true;
  }
  if (!is_named) return "expected the IRI of <" + std::string(open.production->word) + '>';
  if (open.is_annotation) {
    operands_.push_back({Operand::Kind::iri, {}, std::move(iri), {}, {}, {}});
  } else {
    operands_.push_back({Operand::Kind::term, source_.entity(open.production->term(), iri), {}, {}, {}, {}});
  }
  return std::nullopt;
}

Listener::Refusal Builder::named_part(Open& open, std::span<const Attribute> attributes) {
  for (const Attribute& attribute : attributes) {
    if (!attribute.space.empty()) continue;
    if (attribute.name == "IRI") return full_iri(attribute.value, open.name);
    if (attribute.name == "abbreviatedIRI") return short_iri(attribute.value, open.name);
  }
  return "expected the IRI of <" + std::string(open.production->word) + '>';
}

Listener::Refusal Builder::blank(const Open& open, std::span<const Attribute> attributes) {
  std::string_view label;
  for (const Attribute& attribute : attributes) {
    if (attribute.space.empty() && attribute.name == "nodeID") label = attribute.value;
  }
  if (label.starts_with("_:")) label.remove_prefix(2);
  if (label.empty()) return "expected the nodeID of <AnonymousIndividual>";
  if (auto refusal = check_iri(label)) return refusal;
  if (blank_prefix_.empty()) blank_prefix_ = owl::blank_prefix_of(bytes_);
  std::string name = blank_prefix_ + std::string(label);
  if (open.is_annotation) {
    operands_.push_back({Operand::Kind::iri, {}, std::move(name), {}, {}, {}});
  } else {
    operands_.push_back({Operand::Kind::term, source_.anonymous_individual(name), {}, {}, {}, {}});
  }
  return std::nullopt;
}

Listener::Refusal Builder::end_literal(const Open& open) {
  if (operands_.size() != open.first) return "an element within <Literal>";
  std::string language = base::in_lower_case(literal_language_);
  // OWL tools write this datatype beside a language, too.
  if (literal_datatype_ == owl::plain_literal_datatype) {
    literal_datatype_.clear();
    if (language.empty()) {
      auto plain = owl::split_plain_literal(text_);
      language = std::move(plain.language);
      text_.resize(plain.text.size());
    }
  }
  if (!language.empty()) literal_datatype_.clear();
  if (open.is_annotation) {
    operands_.push_back({Operand::Kind::text, {}, {}, text_, std::move(language), literal_datatype_});
  } else {
    operands_.push_back({Operand::Kind::term, source_.literal(text_, literal_datatype_, language), {}, {}, {}, {}});
  }
  return std::nullopt;
}

Listener::Refusal Builder::end_facet(const Open& open) {
  const bool is_one = operands_.size() == open.first + 1 && operands_.back().kind == Operand::Kind::term &&
                      source_.kind(operands_.back().term) == owl::TermKind::literal;
  if (!is_one) return "expected one <Literal> in <FacetRestriction>";
  operands_.back().term = source_.facet(facet_iri_, operands_.back().term);
  return std::nullopt;
}

Listener::Refusal Builder::end_iri(const Open& open) {
  if (!open.is_annotation) return "an <IRI> outside of annotations";
  if (operands_.size() != open.first) return "an element within <IRI>";
  const std::string_view written = base::trimmed(text_);
  Operand operand{Operand::Kind::iri, {}, {}, {}, {}, {}};
  const bool is_full = open.role == Role::iri;
  if (auto refusal = is_full ? full_iri(written, operand.iri) : short_iri(written, operand.iri)) return refusal;
  operands_.push_back(std::move(operand));
  return std::nullopt;
}

}  // namespace geminga::owlxml
