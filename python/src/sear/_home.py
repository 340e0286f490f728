# SPDX-License-Identifier: Apache-2.0
"""Location of SEAR's Java part."""
import os
import re
import shutil
import zipfile

PLUGIN = "plugin"
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


def class_archive(home):
    """Returns Java's option for the class archive of the build; none without an archive."""
    file = os.path.join(home, "lib", "sear.jsa")
    return ["-XX:SharedArchiveFile=" + file] if os.path.exists(file) else []


def jar(home):
    """Returns the path of SEAR's jar."""
    return os.path.join(home, PLUGIN, "sear.jar")


def version(home):
    """Returns SEAR's version, from its jar."""
    with zipfile.ZipFile(jar(home)) as opened:
        found = re.search(r"^Implementation-Version: (\S+)", opened.read("META-INF/MANIFEST.MF").decode("utf-8"), re.MULTILINE)
    return found.group(1) if found else "development"
