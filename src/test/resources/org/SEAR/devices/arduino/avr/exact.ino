// Calculates without interrupts and sets outputs between, so that cycles of all groups of instructions count.
// Compiled by avr-gcc 5.4 with the Arduino AVR core 1.8 of Debian, -Os, for an Uno.
#include <avr/pgmspace.h>

const PROGMEM uint8_t table[16] = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3};
volatile float f = 1.5;
volatile long l = 12345;
volatile uint64_t q = 1;
volatile int16_t s = -77;
volatile uint8_t length;
char text[20];

int compare(const void *a, const void *b) {
  return *(char *) a - *(char *) b;
}

void setup() {
  cli();
  DDRB = 0xff;
  DDRD = 0xff;
  for (;;) {
    PINB = 1;
    f = sin(f) * 3.7 + sqrt(fabs(f));
    PORTD = *(uint8_t *) &f;
    PINB = 2;
    l = l * 1103515245L + 12345;
    l = l / 77 + (l % 1009) * 31;
    PORTD = l;
    PINB = 4;
    q = q * 6364136223846793005ULL + 1442695040888963407ULL;
    q ^= q >> 29;
    PORTD = q >> 32;
    PINB = 8;
    s = s * 13 + (int8_t) l;
    s = s / 3 - s % 7;
    PORTD = s;
    PINB = 16;
    ltoa(l, text, 10);
    length = strlen(text);
    for (byte i = 0; i < length; i++) {
      PORTD = text[i] + pgm_read_byte(table + (i & 15));
    }
    PINB = 32;
    dtostrf(f, 9, 4, text);
    PORTD = text[8];
    qsort(text, 9, 1, compare);
    PORTD = text[3];
  }
}

void loop() {
}
