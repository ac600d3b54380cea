// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_view.h"

#include <string.h>

#include "utf8.h"

#define HEADER_LENGTH 10
#define ADDRESS_LENGTH 4
#define NONCE_LENGTH 6
#define CONVERSATION_LENGTH 4  // with the # before it
#define TAG_LENGTH 8
#define PROOF_LENGTH 8
// The low bits of a fragment's index digit, and the one that asks for an answer.
#define FRAGMENT_INDEX 7
#define FRAGMENT_ASKS 8

static int digit_value(uint8_t digit) {
  static const char ALPHABET[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char *at = digit ? strchr(ALPHABET, digit) : NULL;
  return at ? (int)(at - ALPHABET) : -1;
}

static frame_kind kind_of(const uint8_t *destination) {
  if (memcmp(destination, "////", ADDRESS_LENGTH) == 0) return KIND_BROADCAST;
  if (memcmp(destination, "//", 2) == 0) return KIND_MULTICAST;
  if (memcmp(destination, "+F", 2) == 0 && digit_value(destination[3]) <= (FRAGMENT_ASKS | FRAGMENT_INDEX))
    return KIND_FRAGMENT;
  if (memcmp(destination, "+K", 2) == 0) return KIND_ACKNOWLEDGEMENT;
  if (destination[0] == '+' || destination[0] == '/') return KIND_RESERVED;
  return KIND_UNICAST;
}

// Whether the message is content in the clear: performative;term or performative#conversation;term in UTF-8.
static bool is_plain_content(const frame_view *view) {
  static const char *const PERFORMATIVES[] = {
#define PERFORMATIVE(name, text, meaning, conversation) text,
#include "Performatives.def"
#undef PERFORMATIVE
      NULL};
  const uint8_t *divider = memchr(view->message, ';', view->message_length);
  if (!divider || divider + 1 == view->message + view->message_length) return false;
  size_t performative = (size_t)(divider - view->message);
  if (performative > CONVERSATION_LENGTH && divider[-CONVERSATION_LENGTH] == '#') performative -= CONVERSATION_LENGTH;
  for (int i = 0; PERFORMATIVES[i]; i++)
    if (performative == strlen(PERFORMATIVES[i]) && memcmp(view->message, PERFORMATIVES[i], performative) == 0)
      return utf8_valid(view->message, view->message_length);
  return false;
}

int frame_view_read(frame_view *view, const uint8_t *payload, size_t length) {
  if (length < HEADER_LENGTH) return -1;
  for (int i = 0; i < HEADER_LENGTH; i++)
    if (digit_value(payload[i]) < 0) return -1;
  size_t bits = (size_t)(digit_value(payload[8]) * 64 + digit_value(payload[9]));
  if (bits != (length - HEADER_LENGTH) * 8) return -1;
  view->destination = payload;
  view->origin = payload + ADDRESS_LENGTH;
  view->message = payload + HEADER_LENGTH;
  view->message_length = length - HEADER_LENGTH;
  view->kind = kind_of(view->destination);
  view->fragment_id = digit_value(payload[2]);
  view->fragment_index = digit_value(payload[3]) & FRAGMENT_INDEX;
  view->asks = (digit_value(payload[3]) & FRAGMENT_ASKS) != 0;
  view->sealed = (view->kind == KIND_MULTICAST || view->kind == KIND_UNICAST) &&
                 view->message_length >= NONCE_LENGTH + TAG_LENGTH && !is_plain_content(view);
  return 0;
}

const char *frame_kind_text(frame_kind kind) {
  static const char *const TEXTS[] = {"broadcast", "multicast", "unicast", "fragment", "acknowledgement", "reserved"};
  return TEXTS[kind];
}

const char *frame_answer_text(const frame_view *view) {
  switch (view->message_length) {
    case PROOF_LENGTH: return "delivered";
    case 1 + PROOF_LENGTH: return "fragments";
    case NONCE_LENGTH + 2 + PROOF_LENGTH: return "stale";
    default: return "unknown";
  }
}
