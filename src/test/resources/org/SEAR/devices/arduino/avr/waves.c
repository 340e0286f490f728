// SPDX-License-Identifier: Apache-2.0
// Prints to the standard error the changes of an ATmega328P's outputs as simavr simulates them, one per line: cycle, pin, level.
// apt install libsimavr-dev libelf-dev; gcc -o waves waves.c -lsimavr -lelf; ./waves sketch.elf 16100000
// SimavrTest compares the lines of the first 16,000,000 cycles, counted from the first change and sorted by cycle and
// pin, by their number and CRC-32.
#include <simavr/avr_ioport.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>

static avr_t *avr;

struct pin {
  char name[3];
  uint32_t level;
};

static void changed(struct avr_irq_t *irq, uint32_t level, void *parameter) {
  struct pin *pin = parameter;
  if (level != pin->level) {
    pin->level = level;
    fprintf(stderr, "%llu %s %u\n", (unsigned long long) avr->cycle, pin->name, level);
  }
}

int main(int count, char **arguments) {
  static struct pin pins[24];
  elf_firmware_t firmware = {0};
  if (count != 3 || elf_read_firmware(arguments[1], &firmware) != 0) {
    fprintf(stderr, "usage: waves sketch.elf CYCLES\n");
    return 1;
  }
  firmware.frequency = 16000000;
  avr = avr_make_mcu_by_name("atmega328p");
  avr_init(avr);
  avr_load_firmware(avr, &firmware);
  for (int i = 0; i < 24; i++) {
    snprintf(pins[i].name, sizeof pins[i].name, "%c%d", "BCD"[i / 8], i % 8);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ("BCD"[i / 8]), i % 8), changed, &pins[i]);
  }
  while (avr->cycle < (avr_cycle_count_t) atoll(arguments[2])) {
    int state = avr_run(avr);
    if (state == cpu_Done || state == cpu_Crashed) {
      return 1;
    }
  }
  return 0;
}
