"""Writes places in coordinate systems of the EPSG register, with PROJ's latitudes and longitudes of WGS 84.

write_places.py LIBRARIES FILE SYSTEMS SEED
Each line has the EPSG number, x, y, latitude and longitude; after a tab the system as well-known text of ESRI without numbers, if PROJ's
datum shift is certain within 5 m. SYSTEMS is the number of systems, chosen at random. Places are inside
a system's area of use, and inside the area of the datum shift that PROJ uses there.
"""
import sys

LIBRARIES, FILE, SYSTEMS, SEED = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
sys.path.insert(0, LIBRARIES)

import math
import random
import re
import warnings

import pyproj
from pyproj.database import query_crs_info
from pyproj.enums import PJType
from pyproj.exceptions import CRSError, ProjError

warnings.filterwarnings('ignore')
PLACES, TRIES = 3, 30


def inside(bounds, longitude, latitude):
    west, south, east, north = bounds
    return south <= latitude <= north and (longitude - west) % 360 <= (east - west) % 360 or east - west == 360


def places(code):
    crs = pyproj.CRS.from_epsg(code)
    west, south, east, north = crs.area_of_use.bounds
    east += 360 * (east < west)
    base = crs.geodetic_crs
    unit = math.degrees(base.axis_info[0].unit_conversion_factor)
    meridian = base.prime_meridian
    greenwich = meridian.longitude * math.degrees(meridian.unit_conversion_factor)
    project = pyproj.Transformer.from_crs(base, crs, always_xy=True).transform if crs.is_projected else lambda x, y: (x, y)
    earth = pyproj.Transformer.from_crs(crs, 'EPSG:4326', always_xy=True)
    found = 0
    for _ in range(TRIES):
        longitude, latitude = west + (east - west) * random.uniform(0.1, 0.9), south + (north - south) * random.uniform(0.1, 0.9)
        longitude -= 360 * (longitude > 180)
        x, y = project((longitude - greenwich) / unit, latitude / unit)
        there = earth.transform(x, y)
        if not all(map(math.isfinite, (x, y, *there))):
            continue
        try:
            used = earth.get_last_used_operation()
            area, certain = used.area_of_use, 0 <= used.accuracy <= 5
        except ProjError:
            area, certain = None, False
        if found < PLACES and (area is None or inside(area.bounds, longitude, latitude)):
            found += 1
            text = re.sub(r',AUTHORITY\[[^]]*\]', '', crs.to_wkt('WKT1_ESRI') or '') if certain else ''
            yield f'{code} {x!r} {y!r} {there[1]!r} {there[0]!r}' + ('\t' + re.sub(r'\s*\n\s*', '', text) if text else '') + '\n'


def main():
    random.seed(SEED)
    codes = sorted({int(i.code) for kind in (PJType.GEOGRAPHIC_2D_CRS, PJType.PROJECTED_CRS) for i in query_crs_info('EPSG', kind,
                                                                                                        allow_deprecated=True)})
    random.shuffle(codes)
    done = 0
    with open(FILE, 'w') as out:
        for code in codes:
            try:
                lines = list(places(code))
            except (CRSError, ProjError):       # PROJ lacks a few of the register's methods
                continue
            out.writelines(lines)
            done += bool(lines)
            if done == SYSTEMS:
                break


main()
