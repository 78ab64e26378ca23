#include "bench/reasoner/hard.hpp"

#include <array>
#include <boost/json.hpp>
#include <fstream>

#include "bench/reasoner/child.hpp"
#include "bench/table.hpp"
#include "compare/functional_syntax.hpp"
#include "compare/shapes.hpp"

namespace geminga::bench {
namespace {

namespace fs = std::filesystem;

/// The targets of the project (its issue 9).
constexpr double of_konclude_time = 1;
constexpr double of_konclude_memory = 1.0 / 2;
/// The time limit of each run. A run that is cut off says so, and its figures are those until then.
constexpr const char* our_seconds = "100";
constexpr const char* konclude_seconds = "100";
/// The longest run that is repeated; the fastest of the repetitions counts.
constexpr int runs_of_short_ones = 3;
constexpr double short_milliseconds = 5000;

constexpr std::array published{"bfo-1.1.owl", "amino-acid.owl",  "people.owl",   "pizza.owl",
                               "ogms.owl",    "tambis-full.owl", "sweet.owl.gz", "zp-el.ofn.gz"};

class Hard {
 public:
  explicit Hard(const HardSettings& settings) : settings_(settings), has_konclude_(is_installed("Konclude")) {
    if (!has_konclude_) row_without("hard: Konclude, 2 threads", "-", "Konclude is not installed");
  }

  void measure(const std::string& name, const fs::path& file) {
    const fs::path stats = settings_.folder / "stats.json";
    const Cost ours = cheapest({settings_.program, "classify", "--closure", "--threads", "1", "--time-limit",
                                our_seconds, "--stats", stats.string(), file.string()});
    constexpr int cut_off = 4;
    if (ours.status != 0 && ours.status != cut_off)
      return row_without(name, "-", "classify failed: " + content_of(err_).substr(0, 100));
    const std::string size = classes_in(stats);
    if (ours.status == cut_off) row_without(name, size, "not finished in " + std::string(our_seconds) + " s");
    const Cost konclude = has_konclude_ ? of_konclude(name, size, file) : Cost{};
    const bool has_ended = ours.status == 0;
    const auto goal = [&](double baseline, double ratio) { return Goal{baseline, has_ended ? ratio : 0, 0}; };
    row(name + ": elapsed, to Konclude", size, ours.milliseconds, "ms", goal(konclude.milliseconds, of_konclude_time));
    row(name + ": processor time, to Konclude", size, ours.user_milliseconds, "ms",
        goal(konclude.user_milliseconds, 0));
    row(name + ": peak memory, to Konclude", size, ours.peak_mebibytes, "MiB",
        goal(konclude.peak_mebibytes, of_konclude_memory));
  }

  void measure(const std::string& name, const owl::Ontology& source) {
    const fs::path file = settings_.folder / "shape.ofn";
    std::ofstream(file, std::ios::binary) << compare::functional_syntax(source);
    measure(name, file);
  }

 private:
  Cost cheapest(const std::vector<std::string>& words) {
    const Cost first = run(words, out_, err_);
    if (settings_.is_smoke || first.status != 0 || first.milliseconds > short_milliseconds) return first;
    const Cost later = best_of(runs_of_short_ones - 1, words, out_, err_);
    return later.milliseconds < first.milliseconds ? later : first;
  }

  static std::string classes_in(const fs::path& stats) {
    return std::to_string(boost::json::parse(content_of(stats)).at("classes").to_number<std::size_t>());
  }

  /// The cost of Konclude; zeros if it failed. It hangs with one thread, and does not read packed files.
  Cost of_konclude(const std::string& name, const std::string& size, const fs::path& file) {
    fs::path plain = file;
    if (file.extension() == ".gz") {
      plain = settings_.folder / file.stem();
      if (const Cost unpacked = run({"gzip", "-dc", file.string()}, plain, err_); unpacked.status != 0) {
        row_without(name + ": Konclude, 2 threads", size, "gzip cannot unpack it");
        return {};
      }
    }
    const Cost cost = cheapest({"timeout", konclude_seconds, "Konclude", "classification", "-w", "2", "-i",
                                plain.string(), "-o", (settings_.folder / "konclude.owx").string()});
    if (cost.status == 0) return cost;
    row_without(name + ": Konclude, 2 threads", size, "ended with status " + std::to_string(cost.status));
    return {};
  }

  const HardSettings& settings_;
  const bool has_konclude_;
  fs::path out_ = settings_.folder / "out";
  fs::path err_ = settings_.folder / "err";
};

}  // namespace

void measure_hard(const HardSettings& settings) {
  using compare::Covering;
  Hard hard(settings);
  const fs::path folder = settings.data / "ontologies" / "tbox-hard";
  if (!settings.is_smoke && !settings.data.empty() && fs::is_directory(folder)) {
    for (const char* file : published) {
      if (fs::exists(folder / file)) {
        hard.measure(file, folder / file);
      } else {
        row_without(file, "-", "not in ontologies/tbox-hard");
      }
    }
  } else if (!settings.is_smoke) {
    row_without("published ontologies that branch", "-",
                "no ontologies/tbox-hard in $GEMINGA_TEST_DATA or ../shared/data");
  }
  const std::size_t tree = settings.is_smoke ? 40 : 10'000;
  const std::size_t members = settings.is_smoke ? 20 : 10'000;
  hard.measure("tree of disjoint unions", compare::covering_tree(Covering::disjoint_union, tree, 3));
  hard.measure("tree of unions, disjoint in pairs", compare::covering_tree(Covering::pairwise_disjoint, tree, 3));
  hard.measure("oneOf " + std::to_string(members) + " individuals", compare::enumeration(1, members));
  for (const std::size_t holes : settings.is_smoke ? std::vector<std::size_t>{3} : std::vector<std::size_t>{8, 12})
    hard.measure("pigeonhole of " + std::to_string(holes), compare::pigeonhole(holes));
}

}  // namespace geminga::bench
