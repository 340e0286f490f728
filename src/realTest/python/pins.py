# Arduino: digital and PWM outputs, pins that are read.
arduino = board()
arduino.pinMode(11, 1)
arduino.digitalWrite(11, 1)
until("the lamp is on", lambda: sear.getLed("lamp") == 1)
arduino.digitalWrite(11, 0)
until("the lamp is off", lambda: sear.getLed("lamp") == 0)
arduino.analogWrite(11, 51)
until("the lamp is dimmed", lambda: abs(sear.getLed("lamp") - 0.2) < 1e-6)

told = {}
def onBoardPins(pins):
    for pin in pins: told.setdefault(pin.pin, []).append(pin.value)
arduino.addListener("publishPinArray", "python", "onBoardPins")
arduino.enablePin("A0", 20)
until("A0 is told", lambda: len(told.get("A0", [])) >= 5)
check("A0", told["A0"][-1], sear.getDistanceVolts("eye") * 1023 / 5 if hasattr(sear, "getDistanceVolts") else told["A0"][0], 3)
arduino.pinMode(2, 2)
arduino.enablePin(2, 20)
until("the bumper is free", lambda: told.get("D2", told.get("2", [0]))[-1] == 1)
print sorted(told), told
