# Arduino, Servo and pins in lock-step, twice. The board boots and answers although simulated time stands still until
# the caller advances it.
def run():
    """Returns all messages and actions of the board, with their times."""
    log = []
    def heard(pins):
        for pin in pins:
            log.append((sear.getTime(), pin.pin, pin.value))
            if pin.pin == "D2": arduino.digitalWrite(11, pin.value)    # a callback that sends a command
    globals()["onLockStepPins"] = heard
    if sear.isSimulating(): sear.stopSimulation()
    sear.setLockStep(True)
    sear.startSimulation()
    arduino = Runtime.start("board", "Arduino")
    start = time.time()
    arduino.connect("/dev/SEAR_UNO_01")
    check("computer time of connecting, ms: its service waits 4.5 s for what does not come", (time.time() - start) * 1000, 0, 4000)
    check("the program's version", arduino.getBoardInfo().getVersion(), 68, 0)
    check("simulated time of connecting", sear.getTime(), 0, 0)
    arduino.pinMode(11, 1)
    for level in (1, 0, 1):
        arduino.digitalWrite(11, level)
        sear.simSleep(0.1)
        check("the lamp", sear.getLed("lamp"), level, 0)
    arduino.addListener("publishPinArray", "python", "onLockStepPins")
    arduino.enablePin("A0", 20)
    arduino.pinMode(2, 2)
    arduino.enablePin(2, 5)
    neck = Runtime.start("neckServo", "Servo")
    neck.setPin(3)
    neck.attach(arduino)
    for angle in (120, 60, 90):
        neck.moveTo(angle)
        sear.simSleep(0.1)
        log.append((sear.getTime(), "on its way", sear.getServo("neck")))
        sear.simSleep(0.9)
        check("the servo", sear.getServo("neck"), angle - 90, 1.5)
        log.append((sear.getTime(), "there", sear.getServo("neck")))
    neck.setSpeed(60.0)
    start = sear.getTime()
    neck.moveTo(150)
    sear.simSleep(0.5)
    check("half the way", sear.getServo("neck"), 30, 3)
    sear.simSleep(0.6)
    check("the slow servo", sear.getServo("neck"), 60, 1.5)
    log.append((sear.getTime(), "slow", sear.getServo("neck")))
    pressBumper()
    sear.simSleep(6)
    check("the lamp, which the callback has put out", sear.getLed("lamp"), 0, 0)
    log.append((sear.getTime(), "lamp", sear.getLed("lamp"), tuple(sear.getPose("rover"))))
    arduino.removeListener("publishPinArray", "python", "onLockStepPins")
    sear.stopSimulation()
    for service in ("neckServo", "board"): Runtime.release(service)
    return log

first = run()
check("pins told", len([1 for line in first if line[1] == "A0"]), 200, 80)
second = run()
if first != second: raise AssertionError("two runs differ: %s" % [pair for pair in zip(first, second) if pair[0] != pair[1]][:3])
