"""Writes elevation maps in many encodings and projections with GDAL, and GDAL's reading of each.

make_maps.py LIBRARIES FOLDER SEED
NAME.ENDING is the map. NAME.posts has its elevation as big-endian float32, row by row, NaN without data. NAME.places has
lines of latitude, longitude and elevation, bilinear between pixel centres.
"""
import sys

LIBRARIES, FOLDER, SEED = sys.argv[1], sys.argv[2], int(sys.argv[3])
sys.path.insert(0, LIBRARIES)

import numpy
import rasterio
import rasterio.shutil
from rasterio.transform import Affine
from rasterio.warp import transform

PLACES = 40
random = numpy.random.default_rng(SEED)


def hills(rows, columns, low, high):
    y, x = numpy.mgrid[0:rows, 0:columns]
    shape = numpy.sin(x / 9.0) * numpy.cos(y / 7.0) + 0.5 * numpy.sin((x + 2 * y) / 5.0) + 0.05 * random.standard_normal((rows, columns))
    shape = (shape - shape.min()) / (shape.max() - shape.min())
    return low + (high - low) * shape


def bilinear(posts, column, row):
    left, top = int(numpy.floor(column)), int(numpy.floor(row))
    u, v = column - left, row - top
    upper = posts[top, left] * (1 - u) + posts[top, left + 1] * u
    lower = posts[top + 1, left] * (1 - u) + posts[top + 1, left + 1] * u
    return upper * (1 - v) + lower * v


def tell(path, name):
    with rasterio.open(path) as source:
        posts = source.read(1).astype('float64')
        posts[source.read_masks(1) == 0] = numpy.nan
        posts.astype('>f4').tofile(f'{FOLDER}/{name}.posts')
        with open(f'{FOLDER}/{name}.places', 'w') as out:
            for _ in range(PLACES):
                column, row = random.uniform(0, source.width - 1.001), random.uniform(0, source.height - 1.001)
                x, y = source.transform * (column + 0.5, row + 0.5)
                (longitude,), (latitude,) = transform(source.crs, 'EPSG:4326', [x], [y])
                height = bilinear(posts, column, row)
                if not numpy.isnan(height):
                    out.write(f'{latitude!r} {longitude!r} {float(height)!r}\n')


def write(name, dtype, low=100, high=2500, crs='EPSG:4326', affine=None, rows=67, columns=91, hole=None, point=False, **options):
    posts = hills(rows, columns, low, high)
    posts = (posts if dtype.startswith('float') else numpy.rint(posts)).astype(dtype)
    if hole is not None:
        posts[20:25, 30:41] = hole
    affine = affine or Affine(1 / 1200, 0, 7.9, 0, -1 / 1200, 46.6)
    path = f'{FOLDER}/{name}.tif'
    with rasterio.open(path, 'w', driver='GTiff', height=rows, width=columns, count=1, dtype=dtype, crs=crs, transform=affine, nodata=hole,
                       **options) as out:
        if point:
            out.update_tags(AREA_OR_POINT='Point')
        out.write(posts, 1)
    tell(path, name)
    return path


TILES = dict(tiled=True, blockxsize=32, blockysize=16)
plain = write('plain', 'int16')
write('point', 'int16', point=True)
write('lzw2_big_endian', 'int16', compress='lzw', predictor=2, endianness='big')
write('deflate2_tiles', 'uint16', high=60000 / 2, compress='deflate', predictor=2, **TILES)
write('packbits', 'uint8', low=0, high=255, compress='packbits')
write('signed_bytes', 'int8', low=-100, high=100, compress='lzw', predictor=2)
write('lzw_int32', 'int32', compress='lzw', predictor=2, **TILES)
write('bigtiff_uint32', 'uint32', compress='deflate', predictor=2, BIGTIFF='YES', endianness='big')
write('float3_tiles', 'float32', compress='deflate', predictor=3, **TILES)
write('float3_lzw_big_endian', 'float32', compress='lzw', predictor=3, endianness='big', blockysize=5)
write('float2', 'float32', compress='deflate', predictor=2)
write('double3', 'float64', compress='deflate', predictor=3, endianness='big', **TILES)
write('double_bigtiff', 'float64', compress='lzw', BIGTIFF='YES')
write('bigtiff_tiles', 'int16', BIGTIFF='YES', **TILES)
write('one_strip', 'float32', blockysize=67, compress='lzw')
write('holes', 'float32', hole=-9999, compress='deflate', predictor=3)
write('holes_nan', 'float64', hole=float('nan'))
write('holes_lowest', 'float32', hole=-3.4028234663852886e+38)
write('sparse', 'int16', SPARSE_OK=True, hole=-32768, **TILES)

write('utm', 'float32', crs='EPSG:32632', affine=Affine(30, 0, 447000, 0, -30, 5161000))
write('utm_turned', 'float32', crs='EPSG:32632', affine=Affine.translation(447000, 5161000) * Affine.rotation(17) * Affine.scale(30, -25))
write('utm_sheared', 'float32', crs='EPSG:32632', affine=Affine(30, 7, 447000, -4, -25, 5161000))
write('paris_grads', 'int16', crs='EPSG:4807', affine=Affine(0.001, 0, 3, 0, -0.001, 50))
write('utm_south', 'int16', crs='EPSG:32719', affine=Affine(90, 0, 400000, 0, -90, 6500000))
write('laea_europe', 'float32', crs='EPSG:3035', affine=Affine(25, 0, 4150000, 0, -25, 2600000))
write('lambert_france', 'float32', crs='EPSG:2154', affine=Affine(25, 0, 960000, 0, -25, 6520000))
write('polar', 'float32', crs='EPSG:3413', affine=Affine(100, 0, -300000, 0, -100, -2200000))
write('albers_usa', 'int16', crs='EPSG:5070', affine=Affine(30, 0, 1000000, 0, -30, 1500000))
write('web_mercator', 'float32', crs='EPSG:3857', affine=Affine(40, 0, 880000, 0, -40, 5880000))
for name, proj in dict(
        own_albers='+proj=aea +lat_0=23 +lon_0=-95 +lat_1=29 +lat_2=46 +x_0=1000 +y_0=0 +datum=NAD83 +units=m',
        own_mercator='+proj=tmerc +lat_0=10 +lon_0=-94 +k_0=0.9997 +x_0=300000 +y_0=-1000 +datum=WGS84 +units=m',
        own_lambert='+proj=lcc +lat_0=30 +lon_0=-97 +lat_1=33 +lat_2=45 +x_0=0 +y_0=5000 +ellps=GRS80 +units=us-ft',
        own_equal_area='+proj=laea +lat_0=45 +lon_0=-100 +x_0=10 +y_0=20 +datum=WGS84 +units=m').items():
    (west,), (north,) = transform('EPSG:4326', proj, [-96.0], [40.0])
    write(name, 'float32', crs=proj, affine=Affine(90, 0, west, 0, -90, north))
write('south_up', 'int16', affine=Affine(1 / 1200, 0, 7.9, 0, 1 / 1200, 46.5))

rasterio.shutil.copy(plain, f'{FOLDER}/esri.asc', driver='AAIGrid')
tell(f'{FOLDER}/esri.asc', 'esri')

side = 1201
srtm = write('srtm_source', 'int16', rows=side, columns=side, hole=-32768, affine=Affine(1 / 1200, 0, -71 - 1 / 2400, 0, -1 / 1200, -32 + 1 / 2400),
             compress='deflate')
rasterio.shutil.copy(srtm, f'{FOLDER}/S33W071.hgt', driver='SRTMHGT')
tell(f'{FOLDER}/S33W071.hgt', 'S33W071')
