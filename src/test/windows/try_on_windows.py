"""Runs the built distribution with bin/sear.bat on Wine with a Windows Java, and with bin/sear here; compares output and
files.

usage: try_on_windows.py DISTRIBUTION WINDOWS_JAVA_HOME

Tries the demo without a terminal, check, save, load and TCP export, in folders with blanks and umlauts. Prints a line per
trial, and the differences; exit status 1 if there are any. Leaves no Wine process behind."""
import difflib
import hashlib
import os
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
DISTRIBUTION = "sear"  # no blank here: cmd /c would remove a quote at its beginning; the parent folder has blanks
SCRIPTS = "Skripte für Tests"
LOCK_STEP = ["--headless", "--speed", "max", "--port", "none"]
REAL_TIME = ["--headless", "--port", "none"]
PATIENCE = 1500  # seconds per run: an idle machine needs 30, a machine that runs tests at the same time much longer
UTF_8 = {"LC_ALL": "C.UTF-8"}


class Linux:
    """The launcher for this system."""
    name, encoding = "Linux", "utf-8"

    def __init__(self, root):
        self.folder = os.path.join(root, "Linux Größe 1")
        self.environment = dict(os.environ, SEAR_TERMINAL="1", **UTF_8)  # sear.bat always reports a terminal

    def command(self, arguments):
        return ["sh", "../%s/bin/sear" % DISTRIBUTION] + arguments

    def close(self):
        pass


class Windows:
    """The launcher for Windows, on Wine in its own configuration."""
    name, encoding = "Windows", "cp1252"

    def __init__(self, root, java):
        self.folder = os.path.join(root, "Windows Größe 1")
        home = "Z:" + os.path.abspath(java).replace("/", "\\")
        self.environment = dict(os.environ, WINEPREFIX=os.path.join(root, "wine"), WINEDEBUG="-all", DISPLAY="", JAVA_HOME=home,
                                WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe=", **UTF_8)
        nowhere = subprocess.DEVNULL
        subprocess.run(["wine", "wineboot", "-i"], env=self.environment, stdin=nowhere, stdout=nowhere, stderr=nowhere, timeout=PATIENCE, check=True)

    def command(self, arguments):
        return ["wine", "cmd", "/c", "..\\%s\\bin\\sear.bat" % DISTRIBUTION] + arguments

    def close(self):
        """Ends the Wine of this configuration only, and waits until it has ended."""
        for option in ("-k", "-w"):
            subprocess.run(["wineserver", option], env=self.environment, timeout=60, check=False)


def start(system, arguments):
    # files instead of pipes: Wine's own processes would keep a pipe open after the run
    out, err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
    process = subprocess.Popen(system.command(arguments), cwd=system.folder, env=system.environment, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                               start_new_session=True)
    return process, out, err


def text(system, stream):
    """Returns the printed text, without Java 11's warning about jMonkeyEngine and without reports of long work, which
    depend on the computer's speed. Python's print writes UTF-8 everywhere, Java the system's encoding."""
    stream.seek(0)
    data = re.sub(rb"(?m)^(WARNING: .*(llegal|maintainers).*|.* \d+ s so far)\n", b"", stream.read().replace(b"\r\n", b"\n"))
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode(system.encoding)


def finish(system, started):
    process, out, err = started
    try:
        status = process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        status = "none after %d s" % PATIENCE
    return "exit status %s\n%s%s" % (status, text(system, out), text(system, err))


def run(system, arguments):
    return finish(system, start(system, arguments))


def telegram(*data):
    """Returns a telegram of the LMS200 with its CRC, one shift per byte."""
    frame, value, before = struct.pack("<BBH", 2, 0, len(data)) + bytes(data), 0, 0
    for byte in frame:
        value = (((value << 1) & 0xFFFF) ^ (0x8005 if value & 0x8000 else 0)) ^ ((before << 8) | byte)
        before = byte
    return frame + struct.pack("<H", value)


def ask(connection, question, count):
    connection.sendall(question)
    answer = b""
    while len(answer) < count:
        part = connection.recv(count - len(answer))
        if not part:
            break
        answer += part
    return answer.hex()


def ports(system, started):
    """Returns the TCP ports that the script prints."""
    process, out, _ = started
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and process.poll() is None:
        printed = re.search(r"ports (\d+) (\d+)\n", text(system, out))
        if printed:
            return [int(number) for number in printed.groups()]
        time.sleep(0.2)
    raise RuntimeError("no ports: " + finish(system, started))


def tcp(system):
    """Requests a scan from the LIDAR and the distance from the robot, then drives the robot. Returns the answers and
    the output."""
    started = start(system, [SCRIPTS + "/tcp_export.py"] + REAL_TIME)
    try:
        robot, lidar = ports(system, started)
        with socket.create_connection(("127.0.0.1", lidar), 60) as connection:
            scan = ask(connection, telegram(0x30, 1), 1 + 4 + 3 + 2 * 181 + 1 + 2)
        with socket.create_connection(("127.0.0.1", robot), 60) as connection:
            distance = ask(connection, b"\x80\x83\x8e\x13", 2)
            connection.sendall(b"\x89\x00\xc8\x80\x00")
            end = re.sub(r"ports \d+ \d+\n", "", finish(system, started))
        return "scan %s\ndistance %s\n%s" % (scan, distance, end)
    finally:
        if started[0].poll() is None:
            os.killpg(started[0].pid, signal.SIGKILL)


def files(folder):
    """Returns name and check sum of all files that the runs left; without check sum for those that contain a process id."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.relpath(os.path.join(at, name), folder)
            with open(os.path.join(at, name), "rb") as file:
                found[path] = "" if name.endswith(".owner") else hashlib.sha256(file.read()).hexdigest()
    return found


def trials(system):
    """Yields what each trial prints, and finally the files in the folder."""
    shutil.copytree(HERE, os.path.join(system.folder, SCRIPTS), ignore=shutil.ignore_patterns("try_*", "__pycache__"))
    yield "demo", run(system, ["../%s/scripts/demo.py" % DISTRIBUTION] + LOCK_STEP)
    yield "check", run(system, ["check", "."])
    yield "check of a bundle", run(system, ["check", "../%s/examples/maze.sear" % DISTRIBUTION]).replace("\\", "/")
    yield "check of what is no bundle", run(system, ["check", SCRIPTS + "/tcp_export.py"]).replace("\\", "/")
    yield "save and load", run(system, [SCRIPTS + "/save_and_load.py"] + LOCK_STEP)
    yield "TCP export", tcp(system)
    yield "files", "\n".join("%s %s" % pair for pair in sorted(files(system.folder).items()))


EXPECTED = {"demo": "exit status 0\n.*Standing still\n.*Backward for 2 s\n.*Done.\n", "check": "exit status 0\n.: no problems\n",
            "check of a bundle": "exit status 0\n.*no problems\n", "check of what is no bundle": "exit status 2\n.*no zip file.*problems: 1\n",
            "save and load": r"exit status 0\npose \['.*",
            "TCP export": "scan 0602[0-9a-f]+\ndistance [0-9a-f]{4}\nexit status 0\ndriven from outside\n",
            "files": r".*Büro zwei.sear .*SEARproject/robot/office Roomba.xml "}


def difference(name, ours, theirs):
    if ours == theirs:
        return "both are not as expected (%s):\n%s" % (EXPECTED[name], ours)
    return "\n".join(difflib.unified_diff(ours.splitlines(), theirs.splitlines(), "Linux", "Windows", lineterm="", n=2))


def main():
    distribution, java = sys.argv[1:]
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="SEAR für Größe ") as root:
        shutil.copytree(distribution, os.path.join(root, DISTRIBUTION))
        here, there = Linux(root), Windows(root, java)
        try:
            for (name, ours), (_, theirs) in zip(trials(here), trials(there)):
                fine = ours == theirs and re.match(EXPECTED[name], ours, re.DOTALL)
                print("%s: %s" % (name, "the same" if fine else "DIFFERENT\n" + difference(name, ours, theirs)), flush=True)
                wrong += not fine
        finally:
            here.close()
            there.close()
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
