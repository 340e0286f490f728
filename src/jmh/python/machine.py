# SPDX-License-Identifier: Apache-2.0
"""Describes the machine of a measurement: processor, cores, memory, system, versions. No host name."""
import os
import platform
import re
import subprocess

GIB = 1024.0 ** 3


def field(path, pattern):
    """Returns the first group of a pattern in a file; "unknown" without a match."""
    try:
        with open(path) as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:
        found = None
    return found.group(1).strip() if found else "unknown"


def output(*command):
    """Returns the first line of a command's output; "unknown" after a failure."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    except OSError:
        return "unknown"
    lines = [line for line in done.stdout.splitlines() if line.strip()]
    return lines[0].strip() if done.returncode == 0 and lines else "unknown"


def describe(java):
    """Returns the description for the page."""
    cache = field("/sys/devices/system/cpu/cpu0/cache/index3/size", r"(\d+)K")
    return {
        "cpu": field("/proc/cpuinfo", r"^model name\s*:\s*(.*)$"),
        "mhz": field("/proc/cpuinfo", r"^cpu MHz\s*:\s*([0-9]+)"),
        "cores": os.cpu_count(),
        "lastLevelCacheMiB": "unknown" if cache == "unknown" else int(cache) // 1024,
        "memoryGiB": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / GIB, 1),
        "system": field("/etc/os-release", r'^PRETTY_NAME="?([^"\n]*)'),
        "java": output(java, "-version"),
        "python": platform.python_version(),
    }
