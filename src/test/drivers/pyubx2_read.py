"""Configures and reads a u-blox receiver on a serial port with pyubx2, an independent codec for real ones.

usage: pyubx2_read.py PORT SOLUTIONS

Prints the firmware, the number of satellites and then "latitude longitude altitude height" of each solution. Exit status 1
at the first answer that a NEO-M8N would not give."""
import sys

import serial
from pyubx2 import ERR_RAISE, POLL, SET, UBXMessage, UBXReader

PATIENCE = 200  # messages that may precede an answer


def wait(reader, identity, **fields):
    for _ in range(PATIENCE):
        message = reader.read()[1]
        if message is None:
            sys.exit("nothing came while waiting for %s" % identity)
        if message.identity == identity and all(getattr(message, name) == value for name, value in fields.items()):
            return message
    sys.exit("no %s %s" % (identity, fields))


def command(port, reader, message, answer="ACK-ACK"):
    port.write(message.serialize())
    return wait(reader, answer, clsID=message.msg_cls[0], msgID=message.msg_id[0])


def main():
    solutions = int(sys.argv[2])
    port = serial.Serial(sys.argv[1], 9600, timeout=5)
    reader = UBXReader(port, quitonerror=ERR_RAISE)
    wait(reader, "GNGGA")
    port.write(UBXMessage("MON", "MON-VER", POLL).serialize())
    version = wait(reader, "MON-VER")
    print(version.swVersion.decode().rstrip("\0"))
    command(port, reader, UBXMessage.config_set(1, 0, [("CFG_MSGOUT_UBX_NAV_PVT_UART1", 1)]), "ACK-NAK")
    for sentence in range(6):
        command(port, reader, UBXMessage("CFG", "CFG-MSG", SET, msgClass=0xF0, msgID=sentence, rateUART1=0))
    command(port, reader, UBXMessage("CFG", "CFG-RATE", SET, measRate=200, navRate=1, timeRef=1))
    port.write(UBXMessage("NAV", "NAV-SAT", POLL).serialize())
    print(wait(reader, "NAV-SAT").numSvs)
    port.write(UBXMessage("CFG", "CFG-PRT", POLL, portID=1).serialize())
    settings = wait(reader, "CFG-PRT")
    if (settings.baudRate, settings.outUBX, settings.outNMEA) != (9600, 1, 1):
        sys.exit("the port is set to %s" % settings)
    wait(reader, "ACK-ACK", msgID=0)
    command(port, reader, UBXMessage("CFG", "CFG-PRT", SET, portID=1, charLen=3, parity=4, reserved2=0x10, baudRate=115200, inUBX=1, inNMEA=1, outUBX=1))
    port.baudrate = 115200
    command(port, reader, UBXMessage("CFG", "CFG-MSG", SET, msgClass=1, msgID=7, rateUART1=1))
    before = None
    for _ in range(solutions):
        solution = wait(reader, "NAV-PVT")
        if before is not None and solution.iTOW - before != 200:
            sys.exit("%d ms after the last solution" % (solution.iTOW - before))
        before = solution.iTOW
        print(solution.lat, solution.lon, solution.hMSL / 1000, solution.height / 1000)


if __name__ == "__main__":
    main()
