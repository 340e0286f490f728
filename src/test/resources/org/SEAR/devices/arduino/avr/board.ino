// Answers one-letter requests. Compiled by avr-gcc 5.4 with the Arduino AVR core 1.8 of Debian, -Os, for an Uno.
volatile unsigned edges;

void count() {
  edges++;
}

void setup() {
  Serial.begin(9600);
  pinMode(13, OUTPUT);
  pinMode(12, OUTPUT);
  pinMode(4, INPUT_PULLUP);
  pinMode(10, OUTPUT);
  TCCR1A = _BV(COM1B1) | _BV(WGM11);                // pin 10: a pulse every 20 ms, in half microseconds
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
  ICR1 = 39999;
  OCR1B = 2944;
  analogWrite(5, 64);
  attachInterrupt(digitalPinToInterrupt(2), count, CHANGE);
  Serial.println(F("ready"));
}

void ping(byte pin) {
  pinMode(pin, OUTPUT);
  digitalWrite(pin, HIGH);
  delayMicroseconds(pin == 7 ? 5 : 10);
  digitalWrite(pin, LOW);
  if (pin == 7) {
    pinMode(pin, INPUT);
  }
  Serial.println(pulseIn(pin == 7 ? 7 : 11, HIGH, 60000));
}

void loop() {
  digitalWrite(13, millis() / 250 & 1);
  switch (Serial.read()) {
    case 'a': Serial.println(analogRead(A0)); break;
    case 'd': Serial.println(digitalRead(4)); break;
    case 'e': Serial.println(edges); break;
    case 'h': ping(12); break;
    case 'p': ping(7); break;
    case 's': OCR1B = 2 * Serial.parseInt(); break;
    case 'w': analogWrite(5, Serial.parseInt()); break;
  }
}
