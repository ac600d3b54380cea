// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <random>

extern "C" {
#include "line_code.h"
}

namespace {

// Decodes levels given bit by bit and keeps what comes out.
struct Receiver {
  explicit Receiver(double bit_rate = 2000) : bit_cycles(CYCLES_PER_SECOND / bit_rate) {
    line_decoder_init(&decoder, bit_rate, {this, nullptr, on_packet, on_damaged});
  }

  static void on_packet(void *context, const line_packet *packet) {
    auto *self = static_cast<Receiver *>(context);
    self->packets.emplace_back(packet->payload, packet->payload + packet->length);
    self->path = packet->path;
    self->start = packet->start;
    self->end = packet->end;
    self->bits = packet->bits;
    self->trailer = packet->trailer;
    self->told = static_cast<cycles_t>(self->decoder.next_sample);
  }

  static void on_damaged(void *context, line_error error, cycles_t) {
    static_cast<Receiver *>(context)->errors.push_back(error);
  }

  // `jitter` moves each edge by up to so many cycles; `stretch` makes the sender's bits longer.
  void send(const std::string &bits, int jitter = 0, double stretch = 1, int pause_bits = 20) {
    std::mt19937 random(1);
    double begin = static_cast<double>(now);
    for (size_t i = 0; i < bits.size(); i++) {
      int off = jitter ? static_cast<int>(random() % (2 * jitter + 1)) - jitter : 0;
      double at = begin + static_cast<double>(i) * bit_cycles * stretch + off;
      line_decoder_edge(&decoder, bits[i] == '1', static_cast<cycles_t>(at > 0 ? at : 0));
    }
    now = static_cast<cycles_t>(begin + static_cast<double>(bits.size()) * bit_cycles * stretch);
    line_decoder_edge(&decoder, false, now);
    rest(pause_bits);
  }

  void rest(int bits) {
    now += static_cast<cycles_t>(bits * bit_cycles);
    line_decoder_advance(&decoder, now);
  }

  line_decoder decoder;
  double bit_cycles;
  cycles_t now = 100000;
  unsigned path = 0;
  cycles_t start = 0, end = 0, told = 0;
  unsigned bits = 0;
  line_trailer trailer = LINE_NO_TRAILER;
  std::vector<std::vector<uint8_t>> packets;
  std::vector<line_error> errors;
};

}  // namespace

TEST(LineCode, decodes_every_packet_of_the_vectors) {
  json_t *root = load_vectors("radio.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "packets"), index, vector) {
    for (double stretch : {1.0, 0.97, 1.03}) {
      Receiver receiver;
      receiver.send(text_of(vector, "bits"), 500, stretch);
      ASSERT_EQ(receiver.packets.size(), 1u) << index << " stretched " << stretch;
      EXPECT_EQ(receiver.packets[0], from_hex(text_of(vector, "payload"))) << index;
      EXPECT_TRUE(receiver.errors.empty()) << index;
    }
  }
  json_decref(root);
}

TEST(LineCode, tells_the_path_of_every_copy_of_the_vectors_and_sends_it_so) {
  json_t *root = load_vectors("radio.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "copies"), index, vector) {
    const auto path = static_cast<unsigned>(json_integer_value(json_object_get(vector, "path")));
    const std::string bits = text_of(vector, "bits");
    const std::vector<uint8_t> payload = from_hex(text_of(vector, "payload"));
    Receiver receiver;
    receiver.send(bits);
    ASSERT_EQ(receiver.packets.size(), 1u) << index;
    EXPECT_EQ(receiver.packets[0], payload) << index;
    EXPECT_EQ(receiver.path, path) << index;
    uint8_t encoded[LINE_MAX_BITS];
    ASSERT_EQ(line_encode(encoded, payload.data(), payload.size(), path), bits.size());
    for (size_t i = 0; i < bits.size(); i++) EXPECT_EQ(encoded[i], bits[i] == '1') << index << ", bit " << i;
  }
  json_decref(root);
}

TEST(LineCode, refuses_every_damaged_packet_of_the_vectors) {
  json_t *root = load_vectors("radio.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "invalid"), index, vector) {
    Receiver receiver;
    receiver.send(text_of(vector, "bits"));
    EXPECT_TRUE(receiver.packets.empty()) << text_of(vector, "why");
  }
  json_decref(root);
}

TEST(LineCode, tells_when_the_packet_began_and_ended) {
  json_t *root = load_vectors("radio.json");
  const json_t *vector = json_array_get(json_object_get(root, "packets"), 1);
  std::string bits = text_of(vector, "bits");
  Receiver receiver;
  receiver.send(bits);
  // The first bit of the training is a 0: the carrier comes with the second.
  EXPECT_EQ(receiver.start, 100000 + 8000u);
  EXPECT_NEAR(static_cast<double>(receiver.end), 100000 + 8000.0 * static_cast<double>(bits.size()), 1);
  json_decref(root);
}

TEST(LineCode, decodes_the_next_packet_after_a_damaged_one) {
  json_t *root = load_vectors("radio.json");
  std::string good = text_of(json_array_get(json_object_get(root, "packets"), 0), "bits");
  std::string bad = good;
  bad[100] = bad[100] == '1' ? '0' : '1';
  Receiver receiver;
  receiver.send(bad);
  receiver.send(good);
  EXPECT_FALSE(receiver.errors.empty());  // the rest of the bad one may look like a start again
  EXPECT_EQ(receiver.packets.size(), 1u);
  json_decref(root);
}

TEST(LineCode, a_packet_close_behind_another_starts_where_it_does) {
  json_t *root = load_vectors("radio.json");
  std::string bits = text_of(json_array_get(json_object_get(root, "packets"), 0), "bits");
  Receiver receiver;
  receiver.send(bits, 0, 1, 6);
  cycles_t second = receiver.now;
  receiver.send(bits);
  ASSERT_EQ(receiver.packets.size(), 2u);
  EXPECT_EQ(receiver.start, second + 8000u);
  json_decref(root);
}

TEST(LineCode, no_single_wrong_bit_after_the_start_symbol_gets_through) {
  json_t *root = load_vectors("radio.json");
  std::string good = text_of(json_array_get(json_object_get(root, "packets"), 1), "bits");
  for (size_t i = 48; i < good.size(); i++) {
    std::string bad = good;
    bad[i] = bad[i] == '1' ? '0' : '1';
    Receiver receiver;
    receiver.send(bad);
    receiver.rest(2000);
    EXPECT_TRUE(receiver.packets.empty()) << "bit " << i;
  }
  json_decref(root);
}

TEST(LineCode, a_packet_that_broke_off_in_its_crc_counts_where_it_is_to) {
  json_t *root = load_vectors("radio.json");
  json_t *vector = json_array_get(json_object_get(root, "packets"), 0);
  const std::string bits = text_of(vector, "bits");
  for (size_t cut = 1; cut <= 24; cut++) {
    // Bits that are 0 anyway are not missed.
    size_t wrong = 0;
    for (size_t symbol = bits.size() - 24; symbol < bits.size(); symbol += 6) {
      const size_t missing = bits.find('1', std::max(symbol, bits.size() - cut));
      wrong += missing != std::string::npos && missing < symbol + 6;
    }
    for (bool mends : {false, true}) {
      Receiver receiver;
      receiver.decoder.at_sender = mends;
      receiver.send(bits.substr(0, bits.size() - cut));
      const bool counts = wrong == 0 || (mends && wrong <= 2);
      EXPECT_EQ(receiver.packets.size(), counts ? 1u : 0u) << cut;
      for (const auto &packet : receiver.packets) EXPECT_EQ(packet, from_hex(text_of(vector, "payload")));
    }
  }
  json_decref(root);
}

// The silence has then been long before what may follow the packet is known, or even its end.
TEST(LineCode, a_packet_that_broke_off_is_told_as_soon_as_nothing_follows_it) {
  for (int last = 0; last < 256; last++) {
    uint8_t payload[] = {'x', static_cast<uint8_t>(last)};
    uint8_t encoded[LINE_FRAMING_BITS + LINE_BITS_PER_BYTE * 2];
    const size_t length = line_encode(encoded, payload, sizeof payload, 0);
    std::string bits;
    for (size_t i = 0; i < length; i++) bits += encoded[i] ? '1' : '0';
    for (size_t cut = 1; cut <= 24; cut++) {
      Receiver receiver;
      receiver.decoder.at_sender = true;
      receiver.send(bits.substr(0, length - cut));
      receiver.rest(40);
      const size_t told = receiver.packets.size();
      if (told == 1) {
        EXPECT_NEAR(static_cast<double>(receiver.end), 100000 + length * receiver.bit_cycles, receiver.bit_cycles);
      }
      receiver.send("111111");
      EXPECT_EQ(receiver.packets.size(), told) << last << ", " << cut << " bits less";
    }
  }
}

// The replay of traces takes what is told by 8 bits late, and no later.
TEST(LineCode, a_trailer_that_broke_off_is_told_within_seven_bits_of_its_end) {
  const std::string words[] = {"001110110001", "110001001110"};
  uint8_t payload[] = {'x', 'y'};
  uint8_t encoded[LINE_FRAMING_BITS + LINE_BITS_PER_BYTE * 2];
  const size_t length = line_encode(encoded, payload, sizeof payload, 0);
  std::string packet;
  for (size_t i = 0; i < length; i++) packet += encoded[i] ? '1' : '0';
  for (const std::string &word : words) {
    for (size_t sent = 0; sent <= word.size(); sent++) {
      Receiver receiver;
      receiver.decoder.at_sender = true;
      receiver.send(packet + word.substr(0, sent));
      ASSERT_EQ(receiver.packets.size(), 1u) << word << ", " << sent;
      // Bits that are 0 anyway are not missed.
      size_t seen = sent;
      while (seen < word.size() && word[seen] == '0') seen++;
      if (sent < 3) seen = 0;
      EXPECT_LE(receiver.told, receiver.end + 7 * receiver.bit_cycles) << word << ", " << sent;
      EXPECT_GE(receiver.told, receiver.end - receiver.bit_cycles) << word << ", " << sent;
      EXPECT_EQ(receiver.bits, LINE_FRAMING_BITS + LINE_BITS_PER_BYTE * 2 + seen / 6 * 6) << word << ", " << sent;
      EXPECT_EQ(receiver.trailer, seen < 6 ? LINE_NO_TRAILER : word[0] == '0' ? LINE_MARK : LINE_PARITY) << sent;
    }
  }
}

TEST(LineCode, random_levels_do_no_harm) {
  std::mt19937 random(3);
  Receiver receiver;
  for (int i = 0; i < 100; i++) {
    std::string bits;
    for (int n = 0; n < 2000; n++) bits += random() % 2 ? '1' : '0';
    receiver.send(bits, 3000);
  }
  EXPECT_TRUE(receiver.packets.empty());
}
