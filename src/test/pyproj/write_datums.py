"""Writes resources/org/SEAR/terrain/format/datums.txt: names of datums in .prj files, with the EPSG number of a geographic system on each.

write_datums.py LIBRARIES SYSTEMS FILE
Source: the EPSG database in pyproj's PROJ, whose well-known text has ESRI's and OGC's names. SYSTEMS is systems.txt.
"""
import re
import sys

LIBRARIES, SYSTEMS, FILE = sys.argv[1:4]
sys.path.insert(0, LIBRARIES)

import pyproj
from pyproj.crs import CRS
from pyproj.exceptions import CRSError

HEADER = f"""# Names of datums in well-known text, by ESRI without D_ and by OGC, with the EPSG number of a geographic system (Greenwich, degrees).
# Capitals count as small letters, all but letters, digits and + as _. Written by src/test/pyproj/write_datums.py
# from the EPSG database in PROJ {pyproj.__proj_version__}. EPSG database: https://epsg.org, under its terms of use.
"""


def plain(name):
    """Returns a name as the Java side compares it."""
    return re.sub(r'[^a-z0-9+]+', '_', re.sub(r'^d_', '', name.lower())).strip('_')


def names(code):
    """Returns ESRI's and OGC's name of the datum."""
    crs = CRS.from_epsg(code)
    found = set()
    for version in ('WKT1_ESRI', 'WKT1_GDAL'):
        try:
            match = re.search(r'DATUM\["([^"]+)"', crs.to_wkt(version) or '')
        except CRSError:
            continue
        if match:
            found.add(plain(match.group(1)))
    return found


numbers = {}
for line in open(SYSTEMS, encoding='utf-8'):
    words = line.split()
    if words[0] == 'D' and words[4] == '0' and words[5] == '1' and not line.split(' ', 6)[6].startswith('Un'):
        for name in names(int(words[1])):
            numbers.setdefault(name, []).append(int(words[1]))
lines = [f'{name} {min(codes)}' for name, codes in sorted(numbers.items()) if not name.startswith(('unknown', 'not_specified'))]
with open(FILE, 'w', encoding='utf-8') as out:
    out.write(HEADER + '\n'.join(lines) + '\n')
print(len(lines), [f'{name} {codes}' for name, codes in sorted(numbers.items()) if len(codes) > 1])
