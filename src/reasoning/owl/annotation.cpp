#include "reasoning/owl/annotation.hpp"

#include <utility>

namespace geminga::owl {

std::string property_of_annotation_axiom(std::string_view word) {
  const std::string rdfs = "http://www.w3.org/2000/01/rdf-schema#";
  if (word == "AnnotationPropertyDomain") return rdfs + "domain";
  return rdfs + (word == "AnnotationPropertyRange" ? "range" : "subPropertyOf");
}

std::string_view annotation_axiom_of(const Annotation& annotation) {
  if (annotation.is_literal || annotation.value.starts_with("_:") || annotation.subject.starts_with("_:"))
    return annotation_assertion;
  for (const std::string_view word :
       {sub_annotation_property_of, annotation_property_domain, annotation_property_range}) {
    if (annotation.property == property_of_annotation_axiom(word)) return word;
  }
  return annotation_assertion;
}

Annotations::Annotations(std::span<const Annotation> all) : all_(all) {
  for (std::uint32_t number = 0; number < all.size(); ++number) {
    const Annotation& annotation = all[number];
    if (annotation.of != Annotation::Of::name) about_[{annotation.of, annotation.number}].push_back(number);
  }
}

std::span<const std::uint32_t> Annotations::about(Annotation::Of of, std::uint32_t number) const {
  const auto found = about_.find({of, number});
  return found == about_.end() ? std::span<const std::uint32_t>() : found->second;
}

void AnnotationStack::begin() {
  if (kept_ == nullptr) return;
  begin_ = kept_->size();
  waiting_.clear();
}

void AnnotationStack::add(Annotation annotation, std::size_t level) {
  if (kept_ == nullptr) return;
  const auto number = static_cast<std::uint32_t>(kept_->size());
  if (waiting_.size() < level + 2) waiting_.resize(level + 2);
  for (const std::uint32_t own : waiting_[level + 1]) {
    (*kept_)[own].of = Annotation::Of::annotation;
    (*kept_)[own].number = number;
  }
  waiting_[level + 1].clear();
  const bool has_subject = annotation.of == Annotation::Of::ontology || !annotation.subject.empty();
  if (!has_subject) waiting_[level].push_back(number);
  kept_->push_back(std::move(annotation));
}

void AnnotationStack::attach(const Ontology& source, std::size_t axioms_before, std::size_t ill_typed_before) {
  if (kept_ == nullptr || kept_->size() == begin_) return;
  const bool is_axiom = source.axiom_count() > axioms_before;
  if (!is_axiom && source.ill_typed_count() == ill_typed_before) return drop();
  if (waiting_.size() < 2) return;
  for (const std::uint32_t own : waiting_[1]) {
    (*kept_)[own].of = is_axiom ? Annotation::Of::axiom : Annotation::Of::ill_typed;
    (*kept_)[own].number = static_cast<std::uint32_t>(is_axiom ? axioms_before : ill_typed_before);
  }
  waiting_.clear();
  begin_ = kept_->size();
}

void AnnotationStack::drop() {
  if (kept_ == nullptr) return;
  kept_->resize(begin_);
  waiting_.clear();
}

}  // namespace geminga::owl
