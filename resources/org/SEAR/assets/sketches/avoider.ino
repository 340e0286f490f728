// A rover with an HC-SR04 on a servo finds its way: it drives until something is near, looks to both sides, and turns to
// the side with more space. The sketch of examples/avoider.py, for an Uno.
const byte TRIGGER = 12, ECHO = 11, NECK = 9, LED = 13;
const byte LEFT_POWER = 5, LEFT_DIRECTION = 7, RIGHT_POWER = 6, RIGHT_DIRECTION = 8;
const unsigned NEAR = 35;          // cm
const unsigned MICROS_PER_CM = 58; // sound, there and back

void drive(int left, int right) {
  digitalWrite(LEFT_DIRECTION, left >= 0);
  digitalWrite(RIGHT_DIRECTION, right >= 0);
  analogWrite(LEFT_POWER, abs(left));
  analogWrite(RIGHT_POWER, abs(right));
}

// Timer 1 makes a pulse every 20 ms at pin 9; it counts half microseconds.
void beginNeck() {
  pinMode(NECK, OUTPUT);
  TCCR1A = _BV(COM1A1) | _BV(WGM11);
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
  ICR1 = 39999;
}

void look(int degrees) {           // 0 is straight ahead, positive to the left
  OCR1A = 2 * (1472 + degrees * 10.31);
}

unsigned distance() {
  digitalWrite(TRIGGER, HIGH);
  delayMicroseconds(10);
  digitalWrite(TRIGGER, LOW);
  unsigned long echo = pulseIn(ECHO, HIGH, 60000);
  delay(10);
  return echo == 0 ? 400 : echo / MICROS_PER_CM;
}

unsigned distanceAt(int degrees) {
  look(degrees);
  delay(400);
  return distance();
}

void setup() {
  Serial.begin(9600);
  pinMode(TRIGGER, OUTPUT);
  pinMode(ECHO, INPUT);
  pinMode(LED, OUTPUT);
  pinMode(LEFT_DIRECTION, OUTPUT);
  pinMode(RIGHT_DIRECTION, OUTPUT);
  beginNeck();
  look(0);
  Serial.println(F("avoider"));
}

void loop() {
  unsigned ahead = distance();
  digitalWrite(LED, ahead < NEAR);
  if (ahead >= NEAR) {
    drive(170, 170);
    return;
  }
  drive(0, 0);
  unsigned left = distanceAt(60);
  unsigned right = distanceAt(-60);
  look(0);
  Serial.print(ahead);
  Serial.print(F(" cm ahead, left "));
  Serial.print(left);
  Serial.print(F(", right "));
  Serial.println(right);
  int turn = left > right ? 110 : -110;
  drive(-turn, turn);
  delay(450);
  drive(0, 0);
  delay(200);
}
