"""Reads an RPLIDAR with the driver rplidarc1: samples of some turns, as one line of "angle:distance"."""
import asyncio
import sys

from rplidarc1 import RPLidar

port, samples = sys.argv[1], int(sys.argv[2])


async def main():
    lidar = RPLidar(port, 115200)
    reading = asyncio.ensure_future(lidar.simple_scan())
    line = []
    while len(line) < samples:
        sample = await lidar.output_queue.get()
        if sample["d_mm"]:
            line.append("%s:%s" % (sample["a_deg"], sample["d_mm"]))
    lidar.stop_event.set()
    reading.cancel()
    lidar.shutdown()
    print(" ".join(line))


asyncio.run(main())
