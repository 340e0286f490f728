# Pir: a pin that something pulls to ground and lets go. The bumper's switch stands for the sensor's output. It senses as soon as it is attached.
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
