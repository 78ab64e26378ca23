#include "reasoning/syntax/writing/write.hpp"

#include <utility>

#include "base/assert.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/writing/frames.hpp"
#include "reasoning/syntax/writing/functional_form.hpp"
#include "reasoning/syntax/writing/names.hpp"
#include "reasoning/syntax/writing/structure.hpp"
#include "reasoning/syntax/writing/xml_form.hpp"

namespace geminga::writing {

bool is_of_ontology(const Document& document, const owl::Annotation& annotation) {
  return annotation.of == owl::Annotation::Of::ontology && annotation.property != version_property &&
         document.source.files()[annotation.number].ontology_iri == document.iri;
}

bool is_of_name(const Document& document, const owl::Annotation& annotation) {
  if (annotation.of != owl::Annotation::Of::name) return false;
  for (const owl::LoadedFile& file : document.source.files()) {
    if (annotation.subject == file.ontology_iri && file.ontology_iri != document.iri) return false;
  }
  return true;
}

Written write(const Document& document, syntax::Syntax syntax, const Sink& sink, const WritingLimits& limits) {
  GEMINGA_ASSERT(!syntax::has_triples(syntax));
  const Names names(document.source);
  Output output(sink, limits);
  Written written;
  if (syntax == syntax::Syntax::functional) {
    FunctionalForm form(names, output);
    write_structure(document, form, output);
  } else if (syntax == syntax::Syntax::owl_xml) {
    XmlForm form(names, output);
    write_structure(document, form, output);
  } else {
    Unsaid unsaid = write_frames(document, names, output);
    written.unsaid_annotations = unsaid.annotations;
    written.declared_subjects = std::move(unsaid.declared_subjects);
    written.ambiguous_properties = std::move(unsaid.ambiguous_properties);
  }
  written.problem = output.finish();
  return written;
}

}  // namespace geminga::writing
