#pragma once

#include <framing/Frame.h>

#include <string>

/// An error's name as SPEC 2 and the vectors have it.
inline std::string nameOf(javinolib::FrameError error) {
  switch (error) {
    case javinolib::FrameError::NONE: return "NONE";
    case javinolib::FrameError::TOO_SHORT: return "TOO_SHORT";
    case javinolib::FrameError::BAD_DIGIT: return "BAD_DIGIT";
    case javinolib::FrameError::PARTIAL_BYTE: return "PARTIAL_BYTE";
    case javinolib::FrameError::SIZE_MISMATCH: return "SIZE_MISMATCH";
    default: return "BAD_ORIGIN";
  }
}
