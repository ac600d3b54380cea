#pragma once

#include <stddef.h>
#include <stdint.h>

namespace javinolib {

#ifdef __AVR__

/// Room for the one object of a type.
template <typename Type>
union Place {
  constexpr Place() : empty(0) {}  // so that no code makes it, nor a guard

  uint8_t empty;
  Type part;
};

/// A reference from one part of a board to another, or to what several share. On an AVR a program has one board with a radio, so
/// each part has a place that is known when compiling: this takes no memory, no code in a constructor, and a method of a part
/// need not be told which it is.
template <typename Type>
class Part {
 public:
  Part(Type &) {}
  operator Type &() const { return the(); }
  Type *operator->() const { return &the(); }

  static Type &the() { return place_.part; }

 private:
  static Place<Type> place_;

  char nothing_[0];
};

template <typename Type>
Place<Type> Part<Type>::place_;  // the start-up code clears it (support/Zeroed.h)

struct InPlace {
  void *at;
};

/// A part where it is made.
template <typename Type>
class OwnPart {
 public:
  OwnPart() { new (InPlace{&Part<Type>::the()}) Type; }
  template <typename... Arguments>
  explicit OwnPart(Arguments &&...arguments) {
    new (InPlace{&Part<Type>::the()}) Type(arguments...);
  }
  operator Type &() const { return Part<Type>::the(); }
  Type *operator->() const { return &Part<Type>::the(); }

 private:
  char nothing_[0];
};

#else

template <typename Type>
class Part {
 public:
  Part(Type &part) : part_(part) {}
  operator Type &() const { return part_; }
  Type *operator->() const { return &part_; }

 private:
  Type &part_;
};

template <typename Type>
class OwnPart {
 public:
  template <typename... Arguments>
  explicit OwnPart(Arguments &&...arguments) : part_(arguments...) {}
  operator Type &() { return part_; }
  Type *operator->() { return &part_; }
  const Type *operator->() const { return &part_; }

 private:
  Type part_;
};

#endif

}  // namespace javinolib

#ifdef __AVR__
inline void *operator new(size_t, javinolib::InPlace place) { return place.at; }
#endif
