// SPDX-License-Identifier: GPL-3.0-or-later
// The trace of the exchange of a board and its host, given to the sniffer byte by byte.
#include "support.h"

extern "C" {
#include "line_code.h"
#include "serial_sniffer.h"
}

namespace {

using Bytes = std::vector<uint8_t>;

Bytes bytes(const std::string &text) { return Bytes(text.begin(), text.end()); }

// SPEC 4.1; the size digits are of no interest to the sniffer.
Bytes packet(uint8_t sequence, const std::string &addresses, const Bytes &message) {
  Bytes plain = {sequence};
  for (char c : addresses + "AA") plain.push_back(static_cast<uint8_t>(c));
  plain.insert(plain.end(), message.begin(), message.end());
  uint16_t crc = crc_x25(plain.data(), plain.size());
  plain.push_back(static_cast<uint8_t>(crc));
  plain.push_back(static_cast<uint8_t>(crc >> 8));
  Bytes stuffed = {0};
  size_t code = 0;
  for (uint8_t byte : plain) {
    if (byte != 0) {
      stuffed.push_back(byte);
    } else {
      stuffed[code] = static_cast<uint8_t>(stuffed.size() - code);
      code = stuffed.size();
      stuffed.push_back(0);
    }
  }
  stuffed[code] = static_cast<uint8_t>(stuffed.size() - code);
  stuffed.push_back(0);
  return stuffed;
}

const std::string TO_BOARD = "++++++++";

// A board whose line is listened to.
class Line {
 public:
  Line() : run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"}]})") {
    serial_sniffer_init(&sniffer, run.e.out, "a");
  }

  void host(uint8_t sequence, const std::string &addresses, const Bytes &message) {
    feed(true, packet(sequence, addresses, message));
  }

  void board(uint8_t sequence, const Bytes &message) { feed(false, packet(sequence, TO_BOARD, message)); }

  void greet() {
    host(1, TO_BOARD, {'H', 1});
    board(1, {0, 1, 'R', 'O', 'M', 'A', 0, 0, 1});
  }

  void feed(bool from_host, const Bytes &bytes) {
    for (uint8_t byte : bytes) serial_sniffer_byte(&sniffer, from_host, byte, at += CYCLES_PER_MS / 10);
  }

  std::vector<Event> events(const std::string &event) { return run.events(event); }
  size_t all() {
    size_t count = 0;
    for (const char *event : {"host-id", "host-key", "host-radio", "host-relaying", "host-transmit", "host-relay",
                              "host-handed", "host-taking", "host-taken", "host-outcome"})
      count += events(event).size();
    return count;
  }

  serial_sniffer sniffer;

 private:
  Scratch scratch;
  Emulation run;
  cycles_t at = 0;
};

Bytes joined(const std::vector<Bytes> &parts) {
  Bytes all;
  for (const Bytes &part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Bytes percept(const std::string &literal) {
  return joined({{'P', 0, static_cast<uint8_t>(literal.size())}, bytes(literal)});
}

Bytes message(uint8_t number, const std::string &addresses, const Bytes &id, const std::string &content) {
  const Bytes value = joined({{number}, bytes(addresses), id, bytes(content)});
  return joined({{'M', 0, static_cast<uint8_t>(value.size())}, value});
}

Bytes poll_reply(const std::vector<Bytes> &records) { return joined({{0, 0}, joined(records)}); }

}  // namespace

TEST(SerialSniffer, tells_what_the_host_does_with_keys_and_the_check_value_that_the_board_says) {
  Line line;
  line.greet();
  uint8_t sequence = 2;
  for (char command : {'K', 'N', 'U', 'F', 'D', 'V'}) {
    const bool given = command == 'K' || command == 'N' || command == 'V';
    Bytes request = joined({{static_cast<uint8_t>(command)}, bytes("SUPP"), Bytes(given ? 16 : 0, 7)});
    line.host(sequence, TO_BOARD, request);
    line.board(sequence++, given ? Bytes{0, 1, 2, 3} : Bytes{0});
  }
  line.host(sequence, TO_BOARD, joined({bytes("DSUPO")}));
  line.board(sequence, {11});  // it has none
  const char *steps[] = {"set", "renew", "use", "finish", "delete", "session"};
  auto keys = line.events("host-key");
  ASSERT_EQ(keys.size(), 6u);
  for (size_t i = 0; i < keys.size(); i++) {
    EXPECT_EQ(keys[i].text("address"), "SUPP");
    EXPECT_EQ(keys[i].text("step"), steps[i]);
    EXPECT_NE(json_object_get(keys[i].fields, "asked"), nullptr);
    EXPECT_EQ(json_object_get(keys[i].fields, "check") != nullptr, i < 2 || i == 5);
  }
  EXPECT_EQ(keys[0].text("check"), "010203");
}

TEST(SerialSniffer, tells_of_frames_for_which_the_board_has_no_key) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({joined({{'N', 0, 8}, bytes("ROMASUPP")}), joined({{'N', 0, 7}, bytes("ROMASUP")})}));
  auto frames = line.events("host-no-key");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].text("destination"), "ROMA");
  EXPECT_EQ(frames[0].text("origin"), "SUPP");
}

TEST(SerialSniffer, tells_whether_the_host_opens_or_blocks_the_radio) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'R', 1});
  line.board(2, {0});
  line.host(3, TO_BOARD, {'R', 0});
  line.board(3, {0});
  auto radio = line.events("host-radio");
  ASSERT_EQ(radio.size(), 2u);
  EXPECT_EQ(radio[0].text("radio"), "open");
  EXPECT_EQ(radio[1].text("radio"), "blocked");
}

TEST(SerialSniffer, tells_an_action_with_its_request_and_reply_once) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, joined({{'A'}, bytes("turn(30)")}));
  line.host(2, TO_BOARD, joined({{'A'}, bytes("turn(30)")}));
  line.board(2, {0});
  line.host(2, TO_BOARD, joined({{'A'}, bytes("turn(30)")}));
  line.board(2, {0});
  line.host(3, TO_BOARD, joined({{'A'}, bytes("jump")}));
  line.board(3, {4});
  line.host(4, TO_BOARD, joined({{'A'}, bytes("weigh")}));
  line.board(4, {0, 0xFF, 0xFE, 0x0C});
  auto actions = line.events("host-action");
  ASSERT_EQ(actions.size(), 3u);
  EXPECT_EQ(actions[0].text("action"), "turn(30)");
  EXPECT_LT(actions[0].real("asked"), actions[0].real("replied"));
  EXPECT_LT(actions[0].real("replied"), actions[0].t);
  EXPECT_TRUE(actions[0].flag("done"));
  EXPECT_FALSE(actions[1].flag("done"));
  EXPECT_EQ(json_object_get(actions[0].fields, "number"), nullptr);
  EXPECT_EQ(actions[2].real("number"), -500);
}

TEST(SerialSniffer, tells_whether_the_board_is_a_relay) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'W', 1, 1, 214});
  line.board(2, {0, 1});
  line.host(3, TO_BOARD, {'W'});
  line.board(3, {0, 0});
  line.host(4, TO_BOARD, {'W', 1, 1, 214});
  line.board(4, {0x0A});
  auto relaying = line.events("host-relaying");
  ASSERT_EQ(relaying.size(), 2u);
  EXPECT_EQ(relaying[0].text("relaying"), "on");
  EXPECT_EQ(relaying[1].text("relaying"), "off");
}

TEST(SerialSniffer, tells_the_id_that_a_board_says_and_that_it_is_given) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'I', 'S', 'U', 'P', 'O'});
  line.board(2, {0});
  auto ids = line.events("host-id");
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(ids[0].text("id"), "ROMA");
  EXPECT_EQ(ids[0].text("epoch"), "000001");
  EXPECT_EQ(ids[1].text("id"), "SUPO");
  EXPECT_EQ(ids[1].text("epoch"), "000001");
}

TEST(SerialSniffer, tells_of_a_board_with_sealed_unicasts_only_and_not_of_an_earlier_one_whose_name_looks_so) {
  Line line;
  const Bytes hello = {0, 1, 'R', 'O', 'M', 'A', 0, 0, 1};
  uint8_t sequence = 1;
  for (uint8_t capabilities : Bytes{7, 3, 'l'}) {
    line.host(sequence, TO_BOARD, {'H', 1});
    line.board(sequence++, joined({hello, {capabilities}, bytes("amp")}));
    line.host(sequence, TO_BOARD, joined({bytes("ISUPO")}));
    line.board(sequence++, {0});
  }
  auto ids = line.events("host-id");
  ASSERT_EQ(ids.size(), 6u);
  for (size_t i = 0; i < ids.size(); i++)
    EXPECT_EQ(json_is_true(json_object_get(ids[i].fields, "unicastsOnly")), i < 2) << i;
}

TEST(SerialSniffer, tells_the_epoch_that_a_board_is_raised_to_and_no_lower_one) {
  Line line;
  line.greet();
  for (uint8_t epoch : {2, 1}) {
    line.host(epoch, TO_BOARD, {'E', 0, 0, epoch});
    line.board(epoch, {0});
  }
  auto ids = line.events("host-id");
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_EQ(ids[1].text("id"), "ROMA");
  EXPECT_EQ(ids[1].text("epoch"), "000002");
}

TEST(SerialSniffer, tells_what_is_to_be_sent_and_when_the_host_asked) {
  Line line;
  line.greet();
  line.host(2, "//SUROMA", bytes("tell;help"));
  line.board(2, {0, 7});
  auto sent = line.events("host-transmit");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].number("number"), 7);
  EXPECT_EQ(sent[0].text("destination"), "//SU");
  EXPECT_EQ(sent[0].text("content"), "tell;help");
  EXPECT_LT(json_real_value(json_object_get(sent[0].fields, "asked")), sent[0].t);
}

TEST(SerialSniffer, tells_what_is_to_be_relayed) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, joined({bytes("Y////CAFEAIx")}));
  EXPECT_TRUE(line.events("host-relay").empty());
  line.board(2, {0, 7});
  auto relayed = line.events("host-relay");
  ASSERT_EQ(relayed.size(), 1u);
  EXPECT_EQ(relayed[0].number("number"), 7);
  EXPECT_EQ(relayed[0].text("payload"), "2f2f2f2f43414645414978");
  EXPECT_LT(json_real_value(json_object_get(relayed[0].fields, "asked")), relayed[0].t);
  line.host(3, TO_BOARD, bytes("Y"));
  line.board(3, {3});
  EXPECT_EQ(line.events("host-relay").size(), 1u);
}

TEST(SerialSniffer, tells_messages_with_their_contents_and_outcomes) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 1, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 2},
                            {'P', 0, 1, 'x'},
                            message(3, "ROMASUPO", {0, 1, 2}, "tell;a"),
                            message(4, "////SUPO", {0, 0, 0}, "tell;\xff")}));
  auto handed = line.events("host-handed");
  ASSERT_EQ(handed.size(), 2u);
  EXPECT_EQ(handed[0].number("number"), 3);
  EXPECT_EQ(handed[0].text("destination"), "ROMA");
  EXPECT_EQ(handed[0].text("origin"), "SUPO");
  EXPECT_EQ(handed[0].text("id"), "000102");
  EXPECT_EQ(handed[0].text("content"), "tell;a");
  EXPECT_EQ(handed[1].text("hex"), "74656c6c3bff");
  auto ended = line.events("host-outcome");
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_EQ(ended[0].number("number"), 7);
  EXPECT_EQ(ended[0].text("outcome"), "undelivered");
}

TEST(SerialSniffer, writes_the_keys_that_are_given_to_a_board_apart) {
  Line line;
  char *text = nullptr;
  size_t length = 0;
  line.sniffer.keys = open_memstream(&text, &length);
  const Bytes key = bytes("a key for tests!");
  line.host(1, TO_BOARD, joined({bytes("KSUPO"), key}));  // the board has no id yet
  line.greet();
  line.host(2, TO_BOARD, joined({bytes("KSUPO"), key}));
  line.host(3, TO_BOARD, joined({bytes("N//SU"), key}));
  line.host(4, TO_BOARD, joined({bytes("KSU\nO"), key}));
  line.host(5, TO_BOARD, joined({bytes("KSUPO"), bytes("too short")}));
  line.host(6, "KSUPROMA", joined({bytes("KSUPO"), key}));
  fclose(line.sniffer.keys);
  EXPECT_EQ(std::string(text, length),
            "ROMA SUPO = 61206b657920666f7220746573747321\n//SU = 61206b657920666f7220746573747321\n");
  free(text);
}

TEST(SerialSniffer, tells_once_what_is_taken_and_that_it_is_confirmed) {
  Line line;
  line.greet();
  for (uint8_t sequence : {2, 3}) {
    line.host(sequence, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0, 9});
    EXPECT_EQ(line.events("host-taken").size(), sequence - 2u);
    line.board(sequence, {0, 0});
  }
  ASSERT_EQ(line.events("host-taking").size(), 1u);
  ASSERT_EQ(line.events("host-taken").size(), 1u);
  EXPECT_EQ(line.events("host-taken")[0].number("number"), 9);
}

TEST(SerialSniffer, tells_what_two_replies_say_of_which_the_first_was_held) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 1, 3, 232, 0, 0, 0, 9});
  line.host(3, "//SUROMA", bytes("tell;help"));
  line.board(2, poll_reply({{'T', 0, 2, 7, 2}}));
  line.board(3, {0, 8});
  EXPECT_EQ(line.events("host-taken").size(), 1u);
  EXPECT_EQ(line.events("host-outcome").size(), 1u);
  ASSERT_EQ(line.events("host-transmit").size(), 1u);
  EXPECT_EQ(line.events("host-transmit")[0].number("number"), 8);
  line.board(2, poll_reply({{'T', 0, 2, 7, 2}}));
  EXPECT_EQ(line.events("host-outcome").size(), 1u);
}

TEST(SerialSniffer, tells_once_an_outcome_that_the_board_tells_again) {
  Line line;
  line.greet();
  const uint8_t LOST = 4, COMING = 8;
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}}));
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}, {'T', 0, 2, 8, 1}}));
  line.host(3, TO_BOARD, {'P', COMING, 0, 0, 0, 0, 0});
  line.board(3, poll_reply({{'T', 0, 2, 9, 1}}));
  line.host(4, TO_BOARD, {'P', LOST, 0, 0, 0, 0, 0});
  line.board(4, poll_reply({{'T', 0, 2, 7, 1}, {'T', 0, 2, 8, 1}, {'T', 0, 2, 9, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 3u);
  // Now the host has had them: the board is not to tell them any more.
  line.host(5, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(5, poll_reply({{'T', 0, 2, 9, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 4u);
}

TEST(SerialSniffer, tells_once_an_outcome_that_a_repeat_before_the_next_poll_asks_for_again) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}}));
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.host(3, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}, {'T', 0, 2, 8, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 2u);
  line.board(3, poll_reply({{'T', 0, 2, 7, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 3u);
  line.host(3, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(3, poll_reply({{'T', 0, 2, 7, 1}, {'T', 0, 2, 9, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 4u);
}

TEST(SerialSniffer, tells_once_an_outcome_where_a_poll_was_repeated_before_its_reply) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}}));
  line.board(2, poll_reply({{'T', 0, 2, 7, 1}, {'T', 0, 2, 8, 1}}));
  EXPECT_EQ(line.events("host-outcome").size(), 2u);
}

TEST(SerialSniffer, tells_once_an_outcome_that_the_board_tells_again_after_hello) {
  Line line;
  line.greet();
  for (uint8_t sequence : {2, 3}) {
    line.host(sequence, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
    line.board(sequence, poll_reply({{'T', 0, 2, 7, 1}}));
    EXPECT_EQ(line.events("host-outcome").size(), 1u);
    line.greet();
  }
  for (uint8_t sequence : {4, 5}) {
    line.host(sequence, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
    line.board(sequence, poll_reply({{'T', 0, 2, 7, 1}}));
    EXPECT_EQ(line.events("host-outcome").size(), sequence - 3u);
  }
}

TEST(SerialSniffer, tells_nothing_of_a_poll_that_is_answered_from_memory) {
  Line line;
  line.greet();
  for (int time = 0; time < 3; time++) {
    line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
    line.board(2, {0, 0});
  }
  EXPECT_EQ(line.events("host-nothing").size(), 1u);
  // Both repeats come before the reply to the first one.
  for (int time = 0; time < 2; time++) line.host(2, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0});
  for (int time = 0; time < 2; time++) line.board(2, {0, 0});
  EXPECT_EQ(line.events("host-nothing").size(), 1u);
}

TEST(SerialSniffer, tells_nothing_of_what_is_answered_from_memory) {
  Line line;
  line.greet();
  for (int time = 0; time < 2; time++) {
    line.host(2, "//SUROMA", bytes("tell;help"));
    line.board(2, {0, 7});
  }
  EXPECT_EQ(line.events("host-transmit").size(), 1u);
}

TEST(SerialSniffer, tells_nothing_of_what_is_refused_or_crosses_a_reset) {
  Line line;
  line.greet();
  line.host(2, "//SUROMA", bytes("tell;help"));
  line.board(2, {11, 0});
  serial_sniffer_reset(&line.sniffer);
  line.host(3, TO_BOARD, {'P', 0, 0, 0, 0, 0, 0, 9});
  line.board(3, {1});
  EXPECT_EQ(line.all(), 1u) << "the id alone";
}

TEST(SerialSniffer, skips_damage_and_goes_on_behind_it) {
  Line line;
  Bytes damaged = packet(1, TO_BOARD, {'H', 1});
  damaged[5] ^= 1;
  line.feed(true, damaged);
  line.feed(true, Bytes(3 * SERIAL_MAX_PACKET, 0x55));
  line.feed(true, {0, 0});
  line.feed(false, {0xFF, 1, 2, 0});
  EXPECT_EQ(line.all(), 0u);
  line.greet();
  EXPECT_EQ(line.all(), 1u);
}

TEST(SerialSniffer, tells_each_reading) {
  Line line;
  line.greet();
  line.host(2, TO_BOARD, {'P', 1, 0, 0, 0, 0, 0, 255});
  line.board(2, joined({{0, 4}, percept("light(700)"), percept("moving")}));
  line.host(3, TO_BOARD, {'P', 1, 0, 0, 0, 0, 0, 255});
  line.board(3, {0, 0});  // nothing new
  line.host(4, TO_BOARD, {'P', 1, 0, 0, 0, 0, 0, 255});
  line.board(4, {0, 4});  // nothing is perceived any more
  line.host(5, TO_BOARD, {'P', 1, 0, 0, 0, 0, 0, 255});
  line.board(5, joined({{0, 4}, percept("\xff"), percept("a"), {'P', 0, 9, 'x'}}));  // what is damaged is left out
  std::vector<std::string> told;
  for (const Event &event : line.events("percepts")) {
    char *list = json_dumps(json_object_get(event.fields, "percepts"), JSON_COMPACT);
    told.push_back(list);
    free(list);
  }
  EXPECT_EQ(told, (std::vector<std::string>{R"x(["light(700)","moving"])x", "[]", R"(["a"])"}));
  EXPECT_EQ(line.events("host-nothing").size(), 1u);
}
