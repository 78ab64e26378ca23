// Names and contents that agree, and those that do not.
#include "reasoning/syntax/syntax.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <utility>

#include "reasoning/syntax/count.hpp"

namespace geminga::syntax {
namespace {

TEST(Syntax, IsDecidedByTheNameOfTurtleAndTriplesAndByTheContentOfOthers) {
  const std::string_view turtle = "# a comment\n@prefix : <http://e/> .";
  const std::string_view iri_first = "<http://e/a> a <http://e/B> .";
  const std::string_view xml = "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<rdf:RDF/>";
  EXPECT_EQ(detect_syntax("a.ttl", turtle), Syntax::turtle);
  EXPECT_EQ(detect_syntax("a.ttl", ""), Syntax::turtle);
  EXPECT_EQ(detect_syntax("a.nt", iri_first), Syntax::n_triples);
  EXPECT_EQ(detect_syntax("a.nq", iri_first), Syntax::n_triples);
  EXPECT_EQ(detect_syntax("a.trig", "{ :a :b :c }"), Syntax::turtle);
  EXPECT_EQ(detect_syntax("A.TTL", turtle), Syntax::turtle);
  EXPECT_EQ(detect_syntax("A.NT.gz", iri_first), Syntax::n_triples);
  for (const char* name : {"a.owl", "a.rdf", "a.xml"}) {
    EXPECT_EQ(detect_syntax(name, turtle), Syntax::turtle) << name;
    EXPECT_EQ(detect_syntax(name, iri_first), Syntax::turtle) << name;
    EXPECT_EQ(detect_syntax(name, xml), Syntax::rdf_xml) << name;
    EXPECT_EQ(detect_syntax(name, "<rdf:RDF xmlns:rdf=\"x\">"), Syntax::rdf_xml) << name;
    EXPECT_EQ(detect_syntax(name, "<!-- x -->\n<owl:Ontology rdf:about=''/>"), Syntax::rdf_xml) << name;
    EXPECT_EQ(detect_syntax(name, "# SOMA\nPrefix(:=<http://e/>)\nOntology()"), Syntax::functional) << name;
    EXPECT_EQ(detect_syntax(name, "Ontology ( <http://e/> )"), Syntax::functional) << name;
    EXPECT_EQ(detect_syntax(name, "\xef\xbb\xbfOntology(<http://e/>)"), Syntax::functional) << name;
    EXPECT_EQ(detect_syntax(name, "Prefix: : <http://e/>\nOntology: <http://e/>"), Syntax::manchester) << name;
    EXPECT_EQ(detect_syntax(name, "<?xml version=\"1.0\"?><Ontology xmlns=\"http://www.w3.org/2002/07/owl#\">"),
              Syntax::owl_xml)
        << name;
    EXPECT_EQ(detect_syntax(name, "<owl:Ontology xmlns:owl=\"http://www.w3.org/2002/07/owl#\" ontologyIRI=\"x\">"),
              Syntax::owl_xml)
        << name;
    EXPECT_EQ(detect_syntax(name, "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" rdf:about=\"\">"),
              Syntax::rdf_xml)
        << name;
  }
  EXPECT_EQ(detect_syntax("noname", xml), Syntax::rdf_xml);
  EXPECT_EQ(detect_syntax("a.ttl.gz", turtle), Syntax::turtle);
}

TEST(Syntax, OfTriplesMayBeginWithANameThatLooksLikeAnElementWithAPrefix) {
  EXPECT_EQ(detect_syntax("a.nt", "<urn:a> <http://e/p> <urn:b> .\n"), Syntax::n_triples);
  EXPECT_EQ(detect_syntax("a.ttl", "<urn:a>\n  a <urn:b> ."), Syntax::turtle);
  EXPECT_EQ(detect_syntax("a.owl", "<r:RDF\nxmlns:r='http://www.w3.org/1999/02/22-rdf-syntax-ns#'/>"), Syntax::rdf_xml);
}

TEST(Syntax, OfAnUnknownExtensionIsDecidedByTheContent) {
  for (const char* turtle : {"@prefix : <http://e/> .", "BASE <http://e/>", "<http://e/a> a <http://e/B> .",
                             "<> a :b .", "_:a a <http://e/B> .", "[ a <http://e/B> ] .",
                             "# a comment\n@base <http://e/> .", "{ <a> a <b> }", "GRAPH <g> {}"})
    EXPECT_EQ(detect_syntax("a.txt", turtle), Syntax::turtle) << turtle;
  EXPECT_EQ(detect_syntax("a.txt", "<rdf:RDF xmlns:rdf='x'>"), Syntax::rdf_xml);
  EXPECT_EQ(detect_syntax("a.owl2", "Ontology(<http://e/>)"), Syntax::functional);
  EXPECT_EQ(detect_syntax("a", "Ontology: <http://e/>"), Syntax::manchester);
  for (const char* other : {"hello world", "http://e/a", "SubClassOf(<a> <b>)", "<http://e/a>", "\\documentclass{a}"})
    EXPECT_FALSE(detect_syntax("a.txt", other)) << other;
}

TEST(Syntax, IsFunctionalWhereABracketFollowsTheFirstWord) {
  for (const char* text : {"Prefix(:=<http://e/>)", " \r\n# Prefix\n#\n Prefix # behind\n (", "#\rOntology("}) {
    EXPECT_EQ(detect_syntax("a.owl", text), Syntax::functional) << text;
  }
  for (const char* text : {"Prefix: : <http://e/>", "Ontology: <http://e>", "@prefix : <http://e/> .",
                           "PREFIX : <http://e/>", "<?xml version=\"1.0\"?><Ontology(/>", "Prefixes(", "# Ontology("}) {
    EXPECT_NE(detect_syntax("a.owl", text), Syntax::functional) << text;
  }
}

TEST(Syntax, IsRefusedWithWhatToDo) {
  const auto words = [](std::string_view path, std::string_view content) {
    const auto syntax = detect_syntax(path, content);
    return syntax ? std::string("accepted") : syntax.error();
  };
  EXPECT_EQ(words("a.ttl", "<?xml version=\"1.0\"?>"), "is XML by its content: name it .rdf or .owl");
  EXPECT_EQ(words("a.ttl", "<RDF xmlns=\"http://e/\">"), "is XML by its content: name it .rdf or .owl");
  EXPECT_EQ(words("a.ttl", "<s> <p> 123 ."), "accepted");
  EXPECT_EQ(words("a.txt", "hello"),
            "has no known extension, and begins as no known syntax: name it .ttl, .nt, .trig, .nq, .rdf, .owl, .xml, "
            ".owx, .omn or .ofn");
  EXPECT_EQ(words("a.txt", "[ {\n\"@id\": 1 } ]"), "is in JSON, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.owl", "(define-concept A B)"), "is in KRSS, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.xml", "<TriX xmlns=\"http://www.w3.org/2004/03/trix/trix-1/\">"),
            "is in TriX, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.owl", "ontology: x\n\n[Term]\nid: y\n"),
            "is in OBO format, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.owl", "{ \"@context\": {} }"), "is in JSON, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.owl", "format-version: 1.2\n"),
            "is in OBO format, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.obo", "id-mapping: part_of OBO_REL:part_of\n"),
            "is in OBO format, which is not read: convert it to RDF/XML or Turtle");
  EXPECT_EQ(words("a.owl", " \n"), "is empty");
  EXPECT_EQ(words("a.ofn", ""), "is empty");
  EXPECT_EQ(words("a.ofn", "<http://e/a> a <http://e/B> ."),
            "is not in OWL functional syntax: name it .ttl, .nt, .rdf or .owl, as it is");
  EXPECT_EQ(words("a.omn", "<http://e/a> a <http://e/B> ."),
            "is not in OWL Manchester syntax: name it .ttl, .nt, .rdf or .owl, as it is");
  EXPECT_EQ(words("a.owx", "<http://e/a> a <http://e/B> ."),
            "is not in OWL/XML: name it .ttl, .nt, .rdf or .owl, as it is");
  EXPECT_EQ(words("a.owl.gz", "\x1f\x8b\x08"), "is packed twice by gzip: unpack it once");
}

TEST(Syntax, OfAPageThatCameInsteadOfTheOntologyIsHtml) {
  for (const char* page :
       {"<!DOCTYPE html>\n<html lang=\"en\">", "<!doctype HTML PUBLIC \"-//W3C//DTD HTML 4.01//EN\">", "\n<html><head>",
        "<HTML>", "<!-- saved --><html xmlns=\"http://www.w3.org/1999/xhtml\">", "<?xml version=\"1.0\"?>\n<html>"}) {
    for (const char* name : {"a.owl", "a.rdf", "a.ttl", "a.nt", "a.ofn", "a"}) {
      const auto syntax = detect_syntax(name, page);
      ASSERT_FALSE(syntax) << name << ' ' << page;
      EXPECT_EQ(syntax.error(), "is an HTML page, not an ontology: download the ontology itself");
    }
  }
}

TEST(Syntax, OfWideCharactersIsRefusedWithOrWithoutTheirMark) {
  using std::string_view_literals::operator""sv;
  for (const std::string_view text :
       {"\xff\xfe<\0?\0"sv, "\xfe\xff\0<\0?"sv, "<\0?\0x\0"sv, "\0<\0?"sv, "\0\0\0<"sv, "\xff\xfe\0\0"sv, "@\0p\0"sv}) {
    const auto syntax = detect_syntax("a.ttl", text);
    ASSERT_FALSE(syntax);
    EXPECT_EQ(syntax.error(), "is in UTF-16, which is not read: convert it to UTF-8");
  }
}

TEST(Count, IsReadAsANonNegativeInteger) {
  for (const auto& [text, number] : std::initializer_list<std::pair<const char*, std::uint32_t>>{
           {"2", 2}, {" +2\n", 2}, {"002", 2}, {"-0", 0}, {"-000", 0}, {"+0", 0}, {"4294967295", 4294967295}})
    EXPECT_EQ(read_count(text), number) << text;
  for (const char* text : {"", " ", "+", "-", "-1", "+-2", "2 3", "two", "2.0", "0x2"})
    EXPECT_EQ(read_count(text), std::unexpected(CountFault::not_a_count)) << text;
  EXPECT_EQ(read_count("4294967296"), std::unexpected(CountFault::too_great));
}

}  // namespace
}  // namespace geminga::syntax
