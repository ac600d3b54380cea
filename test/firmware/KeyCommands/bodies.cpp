#include <board/KeyCommands.h>
#include <gtest/gtest.h>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/ReplayRig.h"

using javino::KeyCommands;
using javino::Reply;
using javino::ReplayMemory;
using javino::Status;

namespace {

const uint16_t BODY_AT = 1 + javino::HEADER_LENGTH + 1;

std::string checkOf(const Bytes &key) {
  javino::DerivedKeys keys;
  keys.derive(key.data());
  return std::string(keys.check, keys.check + sizeof keys.check);
}

// The rig's four keys are deleted first.
class KeyCommandsTest : public testing::Test {
 protected:
  KeyCommandsTest() : commands(rig.keys, *rig.memory) {
    for (uint8_t slot = 0; slot < ReplayRig::KEYS; slot++) rig.keys.erase(slot);
    rig.memory->forgetLostKeys(rig.keys);
  }

  Status set(const Bytes &body) { return commands.set(body.data(), static_cast<uint16_t>(body.size()), begin()); }
  Status renew(const Bytes &body) { return commands.renew(body.data(), static_cast<uint16_t>(body.size()), begin()); }
  Status finish(const Bytes &body) { return commands.finish(body.data(), static_cast<uint16_t>(body.size())); }
  Status erase(const Bytes &body) { return commands.erase(body.data(), static_cast<uint16_t>(body.size())); }

  std::string list() {
    EXPECT_EQ(Status::OK, commands.list(0, begin()));
    return body();
  }

  std::string body() const { return std::string(reply.packet() + BODY_AT, reply.packet() + reply.packetLength()); }

  Reply &begin() {
    reply.begin(1);
    return reply;
  }

  ReplayRig rig;
  KeyCommands commands;
  Reply reply;
};

const Bytes TO_SUPO = bytesOf("SUPO");

}  // namespace

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
  EXPECT_EQ("SUPO" + std::string(1, 1) + checkOf(KEY) + "SUPO" + std::string(1, 0) + checkOf(OTHER_KEY), list());
  EXPECT_EQ(Status::OK, finish(TO_SUPO));
  EXPECT_EQ("SUPO" + std::string(1, 0) + checkOf(OTHER_KEY), list());
}

TEST_F(KeyCommandsTest, finish_only_what_was_begun) {
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
  set(TO_SUPO + KEY);
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(Status::OK, finish(TO_SUPO));
  EXPECT_EQ(Status::NO_KEY, finish(TO_SUPO));
}

TEST_F(KeyCommandsTest, delete_both_keys) {
  EXPECT_EQ(Status::NO_KEY, erase(TO_SUPO));
  set(TO_SUPO + KEY);
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(Status::OK, erase(TO_SUPO));
  EXPECT_EQ("", list());
}

TEST_F(KeyCommandsTest, refuse_to_renew_to_the_previous_key) {
  set(TO_SUPO + KEY);
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(Status::BAD_ARGUMENT, renew(TO_SUPO + KEY));
}

TEST_F(KeyCommandsTest, forget_the_floors_of_the_keys_that_go) {
  set(TO_SUPO + KEY);
  const uint8_t first = rig.keys.current(SUPO);
  rig.take(first, SUPO, nonce(5, 7));
  renew(TO_SUPO + OTHER_KEY);
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(first, SUPO, nonce(5, 7))) << "the previous key is still in use";
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
  set(TO_SUPO + KEY);
  EXPECT_EQ(place, rig.keys.current(SUPO));
  EXPECT_EQ(ReplayMemory::REPEATED, rig.judge(place, SUPO, nonce(5, 7)));
}

TEST_F(KeyCommandsTest, after_a_power_cut_anywhere_leave_no_key_without_its_floors) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    ReplayRig torn;
    KeyCommands keys(torn.keys, *torn.memory);
    begin();
    const Bytes first = TO_SUPO + KEY;
    const Bytes second = TO_SUPO + OTHER_KEY;
    keys.set(first.data(), 20, reply);
    torn.take(torn.keys.current(SUPO), SUPO, nonce(5, 7));
    torn.eeprom.cutPowerAfter(cut, 0x5A);
    try {
      keys.set(second.data(), 20, reply);
    } catch (const PowerCut &) {
      cuts++;
    }
    torn.eeprom.restorePower();
    torn.powerCycle();
    const uint8_t slot = torn.keys.current(SUPO);
    uint8_t check[3];
    torn.keys.readCheckValue(slot, check);
    const bool isOld = std::string(check, check + 3) == checkOf(KEY);
    ASSERT_EQ(isOld ? ReplayMemory::STALE : ReplayMemory::NEWER, torn.judge(slot, SUPO, nonce(5, 7))) << cut;
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
      EXPECT_EQ(Status::BAD_ARGUMENT, finish(whole)) << length;
      EXPECT_EQ(Status::BAD_ARGUMENT, erase(whole)) << length;
    }
  }
}

TEST_F(KeyCommandsTest, refuse_addresses_that_have_no_key) {
  for (const char *address : {"++++", "////", "+FAA", "+KAA", "/AAA", "SU O", "SUP\x01"}) {
    EXPECT_EQ(Status::BAD_ARGUMENT, set(bytesOf(address) + KEY)) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, renew(bytesOf(address) + KEY)) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, finish(bytesOf(address))) << address;
    EXPECT_EQ(Status::BAD_ARGUMENT, erase(bytesOf(address))) << address;
  }
}
