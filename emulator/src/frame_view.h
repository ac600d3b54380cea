// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a radio payload that a sniffer without keys can tell (SPEC sections 1 to 3, 5 and 7).
#ifndef JAVINO_FRAME_VIEW_H
#define JAVINO_FRAME_VIEW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
  KIND_BROADCAST,
  KIND_MULTICAST,
  KIND_UNICAST,
  KIND_FRAGMENT,
  KIND_ACKNOWLEDGEMENT,
  KIND_RESERVED
} frame_kind;

typedef struct {
  const uint8_t *destination;  // four digits
  const uint8_t *origin;       // four digits
  const uint8_t *message;
  size_t message_length;
  frame_kind kind;
  bool sealed;         // a multicast or unicast with room for nonce and tag that does not read as content
  int fragment_id;     // of a fragment, 0…63
  int fragment_index;  // of a fragment, 0…7
  bool asks;           // the fragment wants an answer
} frame_view;

// Reads a payload as a frame. Returns 0, or -1 where it is none (SPEC section 2).
int frame_view_read(frame_view *view, const uint8_t *payload, size_t length);

const char *frame_kind_text(frame_kind kind);

// The meaning of an acknowledgement (emulator/README.md): "unknown" for a length that SPEC 7.3 does not have.
const char *frame_answer_text(const frame_view *view);

#endif
