// A whole board: hostile bytes and packets, genuine ones, time, resets and losses of power, in any order. It answers each
// good request once, hands on nothing that was not sealed for it, nothing twice, and shows no key.

#include <Arduino.h>
#include <secure/Proof.h>

#include <algorithm>
#include <set>

#include "Input.h"
#include "support/Digits.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

namespace {

const Bytes PAIR_KEY = fromHex("8f2e07b1c45d6a3990fe1823ab7c56d0");
const Bytes GROUP_KEY = fromHex("31d4a9567be2c80f4d6617ea92053bc8");
const size_t PART = 67;

const char *const ADDRESSES[] = {"SUPO", "ROMA", "//SU", "////", "SUHO", "++++", "+FAA", "+KAA"};

char digit(unsigned value) { return digits()[value % 64]; }

void percepts(javinolib::Percepts &percepts) { percepts.add(F("distance"), 17); }
bool act(const javinolib::Arguments &arguments) { return arguments.count() < 3; }

/// SUPO, which shares keys with ROMA and its group, and what the fuzzer does to it.
class Scene {
 public:
  explicit Scene(Input &input) : input_(input) {
    board_.start("SUPO");
    board_.setKey("ROMA", PAIR_KEY);
    board_.setKey("//SU", GROUP_KEY);
    board_.board->poll().setSource(percepts);
    board_.board->actions().add(F("act"), act);
  }

  void play() {
    while (!input_.empty()) step();
    checkSecrets();
  }

 private:
  typedef void (Scene::*Step)();

  void step() {
    static const Step STEPS[] = {&Scene::rawBytes,  &Scene::request, &Scene::poll,        &Scene::transmit,
                                 &Scene::rawPacket, &Scene::frame,   &Scene::longFrame,   &Scene::fragment,
                                 &Scene::answer,    &Scene::replay,  &Scene::sealedFrame, &Scene::pass,
                                 &Scene::endPacket, &Scene::reset};
    (this->*STEPS[input_.byte() % (sizeof STEPS / sizeof *STEPS)])();
  }

  const char *address() { return ADDRESSES[input_.byte() % 8]; }

  // The serial line.

  void rawBytes() { board_.sendRaw(input_.bytes(200) + Bytes{0}); }

  void request() {
    const char command = "HPARLSZKNFDIV"[input_.byte() % 13];
    // Too little for those that would change the keys and the id by which the scene knows what is genuine.
    const size_t most = std::string("KNFDI").find(command) == std::string::npos ? 120 : 3;
    board_.request(command, input_.bytes(most));
  }

  void poll() {
    const uint8_t how = input_.byte();
    const bool takes = how % 2 != 0;
    board_.hello();  // a request may have been one of another version
    if (how % 4 >= 2) hold(how);
    for (const PolledMessage &message : board_.messages()) {
      if (message.destination != "////") checkGenuine(message);
      if (takes) take(message);
    }
  }

  // A poll that may wait for something, and is ended by a byte or by the end of its time.
  void hold(uint8_t how) {
    board_.hold(how % 8 >= 4 ? 1 : 0, how, how / 16);
    board_.pass(how / 2);
    if (!board_.replies()) board_.port.arrive({0});
    board_.board->run();
    board_.takeReply();
  }

  void checkGenuine(const PolledMessage &message) {
    require(allowed_.count(message.content) == 1, "only what was sealed for it is handed on, and not again when taken");
    require(message.origin == "ROMA", "it is from whom it was sealed by");
  }

  void take(const PolledMessage &message) {
    board_.pollTaking(message.number);
    if (message.destination != "////") allowed_.erase(message.content);
  }

  void transmit() {
    const char *to = address();
    if (to == ADDRESSES[5]) return;  // that would be a command
    board_.transmit(to, "SUPO", textOf(input_.take(input_.byte() % 2 == 0 ? input_.byte() % 60 : input_.word() % 512)));
  }

  // The air.

  void hear(const Bytes &packet) {
    if (!packet.empty() && packet.size() <= javinolib::MAX_RADIO_PAYLOAD) board_.receive(packet);
  }

  void rawPacket() { hear(input_.bytes(javinolib::MAX_RADIO_PAYLOAD)); }

  void frame() {
    const char *to = address();
    const char *from = address();
    hear(reference::frame(to, from, input_.bytes(PART)));
  }

  Bytes seal(size_t length) {
    const bool toGroup = input_.byte() % 3 == 0;
    counter_ += 1 + input_.byte() % 40;
    std::string content = std::to_string(counter_) + ";";
    content.resize(std::max(length, content.size()), 'x');
    allowed_.insert(content);
    const Bytes nonce = {0,
                         0,
                         9,
                         static_cast<uint8_t>(counter_ >> 16),
                         static_cast<uint8_t>(counter_ >> 8),
                         static_cast<uint8_t>(counter_)};
    recorded_.push_back(sealed(toGroup ? GROUP_KEY : PAIR_KEY, toGroup ? "//SU" : "SUPO", "ROMA", nonce, content));
    return recorded_.back();
  }

  // The fuzzer's change of a genuine packet: none, or one byte.
  Bytes changed(Bytes packet) {
    if (input_.byte() % 2 == 0) return packet;
    const size_t at = input_.byte() % packet.size();
    packet[at] = static_cast<uint8_t>(packet[at] ^ input_.byte());
    return packet;
  }

  void sealedFrame() { hear(changed(seal(input_.byte() % 54))); }

  void longFrame() { cut(seal(60 + input_.word() % 435)); }

  void cut(const Bytes &frame) {
    const unsigned id = input_.byte();
    for (unsigned index = 0; index * PART < frame.size(); index++) {
      const uint8_t how = input_.byte();
      const auto from = frame.begin() + index * PART;
      const auto to = frame.begin() + std::min((index + 1) * PART, frame.size());
      const Bytes part = changed(Bytes(from, to));
      const unsigned shown = (how % 8 == 1 ? how : index) + (how % 4 == 2 ? 8 : 0);
      if (how % 16 != 3) hear(reference::frame(std::string("+F") + digit(id) + digit(shown), "ROMA", part));
    }
  }

  void fragment() {
    const std::string to = std::string("+F") + digit(input_.byte()) + digit(input_.byte());
    const char *from = address();
    hear(reference::frame(to, from, input_.bytes(PART)));
  }

  void replay() {
    if (recorded_.empty()) return;
    const Bytes frame = recorded_[input_.byte() % recorded_.size()];
    if (frame.size() <= javinolib::MAX_RADIO_PAYLOAD) {
      hear(changed(frame));
    } else {
      cut(frame);
    }
  }

  // An answer to the last sealed packet that the board sent, genuine or nearly so.
  void answer() {
    if (board_.radio.sent.empty() || board_.radio.sent.back().size() < 24) return;
    const Bytes &packet = board_.radio.sent.back();
    const bool isFragment = packet[0] == '+';
    const auto at = packet.begin() + (isFragment ? 20 : 10);
    if (packet.end() - at < 6) return;
    const Bytes nonce(at, at + 6);
    const uint8_t type = input_.byte() % 3;
    Bytes body = type == 0 ? Bytes() : type == 1 ? Bytes{input_.byte()} : nonce + Bytes{input_.byte(), 0};
    if (type == 2) body[5] = static_cast<uint8_t>(body[5] + input_.byte());
    const std::string to = std::string("+K") + digit(nonce[4] << 2 | nonce[5] >> 6) + digit(nonce[5]);
    hear(changed(reference::frame(to, "ROMA", body + proof(type, nonce, body))));
  }

  static Bytes proof(uint8_t type, const Bytes &nonce, const Bytes &body) {
    javinolib::DerivedKeys keys;
    keys.derive(PAIR_KEY.data());
    javinolib::Address to, from;
    javinolib::Address::parse(bytesOf("SUPO").data(), to);
    javinolib::Address::parse(bytesOf("ROMA").data(), from);
    const auto claimed = static_cast<javinolib::Proof::Type>(javinolib::Proof::DELIVERED + type);
    const javinolib::Proof::Claim claim = {claimed, nonce.data(), to, from, body.data(), false};
    Bytes made(javinolib::PROOF_LENGTH);
    javinolib::Proof(keys).make(claim, made.data());
    return made;
  }

  // Time.

  void pass() {
    const uint8_t how = input_.byte();
    board_.radio.heard = how % 5 == 0;
    if (how < 200) {
      board_.pass(how);
    } else {
      board_.clock.millis += how * 40u;
      board_.board->run();
    }
  }

  void endPacket() {
    if (board_.radio.sending()) board_.finishSending();
  }

  void reset() {
    checkSecrets();
    const uint8_t how = input_.byte();
    if (how % 4 == 0) board_.eeprom.cutPowerAfter(how, input_.byte());
    if (how % 2 == 0) {
      board_.powerUp();
    } else {
      board_.reboot();
    }
    greet();
  }

  void greet() {
    board_.board->poll().setSource(percepts);
    board_.board->actions().add(F("act"), act);
    board_.hello();
    board_.request('R', {1});
  }

  void checkSecrets() {
    Bytes everything = board_.port.everWritten();
    for (const Bytes &packet : board_.radio.sent) everything = everything + packet;
    for (const Bytes &key : {PAIR_KEY, GROUP_KEY}) {
      javinolib::DerivedKeys keys;
      keys.derive(key.data());
      require(!contains(everything, Bytes(key.begin(), key.begin() + 6)), "no key is shown");
      require(!contains(everything, Bytes(keys.encryption, keys.encryption + 6)), "nor what is derived from it");
      require(!contains(everything, Bytes(keys.authentication, keys.authentication + 6)), "nor that");
    }
  }

 public:
  /// Power failed in an EEPROM write.
  void recover() {
    board_.eeprom.restorePower();
    board_.powerUp();
    greet();
  }

 private:
  Input &input_;
  TestBoard board_;
  uint32_t counter_ = 0;
  std::set<std::string> allowed_;  // contents that were sealed, and not taken yet
  std::vector<Bytes> recorded_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Input input(data, size);
  Scene scene(input);
  for (;;) {
    try {
      scene.play();
      return 0;
    } catch (const PowerCut &) {
      scene.recover();
    }
  }
}
