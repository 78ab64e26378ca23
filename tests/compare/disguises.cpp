#include "compare/disguises.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/owlxml/writer.hpp"

namespace geminga::compare {
namespace {

/// The base of a document, the namespace of its names, and the part of it that is written in front of a relative name.
struct Base {
  std::string_view base;
  std::string_view name_space;
  std::string_view relative;
};

/// Base and name are put together (OWLXML.md).
constexpr Base owl_xml_bases[] = {
    {"http://e.example/o", "http://e.example/o#", "#"},
    {"http://e.example/o#", "http://e.example/o#", ""},
    {"http://e.example/", "http://e.example/o/", "o/"},
    {"http://e.example", "http://e.example#", "#"},
    {"http://e.example/a?v=1", "http://e.example/a?v=1#", "#"},
    {"urn:e:o", "urn:e:o#", "#"},
    {"urn:e:o:", "urn:e:o:x", "x"},
};

/// Names are resolved (RFC 3986). Raptor, which others use as well, resolves against the last three otherwise.
constexpr Base rdf_xml_bases[] = {
    {"http://e.example/o", "http://e.example/o#", "#"},
    {"http://e.example/d/o.owl", "http://e.example/d/", ""},
    {"http://e.example/d/", "http://e.example/", "../"},
    {"http://e.example/d/o", "http://e.example/o#", "../o#"},
    {"http://e.example/o#end", "http://e.example/o#", "#"},
    {"http://e.example", "http://e.example#", "#"},
    {"http://e.example/o?v=1", "http://e.example/o?v=1#", "#"},
    {"urn:e:o", "urn:e:o#", "#"},
};
constexpr std::size_t read_otherwise = 3;

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// An ASCII text in UTF-16.
std::string in_utf16(std::string_view text, bool is_big, bool has_mark) {
  std::string wide = has_mark ? (is_big ? "\xfe\xff" : "\xff\xfe") : "";
  for (const char c : text) wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
  return wide;
}

owl::Ontology with_declarations(owl::Ontology source) {
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const owl::TermId term{number};
    if (source.kind(term) <= owl::TermKind::individual && !source.name_of(term).starts_with("http://www.w3.org/"))
      source.add(owl::AxiomKind::declaration, {term}, owl::FileId{0}, 0);
  }
  return source;
}

class Writer {
 public:
  Writer(std::uint64_t seed, std::span<const Base> bases, Disguise disguise)
      : random_(seed), base_(bases[random_.below(bases.size())]), disguise_(disguise) {}

  [[nodiscard]] const Base& base() const { return base_; }
  [[nodiscard]] bool all() const { return disguise_ == Disguise::all; }
  bool chance(double probability) { return random_.chance(probability); }

  /// The attribute of a name, in one of its forms. `attribute` is IRI, rdf:about and their like.
  std::string name(std::string_view attribute, std::string_view local, std::string_view abbreviated) {
    const auto written = [&](std::string_view as, std::string_view front) {
      return std::string(as).append("=\"").append(front).append(local) + '"';
    };
    switch (random_.below(4)) {
      case 0:
        return written(attribute, base_.name_space);
      case 1:
        return written(attribute, "&e;");
      case 2:
        if (!abbreviated.empty()) return written(abbreviated, "p:");
        [[fallthrough]];
      default:
        return written(attribute, base_.relative);
    }
  }

  /// The whole document with its declaration and entities, in some encoding.
  std::string encoded(std::string_view root, std::string_view body) {
    const std::uint64_t encoding = all() ? random_.below(6) : 0;
    const bool is_wide = encoding > 1;
    std::string text = "<?xml version=\"1.0\"";
    if (is_wide) text += " encoding=\"UTF-16\"";
    text += "?>\n<!DOCTYPE " + std::string(root) + " [ <!ENTITY e \"" + std::string(base_.name_space) + "\" > ]>\n";
    text += body;
    if (is_wide) return in_utf16(text, encoding % 2 == 0, encoding < 4);
    return encoding == 1 ? "\xef\xbb\xbf" + text : text;
  }

  /// Gives each name in a text, which is in the namespace behind `attribute="`, a form. The attribute may be kept.
  template <typename Form>
  std::string with_names(std::string_view text, std::string_view attribute, Form&& form) {
    const std::string begin = std::string(attribute) + "=\"" + std::string(base_.name_space);
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at)) {
      const std::size_t local = at + begin.size();
      const std::size_t end = text.find('"', local);
      result.append(text.substr(done, at - done)).append(form(text.substr(local, end - local)));
      done = at = end + 1;
    }
    return result.append(text.substr(done));
  }

 private:
  base::Random random_;
  Base base_;
  Disguise disguise_;
};

/// Adds the forms of OWL 1: a union or intersection of one class, or of none.
std::string with_leftovers(std::string line, Writer& writer) {
  if (line.starts_with("<Declaration") || line.starts_with("<DisjointUnion")) return line;
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = line.find("<Class "); at != std::string::npos; at = line.find("<Class ", done)) {
    const std::size_t end = line.find("/>", at) + 2;
    std::string of = line.substr(at, end - at);
    if (writer.chance(0.1)) of = "<ObjectUnionOf>" + of + "</ObjectUnionOf>";
    if (writer.chance(0.1)) of = "<ObjectIntersectionOf>" + of + "</ObjectIntersectionOf>";
    if (of.ends_with("owl#Nothing\"/>")) of = writer.chance(0.5) ? "<ObjectUnionOf/>" : "<ObjectOneOf/>";
    if (of.ends_with("owl#Thing\"/>")) of = "<ObjectIntersectionOf/>";
    result.append(line, done, at - done).append(of);
    done = end;
  }
  return result.append(line, done);
}

/// Statements that cost nothing but themselves.
std::string harmless_lines(Writer& writer) {
  std::string lines =
      "<AnnotationAssertion><AnnotationProperty IRI=\"http://www.w3.org/2000/01/rdf-schema#comment\"/><IRI></IRI>"
      "<Literal></Literal></AnnotationAssertion>\n";
  if (!writer.all()) return lines;
  lines += "<AnnotationAssertion><AnnotationProperty IRI=\"\"/><IRI/><IRI></IRI></AnnotationAssertion>\n";
  lines += "<DisjointClasses><Class IRI=\"http://www.w3.org/2002/07/owl#Thing\"/></DisjointClasses>\n";
  const std::string begin = "<SubClassOf><Class IRI=\"http://www.w3.org/2002/07/owl#Thing\"/>";
  const std::string property = "<DataProperty IRI=\"http://www.w3.org/2002/07/owl#topDataProperty\"/>";
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  if (writer.chance(0.5))
    lines += begin + "<DataHasValue>" + property + "<Literal datatypeIRI=\"" + xsd +
             "integer\">none</Literal></DataHasValue></SubClassOf>\n";
  if (writer.chance(0.5))
    lines += begin + "<DataSomeValuesFrom>" + property + "<DatatypeRestriction><Datatype IRI=\"" + xsd +
             "double\"/><FacetRestriction facet=\"" + xsd + "maxInclusive\"><Literal datatypeIRI=\"" + xsd +
             "integer\">1</Literal></FacetRestriction></DatatypeRestriction></DataSomeValuesFrom></SubClassOf>\n";
  return lines;
}

/// A text of ours with its names in the namespace of a base.
std::string in_namespace(std::string text, const Base& base) {
  for (const std::string_view own : {"http://random.example/#", "http://shape.example/#"})
    text = replaced(std::move(text), own, base.name_space);
  return text;
}

}  // namespace

Disguised in_owl_xml(const owl::Ontology& source, std::uint64_t seed, Disguise disguise) {
  Writer writer(seed, owl_xml_bases, disguise);
  const std::string plain = in_namespace(owlxml::owl_xml(with_declarations(source)), writer.base());
  const std::size_t root = plain.find("<Ontology");
  const std::size_t begin = plain.find('\n', root) + 1;
  std::string body = "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"" +
                     std::string(writer.base().base) + "\" ontologyIRI=\"http://e.example/ontology\">\n" +
                     "<Prefix name=\"p\" IRI=\"" + std::string(writer.base().name_space) + "\"/>\n" +
                     harmless_lines(writer);
  for (std::size_t at = begin; at < plain.size();) {
    const std::size_t end = plain.find('\n', at);
    body += with_leftovers(plain.substr(at, end - at), writer) + '\n';
    at = end + 1;
  }
  body = writer.with_names(body, " IRI", [&](std::string_view local) {
    return ' ' + (local.empty() ? "IRI=\"" + std::string(writer.base().name_space) + '"'
                                : writer.name("IRI", local, "abbreviatedIRI"));
  });
  return {"t.owx", plain, writer.encoded("Ontology", body)};
}

Disguised in_rdf_xml(const owl::Ontology& source, std::uint64_t seed, Disguise disguise) {
  const std::span<const Base> bases(rdf_xml_bases);
  Writer writer(seed, disguise == Disguise::all ? bases : bases.first(bases.size() - read_otherwise), disguise);
  const owl::Ontology declared = with_declarations(source);
  graph::Graph graph;
  graph::AxiomTriples triples(
      declared, [&](const graph::Node& s, const graph::Node& p, const graph::Node& o) { graph.add(s, p, o); });
  for (std::size_t number = 0; number < declared.axiom_count(); ++number) triples.add(declared.axiom(number));
  graph.sort();
  const auto text = graph.write(graph::Format::rdf_xml, {});
  const std::string plain = in_namespace(text ? *text : std::string(), writer.base());
  const std::size_t root = plain.find("<rdf:RDF");
  std::string body = plain.substr(root);
  body.insert(std::string_view("<rdf:RDF").size(), " xml:base=\"" + std::string(writer.base().base) + '"');
  std::set<std::string, std::less<>> defined;
  body = writer.with_names(body, "rdf:about", [&](std::string_view local) {
    const bool is_of_fragment = writer.base().relative == "#";
    if (is_of_fragment && writer.chance(0.3) && defined.emplace(local).second)
      return "rdf:ID=\"" + std::string(local) + '"';
    return writer.name("rdf:about", local, "");
  });
  body = writer.with_names(body, "rdf:resource",
                           [&](std::string_view local) { return writer.name("rdf:resource", local, ""); });
  return {"t.rdf", plain, writer.encoded("rdf:RDF", body)};
}

}  // namespace geminga::compare
