// Seals as a board does (SPEC 5), with a key of one's own.

import { bytesOf, framed, hexOf } from './packet.js';

const BLOCK = 16;
const NOTHING = new Uint8Array(BLOCK);

const ascii = (text) => new TextEncoder().encode(text);
const joined = (...parts) => Uint8Array.from(parts.flatMap((part) => [...part]));
const xor = (a, b) => a.map((byte, i) => byte ^ b[i]);

/** The blocks of AES-CBC with an IV of zeros; the browser's padding is left out. */
async function chain(key, blocks) {
  const aes = await crypto.subtle.importKey('raw', key, 'AES-CBC', false, ['encrypt']);
  return new Uint8Array(await crypto.subtle.encrypt({ name: 'AES-CBC', iv: NOTHING }, aes, blocks)).slice(0, blocks.length);
}

const doubled = (block) => block.map((byte, i) => (byte << 1) ^ (i + 1 < BLOCK ? block[i + 1] >> 7 : (block[0] >> 7) * 0x87));

/** NIST SP 800-38B. */
async function cmac(key, message) {
  const whole = message.length > 0 && message.length % BLOCK === 0;
  const blocks = new Uint8Array(Math.max(1, Math.ceil(message.length / BLOCK)) * BLOCK);
  blocks.set(message);
  if (!whole) blocks[message.length] = 0x80;
  const subkey = doubled(await chain(key, NOTHING));
  blocks.set(xor(blocks.slice(-BLOCK), whole ? subkey : doubled(subkey)), blocks.length - BLOCK);
  return (await chain(key, blocks)).slice(-BLOCK);
}

const derived = (key, label) => cmac(key, joined([1], ascii(label), [0, 0, 0x80]));

/** CFB128: each block is hidden under the encryption of the one before. */
async function hidden(key, before, content) {
  if (content.length === 0) return content;
  const block = xor(content.slice(0, BLOCK), await chain(key, before));
  return joined(block, await hidden(key, block, content.slice(BLOCK)));
}

/** The payload, in hex, of a sealed frame; key, nonce and content are bytes. */
export async function seal(key, destination, origin, nonce, content) {
  const iv = await chain(await derived(key, 'JavinoEnc'), joined(ascii(origin + destination), nonce, [0, 0]));
  const ciphertext = await hidden(await derived(key, 'JavinoEnc'), iv, content);
  const untagged = framed(destination, origin, joined(nonce, ciphertext), 8);
  const tag = await cmac(await derived(key, 'JavinoMac'), bytesOf(untagged));
  return untagged + hexOf(tag.slice(0, 8));
}
