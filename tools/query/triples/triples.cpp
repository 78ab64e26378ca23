#include "query/triples/triples.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/harmless.hpp"

namespace geminga::query {
namespace {

constexpr std::string_view rdf_type = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
constexpr std::string_view xml_schema = "http://www.w3.org/2001/XMLSchema#";
constexpr std::string_view hexadecimal = "0123456789ABCDEF";

/// RDF 1.1 N-Triples, IRIREF.
bool is_forbidden_in_iri(char c) {
  return static_cast<unsigned char>(c) <= 0x20 || c == 0x7f ||
         std::string_view("<>\"{}|^`\\").find(c) != std::string_view::npos;
}

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)); });
}

bool is_decimal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const auto point = text.find('.');
  const auto are_digits = [](std::string_view digits) {
    return !digits.empty() && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (point == std::string_view::npos) return are_digits(text);
  return are_digits(text.substr(0, point)) && are_digits(text.substr(point + 1));
}

}  // namespace

std::string iri_node(std::string_view iri) {
  std::string node = "<";
  for (const char c : base::harmless(iri)) {
    if (is_forbidden_in_iri(c)) {
      const auto octet = static_cast<unsigned char>(c);
      node += {'%', hexadecimal[octet >> 4U], hexadecimal[octet & 15U]};
    } else {
      node += c;
    }
  }
  return node + '>';
}

std::string literal_node(std::string_view text) {
  std::string node = "\"";
  for (const char c : text) {
    const auto octet = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      node += {'\\', c};
    } else if (octet < 0x20 || octet == 0x7f) {
      node += "\\u00";
      node += {hexadecimal[octet >> 4U], hexadecimal[octet & 15U]};
    } else {
      node += c;
    }
  }
  return base::harmless_json(node + '"');
}

std::string literal_node(std::string_view text, std::string_view datatype) {
  return literal_node(text) + "^^" + iri_node(std::string(xml_schema) + std::string(datatype));
}

std::string value_node(std::string_view text) {
  return is_decimal(text) ? literal_node(text, "decimal") : literal_node(text);
}

Triples::Triples(TripleSyntax syntax) : syntax_(syntax) {
  if (syntax_ == TripleSyntax::turtle) text_ = "@prefix geminga: <" + std::string(core_namespace) + "> .\n";
}

std::string Triples::predicate_node(std::string_view predicate) const {
  if (syntax_ == TripleSyntax::n_triples) return iri_node(predicate);
  if (predicate == rdf_type) return "a";
  const bool is_ours = predicate.starts_with(core_namespace) && is_word(predicate.substr(core_namespace.size()));
  return is_ours ? "geminga:" + std::string(predicate.substr(core_namespace.size())) : iri_node(predicate);
}

void Triples::add_nodes(const std::string& subject, std::string_view predicate, std::string_view object) {
  const bool goes_on = syntax_ == TripleSyntax::turtle && subject == subject_;
  if (goes_on) {
    text_ += " ;\n    ";
  } else {
    if (!subject_.empty()) text_ += " .\n";
    if (syntax_ == TripleSyntax::turtle) subject_ = subject;
    text_ += (syntax_ == TripleSyntax::turtle ? "\n" : "") + subject + ' ';
  }
  text_ += predicate_node(predicate) + ' ';
  text_ += object;
  if (syntax_ == TripleSyntax::n_triples) text_ += " .\n";
}

void Triples::add_type(std::string_view subject, std::string_view class_iri) {
  add(subject, rdf_type, iri_node(class_iri));
}

std::string Triples::finish() && {
  if (!subject_.empty()) text_ += " .\n";
  return std::move(text_);
}

}  // namespace geminga::query
