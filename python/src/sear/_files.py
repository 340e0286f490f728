# SPDX-License-Identifier: Apache-2.0
"""Writing of files, whole or not at all."""
import contextlib
import os
import tempfile


@contextlib.contextmanager
def whole(path):
    """Gives a path beside a file to write to, and moves it there at the end of the block. If the block raises, the file
    is unchanged. Pipes and devices are written directly."""
    path = os.path.abspath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        yield path
        return
    if os.path.exists(path) and not os.access(path, os.W_OK):
        raise PermissionError("%s is read-only" % path)
    if not os.path.isdir(os.path.dirname(path)):
        raise FileNotFoundError("%s can't be written, there is no folder %s" % (path, os.path.dirname(path)))
    with tempfile.TemporaryDirectory(prefix=".sear-", dir=os.path.dirname(path)) as folder:
        aside = os.path.join(folder, os.path.basename(path))
        yield aside
        if os.path.exists(path):
            os.chmod(aside, os.stat(path).st_mode & 0o777)
        os.replace(aside, path)
