#include "sim/small_ontology.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::sim {
namespace {

using Bytes = std::vector<std::byte>;

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
  [[nodiscard]] Bytes finish(bool is_damaged = false) const {
    const auto classification = el::classify(source_);
    GEMINGA_ASSERT(classification.has_value());
    Bytes bytes = compiled::compile(source_, *classification);
    if (is_damaged) bytes.back() ^= std::byte{1};
    return bytes;
  }

 private:
  owl::TermId named(const char* name) { return source_.named_class(std::string(soccer) + name); }
  owl::Ontology source_;
  owl::FileId file_;
  std::uint32_t line_ = 0;
};

Bytes make(bool has_ball) {
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
Bytes make_misspelt() {
  Writer writer;
  writer.sub("TrackedObject", "Information");
  writer.sub("Bal", "TrackedObject");
  return writer.finish();
}

/// A long way up, from Level100 to Level220.
Bytes make_deep() {
  Writer writer;
  for (int level = 100; level < 500; ++level) {
    writer.sub(("Level" + std::to_string(level)).c_str(), ("Level" + std::to_string(level + 1)).c_str());
  }
  return writer.finish();
}

/// Balls in frames that are turned into each other; the other form: by another way for the same cost.
Bytes make_frames(bool is_other_way) {
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
Bytes make_units(const char* pitch) {
  Writer writer;
  writer.sub("Ball", "TrackedObject");
  writer.unit("Pitch", "pitch", pitch);
  writer.unit("Goal", "goal", "7.32");
  return writer.finish();
}

/// For class expressions: cameras that observe balls, and a lidar.
Bytes make_sensors(bool has_ball, bool is_damaged = false, bool has_sonar = false) {
  Writer writer;
  if (has_sonar) writer.sub("Sonar", "Sensor");
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
Bytes make_unread() {
  Writer writer;
  writer.sub("Camera", "Sensor");
  writer.sub("Lidar", "Sensor");
  writer.sub("Sonar", "Sensor");
  writer.disjoint("Camera", "Lidar");
  writer.leave_out("owl:imports");
  return writer.finish();
}

/// 1111 classes: C0 above C1 to C10, each of these above ten, and each of those above ten.
Bytes make_tree(bool is_other) {
  constexpr int classes = 1111;
  Writer writer;
  for (int i = 1; i < classes; ++i) {
    writer.sub(("C" + std::to_string(i)).c_str(), ("C" + std::to_string((i - 1) / 10)).c_str());
  }
  if (is_other) writer.sub("Further", "C0");
  return writer.finish();
}

}  // namespace

std::optional<Bytes> compiled_small_ontology(std::string_view name) {
  if (name == "soccer" || name == "ballless") return make(name == "soccer");
  if (name == "other-sensors") return make_sensors(true, false, true);
  if (name == "sensors" || name == "blind" || name == "damaged")
    return make_sensors(name != "blind", name == "damaged");
  if (name == "frames" || name == "other-frames") return make_frames(name == "other-frames");
  if (name == "units" || name == "other-units") return make_units(name == "units" ? "105" : "50");
  if (name == "unread") return make_unread();
  if (name == "misspelt") return make_misspelt();
  if (name == "deep") return make_deep();
  if (name == "tree" || name == "other-tree") return make_tree(name == "other-tree");
  return std::nullopt;
}

vocabulary::Vocabulary small_ontology(std::string_view name) {
  static std::map<std::string, vocabulary::Vocabulary, std::less<>> known;
  if (const auto found = known.find(name); found != known.end()) return found->second;
  auto bytes = compiled_small_ontology(name);
  if (!bytes) return {};
  auto ontology = compiled::Ontology::from_bytes(std::move(*bytes));
  GEMINGA_ASSERT(ontology.has_value());
  return known.emplace(name, std::move(*ontology)).first->second;
}

}  // namespace geminga::sim
