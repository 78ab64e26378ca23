#include "reasoning/syntax/document/head.hpp"

#include "base/text.hpp"

namespace geminga::document {
namespace {

constexpr std::size_t shown_bytes = 60;

}  // namespace

Head::Head(std::size_t max_prefixes, std::size_t max_imports) : max_prefixes_(max_prefixes), max_imports_(max_imports) {
  prefixes_["owl"].iri = "http://www.w3.org/2002/07/owl#";
  prefixes_["rdf"].iri = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
  prefixes_["rdfs"].iri = "http://www.w3.org/2000/01/rdf-schema#";
  prefixes_["xsd"].iri = "http://www.w3.org/2001/XMLSchema#";
}

std::optional<std::string> Head::declare(std::string_view prefix, std::string_view iri, owl::Document& document) {
  Prefix& known = prefixes_.try_emplace(std::string(prefix), Prefix{std::string(iri)}).first->second;
  if (known.iri != iri)
    return "the prefix " + base::printable(prefix, shown_bytes) + ": already stands for <" +
           base::printable(known.iri, shown_bytes) + '>';
  if (known.is_declared) return std::nullopt;
  if (document.prefixes.size() >= max_prefixes_) return "more than " + std::to_string(max_prefixes_) + " prefixes";
  known.is_declared = true;
  document.prefixes.push_back({std::string(prefix), std::string(iri)});
  return std::nullopt;
}

void Head::change(std::string_view prefix, std::string_view iri, owl::Document& document) {
  Prefix& known = prefixes_.find(prefix)->second;
  known.iri = iri;
  for (owl::DeclaredPrefix& declared : document.prefixes) {
    if (declared.prefix == prefix) declared.iri = iri;
  }
  if (!known.is_declared && document.prefixes.size() < max_prefixes_)
    document.prefixes.push_back({std::string(prefix), known.iri});
  known.is_declared = true;
}

std::optional<std::string> Head::import(std::string_view iri, std::uint32_t line, owl::Document& document) {
  if (!imported_.emplace(iri).second) return std::nullopt;
  if (document.imports.size() >= max_imports_) return "more than " + std::to_string(max_imports_) + " imports";
  document.imports.push_back({std::string(iri), line});
  return std::nullopt;
}

const std::string* Head::iri_of(std::string_view prefix) const {
  const auto found = prefixes_.find(prefix);
  return found == prefixes_.end() ? nullptr : &found->second.iri;
}

std::string Head::undeclared(std::string_view prefix) {
  return "the prefix " + base::printable(prefix, shown_bytes) + ": is not declared";
}

}  // namespace geminga::document
