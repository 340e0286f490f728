# The order of messages, as MessagesTest checks it for the embedded MyRobotLab: queued messages, and messages that
# overtake them.
first, second = Runtime.start("firstPort", "Serial"), Runtime.start("secondPort", "Serial")
heard = []
def onFirstBytes(value): heard.append(("first", value))
def onSecondBytes(value): heard.append(("second", value))
def onFirstLeft(port): heard.append(("left", port))

def same(what, expected):
    until(what, lambda: len(heard) >= len(expected))
    if heard != expected: raise AssertionError("%s: %s, not %s" % (what, heard, expected))
    del heard[:]

first.addListener("publishRX", "python", "onFirstBytes")
first.addListener("publishDisconnect", "python", "onFirstLeft")
for value in range(50):
    first.invoke("publishRX", value)
    first.invoke("publishDisconnect", str(value))
same("what one service publishes comes in order", [one for value in range(50) for one in (("first", value), ("left", str(value)))])

first.addListener("publishRX", "python", "onSecondBytes")
first.removeListener("publishRX", "python", "onFirstBytes")
first.addListener("publishRX", "python", "onFirstBytes")
first.invoke("publishRX", 1)
same("listeners come in the order in which they were added", [("second", 1), ("first", 1)])
first.removeListener("publishRX", "python", "onSecondBytes")

first.removeListener("publishRX", "python", "onFirstBytes")

def onOthersBytes(value): heard.append(("second's", value))
second.addListener("publishRX", "python", "onOthersBytes")
first.addListener("publishRX", "python", "onFirstBytes")
second.invokeOn(False, first, "publishRX", 2)
same("who calls publishes, not who is called", [("second's", 2)])

first.removeListener("publishRX", "python", "onFirstBytes")
first.addListener("publishRX", "secondPort", "publishRX")
first.addListener("publishRX", "python", "onSentBytes")
def onSentBytes(value): heard.append(("sent", value))
second.send("firstPort", "publishRX", 3)
same("send calls at once, with the listeners, whose own answers nobody hears", [("sent", 3)])
first.removeListener("publishRX", "secondPort", "publishRX")
first.removeListener("publishRX", "python", "onSentBytes")

check("what sendBlocking answers, past all that waits", first.sendBlocking("secondPort", "publishRX", 4), 4, 0)
same("and it is published", [("second's", 4)])
first.addListener("publishRX", "secondPort", "publishRX")
Runtime.release("secondPort")
check("who is gone still listens", len(first.getNotifyList("publishRX")), 1, 0)
