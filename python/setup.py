"""Takes the version from gradle.properties, and adds SEAR as built by `./gradlew installDist` to the package."""
import os
import re
import shutil
import subprocess
import sys

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
BUILT = os.path.join(ROOT, "build", "install", "sear")
# Omits parts for the command line only, and the class archive, which other Java releases can't read
TAKEN = ("plugin", "lib", "examples")
LEFT = ("*.jsa", "__pycache__")


def version():
    """Returns the version of the jars."""
    with open(os.path.join(ROOT, "gradle.properties")) as properties:
        return re.search(r"^version=(.+)$", properties.read(), re.MULTILINE).group(1).strip()


class Build(build_py):
    """Builds SEAR first if needed."""

    def run(self):
        super().run()
        if not os.path.isdir(BUILT):
            subprocess.check_call([os.path.join(ROOT, "gradlew"), "-q", "installDist"], cwd=ROOT, stdout=sys.stderr)
        home = os.path.join(self.build_lib, "sear", "home")
        shutil.rmtree(home, ignore_errors=True)
        for folder in TAKEN:
            shutil.copytree(os.path.join(BUILT, folder), os.path.join(home, folder), ignore=shutil.ignore_patterns(*LEFT))


setup(version=version(), cmdclass={"build_py": Build})
