"""Where SEAR's Java half is."""
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
    yield os.path.abspath(os.path.join(HERE, "..", ".."))  # the folder of `sear` has this package in python/
    yield os.path.abspath(os.path.join(HERE, "..", "..", "..", "build", "install", "sear"))  # the sources
    command = shutil.which("sear")
    if command:
        yield os.path.dirname(os.path.dirname(os.path.realpath(command)))


def find():
    """The folder with SEAR's jars in plugin/ and lib/.

    Raises FileNotFoundError, with where it looked.
    """
    looked = []
    for folder in _candidates():
        if os.path.isfile(os.path.join(folder, PLUGIN, "sear.jar")):
            return folder
        looked.append(folder)
    raise FileNotFoundError("SEAR's jars are not there: looked for plugin/sear.jar in %s. Set SEAR_HOME to the folder of SEAR that has bin/sear"
                            % ", ".join(looked))


def jars(home):
    """All jars of SEAR and of the small MyRobotLab that comes with it.

    They are in the order in which the folder lists them, as Java takes lib/*: else it could not use the archive of classes.
    """
    return [os.path.join(home, folder, name) for folder in (PLUGIN, "lib") for name in os.listdir(os.path.join(home, folder))
            if name.endswith(".jar")]


def class_archive(home):
    """Java's option for what the build has written down of these classes; none where it has not."""
    file = os.path.join(home, "lib", "sear.jsa")
    return ["-XX:SharedArchiveFile=" + file] if os.path.exists(file) else []


def jar(home):
    """SEAR's own."""
    return os.path.join(home, PLUGIN, "sear.jar")


def version(home):
    """Of SEAR, as its jar says."""
    with zipfile.ZipFile(jar(home)) as opened:
        found = re.search(r"^Implementation-Version: (\S+)", opened.read("META-INF/MANIFEST.MF").decode("utf-8"), re.MULTILINE)
    return found.group(1) if found else "development"
