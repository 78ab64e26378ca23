// The head of a document in one of OWL's own syntaxes: its prefixes and imports.
#ifndef GEMINGA_REASONING_SYNTAX_DOCUMENT_HEAD_HPP
#define GEMINGA_REASONING_SYNTAX_DOCUMENT_HEAD_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "reasoning/owl/document.hpp"

namespace geminga::document {

/// The remark about a backslash in a text before something else than a quotation mark or a backslash.
inline constexpr std::string_view odd_backslash = "a backslash in a text that escapes nothing, read as itself";

/// Notes what the head of one document declares, each prefix and import once. A function that returns a text refuses
/// the document for that reason.
class Head {
 public:
  /// Every document knows the prefixes owl, rdf, rdfs and xsd (OWL 2, table 2).
  Head(std::size_t max_prefixes, std::size_t max_imports);

  /// Refuses a prefix that has another meaning already.
  [[nodiscard]] std::optional<std::string> declare(std::string_view prefix, std::string_view iri,
                                                   owl::Document& document);
  /// Gives a prefix that is known another meaning, from here on.
  void change(std::string_view prefix, std::string_view iri, owl::Document& document);
  [[nodiscard]] std::optional<std::string> import(std::string_view iri, std::uint32_t line, owl::Document& document);

  /// The IRI of a prefix without its colon; nullptr: it is not declared. Valid as long as the head.
  [[nodiscard]] const std::string* iri_of(std::string_view prefix) const;
  /// Why a name with an undeclared prefix is refused.
  [[nodiscard]] static std::string undeclared(std::string_view prefix);

 private:
  struct Prefix {
    std::string iri;
    bool is_declared = false;  ///< by this document
  };

  std::size_t max_prefixes_;
  std::size_t max_imports_;
  std::map<std::string, Prefix, std::less<>> prefixes_;
  std::set<std::string, std::less<>> imported_;
};

}  // namespace geminga::document

#endif
