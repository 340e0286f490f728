"""Drives the simulated robot and scans with the simulated LIDAR through pyserial, like a user's script for real devices.

usage: pyserial_scan.py ROBOT_PORT ROBOT_BAUD LIDAR_PORT   (paths, or rfc2217://localhost:NUMBER)

Prints the scan's raw values on one line and the distance driven on the next. Exit status 1 with a reason if an answer is
wrong or missing."""
import struct
import sys
import time

import serial

VALUES_180_BY_1 = 181


def crc(telegram):
    """Returns the CRC of SICK's LMS2xx: one shift per byte."""
    value, before = 0, 0
    for byte in bytearray(telegram):
        top, value = value & 0x8000, (value << 1) & 0xFFFF
        if top:
            value ^= 0x8005
        value ^= (before << 8) | byte
        before = byte
    return value


def telegram(*data):
    frame = struct.pack("<BBH", 2, 0, len(data)) + bytes(bytearray(data))
    return frame + struct.pack("<H", crc(frame))


def ask(port, *data):
    port.write(telegram(*data))
    if port.read(1) != b"\x06":
        sys.exit("no ACK to %s" % (data,))
    head = port.read(4)
    if len(head) != 4 or head[:1] != b"\x02":
        sys.exit("no telegram after the ACK to %s: %r" % (data, head))
    length = struct.unpack("<H", head[2:])[0]
    rest = port.read(length + 2)
    if len(rest) != length + 2 or struct.unpack("<H", rest[-2:])[0] != crc(head + rest[:-2]):
        sys.exit("broken telegram in answer to %s" % (data,))
    return rest[:-2]


def set_baud(port, code, baud):
    done = ask(port, 0x20, code)
    if bytearray(done)[:2] != bytearray(b"\xa0\x00"):
        sys.exit("%d baud was refused: %r" % (baud, done))
    port.baudrate = baud


def scan(name):
    with serial.serial_for_url(name, 9600, timeout=3) as port:
        if name.startswith("rfc2217:"):
            port.dtr, port.rts = False, True
        set_baud(port, 0x40, 38400)
        kind = ask(port, 0x3A)
        if not kind[1:].startswith(b"LMS200"):
            sys.exit("the type telegram says %r" % kind)
        switched = ask(port, 0x3B, 180, 0, 100, 0)
        if bytearray(switched)[:2] != bytearray(b"\xbb\x01"):
            sys.exit("variant 180/1 was refused: %r" % switched)
        data = ask(port, 0x30, 1)
        count = struct.unpack("<H", data[1:3])[0] & 0x3FF
        if count != VALUES_180_BY_1:
            sys.exit("%d values instead of %d" % (count, VALUES_180_BY_1))
        set_baud(port, 0x42, 9600)
        return [value & 0x1FFF for value in struct.unpack("<%dH" % count, data[3:3 + 2 * count])]


def drive(name, baud):
    with serial.serial_for_url(name, baud, timeout=3) as port:
        port.write(b"\x80\x83\x8e\x13")
        port.read(2)
        port.write(b"\x89\x00\xc8\x80\x00")
        time.sleep(2)
        port.write(b"\x89\x00\x00\x00\x00\x8e\x13")
        answer = port.read(2)
        if len(answer) != 2:
            sys.exit("no answer to packet 19")
        return struct.unpack(">h", answer)[0]


def main():
    print(" ".join(str(value) for value in scan(sys.argv[3])))
    print(drive(sys.argv[1], int(sys.argv[2])))


if __name__ == "__main__":
    main()
