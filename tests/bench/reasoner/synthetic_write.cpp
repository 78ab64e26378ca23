// The two syntaxes of a made-up ontology.
#include <cstdio>
#include <string>

#include "bench/reasoner/synthetic.hpp"

namespace geminga::bench {
namespace {

constexpr const char* name_space = "http://synthetic.example/id#";

std::string label_of(std::uint32_t number) { return "synthetic concept " + std::to_string(number); }

/// Collects lines into large pieces.
class Pen {
 public:
  explicit Pen(std::FILE* out) : out_(out) {}
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;
  ~Pen() { flush(); }

  template <typename... Parts>
  void line(const Parts&... parts) {
    ((text_ += parts), ...);
    text_ += '\n';
    if (text_.size() > 60'000) flush();
  }

 private:
  void flush() {
    std::fwrite(text_.data(), 1, text_.size(), out_);
    text_.clear();
  }
  std::FILE* out_;
  std::string text_;
};

std::string concept_name(std::uint32_t number) { return "C" + std::to_string(number); }
std::string property_name(std::uint32_t number) { return "p" + std::to_string(number); }

/// ObjectSomeValuesFrom(:p1 ObjectIntersectionOf(...))
std::string functional_group(const Synthetic& ontology, const std::vector<Attribute>& group) {
  std::string parts;
  for (const Attribute& attribute : group)
    parts +=
        " ObjectSomeValuesFrom(:" + property_name(attribute.property) + " :" + concept_name(attribute.filler) + ")";
  const std::string filler = group.size() == 1 ? parts : " ObjectIntersectionOf(" + parts + ")";
  return " ObjectSomeValuesFrom(:" + property_name(ontology.role_group) + filler + ")";
}

std::string functional_groups(const Synthetic& ontology, const SyntheticClass& one) {
  std::string parts;
  for (const auto& group : one.groups) parts += functional_group(ontology, group);
  return parts;
}

void functional_class(const Synthetic& ontology, std::uint32_t number, Pen& pen) {
  const SyntheticClass& one = ontology.classes[number];
  const std::string name = ":" + concept_name(number);
  pen.line("Declaration(Class(", name, "))");
  pen.line("AnnotationAssertion(rdfs:label ", name, " \"", label_of(number), "\"@en)");
  if (one.is_defined) {
    std::string parts;
    for (const std::uint32_t parent : one.parents) parts += " :" + concept_name(parent);
    pen.line("EquivalentClasses(", name, " ObjectIntersectionOf(", parts, functional_groups(ontology, one), "))");
  } else {
    for (const std::uint32_t parent : one.parents) pen.line("SubClassOf(", name, " :", concept_name(parent), ")");
    if (one.groups.size() == 1) pen.line("SubClassOf(", name, functional_groups(ontology, one), ")");
    if (one.groups.size() > 1)
      pen.line("SubClassOf(", name, " ObjectIntersectionOf(", functional_groups(ontology, one), "))");
  }
  if (one.part_of != 0)
    pen.line("SubClassOf(", name, " ObjectSomeValuesFrom(:", property_name(ontology.part_of), " :",
             concept_name(one.part_of), "))");
}

std::string about(const std::string& name) { return std::string(" rdf:about=\"") + name_space + name + "\""; }
std::string resource(const std::string& name) { return std::string(" rdf:resource=\"") + name_space + name + "\""; }

std::string xml_some(const std::string& property, const std::string& filler) {
  return "<owl:Restriction><owl:onProperty" + resource(property) + "/>" + filler + "</owl:Restriction>";
}

std::string xml_some_class(const std::string& property, const std::string& name) {
  return xml_some(property, "<owl:someValuesFrom" + resource(name) + "/>");
}

std::string xml_intersection(const std::string& parts) {
  return "<owl:Class><owl:intersectionOf rdf:parseType=\"Collection\">" + parts + "</owl:intersectionOf></owl:Class>";
}

std::string xml_groups(const Synthetic& ontology, const SyntheticClass& one) {
  std::string groups;
  for (const auto& group : one.groups) {
    std::string parts;
    for (const Attribute& attribute : group)
      parts += xml_some_class(property_name(attribute.property), concept_name(attribute.filler));
    groups += xml_some(
        property_name(ontology.role_group),
        "<owl:someValuesFrom>" + (group.size() == 1 ? parts : xml_intersection(parts)) + "</owl:someValuesFrom>");
  }
  return groups;
}

void xml_class(const Synthetic& ontology, std::uint32_t number, Pen& pen) {
  const SyntheticClass& one = ontology.classes[number];
  pen.line("<owl:Class", about(concept_name(number)), ">");
  pen.line("  <rdfs:label xml:lang=\"en\">", label_of(number), "</rdfs:label>");
  const std::string groups = xml_groups(ontology, one);
  if (one.is_defined) {
    std::string parts;
    for (const std::uint32_t parent : one.parents) parts += "<rdf:Description" + about(concept_name(parent)) + "/>";
    pen.line("  <owl:equivalentClass>", xml_intersection(parts + groups), "</owl:equivalentClass>");
  } else {
    for (const std::uint32_t parent : one.parents) pen.line("  <rdfs:subClassOf", resource(concept_name(parent)), "/>");
    if (!one.groups.empty())
      pen.line("  <rdfs:subClassOf>", one.groups.size() == 1 ? groups : xml_intersection(groups), "</rdfs:subClassOf>");
  }
  if (one.part_of != 0)
    pen.line("  <rdfs:subClassOf>", xml_some_class(property_name(ontology.part_of), concept_name(one.part_of)),
             "</rdfs:subClassOf>");
  pen.line("</owl:Class>");
}

}  // namespace

void write_functional(const Synthetic& ontology, std::FILE* out) {
  Pen pen(out);
  pen.line("Prefix(:=<", name_space, ">)");
  pen.line("Prefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)");
  pen.line("Ontology(<http://synthetic.example/id>");
  for (std::uint32_t property = 0; property < ontology.property_count; ++property)
    pen.line("Declaration(ObjectProperty(:", property_name(property), "))");
  pen.line("TransitiveObjectProperty(:", property_name(ontology.part_of), ")");
  pen.line("ReflexiveObjectProperty(:", property_name(ontology.part_of), ")");
  for (const auto& [sub, super] : ontology.sub_properties)
    pen.line("SubObjectPropertyOf(:", property_name(sub), " :", property_name(super), ")");
  for (const Chain& chain : ontology.chains)
    pen.line("SubObjectPropertyOf(ObjectPropertyChain(:", property_name(chain.first), " :", property_name(chain.second),
             ") :", property_name(chain.result), ")");
  for (std::uint32_t number = 0; number < ontology.classes.size(); ++number) functional_class(ontology, number, pen);
  pen.line(")");
}

void write_rdf_xml(const Synthetic& ontology, std::FILE* out) {
  Pen pen(out);
  pen.line("<?xml version=\"1.0\"?>");
  pen.line(
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\" xmlns:owl=\"http://www.w3.org/2002/07/owl#\">");
  pen.line("<owl:Ontology rdf:about=\"http://synthetic.example/id\"/>");
  for (std::uint32_t property = 0; property < ontology.property_count; ++property) {
    pen.line("<owl:ObjectProperty", about(property_name(property)), ">");
    if (property == ontology.part_of) {
      for (const char* kind : {"TransitiveProperty", "ReflexiveProperty"})
        pen.line("  <rdf:type rdf:resource=\"http://www.w3.org/2002/07/owl#", kind, "\"/>");
    }
    for (const auto& [sub, super] : ontology.sub_properties) {
      if (sub == property) pen.line("  <rdfs:subPropertyOf", resource(property_name(super)), "/>");
    }
    for (const Chain& chain : ontology.chains) {
      if (chain.result != property) continue;
      pen.line("  <owl:propertyChainAxiom rdf:parseType=\"Collection\"><rdf:Description",
               about(property_name(chain.first)), "/><rdf:Description", about(property_name(chain.second)),
               "/></owl:propertyChainAxiom>");
    }
    pen.line("</owl:ObjectProperty>");
  }
  for (std::uint32_t number = 0; number < ontology.classes.size(); ++number) xml_class(ontology, number, pen);
  pen.line("</rdf:RDF>");
}

}  // namespace geminga::bench
