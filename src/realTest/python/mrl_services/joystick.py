# Joystick: a virtual pad, as the computer has none. Its stick drives the rover through two Motor services, its button switches the lamp.
import json, os, tempfile
arduino = board()
stick = Runtime.start("stick", "Joystick")
pad = tempfile.NamedTemporaryFile(suffix=".json", delete=False)
pad.write(json.dumps({"name": "pad", "type": "Gamepad", "portNumber": 0, "portType": "Unknown", "componentMap": {}, "components": [
    {"id": name, "type": kind, "index": index, "isRelative": False, "isAnalog": kind == "Axis", "value": 0.0, "virtualValue": 0.0}
    for index, (name, kind) in enumerate((("y", "Axis"), ("A", "Button")))]}))
pad.close()
stick.loadVirtualController(pad.name)
os.remove(pad.name)
if not stick.setController("pad"): raise AssertionError("the pad cannot be used")
for side, pwm, direction in (("left", 9, 4), ("right", 10, 5)):
    motor = Runtime.start(side + "Motor", "Motor")
    motor.setPwrDirPins(pwm, direction)
    motor.attach(arduino)
    motor.setAxis("y")
    stick.attachAnalogListener(motor)

pressed = []
def onPadInput(data):
    if data.id == "A":
        pressed.append(data.value)
        arduino.digitalWrite(11, int(data.value))
stick.addListener("publishJoystickInput", "python", "onPadInput")
arduino.pinMode(11, 1)

def place():
    return sear.getPose("rover")[2]

start = place()
stick.moveTo("y", 0.5)
until("it drives forward", lambda: place() > start + 0.1)
stick.moveTo("y", -0.5)
until("it drives backward", lambda: place() < start - 0.1)
stick.moveTo("y", 0)
until("it stands", lambda: max(abs(sear.getMotorSpeed(side + "Engine")) for side in ("left", "right")) < 0.01)
for down in (1, 0):
    if down: stick.pressButton("A")
    else: stick.releaseButton("A")
    until("the lamp follows the button", lambda: sear.getLed("lamp") == down)
check("button events", len(pressed), 2, 0)
stick.stopPolling()
