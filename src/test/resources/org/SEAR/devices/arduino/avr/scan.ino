// Searches the I2C bus, and sends a byte by SPI. Compiled by avr-gcc 5.4 with the Arduino AVR core 1.8, SPI and Wire of Debian, -Os, for an Uno.
#include <SPI.h>
#include <Wire.h>

void setup() {
  Serial.begin(115200);
  Wire.begin();
  byte errors[6] = {0};
  for (byte address = 1; address < 127; address++) {
    Wire.beginTransmission(address);
    Wire.write(address);
    errors[Wire.endTransmission()]++;
  }
  for (byte i = 0; i < 6; i++) {
    Serial.print(errors[i]);
    Serial.print(' ');
  }
  Serial.println(Wire.requestFrom(0x1E, 2));
  SPI.begin();
  Serial.println(SPI.transfer(0x55));
}

void loop() {
}
