// Writes the axioms of generated shapes.
#ifndef GEMINGA_TESTS_COMPARE_SHAPE_WRITER_HPP
#define GEMINGA_TESTS_COMPARE_SHAPE_WRITER_HPP

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

class ShapeWriter {
 public:
  ShapeWriter() : file_(source_.add_file("shape")) {}

  owl::TermId named(const std::string& name) { return source_.named_class("http://shape.example/#" + name); }
  owl::TermId property(const std::string& name) { return source_.object_property("http://shape.example/#" + name); }
  owl::TermId individual(const std::string& name) { return source_.individual("http://shape.example/#" + name); }
  owl::TermId term(owl::TermKind kind, std::vector<owl::TermId> arguments, std::uint32_t number = 0) {
    return source_.term(kind, std::move(arguments), number);
  }
  void add(owl::AxiomKind kind, const std::vector<owl::TermId>& arguments) {
    source_.add(kind, arguments, file_, ++line_);
  }
  owl::Ontology take() { return std::move(source_); }

 private:
  owl::Ontology source_;
  owl::FileId file_{};
  std::uint32_t line_ = 0;
};

}  // namespace geminga::compare

#endif
