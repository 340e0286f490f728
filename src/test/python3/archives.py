# The archive of classes in the user's cache: who writes, who reads, how many stay. Run by Python3PackageTest.
import os
from sear import _home

os.environ["XDG_CACHE_HOME"] = os.path.join(os.getcwd(), "cache")
caches = os.path.join(os.getcwd(), "cache", "sear", "classes")
jvm = os.path.join(os.getcwd(), "jdk", "lib", "server", "libjvm.so")
os.makedirs(os.path.dirname(jvm))
open(jvm, "w").close()


def copy(name):
    for folder in "plugin", "lib":
        os.makedirs(os.path.join(name, folder))
        open(os.path.join(name, folder, folder + ".jar"), "w").close()
    return os.path.join(os.getcwd(), name)


for index in range(7):
    home = copy("home%d" % index)
    assert _home.class_archive(home, jvm) == []
    write, = _home.class_archive(home, jvm)
    option, file = write.split("=")
    assert option == "-XX:ArchiveClassesAtExit", write
    assert _home.class_archive(home, jvm) == [], "another start writes"
    with open(file, "wb") as opened:
        opened.write(b"\0\0\0\0unfinished")
    assert _home.class_archive(home, jvm) == []
    with open(file, "wb") as opened:
        opened.write(b"archive")
    assert _home.class_archive(home, jvm) == ["-XX:SharedArchiveFile=" + file]
    os.utime(os.path.dirname(file), (index, index))
    assert len(os.listdir(caches)) <= 5, os.listdir(caches)
built = os.path.join(home, "lib", "sear.jsa")
for java, found in ("other", file), (os.path.join(os.getcwd(), "jdk"), built):
    open(built, "w").close()
    with open(built + ".for", "w") as use:
        use.write(home + " " + java)
    assert _home.class_archive(home, jvm) == ["-XX:SharedArchiveFile=" + found]
os.environ["XDG_CACHE_HOME"] = jvm
assert _home.class_archive(copy("last"), jvm) == [], "no cache"
print("archives are bounded")
