# SPDX-License-Identifier: Apache-2.0
"""Takes the version from gradle.properties, and adds SEAR and type hints as built by `./gradlew installDist`.

Writes into temporary folders only, so that several builds can run at the same time, also from a read-only checkout.
Only a checkout that is writable and has not been built gets a build folder.
"""
import atexit
import contextlib
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
BUILT = os.path.join("build", "install", "sear")
# Omits parts for the command line only, and the class archive, which other Java releases can't read
TAKEN = ("plugin", "lib", "examples")
LEFT = ("*.jsa", "*.jsa.for", "__pycache__")
LICENCES = "LICENSES.md"
HINTS = "__init__.pyi"
# Folders of a checkout that its build does not need
NOT_COPIED = (".git", ".gradle", "build")


def version():
    """Returns the version of the jars."""
    with open(os.path.join(ROOT, "gradle.properties")) as properties:
        return re.search(r"^version=(.+)$", properties.read(), re.MULTILINE).group(1).strip()


def temporary():
    """Returns a new folder, which is deleted at the end of the program."""
    folder = tempfile.mkdtemp(prefix="sear-pip-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


@contextlib.contextmanager
def locked(path):
    """Waits until no other program is in this block with this path."""
    with open(path, "a+") as file:
        if os.name == "nt":
            import msvcrt
            while True:
                try:
                    file.seek(0)
                    msvcrt.locking(file.fileno(), msvcrt.LK_LOCK, 1)    # raises after 10 s
                    break
                except OSError:
                    pass
        else:
            import fcntl
            fcntl.flock(file, fcntl.LOCK_EX)
        yield    # closing the file ends the lock


def is_built(root):
    """Returns whether SEAR has been built there."""
    return os.path.isfile(os.path.join(root, BUILT, "plugin", "sear.jar"))


def build(root):
    """Builds SEAR there."""
    subprocess.check_call([os.path.join(root, "gradlew"), "-q", "installDist"], cwd=root, stdout=sys.stderr)


def built():
    """Returns the folder of the built SEAR; builds it first if necessary."""
    if os.access(ROOT, os.W_OK):
        os.makedirs(os.path.join(ROOT, "build"), exist_ok=True)
        with locked(os.path.join(ROOT, "build", "pip.lock")):
            if not is_built(ROOT):
                build(ROOT)
        return os.path.join(ROOT, BUILT)
    if is_built(ROOT):
        return os.path.join(ROOT, BUILT)
    copy = os.path.join(temporary(), "sear")
    shutil.copytree(ROOT, copy, ignore=lambda folder, names: NOT_COPIED if folder == ROOT else ())
    for folder, _, files in os.walk(copy):
        for path in [folder] + [os.path.join(folder, name) for name in files]:
            os.chmod(path, os.stat(path).st_mode | stat.S_IWUSR)
    build(copy)
    return os.path.join(copy, BUILT)


class Build(build_py):
    """Adds the built SEAR and its type hints to the package."""

    def run(self):
        super().run()
        source = built()
        home = os.path.join(self.build_lib, "sear", "home")
        shutil.rmtree(home, ignore_errors=True)
        for folder in TAKEN:
            shutil.copytree(os.path.join(source, folder), os.path.join(home, folder), ignore=shutil.ignore_patterns(*LEFT))
        shutil.copyfile(os.path.join(source, LICENCES), os.path.join(home, LICENCES))
        shutil.copyfile(os.path.join(source, "python", "sear", HINTS), os.path.join(self.build_lib, "sear", HINTS))


setup(version=version(), cmdclass={"build_py": Build},
      options={"build": {"build_base": temporary()}, "egg_info": {"egg_base": temporary()}})
