#include "PublishedJavino.h"

#include <string.h>

static Javino *theOne;

Javino::Javino() : perceive_(nullptr), askedAt_(0), isOpen_(false) {
  theOne = this;
  act.count_ = 0;
}

Javino::Function &Javino::Actions::operator[](const char *name) {
  uint8_t i = 0;
  while (i != count_ && strcmp(entries_[i].name, name) != 0) i++;
  if (i == count_) {
    if (count_ != javinolib::config::ACTIONS) count_++;
    i = count_ - 1;  // what is one too many takes the place of the last
    entries_[i] = {name, nullptr};
  }
  return entries_[i].function;
}

void Javino::start(unsigned long) {
  isOpen_ = true;
  board_.onPercepts(perceive);
  board_.otherActions(perform);
  board_.begin(115200);
}

void Javino::readSerial() { board_.serve(); }

bool Javino::availableMsg() {
  if (!isOpen_) start(0);
  board_.serve();
  message_ = wanted_;
  wanted_ = String();
  if (message_.length() == 0 && perceive_ == nullptr && board_.wantsPercepts() && millis() - askedAt_ >= 20) {
    askedAt_ = millis();
    message_ = F("getPercepts");
  }
  return message_.length() != 0;
}

bool Javino::requestPercepts() const { return message_ == F("getPercepts"); }

void Javino::sendPercepts() {
  reading_ = percepts_;
  clearPercepts();
}

void Javino::sendMsg(const String &literals) {
  percepts_ = literals + '\n';
  percepts_.replace(';', '\n');
  sendPercepts();
}

// The sketch's function is called when the agent is to be told: it may forget what it adds.
void Javino::perceive(javinolib::Percepts &percepts) {
  String &all = theOne->reading_;
  if (theOne->perceive_ != nullptr) {
    all = String();
    theOne->perceive_();
    all += theOne->percepts_;
    theOne->clearPercepts();
  }
  int begin = 0;
  for (int end; (end = all.indexOf('\n', begin)) >= 0; begin = end + 1) {
    if (end != begin) percepts.literal(all.substring(begin, end));
  }
}

// The agent gets an error for what a sketch does not know; one without functions is asked by availableMsg().
bool Javino::perform(const javinolib::Arguments &arguments) {
  String action;
  for (uint16_t i = 0; i != arguments.nameLength(); i++) action += arguments.name()[i];
  for (uint8_t i = 0; i != theOne->act.count_; i++) {
    const Actions::Entry &entry = theOne->act.entries_[i];
    if (action == entry.name && entry.function != nullptr) {
      entry.function();
      return true;
    }
  }
  if (theOne->act.count_ != 0 || theOne->wanted_.length() != 0) return false;
  theOne->wanted_ = action;
  return true;
}
