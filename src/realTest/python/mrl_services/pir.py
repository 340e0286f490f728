# Pir: a pin pulled to ground and released. The bumper's switch replaces the sensor's output. It is active from the
# start.
arduino = board()
arduino.pinMode(2, 2)
senses = []
def onRoverSense(active):
    senses.append(active)
pir = Runtime.start("pir", "Pir")
pir.addListener("publishSense", "python", "onRoverSense")
pir.setPin("2")
pir.setRate(20)
pir.attach(arduino.getName())
pir.enable()
until("it senses", lambda: senses and senses[-1])
pressBumper()
until("it senses no more", lambda: not senses[-1])
pir.disable()
