#pragma once

#include <framing/Frame.h>

#include <string>

/// An error's name as SPEC 2 and the vectors have it.
inline std::string nameOf(javino::FrameError error) {
  switch (error) {
    case javino::FrameError::NONE: return "NONE";
    case javino::FrameError::TOO_SHORT: return "TOO_SHORT";
    case javino::FrameError::BAD_DIGIT: return "BAD_DIGIT";
    case javino::FrameError::PARTIAL_BYTE: return "PARTIAL_BYTE";
    case javino::FrameError::SIZE_MISMATCH: return "SIZE_MISMATCH";
    default: return "BAD_ORIGIN";
  }
}
