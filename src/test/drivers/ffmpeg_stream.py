"""Reads a network camera with FFmpeg.

usage: ffmpeg_stream.py URL PICTURES

Prints FFmpeg's version, the size of the pictures, and the mean red, green and blue of each, rounded."""
import sys

import imageio_ffmpeg
import numpy


def main():
    print(imageio_ffmpeg.get_ffmpeg_version())
    frames = imageio_ffmpeg.read_frames(sys.argv[1])
    width, height = next(frames)["source_size"]
    print("%d x %d" % (width, height))
    for _ in range(int(sys.argv[2])):
        picture = numpy.frombuffer(next(frames), numpy.uint8).reshape(height * width, 3)
        print("%d %d %d" % tuple(numpy.rint(picture.mean(0))))
    frames.close()


if __name__ == "__main__":
    main()
