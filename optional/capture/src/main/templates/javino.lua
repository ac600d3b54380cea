-- SPDX-License-Identifier: Apache-2.0
-- Dissects Javino's packets in Wireshark and tshark, 4.0 and newer: those of the air (link type USER0) and those of the
-- serial line (USER1), as SPEC.md section 10 has them in a file. The names are those of SPEC.md.
-- Put it into Wireshark's folder of plugins (Help, About, Folders), or name it: wireshark -X lua_script:javino.lua

local RECORD_VERSION = 1
local HEADER_LENGTH = 10
local MAX_MESSAGE_LENGTH = 511
local MAX_CONTENT_LENGTH = 494
local MAX_RADIO_PAYLOAD = 77
local FRAGMENT_LENGTH = 67
local E32_FRAGMENT_LENGTH = 42
local NONCE_LENGTH, TAG_LENGTH, PROOF_LENGTH = 6, 8, 8
local REVOCATION_LIST_LENGTH, SIGNATURE_LENGTH = 71, 64  -- of one without serials, and of that its signature
local LONGEST_COUNT = 80
local HOPS = 4  -- hops and distances are told modulo it
local LAST_PATH = HOPS + HOPS * HOPS - 1
local FRAGMENTS_TIME = 5  -- seconds without a new fragment after which a message is forgotten
local ANSWERABLE = 16  -- frames with the same last bits of their nonce among which an answer looks for its own

local air = Proto("javino", "Javino")
local serial = Proto("javino_serial", "Javino serial line")

air.prefs.keyring = Pref.string("Keyring", "", "The file of javino keygen: with it, contents are opened, and tags and proofs are checked")

-- ---------------------------------------------------------------------------------------------------------------------
-- Names

local WAYS = {[0] = "sent", [1] = "received"}
local HOW = {[0] = "intact", [1] = "mended", [2] = "damaged", [3] = "damaged, shown as sent"}
local HEARD = {[0] = "intact", [1] = "mended", [2] = "damaged"}
local TRAILERS = {[0] = "none", [1] = "MARK", [2] = "PARITY", [255] = "not known"}
local MARK, PARITY = 0x78, 0x87
local FROM = {[0] = "host", [1] = "board"}
local STATUSES = {}
for number, name in ipairs({
  @Statuses.def: "$1",
}) do STATUSES[number - 1] = name end
local OUTCOMES = {[0] = "sent", "delivered", "undelivered"}
local ROLES = {[0] = "current", "previous", "next", "session",
  "current, floors may be lost", "previous, floors may be lost", "next, floors may be lost"}
local RECORDS = {P = "percept", M = "message", T = "transmission", N = "no key", O = "overheard"}
local COMMANDS = {
  @Commands.def: [$2] = "$3",
  transmit = "transmit"}
-- Names of bits, titles, bits.
local CAPABILITIES = {
  @Capabilities.def: {("$1"):lower(), "$3", $2},
}
local COUNTERS = {
  @Counters.def: "$camel",
}
-- How a performative goes with a conversation.
local PERFORMATIVES = {
  @Performatives.def: $2 = "$4",
}
local PROTOCOLS = {m = "mutualism", i = "inquilinism", c = "cloning", p = "predation"}
local RESERVED_WORDS = {self = true, ["true"] = true, ["else"] = true, elif = true}
-- Host messages (SPEC 3.1) by their first bytes, and the lengths of their bodies, of the fragments from 0 on; of the others any.
local KINDS, BODIES = {}, {}
local LONGEST_BODY, FRAGMENT_BODY = 63, 62
for i, row in ipairs({
  @HostMessages.def: {"$1", $3},
}) do
  local name, length = row[1], row[2]
  KINDS[0x7F + i] = name
  if length >= 0 then BODIES[name] = length <= LONGEST_BODY and {length} or {FRAGMENT_BODY, length - FRAGMENT_BODY} end
end
local FIRST_SEALED = 0x88

-- ---------------------------------------------------------------------------------------------------------------------
-- Fields

local f = {}
local fields_of = {[air] = {}, [serial] = {}}

local function field(proto, name, kind, title, ...)
  local made = ProtoField[kind]((proto == air and "javino." or "javino.serial.") .. name, title, ...)
  f[(proto == air and "" or "serial.") .. name] = made
  table.insert(fields_of[proto], made)
end

field(air, "error", "string", "Error")
field(air, "record_version", "uint8", "Version of the record")
field(air, "board", "string", "Board")
field(air, "way", "uint8", "Way", base.DEC, WAYS)
field(air, "how", "uint8", "How it came", base.DEC, HOW)
field(air, "reason", "string", "Reason")
field(air, "trailer", "uint8", "Trailer", base.DEC, TRAILERS)
field(air, "hops", "uint8", "Hops, modulo 4")
field(air, "distance", "uint8", "Distance, modulo 4")
field(air, "parts", "uint8", "Parts that are here", base.HEX)
field(air, "count", "uint8", "Count")
field(air, "payload", "bytes", "Payload")
field(air, "crc", "uint16", "CRC", base.HEX)
field(air, "crc.right", "bool", "CRC is right")
field(air, "trailer.bytes", "bytes", "Trailer's bytes")
field(air, "trailer.parity", "bytes", "Parity")

field(air, "address", "string", "Address")
field(air, "destination", "string", "Destination")
field(air, "destination.class", "string", "Class")
field(air, "destination.group", "string", "Group")
field(air, "destination.member", "string", "Member")
field(air, "origin", "string", "Origin")
field(air, "origin.group", "string", "Group")
field(air, "origin.member", "string", "Member")
field(air, "size", "uint16", "Size", base.UNIT_STRING, {" bits"})
field(air, "message", "bytes", "Message")
field(air, "repeat_of", "framenum", "Sent again; first in", base.NONE, frametype.RETRANS_PREV)

field(air, "content", "string", "Content")
field(air, "performative", "string", "Performative")
field(air, "conversation", "uint24", "Conversation")
field(air, "term", "string", "Term")
field(air, "move", "uint32", "Move", base.HEX)
field(air, "move.protocol", "string", "Protocol")
field(air, "move.parts", "uint8", "Count of parts")
field(air, "move.hash", "bytes", "Hash")
field(air, "move.packed_length", "uint24", "Packed length")
field(air, "move.text_length", "uint24", "Text length")
field(air, "move.token", "bytes", "Return token")
field(air, "move.home", "string", "Home")
field(air, "move.name", "string", "Name")
field(air, "move.part", "uint8", "Part")
field(air, "move.offset", "uint24", "Offset")
field(air, "move.packed", "bytes", "Packed bytes")
field(air, "move.reason", "string", "Error and reason")

field(air, "host_message", "string", "Host message")
field(air, "host_message.kind", "uint8", "Kind", base.HEX, KINDS)
field(air, "host_message.fragment", "uint8", "Fragment")
field(air, "host_message.to", "string", "To")
field(air, "host_message.body", "bytes", "Body")
field(air, "host_message.wanted", "uint8", "Kind that is wanted", base.HEX, KINDS)
field(air, "host_message.wanted.fragment", "uint8", "Fragment that is wanted")
field(air, "host_message.id", "uint24", "Id of the content")
field(air, "revocation_list.authority", "bytes", "Authority")
field(air, "revocation_list.sequence", "uint16", "Sequence")
field(air, "revocation_list.day", "uint16", "Day", base.UNIT_STRING, {" days after 1970-01-01"})
field(air, "revocation_list.least_until", "uint16", "Least until", base.UNIT_STRING, {" days after 1970-01-01"})
field(air, "revocation_list.serial", "uint16", "Revoked serial")
field(air, "revocation_list.signature", "bytes", "Signature")

field(air, "nonce", "bytes", "Nonce N")
field(air, "epoch", "uint24", "Epoch")
field(air, "counter", "uint24", "Counter")
field(air, "sealed", "bytes", "Sealed content C")
field(air, "tag", "bytes", "Tag T")
field(air, "tag.right", "bool", "Tag is right")

field(air, "fragment.id", "uint8", "Id of the whole")
field(air, "fragment.index", "uint8", "Index")
field(air, "fragment.asks", "bool", "Asks for an answer")
field(air, "fragment.part", "bytes", "Part")
field(air, "fragment.whole_in", "framenum", "Whole in")
field(air, "fragment.in", "framenum", "Fragment in")

field(air, "acknowledgement.nonce", "uint16", "Last bits of the nonce", base.HEX)
field(air, "acknowledgement.answers", "string", "Answers")
field(air, "acknowledgement.fragments", "uint8", "Fragments that are here", base.HEX)
field(air, "acknowledgement.floor", "bytes", "Floor")
field(air, "acknowledgement.uptime", "uint16", "Uptime", base.UNIT_STRING, {" × 0.1 s"})
field(air, "acknowledgement.proof", "bytes", "Proof")
field(air, "acknowledgement.proof.right", "bool", "Proof is right")
field(air, "acknowledgement.parity", "bool", "Asks for parity")
field(air, "acknowledgement.of", "framenum", "Answers the packet in", base.NONE, frametype.REQUEST)
field(air, "acknowledgement.sender", "string", "Sender of that packet")
field(air, "acknowledgement.time", "relative_time", "Time from that packet's end to this one's")
field(air, "acknowledged_in", "framenum", "Acknowledged in", base.NONE, frametype.RESPONSE)
field(air, "acknowledged_time", "relative_time", "Time until then")

field(serial, "record_version", "uint8", "Version of the record")
field(serial, "board", "string", "Board")
field(serial, "from", "uint8", "From", base.DEC, FROM)
field(serial, "packet", "bytes", "Packet, COBS")
field(serial, "sequence", "uint8", "Sequence")
field(serial, "crc", "uint16", "CRC", base.HEX)
field(serial, "crc.right", "bool", "CRC is right")
field(serial, "repeat_of", "framenum", "Repeated; first in", base.NONE, frametype.RETRANS_PREV)
field(serial, "reply_in", "framenum", "Reply in", base.NONE, frametype.RESPONSE)
field(serial, "request_in", "framenum", "Request in", base.NONE, frametype.REQUEST)
field(serial, "time", "relative_time", "Time from the request to this reply")
field(serial, "command", "string", "Command")
field(serial, "status", "uint8", "Status", base.DEC, STATUSES)
field(serial, "body", "bytes", "Body")
field(serial, "protocol_version", "uint8", "Protocol version")
field(serial, "rf_id", "string", "RF id")
field(serial, "boot_epoch", "uint24", "Boot epoch")
field(serial, "capabilities", "uint8", "Capabilities", base.HEX)
for _, row in ipairs(CAPABILITIES) do field(serial, "capabilities." .. row[1], "bool", row[2], 8, nil, row[3]) end
field(serial, "firmware", "string", "Firmware name")
field(serial, "act.number", "int24", "Number")
field(serial, "poll.flags", "uint8", "Flags", base.HEX)
field(serial, "poll.percepts", "bool", "Percepts are wanted", 8, nil, 0x01)
field(serial, "poll.now", "bool", "A reading is made and told at once", 8, nil, 0x02)
field(serial, "poll.lost", "bool", "The reply to an earlier poll is lost", 8, nil, 0x04)
field(serial, "poll.coming", "bool", "The reply to an earlier poll may still come", 8, nil, 0x08)
field(serial, "poll.more", "bool", "More is waiting", 8, nil, 0x01)
field(serial, "poll.left_out", "bool", "Some percepts were left out", 8, nil, 0x02)
field(serial, "poll.reading", "bool", "The reply has a reading", 8, nil, 0x04)
field(serial, "poll.damaged", "bool", "The memory of nonces did not hold", 8, nil, 0x08)
field(serial, "poll.taken_timer", "uint8", "One more than the radio's timer, which is taken", base.DEC, nil, 0x70)
field(serial, "poll.hold", "uint16", "Hold", base.UNIT_STRING, {" ms"})
field(serial, "poll.least", "uint24", "Least", base.UNIT_STRING, {" ms"})
field(serial, "poll.taken", "uint8", "Taken")
field(serial, "record.type", "string", "Type of record")
field(serial, "record.length", "uint16", "Length")
field(serial, "percept", "string", "Percept")
field(serial, "message.number", "uint8", "Number of the message")
field(serial, "message.destination", "string", "Destination")
field(serial, "message.origin", "string", "Origin")
field(serial, "message.id", "uint24", "Id of the message")
field(serial, "no_key.destination", "string", "Destination")
field(serial, "no_key.origin", "string", "Origin")
field(serial, "transmission.number", "uint8", "Transmission number")
field(serial, "transmission.outcome", "uint8", "Outcome", base.DEC, OUTCOMES)
field(serial, "overheard.time", "uint32", "Time", base.UNIT_STRING, {" ms after the board's boot"})
field(serial, "overheard.how", "uint8", "How it came", base.DEC, HEARD)
field(serial, "overheard.payload", "bytes", "Payload")
field(serial, "action", "string", "Action")
field(serial, "actions.offset", "uint16", "Offset")
field(serial, "actions.count", "uint8", "Count of actions")
field(serial, "actions.name", "string", "Name")
field(serial, "radio", "bool", "Radio open")
field(serial, "overhear", "bool", "Overhear")
field(serial, "relay", "bytes", "Frame to be relayed")
field(serial, "relaying", "bool", "Relaying")
field(serial, "relaying.number", "uint16", "Random number of the relay")
field(serial, "key.address", "string", "Address of the key")
field(serial, "key", "bytes", "Key")
field(serial, "key.role", "uint8", "Role", base.DEC, ROLES)
field(serial, "key.check", "bytes", "Check value")
for _, name in ipairs(COUNTERS) do field(serial, "counters." .. name, "uint32", name) end
field(serial, "counters.unknown", "uint8", "Number of an unknown counter")

air.fields = fields_of[air]
serial.fields = fields_of[serial]

local e_error = ProtoExpert.new("javino.expert.error", "Error", expert.group.PROTOCOL, expert.severity.WARN)
local e_secret = ProtoExpert.new("javino.expert.unproven", "Not proven", expert.group.SECURITY, expert.severity.ERROR)
local e_repeat = ProtoExpert.new("javino.expert.repeat", "Sent again", expert.group.SEQUENCE, expert.severity.NOTE)
local e_status = ProtoExpert.new("javino.expert.status", "Refused", expert.group.RESPONSE_CODE, expert.severity.NOTE)
air.experts = {e_error, e_secret, e_repeat, e_status}

-- ---------------------------------------------------------------------------------------------------------------------
-- Bytes

local function number(bytes, from, to)
  local value = 0
  for i = from, to do value = value * 256 + bytes:byte(i) end
  return value
end

local BASE64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
local DIGITS = {}
for i = 1, 64 do DIGITS[BASE64:byte(i)] = i - 1 end

-- The number that some Base64 digits hold, or nil.
local function digits(bytes, from, to)
  local value = 0
  for i = from, to do
    local digit = DIGITS[bytes:byte(i)]
    if not digit then return nil end
    value = value * 64 + digit
  end
  return value
end

-- Whether all is UTF-8 (RFC 3629).
local function is_utf8(bytes)
  local at = 1
  while at <= #bytes do
    local first = bytes:byte(at)
    local more = first < 0x80 and 0 or first >= 0xC2 and first < 0xE0 and 1 or first >= 0xE0 and first < 0xF0 and 2
      or first >= 0xF0 and first < 0xF5 and 3
    if not more or at + more > #bytes then return false end
    for i = at + 1, at + more do
      local next = bytes:byte(i)
      if next < 0x80 or next > 0xBF then return false end
    end
    local second = more > 0 and bytes:byte(at + 1)
    if first == 0xE0 and second < 0xA0 or first == 0xED and second > 0x9F or first == 0xF0 and second < 0x90
      or first == 0xF4 and second > 0x8F then return false end
    at = at + more + 1
  end
  return true
end

-- Text that can be shown in a line of a list.
local function plain(bytes)
  return is_utf8(bytes) and (bytes:gsub("%c", "·")) or "(no UTF-8)"
end

local CRC_TABLE = {}
for i = 0, 255 do
  local crc = i
  for _ = 1, 8 do crc = bit.band(crc, 1) == 1 and bit.bxor(bit.rshift(crc, 1), 0x8408) or bit.rshift(crc, 1) end
  CRC_TABLE[i] = crc
end

-- CRC-16/X-25 (SPEC 4.1).
local function crc16(bytes)
  local crc = 0xFFFF
  for i = 1, #bytes do crc = bit.bxor(bit.rshift(crc, 8), CRC_TABLE[bit.band(bit.bxor(crc, bytes:byte(i)), 0xFF)]) end
  return bit.bxor(crc, 0xFFFF)
end

-- The bytes before the closing 0x00, decoded; or nil.
local function cobs(packet)
  local parts, at = {}, 1
  while at <= #packet do
    local code = packet:byte(at)
    if code == 0 or at + code - 1 > #packet then return nil end
    local part = packet:sub(at + 1, at + code - 1)
    if part:find("\0", 1, true) then return nil end
    table.insert(parts, part)
    at = at + code
    if code < 255 and at <= #packet then table.insert(parts, "\0") end
  end
  return table.concat(parts)
end

-- ---------------------------------------------------------------------------------------------------------------------
-- Keys: AES-128 (FIPS 197), CFB128 (SP 800-38A) and CMAC (SP 800-38B). Wireshark's Lua has ciphers only since 4.4. All that
-- is needed is the cipher's forward direction.

local SBOX, DOUBLED = {}, {}
do
  local p, q = 1, 1
  repeat
    p = bit.band(bit.bxor(p, p * 2, bit.band(p, 0x80) ~= 0 and 0x11B or 0), 0xFF)
    q = bit.bxor(q, q * 2)
    q = bit.bxor(q, q * 4)
    q = bit.band(bit.bxor(q, q * 16), 0xFF)
    if bit.band(q, 0x80) ~= 0 then q = bit.bxor(q, 0x09) end
    local turned = q
    for i = 1, 4 do turned = bit.bxor(turned, bit.band(bit.bor(q * 2 ^ i, bit.rshift(q, 8 - i)), 0xFF)) end
    SBOX[p] = bit.bxor(turned, 0x63)
  until p == 1
  SBOX[0] = 0x63
  for i = 0, 255 do DOUBLED[i] = bit.band(bit.bxor(i * 2, i >= 128 and 0x11B or 0), 0xFF) end
end

-- The 176 bytes of the round keys.
local function schedule(key)
  local w, constant = {key:byte(1, 16)}, 1
  for i = 17, 176, 4 do
    local t = {w[i - 4], w[i - 3], w[i - 2], w[i - 1]}
    if i % 16 == 1 then
      t = {bit.bxor(SBOX[t[2]], constant), SBOX[t[3]], SBOX[t[4]], SBOX[t[1]]}
      constant = DOUBLED[constant]
    end
    for j = 0, 3 do w[i + j] = bit.bxor(w[i + j - 16], t[j + 1]) end
  end
  return w
end

local function aes(w, block)
  local s = {block:byte(1, 16)}
  for i = 1, 16 do s[i] = bit.bxor(s[i], w[i]) end
  for round = 1, 10 do
    local t = {}
    for i = 0, 15 do t[i + 1] = SBOX[s[(i + 4 * (i % 4)) % 16 + 1]] end
    if round < 10 then
      for c = 1, 13, 4 do
        local a, b, d, e = t[c], t[c + 1], t[c + 2], t[c + 3]
        local all = bit.bxor(a, b, d, e)
        t[c] = bit.bxor(a, all, DOUBLED[bit.bxor(a, b)])
        t[c + 1] = bit.bxor(b, all, DOUBLED[bit.bxor(b, d)])
        t[c + 2] = bit.bxor(d, all, DOUBLED[bit.bxor(d, e)])
        t[c + 3] = bit.bxor(e, all, DOUBLED[bit.bxor(e, a)])
      end
    end
    for i = 1, 16 do s[i] = bit.bxor(t[i], w[16 * round + i]) end
  end
  return string.char(table.unpack(s))
end

local function xor(a, b)
  local out = {}
  for i = 1, #a do out[i] = string.char(bit.bxor(a:byte(i), b:byte(i))) end
  return table.concat(out)
end

local function doubled(block)
  local out, carry = {}, 0
  for i = 16, 1, -1 do
    local value = block:byte(i) * 2 + carry
    out[i] = string.char(bit.band(value, 0xFF))
    carry = bit.rshift(value, 8)
  end
  local last = bit.bxor(out[16]:byte(), carry == 1 and 0x87 or 0)
  return table.concat(out, "", 1, 15) .. string.char(last)
end

local function cmac(w, text)
  local subkey = doubled(aes(w, ("\0"):rep(16)))
  local full = #text > 0 and #text % 16 == 0
  if not full then
    text = text .. "\128" .. ("\0"):rep(15 - #text % 16)
    subkey = doubled(subkey)
  end
  local state = ("\0"):rep(16)
  for at = 1, #text, 16 do
    local block = xor(text:sub(at, at + 15), state)
    state = aes(w, at + 16 > #text and xor(block, subkey) or block)
  end
  return state
end

local function open_cfb(w, iv, sealed)
  local out = {}
  for at = 1, #sealed, 16 do
    local block = sealed:sub(at, at + 15)
    table.insert(out, xor(block, aes(w, iv)))
    iv = block
  end
  return table.concat(out)
end

-- The keys that SPEC 5.2 derives from a key.
local function derived(key)
  local w = schedule(key)
  local function kdf(label) return schedule(cmac(w, "\1" .. label .. "\0\0\128")) end
  return {enc = kdf("JavinoEnc"), mac = kdf("JavinoMac")}
end

local keyring = {}  -- by their two addresses, or the group's one: the keys that may have sealed

local function pair(one, other) return one < other and one .. other or other .. one end

local function read_keyring(name)
  keyring = {}
  if name == "" then return end
  local file, why = io.open(name)
  if not file then
    report_failure("javino: the keyring cannot be read: " .. why)
    return
  end
  for line in file:lines() do
    local members, keys = line:gsub("^\xEF\xBB\xBF", ""):gsub("#.*", ""):match("^%s*(.-)%s*=%s*(.-)%s*$")
    local one, other = (members or ""):match("^(%S+)%s+(%S+)$")
    for hex in (keys or ""):gmatch("%x+") do
      if #hex == 32 then
        local name = one and pair(one, other) or members
        keyring[name] = keyring[name] or {}
        table.insert(keyring[name], derived((hex:gsub("%x%x", function(digit) return string.char(tonumber(digit, 16)) end))))
      end
    end
  end
  file:close()
end

-- The keys for a frame, or none.
local function keys_for(destination, origin)
  return keyring[destination:sub(1, 2) == "//" and destination or pair(destination, origin)] or {}
end

-- The content and true; nil and false where no key has made the tag; nil where there is no key.
local function open(frame)
  local keys = keys_for(frame.destination, frame.origin)
  for _, key in ipairs(keys) do
    if cmac(key.mac, frame.bytes:sub(1, -TAG_LENGTH - 1)):sub(1, TAG_LENGTH) == frame.bytes:sub(-TAG_LENGTH) then
      local iv = aes(key.enc, frame.origin .. frame.destination .. frame.nonce .. "\0\0")
      return open_cfb(key.enc, iv, frame.message:sub(NONCE_LENGTH + 1, -TAG_LENGTH - 1)), true
    end
  end
  if #keys > 0 then return nil, false end
end

-- Whether a frame's partner has made a proof, and whether it then asks for parity; nil where there is no key.
local PROOF_TYPES = {delivered = {"\6", "\22"}, fragments = {"\7", "\23"}, stale = {"\8"}}

local function is_proof(answered, acknowledger, answers, message)
  local keys = keys_for(answered.destination, answered.origin)
  for _, key in ipairs(keys) do
    for i, type in ipairs(PROOF_TYPES[answers]) do
      local told = type .. answered.nonce .. answered.origin .. acknowledger .. message:sub(1, -PROOF_LENGTH - 1)
      if cmac(key.mac, told):sub(1, PROOF_LENGTH) == message:sub(-PROOF_LENGTH) then return true, i == 2 end
    end
  end
  if #keys > 0 then return false end
end

-- ---------------------------------------------------------------------------------------------------------------------
-- Facts known from earlier packets. They are learned in the first pass, when packets come in their order.

local known

local function forget()
  known = {frames = {}, packets = {}, answerable = {}, partial = {}, last_request = {}, requests = {}}
  read_keyring(air.prefs.keyring)
end

air.init = forget
function air.prefs_changed() read_keyring(air.prefs.keyring) end

-- From an earlier packet to this one, to the microsecond.
local function since(pinfo, earlier)
  local micros = math.floor((pinfo.abs_ts - earlier) * 1e6 + 0.5)
  return NSTime.new(math.floor(micros / 1e6), micros % 1e6 * 1000)
end

-- Facts known of this packet.
local function this_packet(pinfo)
  known.packets[pinfo.number] = known.packets[pinfo.number] or {}
  return known.packets[pinfo.number]
end

-- ---------------------------------------------------------------------------------------------------------------------
-- Frames

local function complain(tree, expert, range, name, why)
  local item = range and tree:add(f["error"], range, name) or tree:add(f["error"], name)
  item:set_generated():add_proto_expert_info(expert, why and name .. ": " .. why or name)
end

local function class_of(address)
  local value = digits(address, 1, 4)
  if address == "++++" then return "serial" end
  if address == "////" then return "broadcast" end
  if address:sub(1, 2) == "//" then return "multicast" end
  if address:sub(1, 2) == "+F" then return "fragment" end
  if address:sub(1, 2) == "+K" then return "acknowledgement" end
  if value >= 62 * 64 ^ 3 or RESERVED_WORDS[address] then return "reserved" end
  return "device"
end

-- The frame that fills these bytes, or the name of the error and why.
local function parse_frame(bytes)
  if #bytes < HEADER_LENGTH then return nil, "TOO_SHORT", "a frame has at least 10 bytes" end
  if not digits(bytes, 1, 8) then return nil, "BAD_DIGIT", "no address" end
  local bits = digits(bytes, 9, 10)
  if not bits then return nil, "BAD_DIGIT", "no size" end
  if bits % 8 ~= 0 then return nil, "PARTIAL_BYTE", bits .. " bits" end
  if bits ~= 8 * (#bytes - HEADER_LENGTH) then return nil, "SIZE_MISMATCH", bits .. " bits, " .. 8 * (#bytes - HEADER_LENGTH) .. " follow" end
  local frame = {bytes = bytes, destination = bytes:sub(1, 4), origin = bytes:sub(5, 8), message = bytes:sub(HEADER_LENGTH + 1)}
  frame.class = class_of(frame.destination)
  local from = class_of(frame.origin)
  if from ~= "device" and from ~= "serial" then return nil, "BAD_ORIGIN", frame.origin .. " is " .. from end
  return frame
end

local function text(tree, name, range)
  return (tree:add_packet_field(f[name], range, ENC_UTF_8))
end

local function address(tree, name, range)
  local bytes = range:raw()
  local item = text(tree, name, range)
  text(tree, "address", range):set_hidden()
  if digits(bytes, 1, 4) then
    if name == "destination" then item:add(f["destination.class"], range, class_of(bytes)):set_generated() end
    if name == "destination" or name == "origin" then
      text(item, name .. ".group", range(0, 2))
      text(item, name .. ".member", range(2, 2))
    end
  end
  return item
end

-- Shows the body of a message of a move (SPEC 9.1), or returns false where it is none.
local function show_move(tree, name, range)
  local bytes = range:raw()
  if #bytes < 4 then return false end
  tree:add(f["move"], range(0, 4))
  local at = 4
  local function has(count) return at + count <= #bytes end
  local function take(name, length)
    tree:add(f[name], range(at, length))
    at = at + length
  end
  if name == "MOVE_OFFER" and has(2) then
    tree:add(f["move.protocol"], range(at, 1), PROTOCOLS[bytes:sub(at + 1, at + 1)] or "unknown")
    at = at + 1
    local parts = bytes:byte(at + 1)
    take("move.parts", 1)
    for _ = 1, parts do
      if not has(14) then return true end
      take("move.hash", 8)
      take("move.packed_length", 3)
      take("move.text_length", 3)
    end
    if has(13) then
      take("move.token", 8)
      address(tree, "move.home", range(at, 4))
      text(tree, "move.name", range(at + 4))
    end
  elseif name == "MOVE_WANT" then
    while has(3) do take("move.offset", 3) end
  elseif name == "MOVE_DATA" and has(5) then
    take("move.part", 1)
    take("move.offset", 3)
    take("move.packed", #bytes - at)
  elseif name == "MOVE_AWAKE" and has(1) then
    text(tree, "move.name", range(at))
  elseif name == "MOVE_REFUSED" and has(1) then
    text(tree, "move.reason", range(at))
  end
  return true
end

-- Shows `performative;term` or `performative#conversation;term` (SPEC 3), and returns it for the list.
local function show_content(tree, range)
  local bytes = range and range:raw() or ""
  local function bad(name, why)
    complain(tree, e_error, range, name, why)
    return range and plain(bytes) or ""
  end
  if not range then
    complain(tree, e_error, nil, "BAD_CONTENT", "empty")
    return ""
  end
  local performative, mark, term = bytes:match("^(%a+)(#?[%w+/]*);(.+)$")
  local item = text(tree, "content", range)
  if #bytes > MAX_CONTENT_LENGTH then return bad("TOO_LONG", #bytes .. " bytes") end
  local rule = PERFORMATIVES[performative]
  if not rule or #mark ~= 0 and #mark ~= 4 or #mark == 4 and mark:sub(1, 1) ~= "#" then return bad("BAD_CONTENT", "not performative;term") end
  if rule == "always" and mark == "" or rule == "never" and mark ~= "" then
    return bad("BAD_CONTENT", performative .. (mark == "" and " without a conversation" or " with a conversation"))
  end
  if not is_utf8(bytes) then return bad("BAD_TEXT", "no UTF-8") end
  text(item, "performative", range(0, #performative))
  if mark ~= "" then item:add(f["conversation"], range(#performative + 1, 3), digits(mark, 2, 4)) end
  text(item, "term", range(#performative + #mark + 1))
  return plain(bytes)
end

-- Shows a revocation list (SPEC 11.2), or returns false where it is none.
local function show_revocation_list(tree, range)
  local serials = range:len() - REVOCATION_LIST_LENGTH
  if serials < 0 or serials % 2 ~= 0 then return false end
  tree:add(f["revocation_list.authority"], range(0, 1))
  for i, name in ipairs({"sequence", "day", "least_until"}) do tree:add(f["revocation_list." .. name], range(2 * i - 1, 2)) end
  for at = 7, 5 + serials, 2 do tree:add(f["revocation_list.serial"], range(at, 2)) end
  tree:add(f["revocation_list.signature"], range(range:len() - SIGNATURE_LENGTH))
  return true
end

-- Shows a host message (SPEC 3.1), and returns its name for the list.
local function show_host_message(tree, range, is_plain)
  local bytes = range:raw()
  local kind, fragment = bytes:byte(), 0
  local name = KINDS[kind]
  local item = tree:add(f["host_message"], range, name or "unknown")
  item:add(f["host_message.kind"], range(0, 1))
  local function bad(why)
    complain(item, e_error, range, "BAD_HOST_MESSAGE", why)
    return "host message: " .. (name or "unknown")
  end
  if not name then return bad(string.format("kind 0x%02X", kind)) end
  if is_plain ~= (kind < FIRST_SEALED) then return bad(name .. (is_plain and " in a broadcast" or " in a sealed message")) end
  local line, head = "host message: " .. name, 1
  if is_plain then
    head = 4
    if #bytes < head then return bad("no address") end
    local to = ""
    for power = 3, 0, -1 do
      local digit = math.floor(number(bytes, 2, 4) / 64 ^ power) % 64 + 1
      to = to .. BASE64:sub(digit, digit)
    end
    item:add(f["host_message.to"], range(1, 3), to)
    item:add(f["address"], range(1, 3), to):set_hidden()
    line = line .. " to " .. to
  end
  local lengths = BODIES[name]
  if lengths and #lengths > 1 and #bytes > head then
    fragment = bytes:byte(head + 1)
    item:add(f["host_message.fragment"], range(head, 1))
    head = head + 1
  end
  local body = #bytes > head and range(head) or nil
  local length = #bytes - head
  lengths = lengths or {length}
  if length ~= lengths[fragment + 1] then return bad(string.format("fragment %d of %d bytes", fragment, length)) end
  if #lengths > 1 then line = line .. ", fragment " .. fragment end
  if not body then return line end
  local shown = item:add(f["host_message.body"], body)
  if name == "WANT" then
    shown:add(f["host_message.wanted"], body(0, 1))
    shown:add(f["host_message.wanted.fragment"], body(1, 1))
  elseif name == "CONTENT" then
    if length < 4 then return bad("no content") end
    shown:add(f["host_message.id"], body(0, 3))
    return line .. ": " .. show_content(shown, body(3))
  elseif name == "SEQUENCES" then
    if length % 3 ~= 0 then return bad(length .. " bytes") end
    for at = 0, length - 3, 3 do
      shown:add(f["revocation_list.authority"], body(at, 1))
      shown:add(f["revocation_list.sequence"], body(at + 1, 2))
    end
  elseif name == "REVOCATION_LIST" and not show_revocation_list(shown, body) then
    return bad("no revocation list")
  elseif name:find("^MOVE_") and not show_move(shown, name, body) then
    return bad("no move")
  end
  return line
end

-- Shows a content or a host message. `is_plain` says whether it was broadcast.
local function show_message(tree, range, is_plain)
  local first = range and range(0, 1):uint() or 0
  local is_host_message = first >= 0x80 and first <= 0xBF and range:len() <= MAX_CONTENT_LENGTH
  return is_host_message and show_host_message(tree, range, is_plain) or show_content(tree, range)
end

local function show_nonce(tree, name, range)
  local item = tree:add(f[name], range)
  item:add(f["epoch"], range(0, 3))
  item:add(f["counter"], range(3, 3))
end

-- The frames that an acknowledgement may answer: by the last 12 bits of the nonce.
local function answerable(place, frame)
  local key = place .. number(frame.nonce, 5, 6) % 4096
  known.answerable[key] = known.answerable[key] or {}
  return known.answerable[key]
end

local function remember_answerable(place, pinfo, frame)
  local list = answerable(place, frame)
  table.insert(list, {origin = frame.origin, destination = frame.destination, nonce = frame.nonce, number = pinfo.number, time = pinfo.abs_ts})
  if #list > ANSWERABLE then table.remove(list, 1) end
end

-- The latest sending of that frame by this board, if it has sent it: later it may have heard a relay's copy.
local function own_sending(list, frame)
  for i = #list, 1, -1 do
    local one = list[i]
    if known.packets[one.number].sent and one.nonce == frame.nonce and one.origin == frame.origin and one.destination == frame.destination then
      return one
    end
  end
  return frame
end

-- The latest frame that this device may answer so; with keys, the latest whose proof it is.
local function answered_by(place, acknowledger, bits, answers, message)
  local list = known.answerable[place .. bits] or {}
  local likely
  for i = #list, 1, -1 do
    local one = list[i]
    local group = one.destination:sub(1, 2) == "//" and one.destination:sub(3) == acknowledger:sub(1, 2)
    if one.destination == acknowledger or group and answers == "stale" then
      local right, parity = is_proof(one, acknowledger, answers, message)
      if right then return own_sending(list, one), true, parity end
      likely = likely or {one, right}
    end
  end
  if likely then return own_sending(list, likely[1]), likely[2] end
end

local ANSWERS = {[8] = "delivered", [9] = "fragments", [16] = "stale"}

local function show_acknowledgement(tree, range, pinfo, frame, place)
  local message, packet = frame.message, this_packet(pinfo)
  local body = range:len() > HEADER_LENGTH and range(HEADER_LENGTH) or nil
  local bits = digits(frame.destination, 3, 4)
  tree:add(f["acknowledgement.nonce"], range(2, 2), bits)
  local answers = ANSWERS[#message]
  tree:add(f["acknowledgement.answers"], body or range, answers or "unknown"):set_generated()
  if not answers then
    complain(tree, e_error, body or range, "radioBadProofs", "no acknowledgement has " .. #message .. " bytes")
    return "acknowledgement of no known shape"
  end
  if answers == "fragments" then tree:add(f["acknowledgement.fragments"], body(0, 1)) end
  if answers == "stale" then
    show_nonce(tree, "acknowledgement.floor", body(0, 6))
    tree:add(f["acknowledgement.uptime"], body(6, 2))
  end
  tree:add(f["acknowledgement.proof"], body(#message - PROOF_LENGTH))
  if place and not pinfo.visited and not packet.answered then
    local one, right, parity = answered_by(place, frame.origin, bits, answers, message)
    packet.answered = one and {number = one.number, time = since(pinfo, one.time), sender = one.origin, right = right, parity = parity}
    if one and right ~= false then
      local there = known.packets[one.number]
      there.acknowledged = there.acknowledged or {number = pinfo.number, time = since(pinfo, one.time)}
    end
  end
  local one = packet.answered
  if not one then return answers .. " by " .. frame.origin end
  tree:add(f["acknowledgement.of"], one.number):set_generated()
  tree:add(f["acknowledgement.sender"], one.sender):set_generated()
  tree:add(f["acknowledgement.time"], one.time):set_generated()
  if one.right ~= nil then tree:add(f["acknowledgement.proof.right"], one.right):set_generated() end
  if one.right == false then complain(tree, e_secret, body, "radioBadProofs", "no key of the keyring has made this proof") end
  if one.right then tree:add(f["acknowledgement.parity"], one.parity):set_generated() end
  pinfo.cols.dst = one.sender
  return answers .. ", answers " .. one.number
end

local function show_sealed(tree, range, frame)
  local message = frame.message
  if #message < NONCE_LENGTH + TAG_LENGTH then
    complain(tree, e_error, range, "radioBadTag", "too short for a nonce and a tag")
    return "too short to be sealed"
  end
  local body = range(HEADER_LENGTH)
  show_nonce(tree, "nonce", body(0, NONCE_LENGTH))
  if #message > NONCE_LENGTH + TAG_LENGTH then tree:add(f["sealed"], body(NONCE_LENGTH, #message - NONCE_LENGTH - TAG_LENGTH)) end
  local tag = tree:add(f["tag"], body(#message - TAG_LENGTH))
  local content, right = open(frame)
  if right ~= nil then tag:add(f["tag.right"], right):set_generated() end
  if right == false then complain(tree, e_secret, body(#message - TAG_LENGTH), "radioBadTag", "no key of the keyring has made this tag") end
  if not content then return string.format("sealed, %d bytes", #message - NONCE_LENGTH - TAG_LENGTH) end
  if content == "" then return show_content(tree, nil) end
  return show_message(tree, ByteArray.new(content, true):tvb("Content, opened")(), false)
end

-- The fault in the shape of a fragment, or nil (SPEC 7.1).
local function wrong_fragment(frame, index)
  local length = #frame.message
  if index > 7 then return "index " .. index end
  if length == 0 or length > FRAGMENT_LENGTH then return length .. " bytes" end
  if index * FRAGMENT_LENGTH + length > HEADER_LENGTH + MAX_MESSAGE_LENGTH then return "the whole would be too long" end
  if frame.origin == "++++" then return "from the serial line" end
  if index > 0 then return nil end
  if length < FRAGMENT_LENGTH and length ~= E32_FRAGMENT_LENGTH then return "a first fragment of " .. length .. " bytes" end
  local destination, bits = frame.message:sub(1, 4), digits(frame.message, 9, 10)
  if not digits(destination, 1, 4) or not bits or bits % 8 ~= 0 or bits / 8 <= length then return "no header of a whole" end
  if frame.message:sub(5, 8) ~= frame.origin then return "the whole is another device's" end
  local class = class_of(destination)
  if class ~= "device" and class ~= "multicast" and class ~= "broadcast" then return "the whole goes to " .. destination end
end

-- The bytes of the whole, as far as they are here in one; and whether that is all.
local function join(partial)
  local first = partial.parts[0]
  if not first then return "", false end
  local total = HEADER_LENGTH + digits(first, 9, 10) / 8
  local parts = {}
  for i = 0, math.ceil(total / #first) - 1 do
    local part = partial.parts[i]
    if not part or #part ~= math.min(#first, total - i * #first) then return table.concat(parts), false end
    table.insert(parts, part)
  end
  return table.concat(parts), true
end

-- Joins a fragment with those before it, and returns the message that they make.
local function add_fragment(place, pinfo, frame, id, index)
  local key = place .. frame.origin .. id
  local partial = known.partial[key]
  local another = partial and partial.parts[index] and partial.parts[index] ~= frame.message
  if not partial or another or pinfo.abs_ts - partial.time > FRAGMENTS_TIME then
    partial = {parts = {}, numbers = {}}
    known.partial[key] = partial
  end
  if not partial.parts[index] then
    partial.parts[index] = frame.message
    partial.numbers[index] = pinfo.number
    partial.time = pinfo.abs_ts
    local whole, all = join(partial)
    if all then
      partial.whole, partial.whole_in = whole, pinfo.number
    end
  end
  return partial
end

local show_frame

local function show_fragment(tree, range, pinfo, frame, place)
  local packet = this_packet(pinfo)
  local id, digit = digits(frame.destination, 3, 3), digits(frame.destination, 4, 4)
  local index = digit < 16 and digit % 8 or digit
  tree:add(f["fragment.id"], range(2, 1), id)
  tree:add(f["fragment.index"], range(3, 1), index)
  tree:add(f["fragment.asks"], range(3, 1), digit >= 8 and digit < 16)
  if #frame.message > 0 then tree:add(f["fragment.part"], range(HEADER_LENGTH)) end
  local wrong = wrong_fragment(frame, index)
  if wrong then
    complain(tree, e_error, range, "radioFragmentsDropped", wrong)
    return "a fragment that fits no message"
  end
  if place and not pinfo.visited and not packet.partial then
    packet.partial = add_fragment(place, pinfo, frame, id, index)
    local first = packet.partial.parts[0]
    if first and #first >= HEADER_LENGTH + NONCE_LENGTH then
      remember_answerable(place, pinfo, {origin = frame.origin, destination = first:sub(1, 4), nonce = first:sub(HEADER_LENGTH + 1, HEADER_LENGTH + NONCE_LENGTH)})
    end
  end
  local line = string.format("fragment %d of %d%s", index, id, digit >= 8 and ", asks" or "")
  local partial = packet.partial
  if not partial then return line end
  for i = 0, 7 do
    if partial.numbers[i] and partial.numbers[i] ~= pinfo.number then tree:add(f["fragment.in"], partial.numbers[i]):set_generated() end
  end
  if not partial.whole then return line end
  if partial.whole_in ~= pinfo.number then
    tree:add(f["fragment.whole_in"], partial.whole_in):set_generated()
    return line .. ", whole in " .. partial.whole_in
  end
  local whole = ByteArray.new(partial.whole, true):tvb("Frame, put together")
  return line .. "; whole: " .. show_frame(tree, whole(), pinfo, nil, true)
end

-- Shows a frame of the air and returns what the list says of it. `place` is where its like are looked for, nil where nothing
-- is to be linked; `whole` says that it was put together.
show_frame = function(parent, range, pinfo, place, whole)
  local frame, name, why = parse_frame(range and range:raw() or "")
  if not frame then
    complain(parent, e_error, range, name, why)
    return "no frame: " .. name
  end
  local tree = parent:add(air, range, whole and "Frame, put together" or "Frame")
  address(tree, "destination", range(0, 4))
  address(tree, "origin", range(4, 4))
  tree:add(f["size"], range(8, 2), digits(frame.bytes, 9, 10))
  local body
  if #frame.message > 0 then
    body = range(HEADER_LENGTH)
    tree:add(f["message"], body)
  end
  if not whole then
    pinfo.cols.src = frame.origin
    pinfo.cols.dst = frame.destination
  end
  local line
  if frame.origin == "++++" then
    complain(tree, e_error, range(4, 4), "radioBadFrames", "the serial line is never on the air")
    line = "from the serial line"
  elseif frame.class == "serial" or frame.class == "reserved" then
    complain(tree, e_error, range(0, 4), "radioReserved", frame.destination)
    line = "to a reserved address"
  elseif frame.class == "broadcast" then
    line = show_message(tree, body, true)
  elseif frame.class == "acknowledgement" then
    line = show_acknowledgement(tree, range, pinfo, frame, place)
  elseif frame.class == "fragment" then
    line = show_fragment(tree, range, pinfo, frame, place)
  else
    frame.nonce = frame.message:sub(1, NONCE_LENGTH)
    if place and not pinfo.visited and #frame.nonce == NONCE_LENGTH then remember_answerable(place, pinfo, frame) end
    line = show_sealed(tree, range, frame)
  end
  local packet = this_packet(pinfo)
  if place and not pinfo.visited and not packet.first then
    local key = place .. frame.bytes
    packet.first = known.frames[key] or pinfo.number
    known.frames[key] = packet.first
  end
  if place and packet.first and packet.first ~= pinfo.number then
    tree:add(f["repeat_of"], packet.first):set_generated():add_proto_expert_info(e_repeat)
    line = line .. ", again"
  end
  if place and packet.acknowledged then
    tree:add(f["acknowledged_in"], packet.acknowledged.number):set_generated()
    tree:add(f["acknowledged_time"], packet.acknowledged.time):set_generated()
  end
  return line
end

-- ---------------------------------------------------------------------------------------------------------------------
-- Packets of the air (SPEC 10.1)

local COUNT_HERE, CRC_HERE, TRAILER_HERE = 1, 2, 4

-- Shows count, payload, CRC and trailer, as far as they are here, and returns the payload's range, or nil; and the path, if
-- count and CRC tell it.
local function show_packet(tree, range, parts)
  local bytes = range and range:raw() or ""
  local start, stop = 0, #bytes  -- of the payload, from 0
  local path
  if bit.band(parts, COUNT_HERE) ~= 0 then
    if #bytes == 0 then
      complain(tree, e_error, range, "radioDamaged", "no count")
      return nil
    end
    start = 1
    local count = bytes:byte(1)
    local item = tree:add(f["count"], range(0, 1))
    local length = count - 3
    if length < 1 or count > LONGEST_COUNT then
      complain(item, e_error, range(0, 1), "radioDamaged", "count " .. count)
    else
      if bit.band(parts, TRAILER_HERE) ~= 0 then stop = math.min(#bytes, 1 + length + 2) end
      local here = stop - start - (bit.band(parts, CRC_HERE) ~= 0 and 2 or 0)
      if here ~= length then complain(item, e_error, range(0, 1), "radioDamaged", "the count says " .. length .. " bytes, " .. here .. " are here") end
    end
  end
  if bit.band(parts, TRAILER_HERE) ~= 0 and stop < #bytes then
    local trailer = range(stop)
    tree:add(f["trailer.bytes"], trailer)
    if bytes:byte(stop + 1) == PARITY and trailer:len() > 1 then tree:add(f["trailer.parity"], trailer(1)) end
  end
  if bit.band(parts, CRC_HERE) ~= 0 then
    if stop - start < 2 then
      complain(tree, e_error, range, "radioDamaged", "no CRC")
    else
      stop = stop - 2
      local told = bytes:byte(stop + 1) + 256 * bytes:byte(stop + 2)
      local item = tree:add_le(f["crc"], range(stop, 2))
      if start == 1 then
        local change = bit.bxor(told, crc16(bytes:sub(1, stop)))
        for p = 0, LAST_PATH do path = change == bit.bxor(p, p * 16, p * 2048) and p or path end
        item:add(f["crc.right"], range(stop, 2), path ~= nil):set_generated()
        if not path then complain(item, e_error, range(stop, 2), "radioDamaged", "wrong CRC") end
      end
    end
  end
  if start >= stop then return nil, path end
  local payload = range(start, stop - start)
  tree:add(f["payload"], payload)
  return payload, path
end

-- Shows what a path tells, which is in this range or, without one, concluded; and returns what the list says of it.
local function show_path(tree, path, range)
  local line = ""
  local function show(name, value)
    local item = range and tree:add(f[name], range, value) or tree:add(f[name], value)
    if not range then item:set_generated() end
    if value > 0 or name == "distance" then line = line .. ", " .. name .. " " .. value end
  end
  show("hops", path % HOPS)
  if path >= HOPS then show("distance", math.floor(path / HOPS) - 1) end
  return line
end

-- Reads the beginning of a record: version, numbers, and then texts, each behind its length. Returns the numbers, the ranges
-- of the texts (false where empty), and the range of the rest (nil where empty); or nil where it is no such record.
local function read_record(range, numbers, texts)
  local bytes = range:raw()
  if #bytes < 1 + numbers or bytes:byte(1) ~= RECORD_VERSION then return nil end
  local at, found = 1 + numbers, {}
  for i = 1, texts do
    local length = bytes:byte(at + 1)
    if not length or at + 1 + length > #bytes then return nil end
    found[i] = length > 0 and range(at + 1, length)
    at = at + 1 + length
  end
  return {bytes:byte(2, 1 + numbers)}, found, at < #bytes and range(at) or nil
end

function air.dissector(tvb, pinfo, root)
  pinfo.cols.protocol = "Javino"
  local range = tvb()
  local tree = root:add(air, range, "Javino, air")
  local numbers, texts, packet = read_record(range, 5, 2)
  if not numbers then
    complain(tree, e_error, range, "BAD_RECORD", "no record of SPEC 10.1, version " .. RECORD_VERSION)
    pinfo.cols.info = "no record of SPEC 10.1"
    return
  end
  local way, how, _, path, parts = table.unpack(numbers)
  local board, reason = texts[1], texts[2]
  tree:add(f["record_version"], range(0, 1))
  tree:add(f["way"], range(1, 1))
  local came = tree:add(f["how"], range(2, 1))
  tree:add(f["trailer"], range(3, 1))
  local passed = path <= LAST_PATH and show_path(tree, path, range(4, 1))
  tree:add(f["parts"], range(5, 1))
  local name = board and plain(board:raw()) or "?"
  local line = name .. " " .. (WAYS[way] or "?")
  if board then text(tree, "board", board) end
  if way == 1 and how ~= 0 then line = line .. " " .. HEARD[math.min(how, 2)] end
  if reason then
    text(tree, "reason", reason)
    line = line .. " (" .. plain(reason:raw()) .. ")"
  end
  if how >= 2 then complain(came, e_error, range(2, 1), "radioDamaged", reason and plain(reason:raw()) or nil) end
  local payload, told = show_packet(tree, packet, parts)
  line = line .. (passed or told and show_path(tree, told) or "")
  this_packet(pinfo).sent = way == 0
  -- A damaged payload may be wrong anywhere: it is shown, and nothing is concluded from it.
  local place = how ~= 2 and name .. "/" or nil
  pinfo.cols.info = line .. ": " .. (payload and show_frame(tree, payload, pinfo, place) or "no payload")
end

-- ---------------------------------------------------------------------------------------------------------------------
-- Packets of the serial line (SPEC 10.2)

-- Reads a message from its beginning on; what does not fit is told once.
local function reader(tree, range, from)
  local r = {at = from, length = range and range:len() or 0}
  function r.has(count) return r.at + count <= r.length end
  function r.left() return r.length - r.at end
  function r.range(count)
    local taken = range(r.at, count)
    r.at = r.at + count
    return taken
  end
  -- Shows the next bytes as a number or bytes, and returns the item and them; nil, and nothing shown, if there are too few.
  function r.take(name, count)
    if not r.has(count) or count == 0 then return nil end
    local taken = r.range(count)
    return tree:add(f[name], taken), taken:raw(), taken
  end
  function r.text(name, count)
    if not r.has(count) or count == 0 then return nil end
    local taken = r.range(count)
    return text(tree, name, taken), taken:raw()
  end
  function r.address(name)
    if not r.has(4) then return nil end
    local taken = r.range(4)
    return address(tree, name, taken), taken:raw()
  end
  return r
end

local FLAGS_PERCEPTS, FLAGS_NOW = 1, 2

local function is_device(address)
  return address and digits(address, 1, 4) and class_of(address) == "device"
end

local function has_key(address)
  return address and digits(address, 1, 4) and (class_of(address) == "device" or class_of(address) == "multicast")
end

local function key_address(r)
  local _, bytes = r.address("key.address")
  return has_key(bytes)
end

local function nothing() return true end

local function show_relaying(r)
  local _, bytes = r.take("serial.relaying", 1)
  return bytes and bytes:byte() < 2, bytes == "\1"
end

-- Each shows what follows the command byte, and returns whether it is what the command takes.
local REQUESTS = {
  H = function(r) return r.take("serial.protocol_version", 1) end,
  P = function(r)
    local item, flags, range = r.take("serial.poll.flags", 1)
    if not item then return false end
    for _, name in ipairs({"percepts", "now", "lost", "coming"}) do item:add(f["serial.poll." .. name], range) end
    flags = flags:byte()
    local right = r.take("serial.poll.hold", 2) and r.take("serial.poll.least", 3)
    if r.left() > 0 then right = r.take("serial.poll.taken", 1) and right end
    return right and flags < 16 and (bit.band(flags, FLAGS_NOW) == 0 or bit.band(flags, FLAGS_PERCEPTS) ~= 0)
  end,
  A = function(r) return r.text("serial.action", r.left()) end,
  C = function(r) return r.take("serial.actions.offset", 2) end,
  I = function(r)
    local _, bytes = r.address("serial.rf_id")
    return is_device(bytes)
  end,
  R = function(r)
    local _, bytes = r.take("serial.radio", 1)
    return bytes and bytes:byte() < 2
  end,
  O = function(r)
    local _, bytes = r.take("serial.overhear", 1)
    return bytes and bytes:byte() < 2
  end,
  E = function(r)
    local _, bytes = r.take("serial.boot_epoch", 3)
    return bytes and bytes ~= "\255\255\255"
  end,
  K = function(r) return key_address(r) and r.take("serial.key", 16) end,
  V = function(r)
    local _, bytes = r.address("key.address")
    return is_device(bytes) and r.take("serial.key", 16)
  end,
  W = function(r)
    if r.left() == 0 then return true end
    local right, on = show_relaying(r)
    return right and (not on or r.take("serial.relaying.number", 2))
  end,
  U = key_address, F = key_address, D = key_address, L = nothing, S = nothing,
}
REQUESTS.N = REQUESTS.K
f["key.address"] = f["serial.key.address"]

local function show_relay(tree, range, r)
  if r.left() == 0 then return false end
  local _, bytes, taken = r.take("serial.relay", r.left())
  local frame = parse_frame(bytes)
  if not frame or frame.origin == "++++" then return false end
  address(tree, "destination", taken(0, 4))
  address(tree, "origin", taken(4, 4))
  if frame.class == "serial" or frame.class == "reserved" then return false, "BAD_DESTINATION" end
  if #bytes > MAX_RADIO_PAYLOAD then return false, "TOO_LONG" end
  return true
end

local RECORD = {
  P = function(tree, r) return r.left() == 0 or is_utf8(select(2, r.text("serial.percept", r.left()))) end,
  M = function(tree, r, range)
    if not r.has(12) then return false end
    r.take("serial.message.number", 1)
    local _, destination = r.address("serial.message.destination")
    local _, origin = r.address("serial.message.origin")
    r.take("serial.message.id", 3)
    show_message(tree, r.left() > 0 and r.range(r.left()) or nil, destination == "////")
    return digits(destination, 1, 4) and digits(origin, 1, 4)
  end,
  T = function(tree, r)
    local number = r.take("serial.transmission.number", 1)
    local _, outcome = r.take("serial.transmission.outcome", 1)
    return number and outcome and OUTCOMES[outcome:byte()]
  end,
  N = function(tree, r)
    local _, destination = r.address("serial.no_key.destination")
    local _, origin = r.address("serial.no_key.origin")
    return has_key(destination) and is_device(origin)
  end,
  O = function(tree, r)
    local time = r.take("serial.overheard.time", 4)
    local _, how = r.take("serial.overheard.how", 1)
    r.take("serial.overheard.payload", r.left())
    return time and how and HEARD[how:byte()]
  end,
}

-- Each shows a reply's body, and returns whether it is one to the command.
local REPLIES = {
  A = function(r) return r.left() == 0 or r.take("serial.act.number", 3) end,
  H = function(r, _, range)
    r.take("serial.protocol_version", 1)
    local _, id = r.address("serial.rf_id")
    if not id or not digits(id, 1, 4) or not r.take("serial.boot_epoch", 3) then return false end
    -- A board of an earlier library has its name there.
    if r.left() > 0 and range(r.at, 1):uint() < 0x20 then
      local item, _, bits = r.take("serial.capabilities", 1)
      for _, row in ipairs(CAPABILITIES) do item:add(f["serial.capabilities." .. row[1]], bits) end
    end
    return (r.left() == 0 or is_utf8(select(2, r.text("serial.firmware", r.left()))))
  end,
  P = function(r, tree, range)
    local item, _, flags = r.take("serial.poll.flags", 1)
    if not item then return false end
    for _, name in ipairs({"more", "left_out", "reading", "damaged", "taken_timer"}) do item:add(f["serial.poll." .. name], flags) end
    local right = true
    while r.has(3) do
      local head = r.range(3)
      local type, length = head:raw():sub(1, 1), head(1, 2):uint()
      if not r.has(length) then
        r.at = r.at - 3
        break
      end
      local record = tree:add(f["serial.record.type"], head(0, 1), RECORDS[type] or "unknown")
      record:add(f["serial.record.length"], head(1, 2))
      local value = length > 0 and r.range(length) or nil
      local rr = reader(record, value, 0)
      right = RECORD[type] and RECORD[type](record, rr) and rr.left() == 0 and right
    end
    return right
  end,
  C = function(r)
    local _, count = r.take("serial.actions.count", 1)
    local names, whole = 0, true
    while count and r.left() > 0 do
      local _, zero = r.peek("\0")
      whole = zero
      local length = (zero or r.length + 1) - r.at - 1
      local _, bytes = r.text("serial.actions.name", length)
      if not is_utf8(bytes or "") and zero then return false end
      if zero then
        names = names + 1
        r.at = r.at + 1
      end
    end
    return count and names <= count:byte() and (whole or names < count:byte())
  end,
  K = function(r) return r.take("serial.key.check", 3) end,
  L = function(r)
    local right = true
    while r.has(8) do
      local _, bytes = r.address("serial.key.address")
      local _, role = r.take("serial.key.role", 1)
      r.take("serial.key.check", 3)
      right = digits(bytes, 1, 4) and ROLES[role:byte()] and right
    end
    return right
  end,
  S = function(r, tree)
    while r.has(5) do
      local number, value = r.range(1), r.range(4)
      local name = COUNTERS[number:uint()]
      if name then tree:add(f["serial.counters." .. name], value) else tree:add(f["serial.counters.unknown"], number) end
    end
    return true
  end,
  Y = function(r) return r.take("serial.transmission.number", 1) end,
  W = show_relaying,
}
REPLIES.N, REPLIES.V = REPLIES.K, REPLIES.K
REPLIES.transmit = REPLIES.Y

local function command_name(command)
  return COMMANDS[command] or command == "" and "none" or string.format("0x%02x", command:byte())
end

local function show_request(tree, range, frame)
  if frame.origin ~= "++++" and frame.destination == "++++" then
    complain(tree, e_error, range, "WRONG_ORIGIN", frame.origin)
    return "refused"
  end
  if frame.destination ~= "++++" then
    local item = tree:add(f["serial.command"], "transmit"):set_generated()
    local body = #frame.message > 0 and range(HEADER_LENGTH) or nil
    return "transmit from " .. frame.origin .. " to " .. frame.destination .. ": " .. show_message(tree, body, frame.class == "broadcast")
  end
  local command = frame.message:sub(1, 1)
  local name = COMMANDS[command]
  if not name then
    complain(tree, e_error, range, "UNKNOWN_COMMAND", command_name(command))
    return "unknown command"
  end
  tree:add(f["serial.command"], range(HEADER_LENGTH, 1), name)
  local r = reader(tree, range, HEADER_LENGTH + 1)
  local right, what
  if command == "Y" then right, what = show_relay(tree, range, r) else right = REQUESTS[command](r) end
  if not right or r.left() > 0 then complain(tree, e_error, range(HEADER_LENGTH), what or "BAD_ARGUMENT", "not what " .. name .. " takes") end
  return name
end

local function show_reply(tree, range, frame, request)
  local code = frame.message:byte(1)
  if not code or frame.destination ~= "++++" or frame.origin ~= "++++" then
    complain(tree, e_error, range, "BAD_REPLY", "no status")
    return "no reply"
  end
  local item = tree:add(f["serial.status"], range(HEADER_LENGTH, 1))
  local command = request and request.command
  if command then tree:add(f["serial.command"], command_name(command)):set_generated() end
  local line = (STATUSES[code] or "unknown status") .. (request and ", " .. command_name(command) or "")
  if not STATUSES[code] then
    complain(item, e_error, range(HEADER_LENGTH, 1), "BAD_REPLY", "unknown status " .. code)
  elseif code ~= 0 then
    complain(item, e_status, range(HEADER_LENGTH, 1), STATUSES[code])
  end
  local r = reader(tree, range, HEADER_LENGTH + 1)
  function r.peek(byte) return byte, frame.bytes:find(byte, r.at + 1, true) end
  if not command then
    if r.left() > 0 then r.take("serial.body", r.left()) end
    return line
  end
  local right = code ~= 0 or (REPLIES[command] or nothing)(r, tree, range)
  if not right or r.left() > 0 then complain(tree, e_error, range, "BAD_REPLY", "not what answers " .. (command_name(command))) end
  return line
end

-- Links a request with its repeats and its reply: by board and sequence byte, in the order in which they come.
local function link(packet, pinfo, place, from, sequence, frame, command)
  if packet.linked or pinfo.visited then return end
  packet.linked = true
  local key = place .. sequence
  local last = known.last_request[key]
  if from == 0 then
    if last and last.bytes == frame.bytes then
      packet.first = last.number
    else
      last = {number = pinfo.number, bytes = frame.bytes, command = command}
      known.last_request[key] = last
    end
    last.time = pinfo.abs_ts
  elseif last then
    packet.request, packet.time = last, since(pinfo, last.time)
    last.reply = last.reply or pinfo.number
  end
  packet.own = from == 0 and last or nil
end

local function command_of(frame)
  if frame.destination ~= "++++" then return "transmit" end
  return frame.message:sub(1, 1)
end

function serial.dissector(tvb, pinfo, root)
  pinfo.cols.protocol = "Javino serial"
  local range = tvb()
  local tree = root:add(serial, range)
  local numbers, texts, coded = read_record(range, 1, 1)
  if not numbers or numbers[1] > 1 then
    complain(tree, e_error, range, "BAD_RECORD", "no record of SPEC 10.2, version " .. RECORD_VERSION)
    pinfo.cols.info = "no record of SPEC 10.2"
    return
  end
  local from, board = numbers[1], texts[1]
  tree:add(f["serial.record_version"], range(0, 1))
  tree:add(f["serial.from"], range(1, 1))
  if board then text(tree, "serial.board", board) end
  pinfo.cols.src = FROM[from]
  pinfo.cols.dst = FROM[1 - from]
  local bytes = ""
  if coded then
    bytes = coded:raw()
    tree:add(f["serial.packet"], coded)
  end
  local function refuse(name, why)
    complain(tree, e_error, coded, name, why)
    pinfo.cols.info = "refused: " .. name
  end
  if bytes == "\0" then
    pinfo.cols.info = from == 0 and "0x00: a packet begins" or "0x00: has started, or refused a packet"
    return
  end
  local decoded = bytes:sub(-1) == "\0" and cobs(bytes:sub(1, -2))
  if not decoded then return refuse("BAD_COBS", "no packet with a closing 0x00") end
  if #decoded > 524 then return refuse("TOO_LONG", #decoded .. " bytes") end
  if #decoded < 13 then return refuse("TOO_SHORT", #decoded .. " bytes") end
  local packet = ByteArray.new(decoded, true):tvb("Packet, decoded")()
  local sequence = decoded:byte(1)
  tree:add(f["serial.sequence"], packet(0, 1))
  local crc = tree:add_le(f["serial.crc"], packet(#decoded - 2, 2))
  local right = decoded:byte(-2) + 256 * decoded:byte(-1) == crc16(decoded:sub(1, -3))
  crc:add(f["serial.crc.right"], packet(#decoded - 2, 2), right):set_generated()
  if not right then return refuse("BAD_CRC") end
  local frame, name, why = parse_frame(decoded:sub(2, -3))
  if not frame then return refuse(name, why) end

  local known_here = this_packet(pinfo)
  link(known_here, pinfo, (board and board:raw() or "") .. "/", from, sequence, frame, command_of(frame))
  local body = packet(1, #decoded - 3)
  address(tree, "destination", body(0, 4))
  address(tree, "origin", body(4, 4))
  tree:add(f["size"], body(8, 2), digits(frame.bytes, 9, 10))
  if #frame.message > 0 then tree:add(f["message"], body(HEADER_LENGTH)) end
  local line
  if from == 0 then
    line = show_request(tree, body, frame)
    local own = known_here.own
    if known_here.first then
      tree:add(f["serial.repeat_of"], known_here.first):set_generated():add_proto_expert_info(e_repeat)
      line = line .. ", again"
    end
    if own and own.reply then tree:add(f["serial.reply_in"], own.reply):set_generated() end
  else
    local request = known_here.request
    line = show_reply(tree, body, frame, request)
    if request then
      tree:add(f["serial.request_in"], request.number):set_generated()
      tree:add(f["serial.time"], known_here.time):set_generated()
    end
  end
  pinfo.cols.info = string.format("%3d  %s", sequence, line)
end

local encapsulations = DissectorTable.get("wtap_encap")
encapsulations:add(wtap.USER0, air)
encapsulations:add(wtap.USER1, serial)
