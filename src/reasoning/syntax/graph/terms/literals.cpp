#include "reasoning/syntax/graph/terms/literals.hpp"

namespace geminga::graph {
namespace {

struct FreeLiteral {
  void operator()(rasqal_literal* literal) const { rasqal_free_literal(literal); }
};

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
