// The benchmark of the reasoner on given and made-up ontologies: ontologies that branch first, then time and memory
// from file to taxonomy, beside rapper and Konclude in the same run, then questions to a loaded ontology. Writes rows
// for tools/bench.
//
//   --smoke                   tiny sizes, one run each
//   GEMINGA_BENCH_FULL=1      350 000 classes, too, and Konclude on them: 10 GB and minutes
//   GEMINGA_BENCH_ONTOLOGY=F  only this RDF/XML file
#include <unistd.h>

#include <algorithm>
#include <boost/json.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/reasoner/child.hpp"
#include "bench/reasoner/hard.hpp"
#include "bench/reasoner/loaded.hpp"
#include "bench/reasoner/synthetic.hpp"
#include "bench/table.hpp"

namespace geminga::bench {
namespace {

namespace fs = std::filesystem;

/// The size above which the way from file to taxonomy must take half of Konclude's time, and below which it may take
/// twice the time of rapper.
constexpr std::size_t large = 18'000;
/// The targets of the project (its issue 3).
constexpr double of_konclude_classifying = 1.0 / 5;
constexpr double of_konclude_whole = 1.0 / 2;
constexpr double of_rapper = 2;
constexpr double of_one_thread = 1 / 1.7;
constexpr unsigned konclude_seconds = 600;

struct Settings {
  bool is_smoke = false;
  bool is_full = false;
  fs::path folder;
  [[nodiscard]] int runs(std::size_t classes) const { return is_smoke || classes > 100'000 ? 1 : 3; }
};

struct Stats {
  double load_ms = 0;
  double classify_ms = 0;
  std::size_t classes = 0;
};

Stats stats_of(const fs::path& path) {
  const boost::json::object document = boost::json::parse(content_of(path)).as_object();
  return {document.at("load_ms").to_number<double>(), document.at("classify_ms").to_number<double>(),
          document.at("classes").to_number<std::size_t>()};
}

std::string program() {
  const char* folder = std::getenv("GEMINGA_BENCH_BIN");
  return (folder == nullptr ? fs::path(GEMINGA_BINARY_DIR) / "bin" : fs::path(folder)) / "geminga-ontology";
}

/// Konclude's own milliseconds from the parsed ontology to the classified one.
double konclude_classifying(const std::string& said) {
  double sum = 0;
  for (const std::string_view step :
       {"Finished preprocessing in ", "Finished precomputing in ", "Finished class classification in "}) {
    const std::size_t at = said.find(step);
    if (at != std::string::npos) sum += std::strtod(said.c_str() + at + step.size(), nullptr);
  }
  return sum;
}

/// One ontology as RDF/XML and, if there is one, in the syntax that Konclude reads fastest.
class Measured {
 public:
  Measured(const Settings& settings, std::string name, fs::path rdf_xml, fs::path for_konclude)
      : settings_(settings),
        name_(std::move(name)),
        rdf_xml_(std::move(rdf_xml)),
        for_konclude_(std::move(for_konclude)) {}

  void measure() {
    const auto [first, one] = classify(1);
    if (first.status != 0) return row_without(name_, "-", "classify failed: " + content_of(err_).substr(0, 100));
    size_ = std::to_string(one.classes);
    const double rapper = measure_rapper(one.classes);
    const Konclude konclude = measure_konclude(one.classes);
    const bool is_large = one.classes > large;
    row(name_ + ": RDF/XML to closure, to Konclude", size_, first.milliseconds, "ms",
        {konclude.whole, is_large ? of_konclude_whole : 0});
    row(name_ + ": RDF/XML to closure, to rapper", size_, first.milliseconds, "ms", {rapper, is_large ? 0 : of_rapper});
    row(name_ + ": loading", size_, one.load_ms, "ms");
    row(name_ + ": classifying, 1 thread, to Konclude", size_, one.classify_ms, "ms",
        {konclude.classifying, of_konclude_classifying});
    row(name_ + ": peak memory, to Konclude", size_, first.peak_mebibytes, "MiB", {konclude.mebibytes, 0});
    const auto [second, two] = classify(2);
    if (second.status == 0)
      row(name_ + ": classifying, 2 threads, to 1", size_, two.classify_ms, "ms",
          {one.classify_ms, is_large ? of_one_thread : 0});
    const fs::path compiled = settings_.folder / "compiled.geminga";
    const Cost compiling = run({program(), "compile", rdf_xml_.string(), "-o", compiled.string()}, out_, err_);
    if (compiling.status != 0) return row_without(name_ + ": compiling", size_, "failed");
    row(name_ + ": RDF/XML to compiled file", size_, compiling.milliseconds, "ms");
    measure_loaded(compiled, name_, size_, settings_.is_smoke ? 1'000 : 1'000'000);
  }

 private:
  struct Konclude {
    double whole = 0;
    double classifying = 0;
    double mebibytes = 0;
  };

  std::pair<Cost, Stats> classify(unsigned threads) {
    const fs::path stats = settings_.folder / "stats.json";
    const std::vector<std::string> words{
        program(), "classify",     "--closure",      "--threads", std::to_string(threads),
        "--stats", stats.string(), rdf_xml_.string()};
    Cost best = run(words, out_, err_);
    if (best.status != 0) return {best, {}};
    Stats of_best = stats_of(stats);
    for (int more = 1; more < settings_.runs(of_best.classes); ++more) {
      const Cost cost = run(words, out_, err_);
      const Stats another = stats_of(stats);
      of_best.classify_ms = std::min(of_best.classify_ms, another.classify_ms);
      of_best.load_ms = std::min(of_best.load_ms, another.load_ms);
      if (cost.milliseconds < best.milliseconds) best = cost;
    }
    return {best, of_best};
  }

  double measure_rapper(std::size_t classes) {
    if (!is_installed("rapper")) {
      row_without(name_ + ": rapper -c", size_, "rapper is not installed");
      return 0;
    }
    const Cost cost = best_of(settings_.runs(classes), {"rapper", "-q", "-c", rdf_xml_.string()}, out_, err_);
    row(name_ + ": rapper -c", size_, cost.milliseconds, "ms");
    return cost.milliseconds;
  }

  Konclude measure_konclude(std::size_t classes) {
    const std::string name = name_ + ": Konclude, 2 threads";
    if (!is_installed("Konclude")) {
      row_without(name, size_, "Konclude is not installed");
      return {};
    }
    if (classes > 100'000 && !settings_.is_full) {
      row_without(name, size_, "only with --full: it takes 10 GB");
      return {};
    }
    // It hangs with one thread.
    const Cost cost = best_of(settings_.runs(classes),
                              {"timeout", std::to_string(konclude_seconds), "Konclude", "classification", "-w", "2",
                               "-i", for_konclude_.string(), "-o", (settings_.folder / "konclude.owx").string()},
                              out_, err_);
    if (cost.status != 0) {
      row_without(name, size_, "ended with status " + std::to_string(cost.status));
      return {};
    }
    const double classifying = konclude_classifying(content_of(out_) + content_of(err_));
    row(name + ", whole", size_, cost.milliseconds, "ms");
    row(name + ", classifying", size_, classifying, "ms");
    row(name + ", peak memory", size_, cost.peak_mebibytes, "MiB");
    return {cost.milliseconds, classifying, cost.peak_mebibytes};
  }

  const Settings& settings_;
  std::string name_;
  fs::path rdf_xml_;
  fs::path for_konclude_;
  std::string size_ = "-";
  fs::path out_ = settings_.folder / "out";
  fs::path err_ = settings_.folder / "err";
};

void measure_synthetic(const Settings& settings, std::uint32_t classes) {
  const Synthetic made = make_synthetic(classes, 1);
  const fs::path rdf_xml = settings.folder / "synthetic.rdf";
  const fs::path functional = settings.folder / "synthetic.ofn";
  for (const bool is_functional : {false, true}) {
    std::FILE* file = std::fopen((is_functional ? functional : rdf_xml).c_str(), "w");
    if (file == nullptr) return row_without("synthetic", std::to_string(classes), "it cannot be written");
    (is_functional ? write_functional : write_rdf_xml)(made, file);
    std::fclose(file);
  }
  Measured(settings, "synthetic", rdf_xml, functional).measure();
}

/// The folder that has the folder ontologies; empty: there is none.
fs::path data_folder() {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const fs::path& folder :
       {fs::path(named == nullptr ? "" : named), fs::path(GEMINGA_SOURCE_DIR) / ".." / "shared" / "data"}) {
    if (!folder.empty() && fs::is_directory(folder / "ontologies")) return folder;
  }
  return {};
}

void measure_given(const Settings& settings) {
  const fs::path data = data_folder();
  if (data.empty()) return row_without("given ontologies", "-", "none in $GEMINGA_TEST_DATA or ../shared/data");
  const fs::path ontologies = data / "ontologies";
  for (const auto& [name, file] : {std::pair{"SOMA", "soma/all-modules-merged.rdf"},
                                   {"IEEE 1872", "ieee1872/cora-fullaxiom.owl"},
                                   {"GALEN", "galen/galen.owl"}}) {
    if (fs::exists(ontologies / file)) Measured(settings, name, ontologies / file, ontologies / file).measure();
  }
}

void measure_all(const Settings& settings) {
  if (const char* only = std::getenv("GEMINGA_BENCH_ONTOLOGY"); only != nullptr)
    return Measured(settings, fs::path(only).filename(), only, only).measure();
  measure_hard({settings.is_smoke, program(), settings.folder, data_folder()});
  if (settings.is_smoke) return measure_synthetic(settings, 300);
  measure_given(settings);
  for (const std::uint32_t classes : {5'000U, 20'000U, 50'000U}) measure_synthetic(settings, classes);
  if (settings.is_full) measure_synthetic(settings, 350'000);
}

}  // namespace
}  // namespace geminga::bench

int main(int argc, char** argv) {
  using namespace geminga::bench;
  const char* full = std::getenv("GEMINGA_BENCH_FULL");
  Settings settings{argc > 1 && std::string_view(argv[1]) == "--smoke", full != nullptr && *full == '1', {}};
  std::string folder = std::filesystem::temp_directory_path() / "geminga-bench-XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr) return 1;
  settings.folder = folder;
  int status = 0;
  try {
    measure_all(settings);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    status = 1;
  }
  std::error_code ignored;
  std::filesystem::remove_all(settings.folder, ignored);
  return status;
}
