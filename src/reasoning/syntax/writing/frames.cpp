#include "reasoning/syntax/writing/frames.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>
#include <utility>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::writing {
namespace {

using owl::Annotation;
using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// The annotation properties of OWL 2 (structural specification, section 5.5), which have no frame.
constexpr std::array<std::string_view, 9> built_in_annotations{
    "http://www.w3.org/2000/01/rdf-schema#label",    "http://www.w3.org/2000/01/rdf-schema#comment",
    "http://www.w3.org/2000/01/rdf-schema#seeAlso",  "http://www.w3.org/2000/01/rdf-schema#isDefinedBy",
    "http://www.w3.org/2002/07/owl#deprecated",      "http://www.w3.org/2002/07/owl#versionInfo",
    "http://www.w3.org/2002/07/owl#priorVersion",    "http://www.w3.org/2002/07/owl#backwardCompatibleWith",
    "http://www.w3.org/2002/07/owl#incompatibleWith"};
/// The classes and properties of OWL 2, which have no frame either.
constexpr std::array<std::string_view, 7> built_in_names{owl::owl_thing,
                                                         owl::owl_nothing,
                                                         owl::owl_top_object_property,
                                                         owl::owl_bottom_object_property,
                                                         owl::owl_top_data_property,
                                                         owl::owl_bottom_data_property,
                                                         owl::rdfs_literal};

/// The section of a frame in which an axiom of one kind stands, and the place of its subject. The other operands are
/// what the section lists. `miscellaneous` is the word for any number of operands without a frame.
struct Section {
  AxiomKind kind;
  std::string_view word;
  std::size_t subject = 0;
  std::string_view miscellaneous = {};
};
constexpr std::array sections{
    Section{AxiomKind::sub_class_of, "SubClassOf"},
    Section{AxiomKind::equivalent_classes, "EquivalentTo", 0, "EquivalentClasses"},
    Section{AxiomKind::disjoint_classes, "DisjointWith", 0, "DisjointClasses"},
    Section{AxiomKind::disjoint_union, "DisjointUnionOf"},
    Section{AxiomKind::sub_object_property_of, "SubPropertyOf"},
    Section{AxiomKind::equivalent_object_properties, "EquivalentTo", 0, "EquivalentProperties"},
    Section{AxiomKind::disjoint_object_properties, "DisjointWith", 0, "DisjointProperties"},
    Section{AxiomKind::inverse_object_properties, "InverseOf"},
    Section{AxiomKind::object_property_domain, "Domain"},
    Section{AxiomKind::object_property_range, "Range"},
    Section{AxiomKind::sub_data_property_of, "SubPropertyOf"},
    Section{AxiomKind::equivalent_data_properties, "EquivalentTo", 0, "EquivalentProperties"},
    Section{AxiomKind::disjoint_data_properties, "DisjointWith", 0, "DisjointProperties"},
    Section{AxiomKind::data_property_domain, "Domain"},
    Section{AxiomKind::data_property_range, "Range"},
    Section{AxiomKind::datatype_definition, "EquivalentTo"},
    Section{AxiomKind::has_key, "HasKey"},
    Section{AxiomKind::same_individual, "SameAs", 0, "SameIndividual"},
    Section{AxiomKind::different_individuals, "DifferentFrom", 0, "DifferentIndividuals"},
    Section{AxiomKind::class_assertion, "Types", 1},
    Section{AxiomKind::object_property_assertion, "Facts", 1},
    Section{AxiomKind::negative_object_property_assertion, "Facts", 1},
    Section{AxiomKind::data_property_assertion, "Facts", 1},
    Section{AxiomKind::negative_data_property_assertion, "Facts", 1},
};

/// The section of a kind; nullptr for declarations and characteristics, which have words of their own.
const Section* section_of(AxiomKind kind) {
  const auto* const found = std::ranges::find(sections, kind, &Section::kind);
  return found == sections.end() ? nullptr : found;
}

std::string_view frame_word(TermKind kind) {
  if (owl::is_object_property_expression(kind)) return "ObjectProperty: ";
  if (owl::is_individual(kind)) return "Individual: ";
  return kind == TermKind::data_property         ? "DataProperty: "
         : kind == TermKind::annotation_property ? "AnnotationProperty: "
         : kind == TermKind::datatype            ? "Datatype: "
                                                 : "Class: ";
}

class Frames {
 public:
  Frames(const Document& document, const Names& names, Output& output)
      : document_(document),
        source_(document.source),
        names_(names),
        output_(output),
        short_name_([this](std::string_view iri) { return name_or_blank(iri); }) {}

  Unsaid run() {
    gather();
    write_head();
    std::ranges::stable_sort(items_, {}, &Item::frame);
    std::size_t at = 0;
    for (std::uint32_t frame = 0; frame < heads_.size() && !output_.has_failed(); ++frame) {
      output_.add({"\n", *heads_[frame], "\n"});
      for (; at < items_.size() && items_[at].frame == frame; ++at) write(items_[at]);
    }
    for (; at < items_.size() && !output_.has_failed(); ++at) write(items_[at]);
    return std::move(unsaid_);
  }

 private:
  static constexpr std::uint32_t no_frame = 0xffffffffU;  // sorted behind all others

  struct Item {
    enum class Kind : std::uint8_t { axiom, ill_typed, annotation } kind = Kind::axiom;
    std::uint32_t number = 0;
    std::uint32_t frame = no_frame;
  };

  void gather() {
    for (const std::uint32_t number : document_.axioms) gather(source_.axiom(number), Item::Kind::axiom, number);
    for (std::uint32_t number = 0; document_.has_ill_typed && number < source_.ill_typed_count(); ++number)
      gather(source_.ill_typed(number), Item::Kind::ill_typed, number);
    frame_names();
    for (std::uint32_t number = 0; document_.has_annotations && number < document_.annotations.size(); ++number) {
      const Annotation& annotation = document_.annotations.at(number);
      if (is_of_name(document_, annotation))
        items_.push_back({Item::Kind::annotation, number, frame_of_annotation(annotation)});
    }
  }

  void gather(const owl::Axiom& axiom, Item::Kind kind, std::uint32_t number) {
    for (const TermId id : axiom.arguments) roots_.push_back(id);
    const TermId subject = subject_of(axiom);
    const bool is_declaration = axiom.kind == AxiomKind::declaration;
    const std::uint32_t frame = is_miscellaneous(axiom) ? no_frame : frame_of(subject);
    // A frame is a declaration, and has no place for annotations of it.
    if (is_declaration) {
      unsaid_.annotations +=
          document_.has_annotations ? document_.annotations.about(Annotation::Of::axiom, number).size() : 0;
      return;
    }
    items_.push_back({kind, number, frame});
  }

  [[nodiscard]] bool is_named(TermId id) const { return source_.kind(id) <= TermKind::anonymous_individual; }

  /// Whether an axiom of any number of operands cannot stand in the frame of one of them.
  [[nodiscard]] bool is_miscellaneous(const owl::Axiom& axiom) const {
    if (axiom.kind == AxiomKind::dl_safe_rule) return true;
    const Section* section = section_of(axiom.kind);
    if (section == nullptr || section->miscellaneous.empty()) return false;
    return axiom.arguments.size() != 2 || (!is_named(axiom.arguments[0]) && !is_named(axiom.arguments[1]));
  }

  [[nodiscard]] std::size_t place_of_subject(const owl::Axiom& axiom) const {
    const Section* section = section_of(axiom.kind);
    if (section == nullptr) return 0;
    if (axiom.kind == AxiomKind::sub_object_property_of &&
        source_.kind(axiom.arguments[0]) == TermKind::object_property_chain)
      return 1;
    const bool is_symmetric = !section->miscellaneous.empty();
    return is_symmetric && !is_named(axiom.arguments[0]) ? 1 : section->subject;
  }
  [[nodiscard]] TermId subject_of(const owl::Axiom& axiom) const { return axiom.arguments[place_of_subject(axiom)]; }

  std::uint32_t frame_of(TermId subject) {
    const TermKind kind = source_.kind(subject);
    const std::uint32_t frame = frame_named(std::string(frame_word(kind)) + text(subject));
    if (kind <= TermKind::anonymous_individual) frame_of_name_.try_emplace(source_.name_of(subject), frame);
    return frame;
  }

  std::uint32_t frame_named(std::string head) {
    const auto [found, is_new] = frames_.try_emplace(std::move(head), static_cast<std::uint32_t>(heads_.size()));
    if (is_new) heads_.push_back(&found->first);
    return found->second;
  }

  /// Without a frame a property might be read as one of the other kind, and the OWL API refuses a document that uses
  /// any name without a frame.
  void frame_names() {
    std::unordered_map<std::string_view, TermKind> properties;
    for (const TermId id : owl::terms_in(source_, roots_)) {
      const TermKind kind = source_.kind(id);
      if (kind > TermKind::individual) continue;
      const std::string_view iri = source_.name_of(id);
      if (kind == TermKind::object_property || kind == TermKind::data_property) {
        if (properties.try_emplace(iri, kind).first->second != kind) unsaid_.ambiguous_properties.emplace_back(iri);
      }
      const bool is_built_in =
          std::ranges::find(built_in_names, iri) != built_in_names.end() || owl::Datatype::find(iri);
      if (!is_built_in) frame_of(id);
    }
    roots_.clear();
    for (std::uint32_t number = 0; document_.has_annotations && number < document_.annotations.size(); ++number) {
      const Annotation& annotation = document_.annotations.at(number);
      if (annotation.of == Annotation::Of::ontology && annotation.property == version_property) continue;
      const std::string_view word =
          annotation.of == Annotation::Of::name ? owl::annotation_axiom_of(annotation) : owl::annotation_assertion;
      if (word == owl::annotation_assertion) frame_property(annotation.property);
      if (word == owl::sub_annotation_property_of) frame_property(annotation.value);
    }
  }

  void frame_property(std::string_view property) {
    if (std::ranges::find(built_in_annotations, property) != built_in_annotations.end()) return;
    if (!frame_of_name_.contains(property))
      frame_of_name_[property] = frame_named(std::string(frame_word(TermKind::annotation_property)) + name(property));
  }

  std::uint32_t frame_of_annotation(const Annotation& annotation) {
    if (owl::annotation_axiom_of(annotation) != owl::annotation_assertion)
      return frame_named(std::string(frame_word(TermKind::annotation_property)) + name(annotation.subject));
    const auto found = frame_of_name_.find(annotation.subject);
    if (found != frame_of_name_.end()) return found->second;
    const std::size_t before = heads_.size();
    const std::uint32_t frame =
        frame_named(std::string(frame_word(TermKind::individual)) + name_or_blank(annotation.subject));
    if (heads_.size() > before && !annotation.subject.starts_with("_:"))
      unsaid_.declared_subjects.push_back(annotation.subject);
    return frame;
  }

  void write_head() {
    for (const auto& [prefix, iri] : names_.prefixes()) output_.add({"Prefix: ", prefix, ": <", iri, ">\n"});
    output_.add("\nOntology:");
    if (!document_.iri.empty()) output_.add({" <", document_.iri, ">"});
    if (!document_.iri.empty() && !document_.version_iri.empty()) output_.add({" <", document_.version_iri, ">"});
    output_.add("\n");
    for (const std::string& import : document_.imports) output_.add({"Import: <", import, ">\n"});
    for (std::uint32_t number = 0; document_.has_annotations && number < document_.annotations.size(); ++number) {
      if (!is_of_ontology(document_, document_.annotations.at(number))) continue;
      output_.add("Annotations: ");
      annotation(number);
      output_.add("\n");
    }
  }

  void write(const Item& item) {
    if (item.kind == Item::Kind::annotation) return write_annotation(item.number);
    const bool is_axiom = item.kind == Item::Kind::axiom;
    const owl::Axiom axiom = is_axiom ? source_.axiom(item.number) : source_.ill_typed(item.number);
    const Annotation::Of of = is_axiom ? Annotation::Of::axiom : Annotation::Of::ill_typed;
    const auto own =
        document_.has_annotations ? document_.annotations.about(of, item.number) : std::span<const std::uint32_t>();
    output_.add({item.frame == no_frame ? "\n" : "    ", word_of(axiom, item.frame == no_frame), ": "});
    annotations(own);
    output_.add({members_of(axiom, item.frame == no_frame), "\n"});
  }

  [[nodiscard]] std::string_view word_of(const owl::Axiom& axiom, bool is_alone) const {
    if (axiom.kind == AxiomKind::dl_safe_rule) return "Rule";
    const Section* section = section_of(axiom.kind);
    if (section == nullptr) return "Characteristics";
    if (axiom.kind == AxiomKind::sub_object_property_of && place_of_subject(axiom) == 1) return "SubPropertyChain";
    return is_alone ? section->miscellaneous : section->word;
  }

  [[nodiscard]] std::string members_of(const owl::Axiom& axiom, bool is_alone) const {
    const auto arguments = axiom.arguments;
    switch (axiom.kind) {
      case AxiomKind::has_key:  // the OWL API reads no list without commas
      case AxiomKind::disjoint_union:
        return joined(arguments.subspan(1), ", ");
      case AxiomKind::object_property_assertion:
      case AxiomKind::data_property_assertion:
        return text(arguments[0]) + ' ' + text(arguments[2]);
      case AxiomKind::negative_object_property_assertion:
      case AxiomKind::negative_data_property_assertion:
        return "not " + text(arguments[0]) + ' ' + text(arguments[2]);
      case AxiomKind::dl_safe_rule:
        return text(arguments[0]) + " -> " + text(arguments[1]);
      default:
        break;
    }
    if (is_alone) return joined(arguments, ", ");
    if (section_of(axiom.kind) == nullptr) return characteristic(axiom.kind);
    return text(arguments[1 - place_of_subject(axiom)]);
  }

  /// "Transitive" for TransitiveObjectProperty.
  static std::string characteristic(AxiomKind kind) {
    std::string_view word = owl::to_string(kind);
    for (const std::string_view end : {"ObjectProperty", "DataProperty"}) {
      if (word.ends_with(end)) word.remove_suffix(end.size());
    }
    return std::string(word);
  }

  [[nodiscard]] std::string joined(std::span<const TermId> terms, std::string_view between) const {
    std::string result;
    for (const TermId id : terms) {
      if (!result.empty()) result += between;
      result += text(id);
    }
    return result;
  }

  [[nodiscard]] std::string text(TermId id) const {
    return owl::print(source_, id, short_name_, owl::PrintStyle::document);
  }

  [[nodiscard]] std::string name(std::string_view iri) const {
    if (!is_writable(iri)) output_.fail(unwritable(iri));
    return names_.written(iri);
  }
  [[nodiscard]] std::string name_or_blank(std::string_view written) const {
    return written.starts_with("_:") ? Names::blank(written) : name(written);
  }

  /// The value of an annotation, which need not be anything that has a frame: the OWL API reads no prefix there.
  [[nodiscard]] std::string in_full(std::string_view value) const {
    if (value.starts_with("_:")) return Names::blank(value);
    if (!is_writable(value)) output_.fail(unwritable(value));
    return '<' + std::string(value) + '>';
  }

  void annotations(std::span<const std::uint32_t> numbers) {
    for (std::size_t at = 0; at < numbers.size(); ++at) {
      output_.add(at == 0 ? "Annotations: " : ", ");
      annotation(numbers[at]);
    }
    if (!numbers.empty()) output_.add(" ");
  }

  /// The readers bound how deep annotations nest.
  void annotation(std::uint32_t number) {
    const Annotation& annotation = document_.annotations.at(number);
    annotations(document_.annotations.about(Annotation::Of::annotation, number));
    output_.add({name(annotation.property), " "});
    if (!annotation.is_literal) return output_.add(in_full(annotation.value));
    const std::string_view type = annotation.language.empty() ? annotation.datatype : std::string_view();
    const std::string datatype = type.empty() ? "http://www.w3.org/2001/XMLSchema#string" : name(type);
    output_.add(owl::quoted(annotation.value));
    if (!annotation.language.empty()) return output_.add({"@", annotation.language});
    if (!type.empty() && type != "http://www.w3.org/2001/XMLSchema#string") output_.add({"^^", datatype});
  }

  void write_annotation(std::uint32_t number) {
    const Annotation& annotation = document_.annotations.at(number);
    const std::string_view word = owl::annotation_axiom_of(annotation);
    if (word == owl::annotation_assertion) {
      output_.add("    Annotations: ");
      this->annotation(number);
    } else {
      output_.add({"    ",
                   word == owl::sub_annotation_property_of  ? "SubPropertyOf"
                   : word == owl::annotation_property_range ? "Range"
                                                            : "Domain",
                   ": "});
      annotations(document_.annotations.about(Annotation::Of::annotation, number));
      output_.add(word == owl::sub_annotation_property_of ? name(annotation.value) : in_full(annotation.value));
    }
    output_.add("\n");
  }

  const Document& document_;
  const owl::Ontology& source_;
  const Names& names_;
  Output& output_;
  const owl::ShortName short_name_;
  std::vector<TermId> roots_;
  std::unordered_map<std::string, std::uint32_t> frames_;  ///< by head; only looked up
  std::vector<const std::string*> heads_;                  ///< of each frame
  std::unordered_map<std::string_view, std::uint32_t> frame_of_name_;
  std::vector<Item> items_;
  Unsaid unsaid_;
};

}  // namespace

Unsaid write_frames(const Document& document, const Names& names, Output& output) {
  return Frames(document, names, output).run();
}

}  // namespace geminga::writing
