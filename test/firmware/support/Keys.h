#pragma once

#include <storage/KeyStore.h>

#include "Bytes.h"

/// Whether a place of the store holds this key, and not another one or none.
bool holds(const javino::KeyStore &store, uint8_t slot, const Bytes &key);
