// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "../../test/firmware/support/Digits.h"
#include "support.h"

extern "C" {
#include "frame_view.h"
}

static int read(frame_view *view, const std::string &text) {
  return frame_view_read(view, reinterpret_cast<const uint8_t *>(text.data()), text.size());
}

static std::string frame(const std::string &addresses, const std::string &message) {
  return addresses + digits()[message.size() * 8 / 64] + digits()[message.size() * 8 % 64] + message;
}

TEST(FrameView, reads_every_frame_of_the_vectors) {
  json_t *root = load_vectors("frames.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "valid"), index, vector) {
    std::vector<uint8_t> bytes = from_hex(text_of(vector, "frame"));
    frame_view view;
    ASSERT_EQ(frame_view_read(&view, bytes.data(), bytes.size()), 0) << index;
    EXPECT_EQ(std::string(view.destination, view.destination + 4), text_of(vector, "destination"));
    EXPECT_EQ(std::string(view.origin, view.origin + 4), text_of(vector, "origin"));
    EXPECT_EQ(std::vector<uint8_t>(view.message, view.message + view.message_length),
              from_hex(text_of(vector, "message")));
  }
  json_decref(root);
}

TEST(FrameView, refuses_what_is_no_frame) {
  json_t *root = load_vectors("frames.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "invalid"), index, vector) {
    std::vector<uint8_t> bytes = from_hex(text_of(vector, "bytes"));
    frame_view view;
    // A bystander does not judge origins.
    if (text_of(vector, "error") == "BAD_ORIGIN") continue;
    EXPECT_EQ(frame_view_read(&view, bytes.data(), bytes.size()), -1) << text_of(vector, "error");
  }
  json_decref(root);
}

TEST(FrameView, tells_kind_and_sealed) {
  static const struct {
    const char *frame;
    frame_kind kind;
    bool sealed;
  } CASES[] = {
      {"////ROMABItell;help", KIND_BROADCAST, false},
      {"//SUSUPOBw1234567890abcd", KIND_MULTICAST, true},
      {"SUHOSUPOBw1234567890abcd", KIND_UNICAST, true},
      {"SUHOSUPOCItell;a(plain,one)", KIND_UNICAST, false},
      {"SUHOSUPOAoshort", KIND_UNICAST, false},
      {"+FAASUPOAIx", KIND_FRAGMENT, false},
      {"+F/PSUPOBw1234567890abcd", KIND_FRAGMENT, false},
      {"+FAQSUPOAIx", KIND_RESERVED, false},  // no such index
      {"+K//SUPOBA12345678", KIND_ACKNOWLEDGEMENT, false},
      {"+GAASUPOAIx", KIND_RESERVED, false},
      {"/FAASUPOAIx", KIND_RESERVED, false},
  };
  for (const auto &c : CASES) {
    frame_view view;
    ASSERT_EQ(read(&view, c.frame), 0) << c.frame;
    EXPECT_EQ(view.kind, c.kind) << c.frame;
    EXPECT_EQ(view.sealed, c.sealed) << c.frame;
  }
}

// A performative of SPEC 3 that this does not know would be shown as sealed.
TEST(FrameView, every_content_of_the_vectors_is_plain) {
  json_t *root = load_vectors("contents.json");
  size_t index;
  json_t *vector;
  json_array_foreach(json_object_get(root, "valid"), index, vector) {
    std::vector<uint8_t> bytes = from_hex(text_of(vector, "content"));
    frame_view view;
    ASSERT_EQ(read(&view, frame("SUHOSUPO", std::string(bytes.begin(), bytes.end()))), 0) << index;
    EXPECT_FALSE(view.sealed) << text_of(vector, "text");
  }
  json_decref(root);
}

TEST(FrameView, every_performative_of_the_specification_is_plain) {
  std::string spec = read_text(SPEC);
  std::istringstream table(spec.substr(spec.find("| performative | conversation |")));
  int performatives = 0;
  for (std::string row; std::getline(table, row) && !row.empty();) {
    std::istringstream cell(row.substr(0, row.find(" |")));
    std::string word;
    // Every second word is between backticks.
    while (std::getline(cell, word, '`') && std::getline(cell, word, '`')) {
      performatives++;
      for (const char *conversation : {"", "#AbC"}) {
        frame_view view;
        ASSERT_EQ(read(&view, frame("SUHOSUPO", word + conversation + ";a(plain,one)")), 0);
        EXPECT_FALSE(view.sealed) << word;
      }
    }
  }
  EXPECT_GT(performatives, 0);
}

TEST(FrameView, what_only_looks_like_a_content_is_sealed) {
  for (const char *message : {"tel;aaaaaaaaaaaa", "tell#Ab;aaaaaaaaaa", "tellaaaaaaaaaaaa", "aaaaaaaaaaatell;",
                              ";aaaaaaaaaaaaaaa", "#AbC;aaaaaaaaaa"}) {
    frame_view view;
    ASSERT_EQ(read(&view, frame("SUHOSUPO", message)), 0);
    EXPECT_TRUE(view.sealed) << message;
  }
}

TEST(FrameView, reads_the_address_of_every_piece) {
  for (int id = 0; id < 64; id++)
    for (int digit = 0; digit < 16; digit++) {
      frame_view view;
      std::string address = std::string("+F") + digits()[id] + digits()[digit];
      ASSERT_EQ(read(&view, address + "SUPOAIx"), 0);
      EXPECT_EQ(view.kind, KIND_FRAGMENT);
      EXPECT_EQ(view.fragment_id, id);
      EXPECT_EQ(view.fragment_index, digit % 8);
      EXPECT_EQ(view.asks, digit >= 8);
    }
}

TEST(FrameView, tells_what_an_acknowledgement_says_by_its_length) {
  for (size_t length = 0; length <= 67; length++) {
    frame_view view;
    ASSERT_EQ(read(&view, frame("+KABSUPO", std::string(length, 'x'))), 0) << length;
    std::string expected = length == 8 ? "delivered" : length == 9 ? "fragments" : length == 16 ? "stale" : "unknown";
    EXPECT_EQ(frame_answer_text(&view), expected) << length;
  }
}
