#include <gtest/gtest.h>
#include <radioboard/KeyCommands.h>

#include "support/Addresses.h"
#include "support/FakeRadio.h"
#include "support/Keys.h"
#include "support/ReplayRig.h"

using javinolib::KeyCommands;
using javinolib::ReplayMemory;
using javinolib::Reply;
using javinolib::Status;

namespace {

const uint16_t BODY_AT = 1 + javinolib::HEADER_LENGTH + 1;

std::string checkOf(const Bytes &key) {
  javinolib::DerivedKeys keys;
  keys.derive(key.data());
  return std::string(keys.check, keys.check + sizeof keys.check);
}

// The rig's four keys are deleted first.
class KeyCommandsTest : public testing::Test {
 protected:
  KeyCommandsTest() : nonces(epoch), commands(rig.keys, *rig.memory, nonces) {
    epoch.begin(false);
    for (uint8_t slot = 0; slot < ReplayRig::KEYS; slot++) rig.keys.erase(slot);
    rig.memory->forgetLostKeys();
  }

  Status set(const Bytes &body) {
    return commands.store(false, body.data(), static_cast<uint16_t>(body.size()), begin());
  }
  Status renew(const Bytes &body) {
    return commands.store(true, body.data(), static_cast<uint16_t>(body.size()), begin());
  }
  Status use(const Bytes &body) { return change(KeyCommands::USE, body); }
  Status raise(const Bytes &body) { return commands.raiseEpoch(body.data(), static_cast<uint16_t>(body.size())); }
  Status finish(const Bytes &body) { return change(KeyCommands::FINISH, body); }
  Status erase(const Bytes &body) { return change(KeyCommands::DELETE, body); }
  Status change(KeyCommands::Change change, const Bytes &body) {
    return commands.change(change, body.data(), static_cast<uint16_t>(body.size()), idle);
  }

  std::string list() {
    EXPECT_EQ(Status::OK, commands.list(0, begin()));
    return body();
  }

  std::string body() { return std::string(reply.packet() + BODY_AT, reply.packet() + reply.packetLength()); }

  Reply &begin() {
    reply.begin();
    return reply;
  }

  ReplayRig rig;
  javinolib::BootEpoch epoch;
  javinolib::NonceSource nonces;
  KeyCommands commands;
  FakeRadio radio;
  javinolib::BoardState state;
  const javinolib::Delivery idle{radio, state};  // nothing is under way
  uint8_t bytes[javinolib::MAX_PACKET_LENGTH];
  Reply reply{bytes, sizeof bytes};
};

const Bytes TO_SUPO = bytesOf("SUPO");

}  // namespace

// Invented origins of a group there may be as many as it likes.
TEST_F(KeyCommandsTest, refuse_one_more_pair_for_which_the_replay_memory_has_no_place) {
  const Bytes group = bytesOf("//SU");
  ASSERT_EQ(Status::OK, set(group + KEY));
  ASSERT_EQ(Status::OK, set(TO_SUPO + KEY));
  const uint8_t slot = rig.keys.current(javinolib::Address(0xFFF494));
  ASSERT_NE(javinolib::KeyStore::NO_SLOT, slot);
  for (uint32_t origin = 1000; origin < 1200; origin++) rig.take(slot, javinolib::Address(origin), nonce(1, 1));
  EXPECT_EQ(Status::STORE_FULL, set(bytesOf("ROMA") + KEY));
  EXPECT_EQ(Status::STORE_FULL, renew(TO_SUPO + OTHER_KEY)) << "both keys of a pair need a place";
  EXPECT_EQ(Status::OK, set(TO_SUPO + OTHER_KEY)) << "in the place of the old one";
  EXPECT_EQ(Status::OK, set(group + OTHER_KEY)) << "with the group's key its origins go";
  EXPECT_EQ(Status::OK, set(bytesOf("ROMA") + KEY));
}

TEST_F(KeyCommandsTest, tell_the_check_value_of_what_they_store) {
  EXPECT_EQ(Status::OK, set(TO_SUPO + KEY));
  EXPECT_EQ(checkOf(KEY), body());
  EXPECT_EQ(Status::OK, renew(TO_SUPO + OTHER_KEY));
  EXPECT_EQ(checkOf(OTHER_KEY), body());
}

TEST_F(KeyCommandsTest, list_the_roles) {
  EXPECT_EQ("", list());
  set(TO_SUPO + KEY);
  EXPECT_EQ("SUPO" + std::string(1, 0) + checkOf(KEY), list());
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ("SUPO" + std::string(1, 0) + checkOf(KEY) + "SUPO" + std::string(1, 2) + checkOf(OTHER_KEY), list());
  EXPECT_EQ(Status::OK, use(TO_SUPO));
  EXPECT_EQ("SUPO" + std::string(1, 1) + checkOf(KEY) + "SUPO" + std::string(1, 0) + checkOf(OTHER_KEY), list());
  EXPECT_EQ(Status::OK, finish(TO_SUPO));
  EXPECT_EQ("SUPO" + std::string(1, 0) + checkOf(OTHER_KEY), list());
}

TEST_F(KeyCommandsTest, take_each_step_of_a_renewal_only_after_the_one_before) {
  EXPECT_EQ(Status::NO_KEY, renew(TO_SUPO + KEY));
  EXPECT_EQ(Status::NO_KEY, use(TO_SUPO));
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
  set(TO_SUPO + KEY);
  EXPECT_EQ(Status::NO_KEY, use(TO_SUPO));
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
  EXPECT_EQ(Status::OK, renew(TO_SUPO + OTHER_KEY));
  EXPECT_EQ(checkOf(OTHER_KEY), body());
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO)) << "it would delete the next key";
  EXPECT_EQ(Status::OK, use(TO_SUPO));
  EXPECT_EQ(Status::OK, renew(TO_SUPO + OTHER_KEY)) << "it has that one";
  EXPECT_EQ(checkOf(OTHER_KEY), body());
  EXPECT_EQ(Status::NO_KEY, use(TO_SUPO));
  EXPECT_EQ(Status::OK, finish(TO_SUPO));
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
}

TEST_F(KeyCommandsTest, raise_the_epoch_and_never_lower_it) {
  EXPECT_EQ(Status::OK, raise({0, 1, 2}));
  for (const Bytes &notHigher : {Bytes{0, 0, 9}, Bytes{0, 0, 0}, Bytes{0, 1, 2}}) {
    EXPECT_EQ(Status::OK, raise(notHigher));
    EXPECT_EQ(0x102u, nonces.epoch());
  }
  EXPECT_EQ(Status::BAD_ARGUMENT, raise({0xFF, 0xFF, 0xFF})) << "it is never used";
  for (size_t length : {0, 1, 2, 4, 5}) EXPECT_EQ(Status::BAD_ARGUMENT, raise(Bytes(length))) << length;
  EXPECT_EQ(0x102u, nonces.epoch());
  EXPECT_EQ(Status::OK, raise({0xFF, 0xFF, 0xFE}));
  epoch.begin(false);
  javinolib::retained::beginEpoch(epoch.value());
  EXPECT_EQ(Status::NONCE_EXHAUSTED, raise({0xFF, 0xFF, 0xFE}));
}

TEST_F(KeyCommandsTest, tell_where_an_epoch_was_not_stored) {
  for (uint16_t at = 0; at < 4096; at++) rig.eeprom.wearOut(at);
  EXPECT_EQ(Status::STORE_FAILED, raise({0, 1, 2}));
  EXPECT_EQ(Status::STORE_FAILED, nonces.status()) << "nothing is sealed with it";
}

TEST_F(KeyCommandsTest, keep_what_RAM_knows_when_the_epoch_is_raised) {
  rig.take(0, SUPO, nonce(5, 7));
  set(TO_SUPO + KEY);
  const uint8_t slot = rig.keys.current(SUPO);
  rig.take(slot, SUPO, nonce(5, 7));
  EXPECT_EQ(Status::OK, raise({7, 0, 0}));
  rig.epoch = 0x070000;
  rig.reset();
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(slot, SUPO, nonce(5, 8))) << "exactly, and not by the floor";
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(slot, SUPO, nonce(5, 7)));
}

TEST_F(KeyCommandsTest, delete_both_keys) {
  EXPECT_EQ(Status::NO_KEY, erase(TO_SUPO));
  set(TO_SUPO + KEY);
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(Status::OK, erase(TO_SUPO));
  EXPECT_EQ("", list());
}

TEST_F(KeyCommandsTest, refuse_a_renewal_before_the_last_one_is_finished) {
  set(TO_SUPO + KEY);
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(Status::BAD_ARGUMENT, renew(TO_SUPO + THIRD_KEY));
  use(TO_SUPO);
  EXPECT_EQ(Status::BAD_ARGUMENT, renew(TO_SUPO + KEY)) << "the previous key must not come back so";
}

TEST_F(KeyCommandsTest, forget_the_floors_of_the_keys_that_go) {
  set(TO_SUPO + KEY);
  const uint8_t first = rig.keys.current(SUPO);
  rig.take(first, SUPO, nonce(5, 7));
  renew(TO_SUPO + OTHER_KEY);
  use(TO_SUPO);
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(first, SUPO, nonce(5, 7))) << "the previous key still opens";
  finish(TO_SUPO);
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(first, SUPO, nonce(5, 7)));
  const uint8_t second = rig.keys.current(SUPO);
  rig.take(second, SUPO, nonce(5, 7));
  set(TO_SUPO + KEY);
  EXPECT_EQ(ReplayMemory::NEWER, rig.judge(second, SUPO, nonce(5, 7)));
}

TEST_F(KeyCommandsTest, keep_the_floors_of_a_key_that_is_set_again_or_taken_back) {
  set(TO_SUPO + KEY);
  const uint8_t place = rig.keys.current(SUPO);
  rig.take(place, SUPO, nonce(5, 7));
  set(TO_SUPO + KEY);
  renew(TO_SUPO + OTHER_KEY);
  use(TO_SUPO);
  set(TO_SUPO + KEY);
  EXPECT_EQ(place, rig.keys.current(SUPO));
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(place, SUPO, nonce(5, 7)));
}

TEST_F(KeyCommandsTest, after_a_power_cut_anywhere_leave_no_key_without_its_floors) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    ReplayRig torn;
    KeyCommands keys(torn.keys, *torn.memory, nonces);
    begin();
    const Bytes first = TO_SUPO + KEY;
    const Bytes second = TO_SUPO + OTHER_KEY;
    keys.store(false, first.data(), 20, reply);
    torn.take(torn.keys.current(SUPO), SUPO, nonce(5, 7));
    torn.eeprom.cutPowerAfter(cut, 0x5A);
    try {
      keys.store(false, second.data(), 20, reply);
    } catch (const PowerCut &) {
      cuts++;
    }
    torn.eeprom.restorePower();
    torn.powerCycle();
    const uint8_t slot = torn.keys.current(SUPO);
    uint8_t check[3];
    torn.keys.readCheckValue(slot, check);
    const bool isOld = std::string(check, check + 3) == checkOf(KEY);
    ASSERT_EQ(isOld ? ReplayMemory::BELOW_FLOOR : ReplayMemory::NEWER, torn.judge(slot, SUPO, nonce(5, 7))) << cut;
  }
}

TEST_F(KeyCommandsTest, refuse_bodies_of_any_other_shape) {
  for (size_t length = 0; length < 40; length++) {
    Bytes whole = TO_SUPO + KEY + Bytes(20);
    whole.resize(length);
    if (length != 20) {
      EXPECT_EQ(Status::BAD_ARGUMENT, set(whole)) << length;
      EXPECT_EQ(Status::BAD_ARGUMENT, renew(whole)) << length;
    }
    if (length != 4) {
      EXPECT_EQ(Status::BAD_ARGUMENT, use(whole)) << length;
      EXPECT_EQ(Status::BAD_ARGUMENT, finish(whole)) << length;
      EXPECT_EQ(Status::BAD_ARGUMENT, erase(whole)) << length;
    }
  }
}

TEST_F(KeyCommandsTest, refuse_addresses_that_have_no_key) {
  for (const char *address : {"++++", "////", "+FAA", "+KAA", "/AAA", "SU O", "SUP\x01"}) {
    EXPECT_EQ(Status::BAD_ARGUMENT, set(bytesOf(address) + KEY)) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, renew(bytesOf(address) + KEY)) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, use(bytesOf(address))) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, finish(bytesOf(address))) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, erase(bytesOf(address))) << address;
  }
}
