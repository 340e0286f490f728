"""Writes resources/org/SEAR/terrain/systems.txt: the coordinate systems of the EPSG register that SEAR reads, with datum shifts to WGS 84.

write_systems.py LIBRARIES FILE
Source: the EPSG database in pyproj's PROJ. The header of the written file explains its lines.
"""
import re
import sys

LIBRARIES, FILE = sys.argv[1], sys.argv[2]
sys.path.insert(0, LIBRARIES)

import math
import warnings

import numpy
import pyproj
from pyproj.database import query_crs_info
from pyproj.enums import PJType
from pyproj.exceptions import CRSError, ProjError
from pyproj.transformer import Transformer, TransformerGroup

warnings.filterwarnings('ignore')

# Largest uncertainty of a datum shift, metres, as the EPSG database states it.
MAX_UNCERTAINTY = 5
# Reference frames without a published shift that are WGS 84 within two metres by their definition.
LIKE_WGS84 = re.compile(r'ITRF|IGS\d|IGb|SIRGAS-|NAD83\(|China Geodetic Coordinate System 2000|ETRS89|LKS-2020|REDGEOMIN|.*-IRF$')
# Largest difference between a pipeline of PROJ and its seven parameters, metres.
TOLERANCE = 0.1
# Methods that SEAR's projections compute as PROJ does.
METHODS = {'tmerc', 'utm', 'lcc', 'aea', 'cass', 'stere', 'sterea', 'omerc', 'somerc', 'laea', 'merc', 'krovak', 'eqc', 'cea', 'nzmg'}
DROPPED = {'no_defs': 0, 'type': 0, 'datum': 0, 'ellps': 0, 'rf': 0, 'pm': 0, 'towgs84': 0, 'wktext': 0}
DEFAULTS = {'units=m', 'k=1', 'k_0=1', 'lat_0=0', 'lon_0=0', 'x_0=0', 'y_0=0'}
HEADER = f"""# Coordinate systems of the EPSG register that SEAR reads, with datum shifts to WGS 84. Written by src/test/pyproj/write_systems.py
# from the EPSG database {{version}} in PROJ {pyproj.__proj_version__}. EPSG database: https://epsg.org, under its terms of use.
# D number semi-major axis, m; inverse flattening (0: sphere); prime meridian, degrees; unit of angles, degrees; name of a geographic
#   system, followed by:
# S west south east north uncertainty, m; shift by x y z, m; rotations, arc seconds (position vector); scale difference, ppm
# G latitudes and longitudes are those of WGS 84
# N no shift within {MAX_UNCERTAINTY} m: uncertainty of the best one without grid files, m; 0 without any
# P number of a projected system on this geographic system, PROJ parameters
# X the same for a projection that SEAR lacks, its method
"""


def number(value, digits=15):
    text = f'{value:.{digits}g}'
    return text


def helmert(words):
    """Returns matrix and vector of a step of a pipeline, from its parameters."""
    p = {key: float(words.get(key, 0)) for key in ('x', 'y', 'z', 'rx', 'ry', 'rz', 's', 'px', 'py', 'pz')}
    sign = -1 if words.get('convention') == 'coordinate_frame' else 1
    rx, ry, rz = (sign * math.radians(p[key] / 3600) for key in ('rx', 'ry', 'rz'))
    matrix = (1 + p['s'] * 1e-6) * numpy.array([[1, -rz, ry], [rz, 1, -rx], [-ry, rx, 1]])
    pivot = numpy.array([p['px'], p['py'], p['pz']])
    return matrix, numpy.array([p['x'], p['y'], p['z']]) + pivot - matrix @ pivot


def seven(definition):
    """Returns the seven parameters of a pipeline in the position vector convention, or None."""
    matrix, vector = numpy.eye(3), numpy.zeros(3)
    for step in re.split(r'\bstep\b', definition):
        words = dict(word.split('=', 1) if '=' in word else (word, '') for word in step.split())
        kind = words.get('proj')
        if kind in ('helmert', 'molobadekas'):
            m, v = helmert(words)
            if 'inv' in words:
                m = numpy.linalg.inv(m)
                v = -m @ v
            matrix, vector = m @ matrix, m @ vector + v
        elif kind not in (None, 'pipeline', 'unitconvert', 'push', 'pop', 'cart', 'noop', 'longlat', 'axisswap'):
            return None
    scale = numpy.trace(matrix) / 3
    r = (matrix - matrix.T) / 2 / scale
    seconds = [math.degrees(angle) * 3600 for angle in (r[2, 1], r[0, 2], r[1, 0])]
    return [*vector, *seconds, (scale - 1) * 1e6]


def parts(base):
    """Yields definition, uncertainty in metres and area of PROJ's transformations of a geographic system to WGS 84."""
    try:
        group = TransformerGroup(base, 'EPSG:4326', always_xy=True, allow_ballpark=False)
        found = [(t.definition, t.accuracy, t.area_of_use, t.description) for t in group.transformers]
    except IndexError:      # pyproj fails on the empty list of some systems' steps
        found = []
    if not found:           # PROJ looks for intermediate systems only here
        single = Transformer.from_crs(base, 'EPSG:4326', always_xy=True)
        west, south, east, north = base.area_of_use.bounds
        for share in (0.5, 0.3, 0.7):
            single.transform(west + share * (east - west), south + share * (north - south))
            try:
                used = single.get_last_used_operation()
            except ProjError:
                continue
            found.append((used.definition, used.accuracy, used.area_of_use or base.area_of_use, used.description))
    for definition, accuracy, area, description in found:
        at_sea = area is None or '- offshore' in area.name and 'onshore' not in area.name      # as PROJ avoids them
        if accuracy >= 0 and not at_sea and 'Ballpark' not in description:
            yield definition, accuracy, area


def error(base, definition, area, parameters):
    """Returns the largest difference of the seven parameters to a pipeline in an area, metres."""
    unit = math.degrees(base.axis_info[0].unit_conversion_factor)
    greenwich = base.prime_meridian.longitude * math.degrees(base.prime_meridian.unit_conversion_factor)
    seven_ = ' '.join(f'+{key}={value}' for key, value in zip(('x', 'y', 'z', 'rx', 'ry', 'rz', 's'), parameters))
    own = Transformer.from_pipeline('+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=cart '
        f'+a={base.ellipsoid.semi_major_metre} +b={base.ellipsoid.semi_minor_metre} +step +proj=helmert {seven_} +convention=position_vector '
        '+step +inv +proj=cart +ellps=WGS84 +step +proj=unitconvert +xy_in=rad +xy_out=deg')
    pipeline = Transformer.from_pipeline(definition)
    west, south, east, north = area.bounds
    east += 360 * (east < west)
    worst = 0
    for i in range(9):
        longitude, latitude = west + (east - west) * (1 + i % 3) / 4, south + (north - south) * (1 + i // 3) / 4
        longitude -= 360 * (longitude > 180)
        a = pipeline.transform((longitude - greenwich) / unit, latitude / unit)
        b = own.transform(longitude, latitude, 0)
        worst = max(worst, 111320 * math.hypot(a[1] - b[1], ((a[0] - b[0] + 180) % 360 - 180) * math.cos(math.radians(latitude))))
    return worst


def shifts(base):
    """Returns lines with area, uncertainty and seven parameters of a geographic system, and the best uncertainty, m."""
    best, lines = 0, []
    for definition, accuracy, area in parts(base):
        best = accuracy if best == 0 else min(best, accuracy)
        parameters = seven(definition)
        if parameters is not None and accuracy <= MAX_UNCERTAINTY and error(base, definition, area, parameters) < TOLERANCE:
            line = ' '.join(number(value, 7) for value in area.bounds) + f' {number(accuracy)} ' + ' '.join(number(v, 9) for v in parameters)
            if line not in lines:
                lines.append(line)
    return lines, best


def projection(crs):
    """Returns the PROJ parameters of a projected system without its datum, or None."""
    try:
        words = [word.lstrip('+') for word in crs.to_proj4().split()]
    except CRSError:
        return None
    if words[0].split('=')[1] not in METHODS or '+R_A' in crs.to_proj4() or crs.coordinate_operation.method_name.startswith(('Hyperbolic', 'Modified', 'Guam')):
        return None
    kept = [word for word in words[1:] if word.split('=')[0] not in DROPPED and word not in DEFAULTS]
    kept = ['to_meter=0.201168' if word == 'units=link' else word for word in kept]       # a unit that Proj4J lacks
    ellipsoid = crs.geodetic_crs.ellipsoid
    if f'b={number(ellipsoid.semi_minor_metre)}' in kept or any(word.startswith('a=') for word in kept) and 'nadgrids=@null' not in kept:
        kept = [word for word in kept if word[:2] not in ('a=', 'b=')]
    if any(word.startswith('R=') for word in kept) and ellipsoid.inverse_flattening == 0:
        kept = [word for word in kept if word[:2] != 'R=']
    method = words[0].split('=')[1]
    given = dict(word.split('=') for word in kept if '=' in word)
    if method == 'merc' and 'lat_ts' in given:      # Proj4J ignores lat_ts
        latitude = math.radians(float(given['lat_ts']))
        e2 = 1 - (ellipsoid.semi_minor_metre / ellipsoid.semi_major_metre) ** 2
        kept = [word for word in kept if not word.startswith('lat_ts=')]
        kept.append(f'k_0={number(math.cos(latitude) / math.sqrt(1 - e2 * math.sin(latitude) ** 2))}')
    if method == 'omerc' and 'no_uoff' not in kept and given['alpha'] != given['gamma']:     # Proj4J is kilometres off
        return None
    if method == 'stere' and 'lat_ts' not in given:
        kept.append(f'lat_ts={given["lat_0"]}')
    return ' '.join([method, *kept])


def is_like_wgs84(base):
    return LIKE_WGS84.match(base.name) and not base.is_deprecated and base.ellipsoid.name in ('GRS 1980', 'CGCS2000')


def main():
    codes = {kind: sorted({int(i.code) for i in query_crs_info('EPSG', kind, allow_deprecated=True)})
             for kind in (PJType.GEOGRAPHIC_2D_CRS, PJType.PROJECTED_CRS)}
    projected = {}
    for code in codes[PJType.PROJECTED_CRS]:
        crs = pyproj.CRS.from_epsg(code)
        if len(crs.axis_info) > 2:
            continue
        projected.setdefault(crs.geodetic_crs.to_epsg(min_confidence=100), []).append((code, crs))
    with open(FILE, 'w', encoding='utf-8', newline='\n') as out:
        version = pyproj.database.get_database_metadata('EPSG.VERSION')
        out.write(HEADER.format(version=version))
        for code in codes[PJType.GEOGRAPHIC_2D_CRS]:
            base = pyproj.CRS.from_epsg(code)
            ellipsoid, meridian = base.ellipsoid, base.prime_meridian
            angle = math.degrees(base.axis_info[0].unit_conversion_factor)
            greenwich = meridian.longitude * math.degrees(meridian.unit_conversion_factor)
            out.write(f'D {code} {number(ellipsoid.semi_major_metre)} {number(ellipsoid.inverse_flattening)} {number(greenwich, 12)} '
                      f'{number(angle, 12)} {base.name}\n')
            lines, best = shifts(base)
            if ellipsoid.inverse_flattening == 0:
                out.write('G\n')
            elif code == 4326 or is_like_wgs84(base) and not lines:
                out.write('S -180 -90 180 90 2 0 0 0 0 0 0 0\n')
            elif lines:
                out.writelines(f'S {line}\n' for line in lines)
            else:
                out.write(f'N {number(best)}\n')
            for number_, crs in projected.pop(code, []):
                text = projection(crs)
                out.write(f'P {number_} {text}\n' if text else f'X {number_} {crs.coordinate_operation.method_name}\n')
    assert not projected, projected


main()
