// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mega.h"

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>

#include <cstring>
#include <stdexcept>

namespace {

// Data addresses of the ATmega2560 (data sheet, register summary): registers that the firmware does not use.
const uint16_t TWBR = 0xB8;   // markers: 0 ends the measurement, anything else begins it
const uint16_t TWAR = 0xBA;   // the mailbox's address, low byte first
const uint16_t TWAMR = 0xBD;  // the program waits for the mailbox

const uint64_t LONGEST_RUN = 100000000;  // cycles; no operation takes a hundredth of it

}  // namespace

struct Mega::Simulation {
  avr_t *avr = nullptr;
  uint16_t mailbox = 0;  // address in the Mega's RAM
  bool ready = false;
  uint64_t begun = 0;
  uint64_t cycles = 0;

  ~Simulation() {
    if (avr != nullptr) avr_terminate(avr);
  }

  static void onMarker(avr_t *avr, avr_io_addr_t, uint8_t value, void *simulation) {
    Simulation &self = *static_cast<Simulation *>(simulation);
    if (value == 0) self.cycles = avr->cycle - self.begun;
    self.begun = avr->cycle;
  }

  static void onAddress(avr_t *, avr_io_addr_t, uint8_t value, void *simulation) {
    Simulation &self = *static_cast<Simulation *>(simulation);
    self.mailbox = static_cast<uint16_t>(self.mailbox >> 8 | value << 8);
  }

  static void onReady(avr_t *, avr_io_addr_t, uint8_t, void *simulation) {
    static_cast<Simulation *>(simulation)->ready = true;
  }

  void runUntilReady() {
    ready = false;
    const uint64_t end = avr->cycle + LONGEST_RUN;
    while (!ready) {
      const int state = avr_run(avr);
      if (state == cpu_Crashed || state == cpu_Done) throw std::runtime_error("the program on the Mega crashed");
      if (avr->cycle > end) throw std::runtime_error("the program on the Mega does not come to an end");
    }
  }
};

Mega::Mega(const std::string &program) : simulation_(new Simulation) {
  elf_firmware_t firmware = {};
  if (elf_read_firmware(program.c_str(), &firmware) != 0) throw std::runtime_error("cannot read " + program);
  avr_t *avr = simulation_->avr = avr_make_mcu_by_name("atmega2560");
  if (avr == nullptr) throw std::runtime_error("this simavr knows no atmega2560");
  avr_init(avr);
  avr->frequency = 16000000;
  avr->log = LOG_ERROR;
  avr_load_firmware(avr, &firmware);
  avr_register_io_write(avr, TWBR, Simulation::onMarker, simulation_.get());
  avr_register_io_write(avr, TWAR, Simulation::onAddress, simulation_.get());
  avr_register_io_write(avr, TWAMR, Simulation::onReady, simulation_.get());
  simulation_->runUntilReady();
  Mailbox nothing = {};
  overhead_ = perform(Mailbox::NOTHING, nothing);
}

Mega::~Mega() {}

uint64_t Mega::perform(Mailbox::Operation operation, Mailbox &mailbox) {
  mailbox.operation = operation;
  uint8_t *const place = simulation_->avr->data + simulation_->mailbox;
  memcpy(place, &mailbox, sizeof mailbox);
  simulation_->cycles = 0;
  simulation_->runUntilReady();
  if (simulation_->cycles <= overhead_) throw std::runtime_error("the program on the Mega measured nothing");
  memcpy(&mailbox, place, sizeof mailbox);
  return simulation_->cycles - overhead_;
}
