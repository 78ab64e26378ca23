#include "sim/small_ontology.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::sim {
namespace {

constexpr std::string_view soccer = "https://geminga.example/soccer#";

/// Writes axioms over names under `soccer:`; each stands on a line of its own, in the order of the calls.
class Writer {
 public:
  Writer() : file_(source_.add_file("small.ttl", "https://geminga.example/small")) {
    source_.add_prefix("soccer", soccer);
    source_.add_prefix("owl", "http://www.w3.org/2002/07/owl#");
  }
  void sub(const char* sub, const char* super) {
    source_.add(owl::AxiomKind::sub_class_of, {named(sub), named(super)}, file_, ++line_);
  }
  void equivalent(const char* a, const char* b) {
    source_.add(owl::AxiomKind::equivalent_classes, {named(a), named(b)}, file_, ++line_);
  }
  void unsatisfiable(const char* name) {
    source_.add(owl::AxiomKind::sub_class_of, {named(name), source_.named_class(owl::owl_nothing)}, file_, ++line_);
  }
  void sub_some(const char* sub, const char* property, const char* filler) {
    const owl::TermId role = source_.object_property(std::string(soccer) + property);
    const owl::TermId some = source_.term(owl::TermKind::object_some_values_from, {role, named(filler)});
    source_.add(owl::AxiomKind::sub_class_of, {named(sub), some}, file_, ++line_);
  }
  void convert(const char* from, const char* to, const char* cost) {
    source_.add_conversion(std::string(soccer) + from, std::string(soccer) + to, cost, file_, ++line_);
  }
  /// A unit of length.
  void unit(const char* name, const char* symbol, const char* metres) {
    const std::string iri = std::string(soccer) + name;
    source_.add_unit_statement(iri, owl::UnitWord::qudt_multiplier, metres, file_, ++line_);
    source_.add_unit_statement(iri, owl::UnitWord::qudt_dimension, "/A0E0L1I0M0H0T0D0", file_, line_);
    source_.add_unit_statement(iri, owl::UnitWord::qudt_symbol, symbol, file_, line_);
  }
  void disjoint(const char* a, const char* b) {
    source_.add(owl::AxiomKind::disjoint_classes, {named(a), named(b)}, file_, ++line_);
  }
  void leave_out(const char* construct) { source_.leave_out(construct, file_, ++line_); }
  void label(const char* name, const char* text) { source_.add_label(std::string(soccer) + name, text); }
  /// Damage is done to the axioms, which are verified when an explanation or an expression is asked for.
  [[nodiscard]] compiled::Ontology finish(bool is_damaged = false) const {
    const auto classification = el::classify(source_);
    GEMINGA_ASSERT(classification.has_value());
    std::vector<std::byte> bytes = compiled::compile(source_, *classification);
    if (is_damaged) bytes.back() ^= std::byte{1};
    auto ontology = compiled::Ontology::from_bytes(std::move(bytes));
    GEMINGA_ASSERT(ontology.has_value());
    return std::move(*ontology);
  }

 private:
  owl::TermId named(const char* name) { return source_.named_class(std::string(soccer) + name); }
  owl::Ontology source_;
  owl::FileId file_;
  std::uint32_t line_ = 0;
};

compiled::Ontology make(bool has_ball) {
  Writer writer;
  writer.sub("TrackedObject", "Information");
  writer.sub("Opponent", "TrackedObject");
  if (has_ball) {
    writer.sub("Ball", "TrackedObject");
    writer.sub("OrangeBall", "Ball");
    writer.equivalent("Sphere", "Ball");
    writer.unsatisfiable("SquareBall");
    writer.label("OrangeBall", "the orange ball");
  }
  writer.sub("CartesianFrame", "Frame");
  writer.sub("PolarFrame", "Frame");
  return writer.finish();
}

/// As the whole one, by somebody who writes `Bal`.
compiled::Ontology make_misspelt() {
  Writer writer;
  writer.sub("TrackedObject", "Information");
  writer.sub("Bal", "TrackedObject");
  return writer.finish();
}

/// A long way up, from Level100 to Level220.
compiled::Ontology make_deep() {
  Writer writer;
  for (int level = 100; level < 500; ++level) {
    writer.sub(("Level" + std::to_string(level)).c_str(), ("Level" + std::to_string(level + 1)).c_str());
  }
  return writer.finish();
}

/// Balls in frames that are turned into each other; the other form: by another way for the same cost.
compiled::Ontology make_frames(bool is_other_way) {
  Writer writer;
  writer.sub("Ball", "TrackedObject");
  writer.sub("RobotPolar", "RobotFrame");
  writer.sub("MyRobotPolar", "RobotPolar");
  writer.sub("FieldPolar", "FieldFrame");
  writer.sub("FieldCartesian", "FieldFrame");
  writer.sub("RobotCartesian", "RobotFrame");
  writer.sub("CameraPixels", "CameraFrame");
  writer.convert("RobotPolar", "RobotCartesian", "1");
  writer.convert("FieldCartesian", "FieldPolar", "1");
  if (is_other_way) {
    writer.convert("RobotPolar", "FieldPolar", "10");
    writer.convert("FieldPolar", "FieldCartesian", "1");
  } else {
    writer.convert("RobotCartesian", "FieldCartesian", "10");
  }
  return writer.finish();
}

/// Balls on a pitch that is so long.
compiled::Ontology make_units(const char* pitch) {
  Writer writer;
  writer.sub("Ball", "TrackedObject");
  writer.unit("Pitch", "pitch", pitch);
  writer.unit("Goal", "goal", "7.32");
  return writer.finish();
}

/// For class expressions: cameras that observe balls, and a lidar.
compiled::Ontology make_sensors(bool has_ball, bool is_damaged = false) {
  Writer writer;
  writer.sub("Camera", "Sensor");
  writer.sub("Lidar", "Sensor");
  writer.disjoint("Camera", "Lidar");
  writer.sub_some("Camera", "observes", "Goal");
  if (has_ball) {
    writer.sub("BallCamera", "Camera");
    writer.sub_some("BallCamera", "observes", "Ball");
    writer.sub("RedBall", "Ball");
    writer.sub("RedBallCamera", "Camera");
    writer.sub_some("RedBallCamera", "observes", "RedBall");
  }
  return writer.finish(is_damaged);
}

/// As a part of sensors, and an axiom that could not be read.
compiled::Ontology make_unread() {
  Writer writer;
  writer.sub("Camera", "Sensor");
  writer.sub("Lidar", "Sensor");
  writer.sub("Sonar", "Sensor");
  writer.disjoint("Camera", "Lidar");
  writer.leave_out("owl:imports");
  return writer.finish();
}

}  // namespace

vocabulary::Vocabulary small_ontology(std::string_view name) {
  static const vocabulary::Vocabulary whole(make(true));
  static const vocabulary::Vocabulary without_ball(make(false));
  static const vocabulary::Vocabulary misspelt(make_misspelt());
  static const vocabulary::Vocabulary sensors(make_sensors(true));
  static const vocabulary::Vocabulary blind(make_sensors(false));
  static const vocabulary::Vocabulary damaged(make_sensors(true, true));
  static const vocabulary::Vocabulary frames(make_frames(false));
  static const vocabulary::Vocabulary other_frames(make_frames(true));
  static const vocabulary::Vocabulary unread(make_unread());
  static const vocabulary::Vocabulary units(make_units("105"));
  static const vocabulary::Vocabulary other_units(make_units("50"));
  if (name == "unread") return unread;
  if (name == "units") return units;
  if (name == "other-units") return other_units;
  if (name == "frames") return frames;
  if (name == "other-frames") return other_frames;
  if (name == "damaged") return damaged;
  if (name == "soccer") return whole;
  if (name == "misspelt") return misspelt;
  if (name == "deep") return vocabulary::Vocabulary(make_deep());
  if (name == "sensors") return sensors;
  if (name == "blind") return blind;
  return name == "ballless" ? without_ball : vocabulary::Vocabulary();
}

}  // namespace geminga::sim
