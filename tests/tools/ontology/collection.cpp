#include "collection.hpp"

#include <utility>

namespace geminga::ontology {

std::string owls(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  std::string profile;
  std::string parameters;
  for (const auto& [kind, types] : {std::pair("Input", &inputs), std::pair("Output", &outputs)}) {
    for (std::size_t at = 0; at < types->size(); ++at) {
      const std::string name = '_' + std::string(kind) + std::to_string(at);
      profile.append("<profile:has").append(kind).append(" rdf:resource=\"#").append(name).append("\"/>\n");
      parameters.append("<process:")
          .append(kind)
          .append(" rdf:ID=\"")
          .append(name)
          .append("\"><process:parameterType ");
      parameters.append("rdf:datatype=\"http://www.w3.org/2001/XMLSchema#anyURI\">").append((*types)[at]);
      parameters.append("</process:parameterType></process:").append(kind).append(">\n");
    }
  }
  return "<?xml version=\"1.0\" encoding=\"WINDOWS-1252\"?>\n"
         "<rdf:RDF xmlns:owl=\"http://www.w3.org/2002/07/owl#\" "
         "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"\n"
         " xmlns:profile=\"http://www.daml.org/services/owl-s/1.1/Profile.owl#\"\n"
         " xmlns:process=\"http://www.daml.org/services/owl-s/1.1/Process.owl#\" "
         "xml:base=\"http://127.0.0.1/services/s.owls\">\n"
         "<owl:Ontology rdf:about=\"\"><owl:imports "
         "rdf:resource=\"http://127.0.0.1/ontology/Service.owl\"/></owl:Ontology>\n"
         "<profile:Profile rdf:ID=\"PROFILE\">\n" +
         profile + "</profile:Profile>\n" + parameters + "</rdf:RDF>\n";
}

}  // namespace geminga::ontology
