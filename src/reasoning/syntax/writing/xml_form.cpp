#include "reasoning/syntax/writing/xml_form.hpp"

#include <array>

namespace geminga::writing {
namespace {

/// Deeper elements are not indented further.
constexpr std::size_t max_indented = 32;

}  // namespace

void XmlForm::begin(const Document& document) {
  output_.add("<?xml version=\"1.0\"?>\n<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\"");
  if (!document.iri.empty()) {
    attribute("xml:base", document.iri);
    attribute("ontologyIRI", document.iri);
    if (!document.version_iri.empty()) attribute("versionIRI", document.version_iri);
  }
  output_.add(">\n");
  for (const auto& [prefix, iri] : names_.prefixes()) {
    output_.add("    <Prefix");
    attribute("name", prefix);
    attribute("IRI", iri);
    output_.add("/>\n");
  }
  for (const std::string& import : document.imports) {
    output_.add("    <Import>");
    escaped(import, false);
    output_.add("</Import>\n");
  }
}

void XmlForm::end() { output_.add("</Ontology>\n"); }

void XmlForm::indent() {
  for (std::size_t level = 0; level < depth_ && level < max_indented; ++level) output_.add("    ");
}

void XmlForm::open(std::string_view word, std::optional<std::uint32_t> number) {
  indent();
  output_.add({"<", word});
  if (number) attribute("cardinality", std::to_string(*number));
  output_.add(">\n");
  ++depth_;
}

void XmlForm::close(std::string_view word) {
  --depth_;
  indent();
  output_.add({"</", word, ">\n"});
}

void XmlForm::open_facet(std::string_view iri) {
  indent();
  output_.add("<FacetRestriction");
  attribute("facet", iri);
  output_.add(">\n");
  ++depth_;
}

void XmlForm::entity(owl::TermKind kind, std::string_view iri) {
  indent();
  output_.add({"<", owl::to_string(kind)});
  named(iri);
  output_.add("/>\n");
}

void XmlForm::named(std::string_view iri) {
  if (!is_writable(iri)) return output_.fail(unwritable(iri));
  const std::string written = names_.written(iri);
  if (written.starts_with('<')) {
    attribute("IRI", iri);
  } else {
    attribute("abbreviatedIRI", written);
  }
}

void XmlForm::variable(std::string_view iri) {
  indent();
  output_.add("<Variable");
  named(iri);
  output_.add("/>\n");
}

void XmlForm::open_built_in(std::string_view iri) {
  indent();
  output_.add("<BuiltInAtom");
  named(iri);
  output_.add(">\n");
  ++depth_;
}

void XmlForm::name(std::string_view iri) {
  if (!is_writable(iri)) return output_.fail(unwritable(iri));
  indent();
  output_.add("<IRI>");
  escaped(iri, false);
  output_.add("</IRI>\n");
}

void XmlForm::blank(std::string_view name) {
  indent();
  output_.add("<AnonymousIndividual");
  attribute("nodeID", Names::blank(name));
  output_.add("/>\n");
}

void XmlForm::literal(std::string_view lexical, std::string_view datatype, std::string_view language) {
  indent();
  output_.add("<Literal");
  if (!language.empty()) {
    attribute("xml:lang", language);
  } else if (!datatype.empty() && datatype != "http://www.w3.org/2001/XMLSchema#string") {
    attribute("datatypeIRI", datatype);
  }
  output_.add(">");
  escaped(lexical, false);
  output_.add("</Literal>\n");
}

void XmlForm::attribute(std::string_view name, std::string_view value) {
  output_.add({" ", name, "=\""});
  escaped(value, true);
  output_.add("\"");
}

/// White space in attributes, and a carriage return anywhere, would be read as something else (XML 1.0, sections 2.11
/// and 3.3.3). Other control characters cannot be in XML at all (section 2.2).
void XmlForm::escaped(std::string_view text, bool is_attribute) {
  struct Escape {
    char character;
    std::string_view written;
    bool is_always;
  };
  static constexpr std::array<Escape, 7> escapes{{{'&', "&amp;", true},
                                                  {'<', "&lt;", true},
                                                  {'>', "&gt;", true},
                                                  {'"', "&quot;", false},
                                                  {'\r', "&#13;", true},
                                                  {'\n', "&#10;", false},
                                                  {'\t', "&#9;", false}}};
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    for (const Escape& escape : escapes) {
      if (c != escape.character || (!escape.is_always && !is_attribute)) continue;
      output_.add({text.substr(begin, at - begin), escape.written});
      begin = at + 1;
    }
    if (static_cast<unsigned char>(c) < 0x20 && c != '\r' && c != '\n' && c != '\t')
      return output_.fail("a text has the control character " + std::to_string(static_cast<int>(c)) +
                          ", which no XML can have: write another syntax");
  }
  output_.add(text.substr(begin));
}

}  // namespace geminga::writing
