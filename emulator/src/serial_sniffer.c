// SPDX-License-Identifier: GPL-3.0-or-later
#include "serial_sniffer.h"

#include <ctype.h>
#include <string.h>

#include "line_code.h"
#include "utf8.h"

#define SEQUENCE_LENGTH 1
#define CRC_LENGTH 2
#define ADDRESS_LENGTH 4
#define KEY_LENGTH 16
#define HEADER_LENGTH 10
#define RECORD_HEADER_LENGTH 3
#define ACTION_NUMBER_LENGTH 3
// The place of the epoch in the reply to hello, behind version and RF id.
#define EPOCH_AT 5
// The capabilities stand behind it; where a board of an earlier library has its name is a byte of NAME_FROM or more.
#define CAPABILITIES_AT 8
#define NAME_FROM 0x20
enum {
#define CAPABILITY(name, bit, title, meaning) CAPABILITY_##name = bit,
#include "Capabilities.def"
#undef CAPABILITY
};
// Places in a message record, behind the number.
#define DESTINATION_AT 1
#define ORIGIN_AT 5
#define ID_AT 9
#define ID_LENGTH 3
#define CONTENT_AT 12
#define STATUS_OK 0
// A poll's flags stand behind its command.
#define FLAGS_AT 1
#define FLAG_LOST 0x04
#define FLAG_COMING 0x08
// The flag of a reply to a poll that has a reading.
#define FLAG_READING 0x04
#define STATUS_NOT_GREETED 1
#define SERIAL_ADDRESS "++++"

// A frame and what stands before and after it in its packet.
typedef struct {
  uint8_t sequence;
  uint16_t crc;
  const uint8_t *destination, *origin;
  const uint8_t *message;
  size_t length;  // of the message
} serial_packet;

void serial_sniffer_init(serial_sniffer *s, trace *out, const char *board) {
  memset(s, 0, sizeof *s);
  s->out = out;
  s->board = board;
  memcpy(s->id, SERIAL_ADDRESS, sizeof s->id);
  s->taken = -1;
}

void serial_sniffer_reset(serial_sniffer *s) {
  s->from_host.length = s->from_board.length = 0;
  s->waiting = s->held_waiting = s->remembered = s->greeted = s->tells_again = false;
  s->taken = -1;
  memset(s->told, 0, sizeof s->told);
}

int serial_unstuff(uint8_t *bytes, size_t length) {
  size_t read = 0, written = 0;
  while (read < length) {
    size_t run = bytes[read++];
    if (run - 1 > length - read) return -1;
    memmove(bytes + written, bytes + read, run - 1);
    read += run - 1;
    written += run - 1;
    if (run < 0xFF && read < length) bytes[written++] = 0;
  }
  return (int)written;
}

// Returns 0, or -1 where the bytes are no packet.
static int read_packet(serial_line *line, serial_packet *packet) {
  if (line->length > SERIAL_MAX_PACKET) return -1;
  int length = serial_unstuff(line->bytes, line->length);
  if (length < SEQUENCE_LENGTH + HEADER_LENGTH + CRC_LENGTH) return -1;
  size_t checked = (size_t)length - CRC_LENGTH;
  packet->crc = (uint16_t)(line->bytes[checked] | line->bytes[checked + 1] << 8);
  packet->sequence = line->bytes[0];
  packet->destination = line->bytes + SEQUENCE_LENGTH;
  packet->origin = packet->destination + ADDRESS_LENGTH;
  packet->message = packet->destination + HEADER_LENGTH;
  packet->length = checked - SEQUENCE_LENGTH - HEADER_LENGTH;
  return packet->crc == crc_x25(line->bytes, checked) ? 0 : -1;
}

static bool is_for_board(const serial_packet *packet) {
  return memcmp(packet->destination, SERIAL_ADDRESS, ADDRESS_LENGTH) == 0;
}

static void begin(serial_sniffer *s, cycles_t at, const char *event) { trace_begin(s->out, at, s->board, event); }

static void write_number(serial_sniffer *s, cycles_t at, const char *event, int number) {
  begin(s, at, event);
  trace_count(s->out, "number", (uint64_t)number);
  trace_end(s->out);
}

// Writes who the board is now, if it has an id.
static void write_id(serial_sniffer *s, cycles_t at) {
  if (memcmp(s->id, SERIAL_ADDRESS, ADDRESS_LENGTH) == 0) return;
  begin(s, at, "host-id");
  trace_utf8(s->out, "id", s->id, ADDRESS_LENGTH);
  trace_hex(s->out, "epoch", s->epoch, SERIAL_EPOCH_LENGTH);
  if (s->unicasts_only) trace_flag(s->out, "unicastsOnly", true);
  trace_end(s->out);
}

// Whether it is an address, and of whom a board can have a key.
static bool is_sharer(const uint8_t *address) {
  for (int i = 0; i < ADDRESS_LENGTH; i++)
    if (!isalnum(address[i]) && address[i] != '/' && address[i] != '+') return false;
  return address[0] != '+';
}

// Writes a key before the board has set it: after a loss of power it may have the key though it did not say so.
static void write_key(serial_sniffer *s, const uint8_t *address, const uint8_t *key) {
  if (!s->keys || !is_sharer(address) || !is_sharer(s->id)) return;
  if (address[0] != '/') fprintf(s->keys, "%.4s ", (const char *)s->id);
  fprintf(s->keys, "%.4s = ", (const char *)address);
  for (int i = 0; i < KEY_LENGTH; i++) fprintf(s->keys, "%02x", key[i]);
  fputc('\n', s->keys);
  fflush(s->keys);
}

static void host_packet(serial_sniffer *s, const serial_packet *packet, cycles_t at) {
  bool for_board = is_for_board(packet);
  if (for_board && packet->length == 0) return;
  char command = for_board ? (char)packet->message[0] : 0;
  bool same = packet->sequence == s->request.sequence && packet->crc == s->request.crc;
  bool repeated = same && !(command && strchr("HP", command));
  if (repeated && (s->waiting || s->remembered)) return;  // it is answered from memory; a poll may be told more
  // The first byte of a request ends the hold of a poll, whose reply may be on its way still.
  s->held_waiting = s->waiting && s->request.command == 'P';
  s->held = s->request;
  bool forgets = s->request.forgets;
  s->request =
      (serial_request){.sequence = packet->sequence, .crc = packet->crc, .command = command, .taken = -1, .at = at};
  s->waiting = true;
  if (command == 'P' && packet->length > FLAGS_AT) {
    s->request.repeats = same;
    s->request.forgets = same ? forgets : !(packet->message[FLAGS_AT] & (FLAG_LOST | FLAG_COMING));
  }
  if (!for_board) {
    memcpy(s->request.address, packet->destination, ADDRESS_LENGTH);
    s->request.content_length = packet->length < SERIAL_MAX_MESSAGE ? packet->length : SERIAL_MAX_MESSAGE;
    memcpy(s->request.content, packet->message, s->request.content_length);
  }
  if (command == 'E' && packet->length == 1 + SERIAL_EPOCH_LENGTH)
    memcpy(s->request.epoch, packet->message + 1, SERIAL_EPOCH_LENGTH);
  if ((command == 'K' || command == 'N' || command == 'V') && packet->length == 1 + ADDRESS_LENGTH + KEY_LENGTH)
    write_key(s, packet->message + 1, packet->message + 1 + ADDRESS_LENGTH);
  if (command != 0 && strchr("IKNUFDV", command) && packet->length >= 1 + ADDRESS_LENGTH)
    memcpy(s->request.address, packet->message + 1, ADDRESS_LENGTH);
  if (command == 'Y' || command == 'A') {
    s->request.content_length = packet->length - 1;
    memcpy(s->request.content, packet->message + 1, s->request.content_length);
  }
  if (command == 'R' && packet->length == 2) s->request.open = packet->message[1] == 1;
  if (command == 'P' && packet->length == 8) {
    s->request.taken = packet->message[7];
    if (s->request.taken == s->taken)
      s->request.taken = -1;  // the board knows
    else if (s->greeted)
      write_number(s, at, "host-taking", s->request.taken);
  }
}

// A content of one agent for another, also where it is sealed on the air: boards give it to their hosts, and hosts to
// them, like this.
static void write_content(serial_sniffer *s, const uint8_t *content, size_t length) {
  if (utf8_valid(content, length))
    trace_utf8(s->out, "content", content, length);
  else
    trace_hex(s->out, "hex", content, length);
}

static void write_message(serial_sniffer *s, const uint8_t *value, size_t length, cycles_t at) {
  if (length < CONTENT_AT) return;
  begin(s, at, "host-handed");
  trace_count(s->out, "number", value[0]);
  trace_utf8(s->out, "destination", value + DESTINATION_AT, ADDRESS_LENGTH);
  trace_utf8(s->out, "origin", value + ORIGIN_AT, ADDRESS_LENGTH);
  trace_hex(s->out, "id", value + ID_AT, ID_LENGTH);
  write_content(s, value + CONTENT_AT, length - CONTENT_AT);
  trace_end(s->out);
}

static void write_no_key(serial_sniffer *s, const uint8_t *value, size_t length, cycles_t at) {
  if (length != 2 * ADDRESS_LENGTH) return;
  begin(s, at, "host-no-key");
  trace_utf8(s->out, "destination", value, ADDRESS_LENGTH);
  trace_utf8(s->out, "origin", value + ADDRESS_LENGTH, ADDRESS_LENGTH);
  trace_end(s->out);
}

static void write_outcome(serial_sniffer *s, const uint8_t *value, size_t length, cycles_t at) {
  static const char *const OUTCOMES[] = {"sent", "delivered", "undelivered"};
  if (length != 2 || value[1] >= sizeof OUTCOMES / sizeof *OUTCOMES || s->told[value[0]]) return;
  s->told[value[0]] = true;
  begin(s, at, "host-outcome");
  trace_count(s->out, "number", value[0]);
  trace_text(s->out, "outcome", OUTCOMES[value[1]]);
  trace_end(s->out);
}

static void write_records(serial_sniffer *s, const uint8_t *records, size_t length, cycles_t at) {
  while (length >= RECORD_HEADER_LENGTH) {
    size_t size = (size_t)(records[1] << 8 | records[2]);
    const uint8_t *value = records + RECORD_HEADER_LENGTH;
    if (size > length - RECORD_HEADER_LENGTH) return;
    if (records[0] == 'M') write_message(s, value, size, at);
    if (records[0] == 'T') write_outcome(s, value, size, at);
    if (records[0] == 'N') write_no_key(s, value, size, at);
    records = value + size;
    length -= RECORD_HEADER_LENGTH + size;
  }
}

// All that the board perceives now.
static void write_reading(serial_sniffer *s, const uint8_t *records, size_t length, cycles_t at) {
  bool first = true;
  begin(s, at, "percepts");
  trace_list_begin(s->out, "percepts");
  while (length >= RECORD_HEADER_LENGTH) {
    size_t size = (size_t)(records[1] << 8 | records[2]);
    const uint8_t *value = records + RECORD_HEADER_LENGTH;
    if (size > length - RECORD_HEADER_LENGTH) break;
    if (records[0] == 'P' && utf8_valid(value, size)) {
      trace_list_utf8(s->out, value, size, first);
      first = false;
    }
    records = value + size;
    length -= RECORD_HEADER_LENGTH + size;
  }
  trace_list_end(s->out);
  trace_end(s->out);
}

static void write_transmission(serial_sniffer *s, const serial_request *request, int number, cycles_t at) {
  begin(s, at, "host-transmit");
  trace_count(s->out, "number", (uint64_t)number);
  trace_utf8(s->out, "destination", request->address, ADDRESS_LENGTH);
  trace_time(s->out, "asked", request->at);
  write_content(s, request->content, request->content_length);
  trace_end(s->out);
}

static void write_relay(serial_sniffer *s, const serial_request *request, int number, cycles_t at) {
  begin(s, at, "host-relay");
  trace_count(s->out, "number", (uint64_t)number);
  trace_time(s->out, "asked", request->at);
  trace_hex(s->out, "payload", request->content, request->content_length);
  trace_end(s->out);
}

// The check value tells whether two boards have the same key, and nothing more (SPEC 5.2).
static void write_key_step(serial_sniffer *s, const serial_request *request, const char *step, const uint8_t *check,
                           size_t length, cycles_t at) {
  begin(s, at, "host-key");
  trace_utf8(s->out, "address", request->address, ADDRESS_LENGTH);
  trace_time(s->out, "asked", request->at);
  trace_text(s->out, "step", step);
  if (length != 0) trace_hex(s->out, "check", check, length);
  trace_end(s->out);
}

// Pins that change between `asked` and `replied`, when the board begins to reply, change by the action itself.
static void write_action(serial_sniffer *s, const serial_request *request, const uint8_t *reply, size_t length,
                         cycles_t at) {
  if (!utf8_valid(request->content, request->content_length)) return;
  begin(s, at, "host-action");
  trace_utf8(s->out, "action", request->content, request->content_length);
  trace_time(s->out, "asked", request->at);
  trace_time(s->out, "replied", 2 * s->from_board.first - s->from_board.second);
  trace_flag(s->out, "done", reply[0] == STATUS_OK);
  if (length == 1 + ACTION_NUMBER_LENGTH)
    trace_number(s->out, "number", (int32_t)((uint32_t)reply[1] << 24 | (uint32_t)reply[2] << 16 | reply[3] << 8) >> 8);
  trace_end(s->out);
}

static void write_radio(serial_sniffer *s, bool open, cycles_t at) {
  begin(s, at, "host-radio");
  trace_text(s->out, "radio", open ? "open" : "blocked");
  trace_end(s->out);
}

static void write_relaying(serial_sniffer *s, bool on, cycles_t at) {
  begin(s, at, "host-relaying");
  trace_text(s->out, "relaying", on ? "on" : "off");
  trace_end(s->out);
}

// Notes what the board has performed; `body` is the reply's, behind its status.
static void performed(serial_sniffer *s, serial_request *request, const uint8_t *body, size_t length, cycles_t at) {
  switch (request->command) {
    case 'H':
      s->greeted = s->tells_again = true;
      if (length < EPOCH_AT + SERIAL_EPOCH_LENGTH) break;
      memcpy(s->id, body + 1, ADDRESS_LENGTH);
      memcpy(s->epoch, body + EPOCH_AT, SERIAL_EPOCH_LENGTH);
      s->unicasts_only = length > CAPABILITIES_AT && body[CAPABILITIES_AT] < NAME_FROM &&
                         body[CAPABILITIES_AT] & CAPABILITY_UNICASTS_ONLY;
      write_id(s, at);
      break;
    case 'I':
      memcpy(s->id, request->address, ADDRESS_LENGTH);
      write_id(s, at);
      break;
    case 'E':
      if (memcmp(request->epoch, s->epoch, SERIAL_EPOCH_LENGTH) <= 0) break;
      memcpy(s->epoch, request->epoch, SERIAL_EPOCH_LENGTH);
      write_id(s, at);
      break;
    case 'K': write_key_step(s, request, "set", body, length, at); break;
    case 'N': write_key_step(s, request, "renew", body, length, at); break;
    case 'U': write_key_step(s, request, "use", body, length, at); break;
    case 'F': write_key_step(s, request, "finish", body, length, at); break;
    case 'D': write_key_step(s, request, "delete", body, length, at); break;
    case 'V': write_key_step(s, request, "session", body, length, at); break;
    case 'R': write_radio(s, request->open, at); break;
    case 'W':
      if (length == 1) write_relaying(s, body[0] != 0, at);
      break;
    case 'Y':
      if (length == 1) write_relay(s, request, body[0], at);
      break;
    case 'P':
      // Not when the poll comes: the board may answer a repeat of the one before first.
      if (request->forgets && !s->tells_again) memset(s->told, 0, sizeof s->told);
      request->forgets = s->tells_again = false;
      if (s->request.sequence == request->sequence) s->request.forgets = false;  // of its repeat
      if (request->taken >= 0 && request->taken != s->taken) {
        s->taken = request->taken;
        write_number(s, at, "host-taken", request->taken);
      }
      if (length > 0) write_records(s, body + 1, length - 1, at);
      if (length > 0 && body[0] & FLAG_READING) write_reading(s, body + 1, length - 1, at);
      if (length == 1 && body[0] == 0) {
        begin(s, at, "host-nothing");
        trace_end(s->out);
      }
      break;
    case 0:
      if (length == 1) write_transmission(s, request, body[0], at);
      break;
    default: break;
  }
}

static void board_packet(serial_sniffer *s, const serial_packet *packet, cycles_t at) {
  if (!is_for_board(packet) || packet->length == 0) return;
  bool held = s->held_waiting && packet->sequence == s->held.sequence;
  if (!held && !(s->waiting && packet->sequence == s->request.sequence)) return;
  uint8_t status = packet->message[0];
  serial_request *request = held ? &s->held : &s->request;
  bool from_memory = request->repeats && packet->crc == s->reply_crc;
  s->reply_crc = packet->crc;
  if (held) {
    s->held_waiting = false;
  } else {
    s->waiting = false;
    s->remembered = status != STATUS_NOT_GREETED;
  }
  if (request->command == 'A' && status != STATUS_NOT_GREETED)
    write_action(s, request, packet->message, packet->length, at);
  if (status == STATUS_OK && !from_memory) performed(s, request, packet->message + 1, packet->length - 1, at);
}

void serial_sniffer_byte(serial_sniffer *s, bool from_host, uint8_t byte, cycles_t at) {
  serial_line *line = from_host ? &s->from_host : &s->from_board;
  serial_packet packet;
  if (byte != 0) {
    if (line->length == 0) line->first = at;
    if (line->length == 1) line->second = at;
    if (line->length < SERIAL_MAX_PACKET) line->bytes[line->length] = byte;
    if (line->length <= SERIAL_MAX_PACKET) line->length++;
    return;
  }
  if (read_packet(line, &packet) == 0) {
    if (from_host)
      host_packet(s, &packet, at);
    else
      board_packet(s, &packet, at);
  }
  line->length = 0;
}
