// `query why` of every pair of random teams against what their peers are told: it says that they match exactly where
// they do, names the first of its own checks that stands in the way, and the questions about one side agree with it.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>

#include "base/random.hpp"
#include "discovery/gcnp/statement.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/small_ontology.hpp"
#include "sim/world.hpp"
#include "support/rounds.hpp"

namespace geminga::participant {
namespace {

using gcnp::Statement;

constexpr std::array order{"identity", "mode", "protocol",  "provider",   "scope",
                           "where",    "for",  "signature", "arbitration"};

/// One team whose statements are all different, after it has come to rest.
class RestingTeam {
 public:
  explicit RestingTeam(std::uint64_t seed) : random_(seed), world_(seed) {
    for (const char* name : {"robot1", "robot2"}) {
      sim::Host& host = world_.add_host(name);
      host.settings.limits.statements_per_second = 1'000'000;
      host.ontology = sim::small_ontology("frames");
      host.switch_on();
      hosts_.push_back(&host);
    }
    world_.run_for(std::chrono::milliseconds(200));
    for (const char* name : {"a", "b", "c", "asking1", "asking2"}) {
      sim::Client& client = world_.add_client(name);
      client.connect(host_of(client));
      client.say("0 sys hello name=" + client.name());
      world_.run_for(std::chrono::milliseconds(1));
      clients_.push_back(&client);
    }
    for (std::size_t i = 0; i < 3; ++i) state(*clients_[i]);
    world_.run_for(std::chrono::seconds(20));
  }

  void check_everything() {
    std::map<std::string, bool> used;
    std::map<std::string, int> taken;
    for (const Stated& request : requests_) {
      int meeting = 0;
      for (const Stated& service : services_) {
        SCOPED_TRACE(request.text + " / " + service.text);
        const bool is_given = request.client->view(request.number).contains(service.word);
        const bool meets = check_pair(request, service, is_given);
        if (testing::Test::HasFailure()) return;
        meeting += meets ? 1 : 0;
        used[service.word] |= meets;
        taken[service.word] += is_given ? 1 : 0;
      }
      SCOPED_TRACE(request.text);
      check_request(request, meeting);
      if (testing::Test::HasFailure()) return;
    }
    for (const Stated& service : services_) {
      SCOPED_TRACE(service.text);
      check_service(service, used[service.word], taken[service.word]);
      if (testing::Test::HasFailure()) return;
    }
  }

 private:
  struct Stated {
    sim::Client* client;
    std::uint32_t number;
    std::string word;
    std::string text;
  };

  sim::Host& host_of(const sim::Client& client) {
    return *hosts_[client.name() == "c" || client.name() == "asking2" ? 1 : 0];
  }

  template <std::size_t size>
  std::string one_of(const std::array<const char*, size>& words) {
    return words[random_.below(size)];
  }
  std::string perhaps(double chance, const std::string& text) { return random_.chance(chance) ? " " + text : ""; }
  std::string frame() {
    return "soccer:" + one_of<7>({"RobotPolar", "RobotCartesian", "FieldPolar", "FieldCartesian", "RobotFrame",
                                  "MyRobotPolar", "CameraPixels"});
  }
  std::string identity() {
    if (random_.chance(0.1)) return one_of<3>({"text=kick", "text=kcik", "id=7"});
    return "concept=soccer:" + one_of<3>({"Ball", "TrackedObject", "CameraFrame"}) +
           perhaps(0.6, "representation=" + frame());
  }
  std::string mode() { return "mode=" + one_of<4>({"oto", "oto", "otm/pubsub", "otm/stream"}) + " "; }

  std::string some_service() {
    return mode() + identity() + " port=1" + perhaps(0.3, "protocol=tcp") + perhaps(0.3, "priority=1") +
           perhaps(0.5, "rate=" + std::to_string(random_.below(4))) + perhaps(0.15, "scope=!host") +
           perhaps(0.15, "for=\"name = " + one_of<2>({"a", "c"}) + "\"") +
           perhaps(0.2, "outputs=soccer:" + one_of<2>({"Ball", "TrackedObject"})) +
           perhaps(0.15, "inputs=soccer:Ball") +
           perhaps(0.4, "converts=" + frame() + ">" + frame() + " cost=" + std::to_string(1 + random_.below(4)));
  }
  std::string some_request() {
    const std::string kind = mode();
    return kind + identity() + " match=" + one_of<5>({"exact", "narrower", "narrower", "broader", "overlapping"}) +
           perhaps(0.5, "convert=" + one_of<3>({"yes", "3", "11"})) + perhaps(0.2, "protocol=tcp") +
           perhaps(0.2, "provider=" + one_of<2>({"robot1", "robot2/c"})) + perhaps(0.2, "favour=robot2") +
           perhaps(0.2, "prefer=\"rate desc by 1\"") + perhaps(0.2, "rank=degree") +
           perhaps(0.15, "scope=" + one_of<2>({"host", "!host"})) + perhaps(0.2, "where=\"rate > 1\"") +
           perhaps(0.15, "outputs=soccer:Ball") + perhaps(0.1, "inputs=soccer:Ball") +
           // The choice of a consumer of a stream on another host is not known here.
           (kind == "mode=otm/stream " ? "" : perhaps(0.6, "limit=" + std::to_string(random_.below(3))));
  }

  void state(sim::Client& client) {
    for (std::uint32_t number = 1; number <= 14; ++number) {
      const bool is_service = number % 2 == 0;
      const std::string text = is_service ? some_service() : some_request();
      client.say(std::to_string(number) + (is_service ? " pub create " : " sub create ") + text);
      const std::string word = client.participant() + "/" + client.peer() + "/" + std::to_string(number);
      (is_service ? services_ : requests_).push_back({&client, number, word, word + " " + text});
      world_.run_for(std::chrono::milliseconds(random_.below(300)));
    }
  }

  /// The lines of an answer, its end the last, by whom is on the host of a client.
  std::vector<Statement> ask(const sim::Client& near, const std::string& query) {
    sim::Client& asking = *clients_[&host_of(near) == hosts_[0] ? 3 : 4];
    std::vector<Statement> answer;
    asking.on_line = [&](std::string_view, const Statement& line) {
      if (line.id == 900) answer.push_back(line);
    };
    asking.say("900 query " + query);
    for (int i = 0; i < 100 && (answer.empty() || answer.back().subcommand != "end"); ++i) {
      world_.run_for(std::chrono::milliseconds(5));
    }
    asking.on_line = {};
    EXPECT_FALSE(answer.empty() || answer.back().subcommand != "end") << query;
    if (answer.empty()) answer.emplace_back();
    return answer;
  }

  static std::string value(const Statement& line, std::string_view key) {
    for (const auto& one : line.parameters) {
      if (one.key == key) return one.value.value_or("");
    }
    return "";
  }

  /// The provider's host knows that a consumer has chosen another, and not whether that one was there first.
  static std::string kind_of(const std::string& code) { return code == "incumbent" ? "outranked" : code; }

  /// Why it is in a list; empty where it is not.
  std::string listed(const Stated& stated, const std::string& query, const char* key) {
    for (const Statement& line : ask(*stated.client, query)) {
      if (value(line, key) == stated.word) return value(line, "why");
    }
    return "";
  }

  /// Whether they meet, chosen or not.
  bool check_pair(const Stated& request, const Stated& service, bool is_given) {
    const auto answer = ask(*request.client, "why subscription=" + request.word + " service=" + service.word);
    const Statement& end = answer.back();
    std::map<std::string, std::string> codes;  // of what is not well
    for (const Statement& line : answer) {
      if (value(line, "ok") == "0") codes[value(line, "check")] = value(line, "code");
    }
    EXPECT_EQ(value(end, "matches") == "1", is_given);
    EXPECT_EQ(codes.empty(), is_given);
    const auto first = std::ranges::find_if(order, [&](const char* check) { return codes.contains(check); });
    EXPECT_EQ(value(end, "code"), first == order.end() ? "" : codes[*first]);
    const bool is_outranked = first != order.end() && *first == std::string_view("arbitration");
    EXPECT_EQ(value(end, "outranked") == "1", is_outranked);
    if (is_outranked) {
      EXPECT_TRUE(value(end, "code") == "outranked" || value(end, "code") == "incumbent");
    }
    codes_[{request.word, service.word}] = kind_of(value(end, "code"));
    return is_given || is_outranked;
  }

  void check_request(const Stated& request, int meeting) {
    const Statement end = ask(*request.client, "why subscription=" + request.word).back();
    EXPECT_EQ(value(end, "matching"), std::to_string(meeting));
    EXPECT_EQ(value(end, "code").empty(), meeting > 0);
    check_listed(listed(request, "requests unmatched=1", "subscription"), meeting > 0, end,
                 [&](const auto& pair) { return pair.first == request.word; });
    if (meeting > 0 || value(end, "code") == "nobody") return;
    const std::string& about = value(end, "text");
    EXPECT_EQ((codes_[{request.word, about.substr(0, about.find(": "))}]), value(end, "code"));
  }

  /// A list looks at fewer of them, so that another one may be the nearest.
  template <typename IsOf>
  void check_listed(const std::string& code, bool is_met, const Statement& end, const IsOf& is_of) {
    EXPECT_EQ(code.empty(), is_met);
    if (is_met || code == value(end, "code")) return;
    EXPECT_TRUE(std::ranges::any_of(codes_, [&](const auto& one) { return is_of(one.first) && one.second == code; }))
        << code << " for " << value(end, "code");
  }

  void check_service(const Stated& service, bool is_used, int taken) {
    const Statement end = ask(*service.client, "why service=" + service.word).back();
    EXPECT_EQ(value(end, "taken"), std::to_string(taken));
    const bool may_convert = service.text.contains("converts=") && !is_used;
    if (may_convert && value(end, "used") == "1") {
      EXPECT_EQ(listed(service, "services unused=1", "service"), "") << "a chain goes through it";
      return;
    }
    EXPECT_EQ(value(end, "used") == "1", is_used);
    EXPECT_EQ(value(end, "code").empty(), taken > 0);
    check_listed(listed(service, "services unused=1", "service"), is_used, end,
                 [&](const auto& pair) { return pair.second == service.word; });
    if (taken > 0 || value(end, "code") == "nobody") return;
    const std::string& about = value(end, "text");
    EXPECT_EQ((codes_[{about.substr(0, about.find(": ")), service.word}]), kind_of(value(end, "code")));
  }

  base::Random random_;
  sim::World world_;
  std::vector<sim::Host*> hosts_;
  std::vector<sim::Client*> clients_;
  std::vector<Stated> services_;
  std::vector<Stated> requests_;
  std::map<std::pair<std::string, std::string>, std::string> codes_;  ///< of each pair
};

TEST(RandomWhy, AgreesWithWhatPeersAreToldAboutEveryPair) {
  for (std::uint64_t seed = 1; seed <= test::rounds(15U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RestingTeam(seed).check_everything();
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace geminga::participant
