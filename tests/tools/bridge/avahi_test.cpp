// A service of DNS-SD as a publication, and ours as services of DNS-SD.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/avahi/found_service.hpp"
#include "bridge/avahi/limits.hpp"
#include "bridge/avahi/own_service.hpp"

namespace geminga::bridge {
namespace {

using testing::Contains;
using testing::Pair;

FoundService printer() {
  return {.name = "Laser Jet",
          .type = "_ipp._tcp",
          .domain = "local",
          .host = "office.local",
          .address = "10.0.0.2",
          .port = 631,
          .txt = {"rp=printers/x", "duplex", "rp=second"}};
}

NamedPublication publication(const FoundService& service) {
  const auto foreign = foreign_of(service);
  EXPECT_TRUE(foreign) << foreign.error();
  return std::get<NamedPublication>(foreign->stated);
}

TEST(FoundService, BecomesAPublicationOfItsType) {
  const auto foreign = foreign_of(printer());
  ASSERT_TRUE(foreign);
  EXPECT_EQ(foreign->concept_name, "_ipp._tcp");
  const auto& stated = std::get<NamedPublication>(foreign->stated);
  EXPECT_EQ(stated.identity, NamedIdentity(TextIdentity{"_ipp._tcp"}));
  EXPECT_EQ(stated.protocol, "dns-sd");
  EXPECT_EQ(stated.port, 631);
  EXPECT_THAT(stated.attributes, Contains(Pair("dns.name", "Laser Jet")));
  EXPECT_THAT(stated.attributes, Contains(Pair("dns.txt.rp", "printers/x"))) << "the first of equal keys counts";
  EXPECT_THAT(stated.attributes, Contains(Pair("dns.txt.duplex", "")));
}

TEST(FoundService, IsCountedByItsReasonWhereNobodyCouldUseIt) {
  const auto reason = [](auto change) {
    FoundService service = printer();
    change(service);
    const auto foreign = foreign_of(service);
    return foreign ? "" : std::string(foreign.error());
  };
  EXPECT_EQ(reason([](FoundService& s) { s.port = 0; }), "services without a port");
  for (const char* address : {"", "fe80::1", "127.0.0.1", "0.0.0.0", "224.0.0.251", "nowhere"}) {
    EXPECT_EQ(reason([&](FoundService& s) { s.address = address; }), "services without an address that others can use")
        << address;
  }
  EXPECT_EQ(reason([](FoundService& s) { s.name = "\xff\xfe"; }), "names that are no UTF-8");
  for (const char* type : {"", "_._tcp", "ipp._tcp", "_ipp._sctp", "_i pp._tcp", "_<urn:x>._tcp", "_a._b._tcp"}) {
    EXPECT_EQ(reason([&](FoundService& s) { s.type = type; }), "types that are none of DNS-SD") << type;
  }
}

TEST(FoundService, KeepsTheLimitsOfAttributes) {
  FoundService service = printer();
  service.txt = {"a=" + std::string(254, 'x'),
                 "b=" + std::string(255, 'x'),
                 "c=" + std::string(256, 'x'),
                 "bad key=x",
                 "d=\xff",
                 "e=line\nfeed",
                 std::string(56, 'k') + "=1",
                 std::string(57, 'k') + "=1",
                 "=x"};
  auto attributes = publication(service).attributes;
  EXPECT_TRUE(attributes.contains("dns.txt.a"));
  EXPECT_TRUE(attributes.contains("dns.txt.b"));
  EXPECT_TRUE(attributes.contains("dns.txt." + std::string(56, 'k')));
  EXPECT_EQ(attributes.size(), 5U + 3U);
  for (const std::size_t keys : {max_txt_keys - 1, max_txt_keys, max_txt_keys + 1}) {
    service.txt.clear();
    for (std::size_t i = 0; i < keys; ++i) service.txt.push_back("k" + std::to_string(i) + "=v");
    EXPECT_EQ(publication(service).attributes.size(), 5U + std::min(keys, max_txt_keys));
  }
  service.name = std::string(5000, 'n');
  service.host = "\x1b[31m";
  attributes = publication(service).attributes;
  EXPECT_LE(attributes.at("dns.name").size(), max_shown_name_bytes);
  EXPECT_EQ(attributes.at("dns.host"), "?[31m");
}

Record line(std::vector<std::pair<std::string, std::string>> fields, Attributes attributes = {}) {
  std::vector<std::pair<std::string, std::string>> all{
      {"service", "1a2b3c4d/1/42"}, {"mode", "oto"}, {"port", "5000"}, {"protocol", "udp"}, {"priority", "0"}};
  all.insert(all.end(), fields.begin(), fields.end());
  return {"services", std::move(all), std::move(attributes)};
}

TEST(OwnService, HasConceptAndRepresentationInItsTxt) {
  const auto service =
      own_service(line({{"concept", "soccer:BallInfo"}, {"representation", "soccer:X"}}, {{"rate", "30"}}), {});
  ASSERT_TRUE(service);
  EXPECT_EQ(service->label, "soccer:BallInfo 1a2b3c4d/1/42");
  EXPECT_EQ(service->type, "_geminga._udp");
  EXPECT_EQ(service->host, "");
  EXPECT_THAT(service->txt, testing::IsSupersetOf({"txtvers=1", "concept=soccer:BallInfo", "representation=soccer:X",
                                                   "mode=oto", "attr.rate=30"}));
  EXPECT_FALSE(service->is_cut);
}

TEST(OwnService, HasAHostOfItsOwnWhereItsAddressIsAnother) {
  const auto record = line({{"text", "lamp"}, {"address", "10.0.0.9"}});
  EXPECT_EQ(own_service(record, {"10.0.0.9"})->host, "");
  EXPECT_EQ(own_service(record, {"10.0.0.1"})->host, "geminga-1a2b3c4d-1-42");
}

TEST(OwnService, FitsIntoALabelAndATxtRecord) {
  for (const std::size_t size : {48U, 49U, 50U}) {
    const auto service = own_service(line({{"text", std::string(size, 't')}}), {});
    EXPECT_EQ(service->label.size(), std::min<std::size_t>(size + 14, max_label_bytes));
  }
  Attributes many;
  for (int i = 0; i < 32; ++i) many["k" + std::to_string(i)] = std::string(200, 'v');
  const auto service = own_service(line({{"text", "x"}}, many), {});
  std::size_t octets = 0;
  for (const std::string& one : service->txt) octets += one.size() + 1;
  EXPECT_LE(octets, max_txt_bytes);
  EXPECT_TRUE(service->is_cut);
}

TEST(OwnService, IsNothingThatABridgeStated) {
  EXPECT_FALSE(own_service(line({{"text", "_ipp._tcp"}}, {{"bridge", "dns-sd"}}), {}));
  EXPECT_FALSE(own_service({"services", {{"service", "a/1/1"}, {"port", "0"}}, {}}, {}));
}

}  // namespace
}  // namespace geminga::bridge
