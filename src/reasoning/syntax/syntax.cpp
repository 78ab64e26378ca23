// Looks at no more than the first words of a file.
#include "reasoning/syntax/syntax.hpp"

#include <algorithm>
#include <cctype>

#include "base/text.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::syntax {
namespace {

enum class Content {
  empty,
  xml,
  owl_xml,
  html,
  trix,
  json,
  obo,
  krss,
  turtle,
  other,
  functional,
  manchester,
  wide,
  packed
};

std::string not_read(std::string_view syntax) {
  return "is in " + std::string(syntax) + ", which is not read: convert it to RDF/XML or Turtle";
}

bool is_name_byte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// `<a> ` and `<a/> `, which may be a relative IRI of Turtle: RDF/XML has a namespace in its first tag.
bool is_bare_tag(std::string_view text) {
  const std::size_t end = text.find_first_of(" \t\r\n>");
  return text.starts_with('<') && !text.starts_with("<?") && !text.starts_with("<!") && end != std::string_view::npos &&
         text[end] == '>';
}

std::string_view without_comments(std::string_view text) {
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    if (!text.starts_with('#')) return text;
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end);
  }
}

/// `<rdf:RDF `, but not `<http://example.org/a> `, and not `<urn:a> `: an element with a prefix declares it.
bool is_xml_tag(std::string_view text) {
  if (!text.starts_with('<')) return false;
  const std::size_t end = text.find_first_of(" \t\r\n/>", 1);
  if (end == std::string_view::npos || end == 1 || (text[end] == '/' && text.substr(end, 2) != "/>")) return false;
  const std::string_view name = text.substr(1, end - 1);
  const auto colons = std::ranges::count(name, ':');
  return (colons == 0 || (colons == 1 && std::isspace(static_cast<unsigned char>(text[end])) != 0)) &&
         std::ranges::all_of(name, [](char c) { return c == ':' || is_name_byte(c); });
}

/// The tag of the first element behind declaration, comments and DOCTYPE, without its brackets. It suffices to tell
/// what is no RDF/XML.
std::string_view root_tag(std::string_view text) {
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = text.substr(at);
    std::size_t end = std::string_view::npos;
    if (rest.starts_with("<!--")) {
      end = rest.find("-->");
    } else if (rest.starts_with("<?")) {
      end = rest.find("?>");
    } else if (rest.starts_with("<!DOCTYPE")) {
      const std::size_t open = rest.find_first_of("[>");
      end = open != std::string_view::npos && rest[open] == '[' ? rest.find(']', open) : open;
    } else {
      return rest.substr(1, std::min(rest.find('>', 1), rest.size()) - 1);
    }
    if (end == std::string_view::npos) return {};
    at += end + 1;
  }
  return {};
}

bool starts_ignoring_case(std::string_view text, std::string_view lower) {
  return std::ranges::equal(text.substr(0, lower.size()), lower,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// UTF-16 or UTF-32: it begins with their mark, or has NULs between the octets of the first characters.
bool is_wide(std::string_view content) {
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff")) return true;
  return std::ranges::count(content.substr(0, 4), '\0') >= 2;
}

Content look_at_xml(std::string_view text) {
  const std::string_view tag = root_tag(text);
  const std::string_view name = tag.substr(0, std::min(tag.find_first_of(" \t\r\n/"), tag.size()));
  if (starts_ignoring_case(text, "<!doctype html") || (starts_ignoring_case(name, "html") && name.size() == 4))
    return Content::html;
  // RDF/XML may begin with <owl:Ontology, too, and then says rdf:about where OWL/XML says ontologyIRI.
  const bool has_iri = tag.find("ontologyIRI") != std::string_view::npos;
  const bool is_about = tag.find("rdf:about") != std::string_view::npos;
  if (name == "TriX") return Content::trix;
  if ((name == "Ontology" && !is_about) || (name.ends_with(":Ontology") && has_iri)) return Content::owl_xml;
  return Content::xml;
}

/// `{ "` or `{}`, which neither Turtle nor TriG begins with.
bool is_object(std::string_view text) {
  text = base::trimmed(text);
  if (!text.starts_with('{')) return false;
  text = base::trimmed(text.substr(1, 64));
  return text.empty() || text.starts_with('"') || text.starts_with('}');
}

/// A line `format-version: 1.2`, or another `tag: value` before the first stanza.
bool is_obo(std::string_view text) {
  if (text.starts_with("format-version:")) return true;
  constexpr std::size_t head_bytes = std::size_t{1} << 16;
  const std::size_t tag_end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-");
  const bool has_tag = tag_end != std::string_view::npos && text.substr(tag_end).starts_with(": ");
  const std::string_view head = text.substr(0, head_bytes);
  return (has_tag && head.find("\n[Term]") != std::string_view::npos) || text.starts_with("[Term]");
}

/// A directive, an IRI, a blank node, or a graph of TriG.
bool begins_turtle(std::string_view text) {
  for (const std::string_view directive : {"@prefix ", "@base ", "prefix ", "base ", "graph <", "graph _:"}) {
    if (starts_ignoring_case(text, directive)) return true;
  }
  if (text.starts_with('[') || text.starts_with('{')) return true;
  const std::size_t end = text.find_first_of(" \t\r\n");
  if (end == std::string_view::npos) return false;
  const std::string_view first = text.substr(0, end);
  return (first.starts_with('<') && first.ends_with('>')) || first.starts_with("_:");
}

Content look(std::string_view content) {
  if (is_gzip(content)) return Content::packed;
  if (is_wide(content)) return Content::wide;
  const std::string_view text = without_comments(base::without_mark(content));
  if (text.empty()) return Content::empty;
  if (text.starts_with("<?xml") || starts_ignoring_case(text, "<!doctype") || text.starts_with("<!--") ||
      is_xml_tag(text))
    return look_at_xml(text);
  if (is_object(text) || (text.starts_with('[') && is_object(text.substr(1)))) return Content::json;
  if (is_obo(text)) return Content::obo;
  if (text.starts_with("(define-") || text.starts_with("(in-tbox")) return Content::krss;
  if (text.starts_with("Prefix:") || text.starts_with("Ontology:")) return Content::manchester;
  for (const std::string_view word : {"Prefix", "Ontology"}) {
    if (text.starts_with(word) && without_comments(text.substr(word.size())).starts_with('('))
      return Content::functional;
  }
  return begins_turtle(text) ? Content::turtle : Content::other;
}

}  // namespace

std::string_view to_string(Syntax syntax) {
  switch (syntax) {
    case Syntax::rdf_xml:
      return "RDF/XML";
    case Syntax::turtle:
      return "Turtle";
    case Syntax::n_triples:
      return "N-Triples";
    case Syntax::functional:
      return "OWL functional syntax";
    case Syntax::manchester:
      return "OWL Manchester syntax";
    case Syntax::owl_xml:
      return "OWL/XML";
  }
  return {};
}

bool is_foreign_xml(std::string_view begin) {
  const Content found = look(begin);
  if (found == Content::html) return true;
  return found == Content::xml && begin.find(rdf_namespace) == std::string_view::npos &&
         begin.find("http://www.w3.org/2002/07/owl") == std::string_view::npos;
}

std::expected<Syntax, std::string> detect_syntax(std::string_view path, std::string_view content) {
  const std::string lower = base::in_lower_case(name_without_gz(path));
  path = lower;
  const Content found = look(content);
  switch (found) {
    case Content::packed:
      return std::unexpected("is packed twice by gzip: unpack it once");
    case Content::wide:
      return std::unexpected("is in UTF-16, which is not read: convert it to UTF-8");
    case Content::html:
      return std::unexpected("is an HTML page, not an ontology: download the ontology itself");
    case Content::functional:
      return Syntax::functional;
    case Content::json:
      return std::unexpected(not_read("JSON"));
    case Content::obo:
      return std::unexpected(not_read("OBO format"));
    case Content::krss:
      return std::unexpected(not_read("KRSS"));
    case Content::trix:
      return std::unexpected(not_read("TriX"));
    case Content::manchester:
      return Syntax::manchester;
    case Content::owl_xml:
      return Syntax::owl_xml;
    default:
      break;
  }
  const bool says_turtle = path.ends_with(".ttl") || path.ends_with(".trig");
  const bool says_triples = path.ends_with(".nt") || path.ends_with(".nq");
  if (says_turtle || says_triples) {
    const bool is_xml = found == Content::xml && !is_bare_tag(without_comments(base::without_mark(content)));
    if (is_xml) return std::unexpected("is XML by its content: name it .rdf or .owl");
    return says_turtle ? Syntax::turtle : Syntax::n_triples;
  }
  if (found == Content::xml) return Syntax::rdf_xml;
  if (found == Content::empty) return std::unexpected("is empty");
  const auto is_not = [](std::string_view syntax) {
    return std::unexpected("is not in " + std::string(syntax) + ": name it .ttl, .nt, .rdf or .owl, as it is");
  };
  if (path.ends_with(".ofn") || path.ends_with(".fss")) return is_not(to_string(Syntax::functional));
  if (path.ends_with(".omn")) return is_not(to_string(Syntax::manchester));
  if (path.ends_with(".owx")) return is_not(to_string(Syntax::owl_xml));
  if (path.ends_with(".obo")) return std::unexpected(not_read("OBO format"));
  const bool says_xml = path.ends_with(".rdf") || path.ends_with(".owl") || path.ends_with(".xml");
  if (says_xml || found == Content::turtle) return Syntax::turtle;
  return std::unexpected(
      "has no known extension, and begins as no known syntax: name it .ttl, .nt, .trig, .nq, .rdf, .owl, "
      ".xml, .owx, .omn or .ofn");
}

}  // namespace geminga::syntax
