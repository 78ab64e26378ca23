#include "reasoning/syntax/graph/terms/statements.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace geminga::graph {
namespace {

bool is_less(const raptor_statement* a, const raptor_statement* b) { return raptor_statement_compare(a, b) < 0; }
bool is_equal(const raptor_statement* a, const raptor_statement* b) { return raptor_statement_compare(a, b) == 0; }

std::string text_of(const unsigned char* text, std::size_t size) {
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text), size);
}

std::string text_of(raptor_uri* uri) {
  std::size_t size = 0;
  const unsigned char* text = raptor_uri_as_counted_string(uri, &size);
  return text_of(text, size);
}

}  // namespace

Statements::~Statements() {
  for (raptor_statement* statement : all_) raptor_free_statement(statement);
}

raptor_term* new_term(World& world, const Node& node) {
  raptor_world* raptor = world.raptor();
  const unsigned char* text = octets(node.text);
  switch (node.kind) {
    case Node::Kind::iri:
      return raptor_new_term_from_counted_uri_string(raptor, text, node.text.size());
    case Node::Kind::blank:
      return raptor_new_term_from_counted_blank(raptor, text, node.text.size());
    case Node::Kind::literal:
      break;
  }
  if (node.language.size() > std::numeric_limits<unsigned char>::max()) return nullptr;
  const bool is_plain = node.datatype.empty() || node.datatype == xsd_string || !node.language.empty();
  raptor_uri* datatype =
      is_plain ? nullptr : raptor_new_uri_from_counted_string(raptor, octets(node.datatype), node.datatype.size());
  raptor_term* term = raptor_new_term_from_counted_literal(raptor, text, node.text.size(), datatype,
                                                           node.language.empty() ? nullptr : octets(node.language),
                                                           static_cast<unsigned char>(node.language.size()));
  if (datatype != nullptr) raptor_free_uri(datatype);
  return term;
}

bool Statements::add(const Node& subject, const Node& predicate, const Node& object) {
  raptor_term* s = new_term(world_, subject);
  raptor_term* p = new_term(world_, predicate);
  raptor_term* o = new_term(world_, object);
  if (s == nullptr || p == nullptr || o == nullptr) {
    for (raptor_term* term : {s, p, o}) {
      if (term != nullptr) raptor_free_term(term);
    }
    return false;
  }
  raptor_statement* statement = raptor_new_statement_from_nodes(world_.raptor(), s, p, o, nullptr);
  if (statement == nullptr) return false;
  all_.push_back(statement);
  return true;
}

bool Statements::add_copy(const raptor_statement* statement) {
  // The parser reuses its statement for the next triple. Terms have counts of references.
  const auto copy = [&](raptor_term* term) {
    const bool is_text = term->type == RAPTOR_TERM_TYPE_LITERAL && term->value.literal.datatype != nullptr &&
                         text_of(term->value.literal.datatype) == xsd_string;
    return is_text ? new_term(world_, node_of(*term)) : raptor_term_copy(term);
  };
  raptor_statement* kept = raptor_new_statement_from_nodes(
      world_.raptor(), copy(statement->subject), copy(statement->predicate), copy(statement->object), nullptr);
  if (kept == nullptr) return false;
  all_.push_back(kept);
  return true;
}

void Statements::sort() {
  std::ranges::sort(all_, is_less);
  std::vector<raptor_statement*> once;
  for (raptor_statement* statement : all_) {
    if (!once.empty() && is_equal(once.back(), statement)) {
      raptor_free_statement(statement);
    } else {
      once.push_back(statement);
    }
  }
  all_ = std::move(once);
}

void Statements::remove(const Statements& others) {
  std::erase_if(all_, [&](raptor_statement* statement) {
    const bool is_there = std::ranges::binary_search(others.all_, statement, is_less);
    if (is_there) raptor_free_statement(statement);
    return is_there;
  });
}

void Statements::for_each(const TripleSink& sink) const {
  for (const raptor_statement* statement : all_)
    sink(node_of(*statement->subject), node_of(*statement->predicate), node_of(*statement->object));
}

std::size_t octets_of(const raptor_term& term) {
  std::size_t size = 0;
  switch (term.type) {
    case RAPTOR_TERM_TYPE_URI:
      (void)raptor_uri_as_counted_string(term.value.uri, &size);
      break;
    case RAPTOR_TERM_TYPE_BLANK:
      size = term.value.blank.string_len;
      break;
    case RAPTOR_TERM_TYPE_LITERAL:
      size = term.value.literal.string_len;
      break;
    default:
      break;
  }
  return size;
}

Node node_of(const raptor_term& term) {
  switch (term.type) {
    case RAPTOR_TERM_TYPE_URI:
      return iri(text_of(term.value.uri));
    case RAPTOR_TERM_TYPE_BLANK:
      return blank(text_of(term.value.blank.string, term.value.blank.string_len));
    case RAPTOR_TERM_TYPE_LITERAL: {
      const raptor_term_literal_value& literal = term.value.literal;
      return {Node::Kind::literal, text_of(literal.string, literal.string_len),
              literal.datatype == nullptr ? std::string() : text_of(literal.datatype),
              text_of(literal.language, literal.language_len)};
    }
    default:
      return {};
  }
}

}  // namespace geminga::graph
