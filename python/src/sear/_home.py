# SPDX-License-Identifier: Apache-2.0
"""Location of SEAR's Java part."""
import os
import re
import shutil
import time
import zipfile
import zlib

PLUGIN = "plugin"
# Number of archives of classes in the user's cache, and longest time to write one, seconds
CACHED = 5
WRITING_SECONDS = 600
HERE = os.path.dirname(os.path.abspath(__file__))


def _candidates():
    if os.environ.get("SEAR_HOME"):
        yield os.environ["SEAR_HOME"]
        return
    yield os.path.join(HERE, "home")                       # pip install
    yield os.path.abspath(os.path.join(HERE, "..", ".."))  # SEAR's folder contains this package in python/
    yield os.path.abspath(os.path.join(HERE, "..", "..", "..", "build", "install", "sear"))  # the sources
    command = shutil.which("sear")
    if command:
        yield os.path.dirname(os.path.dirname(os.path.realpath(command)))


def find():
    """Returns the folder with SEAR's jars in plugin/ and lib/.

    Raises FileNotFoundError with the folders searched.
    """
    looked = []
    for folder in _candidates():
        if os.path.isfile(os.path.join(folder, PLUGIN, "sear.jar")):
            return folder
        looked.append(folder)
    raise FileNotFoundError("SEAR's jars are missing: no plugin/sear.jar in %s. Set SEAR_HOME to SEAR's folder, which contains bin/sear"
                            % ", ".join(looked))


def jars(home):
    """Returns all jars of SEAR and of its embedded MyRobotLab.

    The order is that of the folder listing, as for Java's lib/*: a different order would disable the class archive.
    """
    return [os.path.join(home, folder, name) for folder in (PLUGIN, "lib") for name in os.listdir(os.path.join(home, folder))
            if name.endswith(".jar")]


def class_archive(home, jvm):
    """Returns Java's option for an archive of classes: the build's for its own folder and Java, else one in the user's
    cache, as bin/sear. The second start of an installation writes it at its end, if several run at the same time only
    one. The cache keeps five.

    jvm is the path of Java's library.
    """
    build = os.path.join(home, "lib", "sear.jsa")
    java = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(jvm))))
    if os.path.exists(build) and os.path.exists(build + ".for"):
        with open(build + ".for", encoding="utf-8") as file:
            if file.read() == home + " " + java:
                return ["-XX:SharedArchiveFile=" + build]
    try:
        return _cached_archive(home, jvm)
    except OSError:
        return []


def _cached_archive(home, jvm):
    files = [(path, os.path.getsize(path), int(os.path.getmtime(path))) for path in sorted(jars(home)) + [jvm]]
    caches = os.path.join(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"), "sear", "classes")
    mine = os.path.join(caches, "python-%d" % zlib.crc32(repr(files).encode("utf-8")))
    archive = os.path.join(mine, "sear.jsa")
    if os.path.exists(archive):
        with open(archive, "rb") as file:
            if file.read(4).strip(b"\0"):    # Java writes the first bytes last
                return ["-XX:SharedArchiveFile=" + archive]
    lock = os.path.join(mine, "lock")
    if not os.path.isdir(mine):
        os.makedirs(mine)
        return []
    if os.path.isdir(lock) and time.time() - os.path.getmtime(lock) > WRITING_SECONDS:
        os.rmdir(lock)
    os.mkdir(lock)
    old = sorted((os.path.join(caches, name) for name in os.listdir(caches)), key=os.path.getmtime)
    for folder in old[:-CACHED]:
        shutil.rmtree(folder, ignore_errors=True)
    return ["-XX:ArchiveClassesAtExit=" + archive]


def jar(home):
    """Returns the path of SEAR's jar."""
    return os.path.join(home, PLUGIN, "sear.jar")


def version(home):
    """Returns SEAR's version, from its jar."""
    with zipfile.ZipFile(jar(home)) as opened:
        found = re.search(r"^Implementation-Version: (\S+)", opened.read("META-INF/MANIFEST.MF").decode("utf-8"), re.MULTILINE)
    return found.group(1) if found else "development"
