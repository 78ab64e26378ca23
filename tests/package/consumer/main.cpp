// Uses the installed public face and links the client: prints an identity, or what the client says where no daemon
// listens.
#include <cstdio>
#include <geminga/attribute.hpp>
#include <geminga/client.hpp>
#include <geminga/node.hpp>
#include <string>

int main(int argc, char**) {
  if (argc > 1) {
    const geminga::Identity ball = geminga::SemanticIdentity{"https://geminga.example/soccer#BallInfo", ""};
    std::printf("%u\n", geminga::id32(ball));
    return 0;
  }
  geminga::ClientOptions options;
  options.connect = "127.0.0.1:1";  // nobody listens on tcpmux here
  const auto client = geminga::Client::connect(options);
  if (client || client.error().kind != geminga::ClientError::Kind::unreachable) return 1;
  std::printf("linked and refused as it should be: %s\n", client.error().text.c_str());
  const auto node = geminga::Node::open(options);
  if (!node || node->is_connected()) return 1;
  return 0;
}
