// Any bytes as a class expression: read, printed and read again as the same, classified; or refused in one line.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/placement/expression_classifier.hpp"
#include "reasoning/syntax/manchester/canonical.hpp"
#include "reasoning/syntax/manchester/parse.hpp"

namespace {

using namespace geminga;

compiled::Ontology ontology() {
  using owl::AxiomKind;
  using owl::TermKind;
  owl::Ontology source;
  const owl::FileId file = source.add_file("fuzz");
  const auto name = [](const char* local) { return std::string("https://t.example/#") + local; };
  const owl::TermId sensor = source.named_class(name("Sensor"));
  const owl::TermId camera = source.named_class(name("Camera"));
  const owl::TermId ball = source.named_class(name("Ball"));
  const owl::TermId observes = source.object_property(name("observes"));
  const owl::TermId weight = source.data_property(name("weight"));
  const owl::TermId robot = source.individual(name("robot1"));
  const owl::TermId seven = source.literal("7", "http://www.w3.org/2001/XMLSchema#integer");
  source.add_prefix("t", "https://t.example/#");
  source.add_label(name("Camera"), "left eye");
  source.add(AxiomKind::sub_class_of, {camera, sensor}, file, 1);
  source.add(AxiomKind::disjoint_classes, {sensor, ball}, file, 2);
  source.add(AxiomKind::sub_class_of, {camera, source.term(TermKind::object_some_values_from, {observes, ball})}, file,
             3);
  source.add(AxiomKind::functional_object_property, {observes}, file, 4);
  source.add(AxiomKind::class_assertion, {sensor, robot}, file, 5);
  source.add(AxiomKind::sub_class_of, {ball, source.term(TermKind::data_has_value, {weight, seven})}, file, 6);
  return *compiled::Ontology::from_bytes(compiled::compile(source, *el::classify(source)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  static const compiled::Ontology loaded = ontology();
  static const compiled::EntityNames names(loaded);
  static const placement::ExpressionClassifier classifier = *placement::ExpressionClassifier::build(loaded);
  const std::string_view text(reinterpret_cast<const char*>(octets), size);
  (void)manchester::is_compound(text);
  manchester::ExpressionLimits limits;
  limits.text_bytes = 300;
  limits.nesting = 20;
  limits.parts = 50;
  const auto expression = manchester::parse(text, names, limits);
  if (!expression) {
    const std::string error = to_string(expression.error());
    GEMINGA_ASSERT(expression.error().column >= 1 && expression.error().column <= size + 1);
    GEMINGA_ASSERT(error.size() < 600 && base::is_valid_utf8(error) && !base::has_control_character(error));
    return 0;
  }
  const std::string canonical = manchester::canonical(expression->source, expression->term);
  const auto again = manchester::parse(canonical, names);
  GEMINGA_ASSERT(again.has_value());
  GEMINGA_ASSERT(manchester::canonical(again->source, again->term) == canonical);
  const placement::ExpressionPlace place = classifier.classify(expression->source, expression->term);
  GEMINGA_ASSERT(!place.is_satisfiable || place.equivalent || !place.parents.empty());
  return 0;
}
