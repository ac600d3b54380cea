// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenario_radio.h"

#include <string.h>

#define DEFAULT_BIT_RATE 2000
#define DEFAULT_RANGE_M 100
#define MAX_DISTANCE_M 1e6
#define DEFAULT_BURST_BITS 30
#define MAX_BURST_BITS 1e6
#define DEFAULT_BURST_RATE 0.25
#define DEFAULT_NOISE_EDGES 2000
#define MAX_NOISE_EDGES 20000
#define DEFAULT_NOISE_AFTER_S 0.2
#define MAX_SHADOWING_DB 20
#define MAX_CAPTURE_DB 60

// "outdoors": 0.5 exp(-SNR / 2), as noncoherent receivers of on-off keying have it; the SNR falls with the third power of
// the distance, and leaves a rate of 1e-3 at 100 m.
static const distance_rate OUTDOORS[] = {{60, 0},       {70, 6.8e-9}, {80, 2.7e-6}, {90, 9.9e-5}, {100, 1e-3},
                                         {110, 4.7e-3}, {120, 0.014}, {130, 0.03},  {150, 0.079}, {200, 0.23}};
#define OUTDOORS_RANGE_M 200
#define OUTDOORS_SHADOWING_DB 4

// emulator/README.md says where these are from.
static const module_config MODULES[] = {
#define JAVINO_SERIAL_MODULE(name, text, baud, longest, slot, airtime, micros, ...) {text, baud, __VA_ARGS__},
#include "SerialModules.def"
#undef JAVINO_SERIAL_MODULE
};
static const char *const MODULE_KINDS[] = {
#define JAVINO_SERIAL_MODULE(name, text, ...) text,
#include "SerialModules.def"
#undef JAVINO_SERIAL_MODULE
    NULL};

static void read_module(module_config *module, const json_node *node) {
  json_node name = json_member(node, "module");
  int kind = json_given(&name) ? json_choice(&name, MODULE_KINDS) : -1;
  if (kind < 0) return;
  *module = MODULES[kind];
  json_node uart_rate = json_member(node, "uartRate");
  json_node air_rate = json_member(node, "airRate");
  json_node delay = json_member(node, "delay");
  json_node buffer = json_member(node, "buffer");
  module->uart_rate = json_number(&uart_rate, 1200, 115200, module->uart_rate);
  module->air_rate = json_number(&air_rate, 300, 1000000, module->air_rate);
  module->delay_s = json_number(&delay, 0, 1, module->delay_s);
  module->buffer = (size_t)json_number(&buffer, 16, MODULE_MAX_BUFFER, (double)module->buffer);
}

static void read_bursts(burst_config *bursts, const json_node *node) {
  static const char *const KEYS[] = {"rate", "length", "rateWithin", NULL};
  if (!json_given(node) || !json_check_object(node, KEYS)) return;
  json_node rate = json_member(node, "rate");
  json_node length = json_member(node, "length");
  json_node within = json_member(node, "rateWithin");
  if (!json_given(&rate)) json_expected(&rate, "the mean rate of errors, 0 to 1");
  bursts->rate = json_number(&rate, 0, 1, 0);
  bursts->length_bits = json_number(&length, 1, MAX_BURST_BITS, DEFAULT_BURST_BITS);
  bursts->rate_within = json_number(&within, 0, 1, DEFAULT_BURST_RATE);
  if (bursts->rate > 0 && bursts->rate >= bursts->rate_within) json_expected(&rate, "less than rateWithin");
}

static void read_distance_rate(distance_rate *point, const json_node *node) {
  if (!json_is_array(node->value) || json_array_length(node) != 2) {
    json_expected(node, "a point [metres, rate]");
    return;
  }
  json_node metres = json_element(node, 0);
  json_node rate = json_element(node, 1);
  point->metres = json_number(&metres, 0, MAX_DISTANCE_M, 0);
  point->rate = json_number(&rate, 0, 1, 0);
}

static bool is_outdoors(const json_node *node) {
  const char *text = json_string_value(node->value);
  return text && strcmp(text, "outdoors") == 0;
}

static void read_distance_rates(radio_config *radio, const json_node *node) {
  size_t count = json_is_array(node->value) ? json_array_length(node) : MAX_DISTANCE_RATES + 1;
  if (!json_given(node)) return;
  if (is_outdoors(node)) {
    radio->distance_rate_count = sizeof OUTDOORS / sizeof *OUTDOORS;
    memcpy(radio->distance_rates, OUTDOORS, sizeof OUTDOORS);
    radio->range_m = OUTDOORS_RANGE_M;
    radio->shadowing_db = OUTDOORS_SHADOWING_DB;
    return;
  }
  if (count > MAX_DISTANCE_RATES) {
    json_expected(node, "\"outdoors\", or a list of up to 16 points [[metres, rate], …]");
    return;
  }
  for (size_t i = 0; i < count; i++) {
    json_node point = json_element(node, i);
    read_distance_rate(&radio->distance_rates[i], &point);
    if (i > 0 && radio->distance_rates[i].metres <= radio->distance_rates[i - 1].metres)
      json_expected(&point, "more metres than those of the point before");
  }
  radio->distance_rate_count = count;
}

static void read_noise(noise_config *noise, const json_node *node) {
  static const char *const KEYS[] = {"edges", "after", NULL};
  if (!json_given(node) || !json_check_object(node, KEYS)) return;
  json_node edges = json_member(node, "edges");
  json_node after = json_member(node, "after");
  noise->edges_per_s = json_number(&edges, 0, MAX_NOISE_EDGES, DEFAULT_NOISE_EDGES);
  noise->after_s = json_number(&after, 0, 1e9, DEFAULT_NOISE_AFTER_S);
}

void radio_change_read(radio_config *radio, const json_node *node) {
  json_node range = json_member(node, "range");
  json_node bit_error_rate = json_member(node, "bitErrorRate");
  json_node bursts = json_member(node, "bursts");
  json_node by_distance = json_member(node, "errorsByDistance");
  json_node shadowing = json_member(node, "shadowing");
  json_node noise = json_member(node, "noise");
  json_node capture = json_member(node, "capture");
  json_node loss = json_member(node, "loss");
  read_distance_rates(radio, &by_distance);  // first: "outdoors" brings a range and shadowing with it
  radio->range_m = json_number(&range, 0, MAX_DISTANCE_M, radio->range_m);
  radio->bit_error_rate = json_number(&bit_error_rate, 0, 1, radio->bit_error_rate);
  read_bursts(&radio->bursts, &bursts);
  radio->shadowing_db = json_number(&shadowing, 0, MAX_SHADOWING_DB, radio->shadowing_db);
  read_noise(&radio->noise, &noise);
  radio->capture_db = json_number(&capture, 0, MAX_CAPTURE_DB, radio->capture_db);
  radio->loss = json_number(&loss, 0, 1, radio->loss);
}

void radio_config_read(radio_config *radio, const json_node *node) {
  static const char *const KEYS[] = {"bitRate", RADIO_KEYS, "module", "uartRate", "airRate", "delay", "buffer", NULL};
  json_node bit_rate = json_member(node, "bitRate");
  *radio = (radio_config){.range_m = DEFAULT_RANGE_M};
  if (json_given(node)) json_check_object(node, KEYS);
  radio->bit_rate = json_number(&bit_rate, MIN_BIT_RATE, MAX_BIT_RATE, DEFAULT_BIT_RATE);
  read_module(&radio->module, node);
  if (radio->module.name) radio->bit_rate = radio->module.air_rate;
  radio_change_read(radio, node);
}

// Settings that are off are left out.
json_t *radio_config_json(const radio_config *radio) {
  json_t *object =
      json_pack("{sfsfsf}", "bitRate", radio->bit_rate, "range", radio->range_m, "bitErrorRate", radio->bit_error_rate);
  const burst_config *bursts = &radio->bursts;
  const noise_config *noise = &radio->noise;
  if (bursts->rate > 0)
    json_object_set_new(
        object, "bursts",
        json_pack("{sfsfsf}", "rate", bursts->rate, "length", bursts->length_bits, "rateWithin", bursts->rate_within));
  if (radio->distance_rate_count > 0) {
    json_t *points = json_array();
    for (size_t i = 0; i < radio->distance_rate_count; i++)
      json_array_append_new(points, json_pack("[ff]", radio->distance_rates[i].metres, radio->distance_rates[i].rate));
    json_object_set_new(object, "errorsByDistance", points);
  }
  if (radio->shadowing_db > 0) json_object_set_new(object, "shadowing", json_real(radio->shadowing_db));
  if (noise->edges_per_s > 0)
    json_object_set_new(object, "noise", json_pack("{sfsf}", "edges", noise->edges_per_s, "after", noise->after_s));
  if (radio->capture_db > 0) json_object_set_new(object, "capture", json_real(radio->capture_db));
  if (radio->loss > 0) json_object_set_new(object, "loss", json_real(radio->loss));
  const module_config *module = &radio->module;
  if (module->name) {
    json_object_set_new(object, "module", json_string(module->name));
    json_object_set_new(object, "uartRate", json_real(module->uart_rate));
    json_object_set_new(object, "airRate", json_real(module->air_rate));
    json_object_set_new(object, "delay", json_real(module->delay_s));
    json_object_set_new(object, "buffer", json_integer((json_int_t)module->buffer));
  }
  return object;
}
