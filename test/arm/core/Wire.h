#pragma once

/// Has no pins here.
struct {
  void begin() {}
} Wire;
