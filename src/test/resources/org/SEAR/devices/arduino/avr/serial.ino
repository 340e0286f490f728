// Compiled by avr-gcc 5.4 with the Arduino AVR core 1.8 of Debian, -Os, for an Uno.
void setup() {
  Serial.begin(115200);
  pinMode(13, OUTPUT);
  analogWrite(9, 64);
  Serial.println(1.5 * 3);
  Serial.println(analogRead(A0));
}

void loop() {
  digitalWrite(13, HIGH);
  delay(100);
  digitalWrite(13, LOW);
  delay(100);
  Serial.println(millis());
}
