// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.solid.HeightsTile;
import org.SEAR.raycast.tree.Bvh;

/**
 * Casts the rays of a picture tile by tile. Walks the hierarchy once for the frustum of a tile, nearer nodes first, and
 * tests each shape inside against the tile's rays. Skips nodes outside the frustum or behind the hits of all rays.
 * Results do not depend on the tiles or the hierarchy. One thread; allocates nothing.
 */
final class PictureCaster {
    /** Tolerance above the rounding errors of node tests, relative and in metres. */
    private static final double SLACK = 1e-9;
    /** Four sides of a tile's frustum and the forward direction; a normal and an offset each. */
    private static final int PLANES = 5;
    private static final int PLANE = 4;
    private static final int AHEAD = 4 * PLANE;
    /** Replaces 1 / 0, so that 0 * LARGEST is 0. */
    private static final double LARGEST = 1e30;

    private final RayCaster rays;
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private final double[] stackNear = new double[Bvh.MAX_DEPTH];
    private final double[] axes = new double[9];
    private final double[] planes = new double[PLANES * PLANE];
    /** Maps (left, up, 1) of a ray to its direction in the frame of a box: 3 x 3 matrix, row by row. */
    private final double[] own = new double[9];
    /** Camera position in the frame of a box, metres. */
    private final double[] place = new double[3];
    /** For each pair of faces of a box: depth at which the last ray has entered the slab. */
    private final double[] mostIns = new double[3];
    private double leastIn;
    private double mostOut;
    /** Depth at which all rays have entered all slabs, and at which the first ray leaves one. */
    private double allIn;
    private double allOut;
    private final HeightsTile ground;
    private final int[] tileStack = new int[Bvh.MAX_DEPTH];
    private final double[] tileNear = new double[Bvh.MAX_DEPTH];
    private final double[] groundPlanes = new double[HeightsTile.PLANES * PLANE];
    /** Width of the tile at one metre ahead, metres. */
    private double wide;
    /** Centre and half size of the tile's bounds at one metre ahead, metres. */
    private double midLeft;
    private double midUp;
    private double halfLeft;
    private double halfUp;
    private PictureBeams beams;
    private Shapes shapes;
    private double ox;
    private double oy;
    private double oz;
    private double start;
    private double range;
    private double[] depth;
    private int[] found;
    private int[] part;
    private int first;
    private int end;
    private int top;
    private int bottom;
    /** First pixel of the result arrays. */
    private int base;
    /** Greatest depth of the tile's rays; the range while any ray has no hit. */
    private double worst;
    /** Whether a ray has hit the last tested shape. */
    private boolean changed;

    PictureCaster(RayCaster rays) {
        this.rays = rays;
        ground = new HeightsTile(rays.heights);
    }

    /** Sets origin and range of the rays, see {@link BeamScene#castPicture}. */
    void begin(Shapes scene, PictureBeams picture, Pose pose, double from, double to, int firstTile) {
        base = picture.top(firstTile) * picture.width;
        shapes = scene;
        beams = picture;
        ox = pose.x;
        oy = pose.y;
        oz = pose.z;
        Rotation.write(pose.qx, pose.qy, pose.qz, pose.qw, axes, 0);
        start = from;
        range = to;
    }

    /** Casts the rays of one tile. */
    void cast(Bvh tree, int tile, int ignored, double[] depths, int[] shapesHit, int[] partsHit) {
        depth = depths;
        found = shapesHit;
        part = partsHit;
        first = beams.first(tile);
        end = beams.end(tile);
        top = beams.top(tile);
        bottom = beams.bottom(tile);
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                depth[i - base] = Double.POSITIVE_INFINITY;
                found[i - base] = -1;
                part[i - base] = -1;
            }
        }
        worst = range;
        pyramid(tile);
        int open = 0;
        if (tree.size() > 0) {
            stackNear[0] = reach(planes, tree.data, 0);
            open = stackNear[0] == Double.POSITIVE_INFINITY ? 0 : 1;
            stack[0] = 0;
        }
        while (open > 0) {
            open--;
            if (stackNear[open] > worst) {
                continue;
            }
            int node = stack[open];
            int count = tree.count(node);
            int link = tree.link(node);
            for (int i = link; i < link + count; i++) {
                if (shapes.isSeen(tree.items[i], ignored)) {
                    shape(tree.items[i]);
                }
            }
            if (count == 0) {
                open = children(tree, link, open);
            }
        }
    }

    private int children(Bvh tree, int left, int open) {
        double nearLeft = reach(planes, tree.data, left * Bvh.STRIDE);
        double nearRight = reach(planes, tree.data, (left + 1) * Bvh.STRIDE);
        boolean leftLast = nearLeft >= nearRight;
        int next = push(open, leftLast ? left : left + 1, leftLast ? nearLeft : nearRight);
        return push(next, leftLast ? left + 1 : left, leftLast ? nearRight : nearLeft);
    }

    private int push(int open, int node, double near) {
        if (near > worst || near == Double.POSITIVE_INFINITY) {
            return open;
        }
        stack[open] = node;
        stackNear[open] = near;
        return open + 1;
    }

    private void pyramid(int tile) {
        int at = PictureBeams.SIDES * tile;
        plane(0, 1, 0, -beams.bounds[at]);
        plane(PLANE, -1, 0, beams.bounds[at + 1]);
        plane(2 * PLANE, 0, 1, -beams.bounds[at + 2]);
        plane(3 * PLANE, 0, -1, beams.bounds[at + 3]);
        plane(AHEAD, 0, 0, 1);
        midLeft = (beams.bounds[at] + beams.bounds[at + 1]) / 2;
        midUp = (beams.bounds[at + 2] + beams.bounds[at + 3]) / 2;
        halfLeft = (beams.bounds[at + 1] - beams.bounds[at]) / 2;
        halfUp = (beams.bounds[at + 3] - beams.bounds[at + 2]) / 2;
        wide = Math.max(beams.bounds[at + 1] - beams.bounds[at], beams.bounds[at + 3] - beams.bounds[at + 2]);
    }

    /** Sets a plane through the origin by its inward normal in the picture's frame. */
    private void plane(int at, double x, double y, double z) {
        double nx = axes[0] * x + axes[1] * y + axes[2] * z;
        double ny = axes[3] * x + axes[4] * y + axes[5] * z;
        double nz = axes[6] * x + axes[7] * y + axes[8] * z;
        planes[at] = nx;
        planes[at + 1] = ny;
        planes[at + 2] = nz;
        planes[at + 3] = -(nx * ox + ny * oy + nz * oz);
    }

    /** Returns a lower bound of a node's depth; infinite outside the frustum. */
    private double reach(double[] p, float[] box, int at) {
        double hx = ((double) box[at + 3] - box[at]) / 2;
        double hy = ((double) box[at + 4] - box[at + 1]) / 2;
        double hz = ((double) box[at + 5] - box[at + 2]) / 2;
        double x = box[at] + hx;
        double y = box[at + 1] + hy;
        double z = box[at + 2] + hz;
        for (int k = 0; k < AHEAD; k += PLANE) {
            double middle = p[k] * x + p[k + 1] * y + p[k + 2] * z + p[k + 3];
            double half = Math.abs(p[k]) * hx + Math.abs(p[k + 1]) * hy + Math.abs(p[k + 2]) * hz;
            if (middle + half < -SLACK * (1 + half + Math.abs(p[k + 3]))) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double middle = p[AHEAD] * x + p[AHEAD + 1] * y + p[AHEAD + 2] * z + p[AHEAD + 3];
        double half = Math.abs(p[AHEAD]) * hx + Math.abs(p[AHEAD + 1]) * hy + Math.abs(p[AHEAD + 2]) * hz;
        double slack = SLACK * (1 + half + Math.abs(p[AHEAD + 3]));
        return middle + half < start - slack ? Double.POSITIVE_INFINITY : middle - half - slack;
    }

    private void shape(int shape) {
        rays.tested++;
        changed = false;
        if (shapes.kind[shape] == Shapes.BOX) {
            box(shape);
        } else if (shapes.kind[shape] == Shapes.HEIGHTS) {
            groundFrame(shape);
            heights(shape, shapes.heights[shape]);
        } else if (shapes.kind[shape] == Shapes.TILES) {
            tiles(shape);
            return;
        } else {
            beams(shape, shapes.kind[shape] == Shapes.MESH);
        }
        narrow();
    }

    /** Updates the greatest depth of the tile's rays. */
    private void narrow() {
        if (!changed) {
            return;
        }
        double farthest = 0;
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                farthest = Math.max(farthest, depth[i - base]);
            }
        }
        worst = Math.min(range, farthest);
    }

    private void beams(int shape, boolean mesh) {
        double sx = ox + start * axes[2];
        double sy = oy + start * axes[5];
        double sz = oz + start * axes[8];
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                double x = beams.left[i];
                double y = beams.up[i];
                double dx = axes[0] * x + axes[1] * y;
                double dy = axes[3] * x + axes[4] * y;
                double dz = axes[6] * x + axes[7] * y;
                double limit = Math.min(range, depth[i - base]) - start;
                double t = start + rays.test(shapes, shape, sx + start * dx, sy + start * dy, sz + start * dz,
                    dx + axes[2], dy + axes[5], dz + axes[8], limit * (1 + SLACK));
                if (t <= range && (t < depth[i - base] || t == depth[i - base] && shape < found[i - base])) {
                    changed = true;
                    depth[i - base] = t;
                    found[i - base] = shape;
                    part[i - base] = mesh ? rays.triangle(shapes.mesh[shape]) : -1;
                }
            }
        }
    }

    /**
     * Casts at tiled elevation: tiles inside the frustum, nearer ones first, until they are behind the hits of all
     * rays.
     */
    private void tiles(int shape) {
        groundFrame(shape);
        Bvh tree = shapes.tileTrees[shape].tree;
        int open = 1;
        tileStack[0] = 0;
        tileNear[0] = reach(groundPlanes, tree.data, 0);
        while (open > 0) {
            open--;
            int node = tileStack[open];
            int link = tree.link(node);
            if (tileNear[open] > worst || tileNear[open] == Double.POSITIVE_INFINITY) {
                continue;
            }
            if (tree.count(node) > 0) {
                changed = false;
                heights(shape, shapes.tiles[shape].tile(tree.items[link]));
                narrow();
                continue;
            }
            double left = reach(groundPlanes, tree.data, link * Bvh.STRIDE);
            double right = reach(groundPlanes, tree.data, (link + 1) * Bvh.STRIDE);
            int further = left >= right ? 0 : 1;
            tileStack[open] = link + further;
            tileNear[open++] = Math.max(left, right);
            tileStack[open] = link + 1 - further;
            tileNear[open++] = Math.min(left, right);
        }
    }

    /** Transforms the frustum into the frame of the ground. */
    private void groundFrame(int shape) {
        double[] m = shapes.data;
        int at = shape * Shapes.STRIDE;
        for (int k = 0; k < groundPlanes.length; k += PLANE) {
            for (int axis = 0; axis < 3; axis++) {
                groundPlanes[k + axis] = m[at + axis] * planes[k] + m[at + 3 + axis] * planes[k + 1]
                    + m[at + 6 + axis] * planes[k + 2];
            }
            groundPlanes[k + 3] = planes[k + 3] + planes[k] * m[at + 9] + planes[k + 1] * m[at + 10]
                + planes[k + 2] * m[at + 11];
        }
    }

    /** Casts at elevation whose blocks are walked for all rays together. */
    private void heights(int shape, HeightField field) {
        double[] m = shapes.data;
        int at = shape * Shapes.STRIDE;
        ground.begin(field, groundPlanes, wide, start);
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                double x = beams.left[i];
                double y = beams.up[i];
                double ax = axes[0] * x + axes[1] * y;
                double ay = axes[3] * x + axes[4] * y;
                double az = axes[6] * x + axes[7] * y;
                double wx = ox + start * axes[2] + start * ax - m[at + 9];
                double wy = oy + start * axes[5] + start * ay - m[at + 10];
                double wz = oz + start * axes[8] + start * az - m[at + 11];
                double dx = ax + axes[2];
                double dy = ay + axes[5];
                double dz = az + axes[8];
                ground.add(m[at] * wx + m[at + 3] * wy + m[at + 6] * wz, m[at + 1] * wx + m[at + 4] * wy
                    + m[at + 7] * wz,
                    m[at + 2] * wx + m[at + 5] * wy + m[at + 8] * wz, m[at] * dx + m[at + 3] * dy + m[at + 6] * dz,
                    m[at + 1] * dx + m[at + 4] * dy + m[at + 7] * dz, m[at + 2] * dx + m[at + 5] * dy + m[at + 8] * dz,
                    (Math.min(range, depth[i - base]) - start) * (1 + SLACK));
            }
        }
        long before = rays.heights.triangles;
        ground.cast();
        rays.triangles += rays.heights.triangles - before;
        int beam = 0;
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                take(i - base, start + ground.distance(beam++), shape);
            }
        }
    }

    private void take(int pixel, double t, int shape) {
        if (t <= range && (t < depth[pixel] || t == depth[pixel] && shape < found[pixel])) {
            changed = true;
            depth[pixel] = t;
            found[pixel] = shape;
            part[pixel] = -1;
        }
    }

    /**
     * Casts at a box. Boxes are the most frequent shapes of rooms: all rays share an origin and their directions are
     * linear in left and up.
     */
    private void box(int shape) {
        double[] m = shapes.data;
        int at = shape * Shapes.STRIDE;
        double wx = ox - m[at + 9];
        double wy = oy - m[at + 10];
        double wz = oz - m[at + 11];
        allIn = Double.NEGATIVE_INFINITY;
        allOut = Double.POSITIVE_INFINITY;
        double firstIn = Double.NEGATIVE_INFINITY;
        double lastOut = Double.POSITIVE_INFINITY;
        int side = -1;
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++) {
                own[3 * k + axis] = m[at + k] * axes[axis] + m[at + 3 + k] * axes[3 + axis]
                    + m[at + 6 + k] * axes[6 + axis];
            }
            place[k] = m[at + k] * wx + m[at + 3 + k] * wy + m[at + 6 + k] * wz;
            slab(k, m[at + 12 + k]);
            if (leastIn > firstIn) {
                firstIn = leastIn;
                side = k;
            }
            lastOut = Math.min(lastOut, mostOut);
        }
        if (firstIn > lastOut + SLACK * (1 + Math.abs(lastOut)) || lastOut < start - SLACK * (1 + start)) {
            return;
        }
        boolean through = firstIn > start + SLACK * (1 + start) && allIn + SLACK * (1 + Math.abs(allIn)) < allOut;
        for (int k = 0; k < 3 && through; k++) {
            through = k == side || firstIn > mostIns[k] + SLACK * (1 + Math.abs(mostIns[k]));
        }
        rays.boxes++;
        if (through) {
            side(shape, side, m[at + 12 + side]);
        } else {
            rays.asked++;
            sides(shape, m[at + 12], m[at + 13], m[at + 14]);
        }
    }

    /**
     * Bounds the depths at which the tile's rays enter and leave the slab between two opposite faces of a box.
     * @param k axis, for which the matrix row and the origin are set
     */
    private void slab(int k, double half) {
        double middle = own[3 * k] * midLeft + own[3 * k + 1] * midUp + own[3 * k + 2];
        double apart = (Math.abs(own[3 * k]) * halfLeft + Math.abs(own[3 * k + 1]) * halfUp) * (1 + SLACK) + SLACK;
        double from = place[k];
        double most = Math.abs(middle) + apart;
        double least = Math.abs(middle) - apart;
        double mostIn;
        double leastOut;
        if (least > 0) {
            // from the slab's face on the origin's side, in units of the direction
            double near = -half - Math.copySign(1, middle) * from;
            double far = half - Math.copySign(1, middle) * from;
            leastIn = near > 0 ? near / most : near / least;
            mostIn = near > 0 ? near / least : near / most;
            leastOut = far > 0 ? far / most : far / least;
            mostOut = far > 0 ? far / least : far / most;
        } else {
            boolean inside = Math.abs(from) < half;
            leastIn = Double.NEGATIVE_INFINITY;
            mostOut = Double.POSITIVE_INFINITY;
            mostIn = inside ? (Math.abs(from) - half) / most : Double.POSITIVE_INFINITY;
            leastOut = inside ? (half - Math.abs(from)) / most : Double.NEGATIVE_INFINITY;
        }
        mostIns[k] = mostIn;
        allIn = Math.max(allIn, mostIn);
        allOut = Math.min(allOut, leastOut);
    }

    /** Casts at a box that all rays enter through one face. */
    private void side(int shape, int k, double half) {
        double x1 = own[3 * k];
        double y1 = own[3 * k + 1];
        double z1 = own[3 * k + 2];
        double to = (x1 * midLeft + y1 * midUp + z1 < 0 ? half : -half) - place[k];
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                double t = to * (1 / (x1 * beams.left[i] + y1 * beams.up[i] + z1));
                if (t <= range && (t < depth[i - base] || t == depth[i - base] && shape < found[i - base])) {
                    changed = true;
                    depth[i - base] = t;
                    found[i - base] = shape;
                    part[i - base] = -1;
                }
            }
        }
    }

    private void sides(int shape, double a, double b, double c) {
        double px = place[0];
        double py = place[1];
        double pz = place[2];
        double xx = own[0];
        double xy = own[1];
        double xz = own[2];
        double yx = own[3];
        double yy = own[4];
        double yz = own[5];
        double zx = own[6];
        double zy = own[7];
        double zz = own[8];
        for (int row = top; row < bottom; row++) {
            for (int i = row * beams.width + first; i < row * beams.width + end; i++) {
                double x = beams.left[i];
                double y = beams.up[i];
                double ix = inverse(xx * x + xy * y + xz);
                double iy = inverse(yx * x + yy * y + yz);
                double iz = inverse(zx * x + zy * y + zz);
                double nearX = ix < 0 ? a : -a;
                double nearY = iy < 0 ? b : -b;
                double nearZ = iz < 0 ? c : -c;
                double in = Math.max((nearX - px) * ix, Math.max((nearY - py) * iy, (nearZ - pz) * iz));
                double out = Math.min((-nearX - px) * ix, Math.min((-nearY - py) * iy, (-nearZ - pz) * iz));
                double t = in >= start ? in : out;
                if (in <= out && out >= start && t <= range
                    && (t < depth[i - base] || t == depth[i - base] && shape < found[i - base])) {
                    changed = true;
                    depth[i - base] = t;
                    found[i - base] = shape;
                    part[i - base] = -1;
                }
            }
        }
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }
}
