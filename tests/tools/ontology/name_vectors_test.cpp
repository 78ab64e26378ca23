// The names of files in every syntax become the IRIs and identities of src/identity/names.tsv.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "base/text.hpp"
#include "geminga/identity.hpp"
#include "program.hpp"

namespace geminga::ontology {
namespace {

struct Vector {
  std::string written;
  std::string iri;
};
using Document = std::pair<std::string, std::string>;  // syntax and base

/// The vectors of each document, in their order. Where a field is "-", it is empty.
std::map<Document, std::vector<Vector>> vectors() {
  std::map<Document, std::vector<Vector>> found;
  std::ifstream file(GEMINGA_NAME_VECTORS);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, '\t');) fields.push_back(field == "-" ? "" : field);
    fields.resize(6);
    EXPECT_EQ(std::to_string(id32(SemanticIdentity{fields[3], ""})), fields[4]) << line;
    found[{fields[0], fields[1]}].push_back({fields[2], fields[3]});
  }
  return found;
}

std::string super(std::size_t number) { return "http://super.example/" + std::to_string(number); }

struct Written {
  std::string file;
  std::string text;
};

/// A document that says of each name that it is a subclass of the class of its number.
Written document_of(const Document& of, const std::vector<Vector>& names) {
  const auto& [syntax, base] = of;
  std::string body;
  const auto each = [&](const auto& line) {
    for (std::size_t number = 0; number < names.size(); ++number) body += line(names[number].written, super(number));
  };
  if (syntax.starts_with("rdfxml")) {
    const std::string attribute = syntax == "rdfxml-id" ? "rdf:ID" : "rdf:about";
    each([&](const std::string& name, const std::string& above) {
      return "<owl:Class " + attribute + "=\"" + name + "\"><rdfs:subClassOf rdf:resource=\"" + above +
             "\"/></owl:Class>\n";
    });
    return {"a.rdf",
            "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
            "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\" "
            "xmlns:owl=\"http://www.w3.org/2002/07/owl#\" xml:base=\"" +
                base + "\">\n" + body + "</rdf:RDF>\n"};
  }
  if (syntax == "owlxml") {
    each([](const std::string& name, const std::string& above) {
      return "<SubClassOf><Class IRI=\"" + name + "\"/><Class IRI=\"" + above + "\"/></SubClassOf>\n";
    });
    return {"a.owx",
            "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"" + base + "\">\n" + body + "</Ontology>\n"};
  }
  if (syntax == "functional") {
    each([](const std::string& name, const std::string& above) {
      return "SubClassOf(<" + name + "> <" + above + ">)\n";
    });
    return {"a.ofn", "Ontology(\n" + body + ")\n"};
  }
  if (syntax == "manchester") {
    each([](const std::string& name, const std::string& above) {
      return "Class: <" + name + ">\n  SubClassOf: <" + above + ">\n";
    });
    return {"a.omn", "Ontology: <http://o.example>\n" + body};
  }
  each([](const std::string& name, const std::string& above) {
    return "<" + name + "> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <" + above + "> .\n";
  });
  return {syntax == "turtle" ? "a.ttl" : "a.nt", (base.empty() ? "" : "@base <" + base + "> .\n") + body};
}

TEST(NameVectors, AreWhatFilesOfEverySyntaxMean) {
  const auto all = vectors();
  ASSERT_GE(all.size(), 40U) << GEMINGA_NAME_VECTORS;
  const Program program;
  for (const auto& [of, names] : all) {
    const auto [file, text] = document_of(of, names);
    program.write(file, text);
    const Outcome outcome = program.run({"classify", "--closure", file});
    ASSERT_EQ(outcome.status, 0) << of.first << ' ' << of.second << '\n' << outcome.err;
    const std::string lines = '\n' + outcome.out;
    for (std::size_t number = 0; number < names.size(); ++number)
      EXPECT_NE(lines.find('\n' + names[number].iri + '\t' + super(number) + '\n'), std::string::npos)
          << of.first << ", base " << of.second << ", name " << names[number].written << '\n'
          << outcome.out;
  }
}

TEST(NameVectors, HoldForBasesThatAreEntitiesOrStandWithin) {
  const Program program;
  program.write("a.rdf",
                "<!DOCTYPE rdf:RDF [<!ENTITY c \"http://cmt\"><!ENTITY d \"&c;\">]>\n"
                "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
                "xmlns:owl=\"http://www.w3.org/2002/07/owl#\" xml:base='&d;'><owl:Class rdf:ID=\"A\"/>"
                "<owl:Class rdf:ID=\"B\" xml:base=\"http://x/y?q=1&amp;r\"/><owl:Class rdf:about=\"C\"/>"
                "<owl:Class rdf:about='http://cmt/geminga.base.0.#D'/><!-- xml:base=\"http://n\" --></rdf:RDF>");
  const std::string classes = program.run({"classify", "--json", "a.rdf"}).out;
  for (const char* iri : {"http://cmt#A", "http://cmt/C", "http://cmt/geminga.base.0.#D", "http://x/y?q=1&r#B"})
    EXPECT_NE(classes.find('"' + std::string(iri) + '"'), std::string::npos) << iri << '\n' << classes;
  program.write("a.ttl",
                "@base <http://cmt> . @prefix : <#> . @prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
                ":A a owl:Class . <B> a owl:Class .\nBASE <http://x/y#f>\n<> a owl:Class . "
                "<#A> a owl:Class ; owl:versionInfo \"@base <http://n> .\" .");
  EXPECT_EQ(program.run({"classify", "--json", "a.ttl"}).out.find("geminga.base"), std::string::npos);
  const Outcome converted = program.run({"convert", "a.ttl", "-o", "c.nt"});
  EXPECT_EQ(converted.status, 0) << converted.err;
  EXPECT_NE(program.read("c.nt").find("<http://x/y#A>"), std::string::npos) << program.read("c.nt");
  EXPECT_EQ(program.read("c.nt").find("geminga.base"), std::string::npos);
}

}  // namespace
}  // namespace geminga::ontology
