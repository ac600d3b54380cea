#pragma once

#include <storage/KeyStore.h>

#include "Bytes.h"

// Shared keys.
const Bytes KEY = fromHex("000102030405060708090a0b0c0d0e0f");
const Bytes OTHER_KEY = fromHex("2b7e151628aed2a6abf7158809cf4f3c");
const Bytes THIRD_KEY = fromHex("ffeeddccbbaa99887766554433221100");

/// Whether a place of the store holds this key, and not another one or none.
bool holds(const javinolib::KeyStore &store, uint8_t slot, const Bytes &key);
