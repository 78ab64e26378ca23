// The quality of rankings: a collection over the ontologies that ship, with relevance judged by hand for each concept,
// compared with matching by degrees alone.
//
// The judgements are those of a person who builds rescue robots, for each concept beside a wanted or a given one, from
// 3 (the same) to 0 (not listed). They were made without the score, and differ from the taxonomy where people do: a
// sign of life is of some use in a search for victims, although the taxonomy has it far away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <ranges>
#include <set>
#include <sstream>

#include "base/random.hpp"
#include "collection.hpp"
#include "program.hpp"

namespace geminga::ontology {
namespace {

/// The grades for one parameter of a request: its own concept first, then others.
struct Judged {
  std::string own;
  std::map<std::string, int> grades;
};

struct JudgedRequest {
  std::string name;
  std::vector<Judged> inputs;
  std::vector<Judged> outputs;
};

const std::vector<JudgedRequest>& requests() {
  static const std::vector<JudgedRequest> all{
      {"victim_from_aerial",
       {{"r:AerialImage",
         {{"r:AerialImage", 3},
          {"g:Image", 3},
          {"r:AerialObservation", 3},
          {"g:SensorReading", 2},
          {"r:AerialThermalImage", 2},
          {"r:ThermalImage", 2}}}},
       {{"r:Victim",
         {{"r:Victim", 3},
          {"r:TrappedVictim", 3},
          {"r:Person", 2},
          {"r:Rescuer", 1},
          {"r:SignOfLife", 1},
          {"r:BodyHeat", 1}}}}},
      {"grid_from_scan",
       {{"r:LaserScan", {{"r:LaserScan", 3}, {"g:RangeScan", 3}, {"g:SensorReading", 2}, {"r:PointCloud", 2}}}},
       {{"r:OccupancyMap",
         {{"r:OccupancyMap", 3},
          {"r:SiteMap", 2},
          {"r:ElevationMap", 2},
          {"g:SharedWorldModel", 1},
          {"g:WorldModel", 1}}}}},
      {"waypoint_from_fix_and_map",
       {{"r:SatelliteFix",
         {{"r:SatelliteFix", 3}, {"g:Position", 3}, {"g:Localization", 3}, {"g:Pose", 2}, {"g:RobotPose", 1}}},
        {"r:SiteMap",
         {{"r:SiteMap", 3},
          {"g:SharedWorldModel", 3},
          {"g:WorldModel", 3},
          {"r:OccupancyMap", 2},
          {"r:ElevationMap", 2}}}},
       {{"r:Waypoint", {{"r:Waypoint", 3}, {"g:NavigationGoal", 2}, {"g:Path", 1}}}}},
      {"pose_from_odometry_and_image",
       {{"r:WheelOdometry",
         {{"r:WheelOdometry", 3}, {"g:Odometry", 3}, {"g:Localization", 2}, {"r:VisualOdometry", 1}}},
        {"g:Image", {{"g:Image", 3}, {"g:SensorReading", 2}, {"r:AerialImage", 2}, {"r:ThermalImage", 1}}}},
       {{"g:RobotPose",
         {{"g:RobotPose", 3},
          {"g:Pose", 2},
          {"r:FlightState", 3},
          {"g:Localization", 2},
          {"g:Position", 1},
          {"r:SatelliteFix", 1}}}}},
      {"life_from_sound",
       {{"r:Sound", {{"r:Sound", 3}, {"g:SensorReading", 3}, {"g:Observation", 2}, {"r:Voice", 2}}}},
       {{"r:SignOfLife", {{"r:SignOfLife", 3}, {"r:Voice", 3}, {"r:BodyHeat", 3}, {"g:Observation", 1}}}}},
      {"hazard_from_gas",
       {{"r:GasConcentration", {{"r:GasConcentration", 3}, {"g:SensorReading", 3}}}},
       {{"r:Hazard", {{"r:Hazard", 3}, {"r:Fire", 3}, {"r:UnstableStructure", 3}}}}},
      {"return_when_empty",
       {{"r:BatteryStatus", {{"r:BatteryStatus", 3}, {"g:PowerStatus", 3}, {"g:StatusReport", 2}}},
        {"r:SatelliteFix", {{"r:SatelliteFix", 3}, {"g:Position", 3}, {"g:Localization", 3}, {"g:Pose", 2}}}},
       {{"r:ReturnToBase",
         {{"r:ReturnToBase", 3},
          {"g:BehaviourCommand", 2},
          {"g:ControlCommand", 1},
          {"r:TakeOff", 1},
          {"r:EmergencyStop", 1}}}}},
      {"obstacles_from_cloud",
       {{"r:PointCloud", {{"r:PointCloud", 3}, {"g:SensorReading", 3}, {"g:RangeScan", 2}, {"r:LaserScan", 2}}}},
       {{"g:Obstacle",
         {{"g:Obstacle", 3},
          {"r:Debris", 3},
          {"r:OverheadLine", 3},
          {"r:UnstableStructure", 3},
          {"s:ObstacleInfo", 3},
          {"g:ObservedObject", 1},
          {"r:Hazard", 1}}}}},
      {"landing_site",
       {{"r:ElevationMap",
         {{"r:ElevationMap", 3}, {"r:SiteMap", 3}, {"g:SharedWorldModel", 2}, {"r:OccupancyMap", 2}}}},
       {{"r:LandingSite", {{"r:LandingSite", 3}, {"g:FreeSpace", 2}, {"r:PassableGround", 1}}}}},
      {"motion_to_goal",
       {{"g:NavigationGoal",
         {{"g:NavigationGoal", 3}, {"r:Waypoint", 2}, {"g:ControlCommand", 3}, {"s:DriveToPointInfo", 2}}}},
       {{"g:MotionCommand",
         {{"g:MotionCommand", 3},
          {"r:DriveCommand", 3},
          {"r:FlightCommand", 3},
          {"g:ControlCommand", 1},
          {"s:MotionControl", 3}}}}},
      {"ball_from_image",
       {{"g:Image", {{"g:Image", 3}, {"g:SensorReading", 3}, {"r:AerialImage", 1}, {"r:ThermalImage", 1}}}},
       {{"s:BallInfo",
         {{"s:BallInfo", 3},
          {"s:SharedBallInfo", 3},
          {"s:NegotiatedBallInfo", 3},
          {"s:TrackedObjectInfo", 2},
          {"s:TrackedObject", 2},
          {"s:OpponentInfo", 1}}}}},
      {"ball_and_goal",
       {{"g:Image", {{"g:Image", 3}, {"g:SensorReading", 3}}}},
       {{"s:BallInfo",
         {{"s:BallInfo", 3}, {"s:SharedBallInfo", 3}, {"s:NegotiatedBallInfo", 3}, {"s:TrackedObjectInfo", 2}}},
        {"s:GoalInfo",
         {{"s:GoalInfo", 3},
          {"s:YellowGoalInfo", 3},
          {"s:BlueGoalInfo", 3},
          {"s:FieldLandmark", 2},
          {"g:Landmark", 2}}}}},
      {"team_task",
       {{"r:TaskBid", {{"r:TaskBid", 3}, {"g:TeamCoordination", 3}}},
        {"r:TaskOffer", {{"r:TaskOffer", 3}, {"g:TeamCoordination", 3}}}},
       {{"r:TaskAward", {{"r:TaskAward", 3}, {"g:TeamCoordination", 2}}}}},
      {"any_map",
       {},
       {{"r:SiteMap",
         {{"r:SiteMap", 3},
          {"r:OccupancyMap", 3},
          {"r:ElevationMap", 3},
          {"g:SharedWorldModel", 2},
          {"g:WorldModel", 1}}}}},
  };
  return all;
}

constexpr std::array strangers{"r:RadioLinkStatus", "r:GripperStatus", "r:WinchCommand", "r:Sighting",
                               "s:CompassInfo",     "g:Velocity",      "g:Area",         "s:FreeAreaInfo",
                               "s:KickInfo",        "g:SimulationData"};

std::string iri(const std::string& name) {
  const char* const ontology = name[0] == 'r' ? "rescue#" : name[0] == 's' ? "soccer#" : "core#";
  return std::string("https://geminga.example/") + ontology + name.substr(2);
}

std::vector<std::string> iris(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(iri(name));
  return all;
}

struct Service {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  auto operator<=>(const Service&) const = default;
};

std::vector<std::string> own(const std::vector<Judged>& side) {
  std::vector<std::string> names;
  for (const Judged& judged : side) names.push_back(judged.own);
  return names;
}

/// Variations of the requests (a similar concept, one too few, one too many, an unrelated one), and services that have
/// nothing in common with any request.
std::vector<Service> services(std::uint64_t seed) {
  base::Random random(seed);
  const auto one_of = [&](const std::vector<std::string>& names) { return names[random.below(names.size())]; };
  std::set<std::string> all_inputs(strangers.begin(), strangers.end());
  std::set<std::string> all_outputs = all_inputs;
  for (const JudgedRequest& request : requests()) {
    for (const Judged& judged : request.inputs)
      std::ranges::copy(std::views::keys(judged.grades), std::inserter(all_inputs, all_inputs.end()));
    for (const Judged& judged : request.outputs)
      std::ranges::copy(std::views::keys(judged.grades), std::inserter(all_outputs, all_outputs.end()));
  }
  const std::vector<std::string> inputs(all_inputs.begin(), all_inputs.end());
  const std::vector<std::string> outputs(all_outputs.begin(), all_outputs.end());
  const auto vary = [&](const std::vector<Judged>& side, const std::vector<std::string>& any) {
    std::vector<std::string> names;
    for (const Judged& judged : side)
      names.push_back(
          std::next(judged.grades.begin(), static_cast<std::ptrdiff_t>(random.below(judged.grades.size())))->first);
    const std::uint64_t kind = random.below(10);
    if (kind == 0 && names.size() > 1) names.pop_back();
    if (kind == 1) names.push_back(one_of(any));
    if (kind <= 3 && kind >= 2 && !names.empty()) names[random.below(names.size())] = one_of(any);
    return names;
  };
  std::set<Service> made;
  for (const JudgedRequest& request : requests()) {
    for (int round = 0; round < 40; ++round)
      made.insert({vary(request.inputs, inputs), vary(request.outputs, outputs)});
  }
  for (int round = 0; round < 400; ++round) {
    Service service;
    for (std::uint64_t left = random.below(3); left > 0; --left) service.inputs.push_back(one_of(inputs));
    for (std::uint64_t left = 1 + random.below(2); left > 0; --left) service.outputs.push_back(one_of(outputs));
    made.insert(std::move(service));
  }
  std::vector<Service> all(made.begin(), made.end());
  for (std::size_t at = all.size(); at > 1; --at) std::swap(all[at - 1], all[random.below(at)]);
  return all;
}

/// The mean of the best grades of the judged parameters, each by a different parameter.
int grade(const std::vector<Judged>& side, std::vector<std::string> names) {
  if (side.empty()) return 3;
  names.resize(std::max(names.size(), side.size()));
  std::ranges::sort(names);
  int best = 0;
  do {
    int sum = 0;
    for (std::size_t at = 0; at < side.size(); ++at) {
      const auto found = side[at].grades.find(names[at]);
      sum += found == side[at].grades.end() ? 0 : found->second;
    }
    best = std::max(best, sum);
  } while (std::ranges::next_permutation(names).found);
  return best / static_cast<int>(side.size());
}

/// The grade of a service: both sides must be right, and each unrelated input costs a grade.
int relevance(const JudgedRequest& request, const Service& service) {
  int inputs = grade(request.inputs, service.inputs);
  for (const std::string& name : service.inputs) {
    const bool is_known =
        std::ranges::any_of(request.inputs, [&](const Judged& judged) { return judged.grades.contains(name); });
    if (!is_known) --inputs;
  }
  if (service.inputs.empty() != request.inputs.empty()) inputs = std::max(inputs, 1);
  return std::max(0, std::min(grade(request.outputs, service.outputs), inputs));
}

/// "Is A below B", from the output of `classify --closure`.
class Closure {
 public:
  explicit Closure(const Program& program) {
    std::istringstream lines(program.run({"classify", "--closure", shipped()}).out);
    for (std::string line; std::getline(lines, line);) pairs_.insert(line);
  }
  [[nodiscard]] bool is_below(const std::string& sub, const std::string& super) const {
    return sub == super || pairs_.contains(iri(sub) + '\t' + iri(super));
  }
  [[nodiscard]] bool empty() const { return pairs_.empty(); }

 private:
  std::set<std::string> pairs_;
};

/// The degree of one parameter: 3 exact, 2 in the safe direction, 1 in the other, 0 fail.
int degree(const Closure& closure, const std::string& required, const std::string& offered) {
  if (required == offered) return 3;
  if (closure.is_below(offered, required)) return 2;
  return closure.is_below(required, offered) ? 1 : 0;
}

/// The worst of the best degrees of all parameters.
int degree(const Closure& closure, const std::vector<std::string>& required, const std::vector<std::string>& offered) {
  int worst = 3;
  for (const std::string& one : required) {
    int best = 0;
    for (const std::string& other : offered) best = std::max(best, degree(closure, one, other));
    worst = std::min(worst, best);
  }
  return worst;
}

/// The average precision of services in the order of a number, the largest first. Equal ones stay in the order of the
/// collection, which is random.
double average_precision(const std::vector<double>& scores, const std::vector<int>& grades) {
  std::vector<std::size_t> order(scores.size());
  for (std::size_t at = 0; at < order.size(); ++at) order[at] = at;
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t at) { return scores[at]; });
  double sum = 0;
  double found = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (grades[order[rank]] > 0) sum += ++found / static_cast<double>(rank + 1);
  }
  return found > 0 ? sum / found : 0;
}

/// The scores of the program by request and service.
std::map<std::string, std::vector<double>> scores_of(const Program& program, const std::vector<Service>& all) {
  std::filesystem::create_directories(program.folder() / "services");
  std::filesystem::create_directories(program.folder() / "requests");
  for (std::size_t at = 0; at < all.size(); ++at)
    program.write("services/" + std::to_string(at) + ".owls", owls(iris(all[at].inputs), iris(all[at].outputs)));
  for (const JudgedRequest& request : requests())
    program.write("requests/" + request.name + ".owls", owls(iris(own(request.inputs)), iris(own(request.outputs))));
  const Outcome outcome =
      program.run({"rank", "--services", "services", "--requests", "requests", "--ontologies", shipped()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, std::vector<double>> scores;
  std::istringstream lines(outcome.out);
  std::string request;
  std::string rank;
  std::string service;
  for (double score = 0; lines >> request >> rank >> service >> score;) {
    std::vector<double>& of = scores[request.substr(0, request.find('.'))];
    of.resize(all.size());
    of[std::stoul(service)] = score;
  }
  return scores;
}

TEST(RankQuality, IsAboveTheBarAndAboveAllThatOnlyKnowsDegrees) {
  const Program program;
  const Closure closure(program);
  ASSERT_FALSE(closure.empty());
  double mean = 0;
  double exact_mean = 0;
  double owls_m0_mean = 0;
  double paolucci_mean = 0;
  const std::vector<Service> all = services(5);
  auto scores = scores_of(program, all);
  for (const JudgedRequest& request : requests()) {
    std::vector<int> grades;
    std::vector<double> exact;
    std::vector<double> owls_m0;
    std::vector<double> paolucci;
    for (const Service& service : all) {
      grades.push_back(relevance(request, service));
      const int outputs = degree(closure, own(request.outputs), service.outputs);
      const int inputs = degree(closure, service.inputs, own(request.inputs));
      exact.push_back(outputs == 3 && inputs == 3 ? 1 : 0);
      // Only services whose inputs can all be given: exact, plug-in and subsumes, subsumed-by, fail.
      owls_m0.push_back(inputs < 2 ? 0 : std::min(outputs, inputs == 3 ? 3 : 2));
      // By the degree of outputs, and where it is the same by that of inputs.
      paolucci.push_back(outputs * 4 + inputs);
    }
    ASSERT_EQ(scores[request.name].size(), all.size());
    const double precision = average_precision(scores[request.name], grades);
    EXPECT_GE(precision, 0.5) << request.name;
    mean += precision;
    exact_mean += average_precision(exact, grades);
    owls_m0_mean += average_precision(owls_m0, grades);
    paolucci_mean += average_precision(paolucci, grades);
  }
  const auto count = static_cast<double>(requests().size());
  RecordProperty("precision", std::to_string(mean / count));
  std::cout << "average precision of " << all.size() << " services: " << mean / count << ", exact "
            << exact_mean / count << ", OWLS-M0 " << owls_m0_mean / count << ", Paolucci " << paolucci_mean / count
            << '\n';
  EXPECT_GE(mean / count, 0.82);
  EXPECT_LT(exact_mean / count, mean / count - 0.4);
  EXPECT_LT(owls_m0_mean / count, mean / count - 0.2);
  EXPECT_LT(paolucci_mean / count, mean / count - 0.1);
}

}  // namespace
}  // namespace geminga::ontology
