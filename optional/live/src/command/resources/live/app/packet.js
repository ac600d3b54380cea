// The bytes of a radio packet as anyone can read them, without any key (SPEC 2, 3, 5, 7).

const ALPHABET = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const HEADER_LENGTH = 10;
const NONCE_LENGTH = 6;
const TAG_LENGTH = 8;
const MAX_RADIO_PAYLOAD = 77;
const WORDS_OF_AGENTSPEAK = ['self', 'true', 'else', 'elif'];

export function bytesOf(hex) {
  return Uint8Array.from(hex.match(/[0-9a-f]{2}/gi) ?? [], (pair) => parseInt(pair, 16));
}

export function hexOf(bytes) {
  return Array.from(bytes, (b) => b.toString(16).padStart(2, '0')).join('');
}

const textOf = (bytes) => new TextDecoder().decode(bytes);

const numberOf = (bytes) => bytes.reduce((n, b) => n * 256 + b, 0);

/** Whether it is the address of a device (SPEC 1). */
export function isDevice(address) {
  return /^[A-Za-z0-9][A-Za-z0-9+/]{3}$/.test(address) && !WORDS_OF_AGENTSPEAK.includes(address);
}

/** Whether a packet to this destination is for the device with this address. */
export function isFor(destination, address) {
  return destination === '////' || destination === address ||
    (destination.startsWith('//') && destination.slice(2) === address.slice(0, 2));
}

/**
 * The fields of a packet, in their order: `name`, `bytes`, the number of the first byte `at`, and `text`, what anyone
 * can say about them.
 */
export function fieldsOf(packet) {
  const all = bytesOf(packet.payload);
  const fields = [];
  let at = 0;
  const take = (name, length, describe) => {
    const bytes = all.slice(at, at + Math.max(0, length));
    if (bytes.length > 0) fields.push({ name, bytes, at, text: describe(bytes) });
    at += bytes.length;
  };
  const rest = () => all.length - at;
  if (packet.kind === 'no frame' || all.length < HEADER_LENGTH) {
    take('no frame', all.length, () => 'these bytes are no frame');
    return fields;
  }
  take('destination', 4, textOf);
  take('origin', 4, textOf);
  take('size', 2, (b) => sizeOf(b) + ' bits');
  if (packet.kind === 'acknowledgement') {
    if (packet.answers === 'stale') {
      take('floor', NONCE_LENGTH, (b) => 'only numbers above ' + hexOf(b) + ' are accepted');
      take('uptime', 2, (b) => numberOf(b) / 10 + ' s since the board started');
    } else if (packet.answers === 'fragments') {
      take('fragments', 1, (b) => 'has the fragments ' + b[0].toString(2).padStart(8, '0'));
    }
    take('proof', rest(), () => 'only who has the key can make it');
  } else if (packet.kind === 'fragment') {
    take('fragment', rest(), () => 'a part of a longer frame');
  } else if (packet.sealed) {
    take('nonce', NONCE_LENGTH, (b) => 'start ' + numberOf(b.slice(0, 3)) + ', message ' + numberOf(b.slice(3)) + ' of it');
    take('ciphertext', rest() - TAG_LENGTH, (b) => b.length + ' bytes that only the key opens');
    take('tag', TAG_LENGTH, () => 'shows whether one bit before it was changed');
  } else {
    take('content', rest(), textOf);
  }
  return fields;
}

const sizeOf = (digits) =>
  ALPHABET.indexOf(String.fromCharCode(digits[0])) * 64 + ALPHABET.indexOf(String.fromCharCode(digits[1]));

/** The payload, in hex, of a broadcast that says `performative;term`; an error says in one line what is wrong. */
export function broadcast(origin, performative, term) {
  if (!isDevice(origin)) {
    throw new Error(`“${origin}” is no address of a device: use four letters or digits, such as EVIL`);
  }
  if (term === '') throw new Error('There is nothing to shout: write a term, such as help');
  const content = new TextEncoder().encode(performative + ';' + term);
  const most = MAX_RADIO_PAYLOAD - HEADER_LENGTH;
  if (content.length > most) {
    throw new Error(`The term is ${content.length - most} bytes too long for one packet: use a shorter one`);
  }
  return framed('////', origin, content);
}

/** A frame in hex, or its beginning, to which so many bytes are `missing`. */
export function framed(destination, origin, message, missing = 0) {
  const bits = (message.length + missing) * 8;
  return hexOf(new TextEncoder().encode(destination + origin + ALPHABET[bits >> 6] + ALPHABET[bits & 63])) + hexOf(message);
}
