#include "reasoning/syntax/graph/literals.hpp"

#include <algorithm>

namespace geminga::graph {
namespace {

struct FreeLiteral {
  void operator()(rasqal_literal* literal) const { rasqal_free_literal(literal); }
};

/// A copy that rasqal frees; null if memory is short.
unsigned char* copy_of(const unsigned char* text, std::size_t size) {
  auto* copy = static_cast<unsigned char*>(rasqal_alloc_memory(size + 1));
  if (copy == nullptr) return nullptr;
  if (size > 0) std::copy_n(text, size, copy);
  copy[size] = 0;
  return copy;
}

}  // namespace

OwnedTerm term_of(World& world, rasqal_literal* literal) {
  if (literal == nullptr || literal->type == RASQAL_LITERAL_VARIABLE) return nullptr;
  const std::unique_ptr<rasqal_literal, FreeLiteral> node(rasqal_literal_as_node(literal));
  if (node == nullptr) return nullptr;
  raptor_world* raptor = world.raptor();
  if (node->type == RASQAL_LITERAL_URI) return OwnedTerm(raptor_new_term_from_uri(raptor, node->value.uri));
  if (node->type == RASQAL_LITERAL_BLANK) return OwnedTerm(raptor_new_term_from_blank(raptor, node->string));
  const auto* language = reinterpret_cast<const unsigned char*>(node->language);
  const bool has_language = language != nullptr && *language != 0;
  return OwnedTerm(raptor_new_term_from_literal(raptor, node->string, has_language ? nullptr : node->datatype,
                                                has_language ? language : nullptr));
}

rasqal_literal* literal_of(World& world, const raptor_term& term) {
  rasqal_world* rasqal = world.rasqal();
  switch (term.type) {
    case RAPTOR_TERM_TYPE_URI:
      return rasqal_new_uri_literal(rasqal, raptor_uri_copy(term.value.uri));
    case RAPTOR_TERM_TYPE_BLANK: {
      unsigned char* label = copy_of(term.value.blank.string, term.value.blank.string_len);
      return label == nullptr ? nullptr : rasqal_new_simple_literal(rasqal, RASQAL_LITERAL_BLANK, label);
    }
    case RAPTOR_TERM_TYPE_LITERAL: {
      const raptor_term_literal_value& value = term.value.literal;
      unsigned char* text = copy_of(value.string, value.string_len);
      if (text == nullptr) return nullptr;
      const bool has_language = value.language != nullptr && value.language_len > 0;
      auto* language = has_language ? reinterpret_cast<char*>(copy_of(value.language, value.language_len)) : nullptr;
      raptor_uri* datatype = value.datatype == nullptr ? nullptr : raptor_uri_copy(value.datatype);
      return rasqal_new_string_literal(rasqal, text, language, datatype, nullptr);
    }
    default:
      return nullptr;
  }
}

std::string_view blank_name(const rasqal_literal* literal) {
  if (literal == nullptr) return {};
  if (literal->type == RASQAL_LITERAL_BLANK) return reinterpret_cast<const char*>(literal->string);
  if (literal->type != RASQAL_LITERAL_VARIABLE || literal->value.variable->type != RASQAL_VARIABLE_TYPE_ANONYMOUS)
    return {};
  return reinterpret_cast<const char*>(literal->value.variable->name);
}

std::string_view iri_of(const rasqal_literal* literal) {
  if (literal == nullptr || literal->type != RASQAL_LITERAL_URI) return {};
  return reinterpret_cast<const char*>(raptor_uri_as_string(literal->value.uri));
}

}  // namespace geminga::graph
