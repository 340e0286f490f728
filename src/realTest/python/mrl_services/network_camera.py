# A network camera, read like MyRobotLab's OpenCV service: a picture's head ends before its first two bytes and contains
# its length.
from java.io import DataInputStream
from java.net import URL
from javax.imageio import ImageIO
from java.io import ByteArrayInputStream
from jarray import zeros
from org.SEAR.POJOs import Camera, Marker

sear.stopSimulation()
port = sear.exportCamera("view", 0)
seer = Robots.create2("seer")
seer.move(4, 0, 0)
seer.addComponent(Camera("view", 0, 0.3, 0))
Marker("mark", "DICT_4X4_50", 7, 0.4, 4, 0.4, 1.5)
sear.startSimulation()
address = "http://localhost:%d" % port
stream = DataInputStream(URL(address + "/stream.mjpg").openStream())
for picture in range(5):
    head = ""
    while not head.endswith("\xff\xd8"): head += chr(stream.readUnsignedByte())
    length = int(head.split("Content-Length: ")[1].split("\r")[0])
    file = zeros(length, "b")
    file[0], file[1] = -1, -40
    stream.readFully(file, 2, length - 2)
    image = ImageIO.read(ByteArrayInputStream(file))
    if (image.getWidth(), image.getHeight()) != (320, 240):
        raise AssertionError("%d x %d" % (image.getWidth(), image.getHeight()))
stream.close()
middle = image.getRGB(160, 120 - 18) & 255      # on the marker's plate
pixel = sear.getPixels("view")[(120 - 18) * 320 + 160] & 255
check("the pixel of the stream", middle, pixel, 40)
if sear.getExports()["view"] != ["network camera " + address + "/stream.mjpg"]:
    raise AssertionError(sear.getExports())
sear.stopExportCamera("view")
if "view" in sear.getExports():
    raise AssertionError("still exported")
