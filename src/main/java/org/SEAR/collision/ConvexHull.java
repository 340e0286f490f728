// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.VolumeIntegrals;

/**
 * Convex hull of points (quickhull, Barber, Dobkin and Huhdanpaa 1996). No point is outside by more than
 * {@link #TOLERANCE}, unless the hull would exceed the limit of corners. Coplanar points get a hull 0.5 to 1 mm thick.
 * Immutable.
 */
public final class ConvexHull implements ConvexShape {
    /** Largest distance of a point outside the hull, metres. */
    static final double TOLERANCE = 1e-4;
    /** Largest number of corners, which bounds the cost of contacts; a larger hull is approximated. */
    private static final int MAX_CORNERS = 1000;
    /** Half of the thickness of a flat hull, metres. */
    private static final double CARD = 2.5e-4;
    private static final double NOTHING = 1e-12;
    /** Largest shrinkage of the core. */
    private static final double DRAWN = 0.1;

    /** x, y, z of each corner, metres. */
    private final double[] corners;
    /** Outward normal and distance from the origin of each face's plane. */
    private final double[] planes;
    /** Corners in each face's plane, in order around it. */
    private final int[][] polygons;
    private final double volume;
    private final double least;
    private final double radius;
    /** Shrinkage of the core towards the centre. */
    private final double drawn;
    private final double[] centre;
    private final InertiaTensor inertia;

    private ConvexHull(double[] points, List<Face> faces) {
        Set<Integer> used = new LinkedHashSet<>();
        faces.forEach(face -> {
            used.add(face.a);
            used.add(face.b);
            used.add(face.c);
        });
        corners = new double[3 * used.size()];
        int next = 0;
        for (int point : used) {
            System.arraycopy(points, 3 * point, corners, next, 3);
            next += 3;
        }
        planes = new double[4 * faces.size()];
        polygons = new int[faces.size()][];
        for (int i = 0; i < polygons.length; i++) {
            Face face = faces.get(i);
            System.arraycopy(new double[] {face.nx, face.ny, face.nz, face.offset}, 0, planes, 4 * i, 4);
            polygons[i] = polygon(face);
        }
        VolumeIntegrals integrals = weigh(points, faces);
        volume = integrals.volume();
        centre = integrals.centre();
        inertia = integrals.inertia();
        least = thinnest();
        radius = farthest();
        drawn = Math.min(DRAWN, ConvexRadius.of(Double.POSITIVE_INFINITY) / radius);
    }

    private static VolumeIntegrals weigh(double[] p, List<Face> faces) {
        int first = 3 * faces.get(0).a;
        VolumeIntegrals sum = new VolumeIntegrals(p[first], p[first + 1], p[first + 2]);
        for (Face face : faces) {
            sum.add(p, 3 * face.a, 3 * face.b, 3 * face.c);
        }
        return sum;
    }

    private static double square(double value) {
        return value * value;
    }

    @Override
    public InertiaTensor inertia() {
        return inertia;
    }

    @Override
    public double radius() {
        return radius;
    }

    private double farthest() {
        double most = 0;
        for (int i = 0; i < corners.length; i += 3) {
            most = Math.max(most, square(corners[i]) + square(corners[i + 1]) + square(corners[i + 2]));
        }
        return Math.sqrt(most);
    }

    /** Half of the smallest extent between a face and the opposite corners. */
    @Override
    public double least() {
        return least;
    }

    private double thinnest() {
        double thinnest = Double.POSITIVE_INFINITY;
        double[] at = new double[3];
        for (int i = 0; i < planes.length; i += 4) {
            support(-planes[i], -planes[i + 1], -planes[i + 2], at);
            thinnest = Math.min(thinnest, planes[i + 3] - planes[i] * at[0] - planes[i + 1] * at[1]
                - planes[i + 2] * at[2]);
        }
        return thinnest / 2;
    }

    @Override
    public double volume() {
        return volume;
    }

    @Override
    public double[] centre() {
        return centre.clone();
    }

    /** Returns x, y, z of each corner, metres. */
    double[] corners() {
        return corners.clone();
    }

    /**
     * Clips a line along x to the hull.
     * @param range least and greatest x, metres; the least is above the greatest if no point is inside
     * @param near distance outside a face that counts as inside, metres
     */
    void clip(double y, double z, double near, double[] range) {
        for (int i = 0; i < planes.length; i += 4) {
            double room = planes[i + 3] + near - planes[i + 1] * y - planes[i + 2] * z;
            if (Math.abs(planes[i]) < NOTHING) {
                range[0] = room < 0 ? Double.POSITIVE_INFINITY : range[0];
            } else if (planes[i] > 0) {
                range[1] = Math.min(range[1], room / planes[i]);
            } else {
                range[0] = Math.max(range[0], room / planes[i]);
            }
        }
    }

    private static final class Face {
        final int a;
        final int b;
        final int c;
        final double nx;
        final double ny;
        final double nz;
        final double offset;
        final List<Integer> outside = new ArrayList<>();
        int farthest = -1;
        double most = TOLERANCE;

        Face(double[] p, int a, int b, int c) {
            this.a = a;
            this.b = b;
            this.c = c;
            double[] n = cross(p, a, b, c);
            double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            double scale = length > 0 ? 1 / length : 0;
            nx = n[0] * scale;
            ny = n[1] * scale;
            nz = n[2] * scale;
            offset = nx * p[3 * a] + ny * p[3 * a + 1] + nz * p[3 * a + 2];
        }

        double height(double[] p, int i) {
            return nx * p[3 * i] + ny * p[3 * i + 1] + nz * p[3 * i + 2] - offset;
        }

        /** Takes a point outside this face. */
        boolean take(double[] p, int i) {
            double height = height(p, i);
            if (height <= TOLERANCE) {
                return false;
            }
            outside.add(i);
            if (height > most) {
                most = height;
                farthest = i;
            }
            return true;
        }
    }

    /** @param points x, y, z of each, metres; at least one */
    public static ConvexHull of(double[] points) {
        return of(points, MAX_CORNERS);
    }

    /** @param most largest number of corners; those furthest out come first */
    static ConvexHull of(double[] points, int most) {
        int[] start = start(points);
        if (start == null) {
            return of(thickened(points), most);
        }
        return new ConvexHull(points, grow(points, most, start));
    }

    /** Replaces each point by six points around it. */
    private static double[] thickened(double[] points) {
        double[] thick = new double[points.length * 6];
        for (int i = 0; i < points.length / 3; i++) {
            for (int k = 0; k < 6; k++) {
                System.arraycopy(points, 3 * i, thick, 3 * (6 * i + k), 3);
                thick[3 * (6 * i + k) + k / 2] += k % 2 == 0 ? CARD : -CARD;
            }
        }
        return thick;
    }

    /** Returns four points far apart, the first three counter-clockwise seen from outside; null if all are coplanar. */
    private static int[] start(double[] p) {
        int[] four = new int[4];
        for (int found = 1; found < 4; found++) {
            double most = NOTHING;
            for (int i = 0; i < p.length / 3; i++) {
                double room = room(p, four, found, i);
                if (room > most) {
                    most = room;
                    four[found] = i;
                }
            }
            if (most == NOTHING) {
                return null;
            }
        }
        Face base = new Face(p, four[0], four[1], four[2]);
        if (Math.abs(base.height(p, four[3])) < 2 * CARD) {
            return null;
        }
        if (base.height(p, four[3]) > 0) {
            int other = four[1];
            four[1] = four[2];
            four[2] = other;
        }
        return four;
    }

    /** Returns the gain by a point: a squared length, a squared area, or a volume. */
    private static double room(double[] p, int[] four, int found, int i) {
        int a = four[0];
        double x = p[3 * i] - p[3 * a];
        double y = p[3 * i + 1] - p[3 * a + 1];
        double z = p[3 * i + 2] - p[3 * a + 2];
        if (found == 1) {
            return x * x + y * y + z * z;
        }
        double[] n = cross(p, a, four[1], found == 2 ? i : four[2]);
        return found == 2 ? n[0] * n[0] + n[1] * n[1] + n[2] * n[2] : Math.abs(n[0] * x + n[1] * y + n[2] * z);
    }

    private static List<Face> grow(double[] p, int most, int[] start) {
        List<Face> faces = new ArrayList<>();
        faces.add(new Face(p, start[0], start[1], start[2]));
        faces.add(new Face(p, start[0], start[3], start[1]));
        faces.add(new Face(p, start[1], start[3], start[2]));
        faces.add(new Face(p, start[2], start[3], start[0]));
        for (int i = 0; i < p.length / 3; i++) {
            share(p, i, faces, 0);
        }
        for (int count = 4; count < most; count++) {
            Face next = faces.get(0);
            for (Face face : faces) {
                if (face.most > next.most) {
                    next = face;
                }
            }
            if (next.farthest < 0) {
                break;
            }
            add(p, next.farthest, faces);
        }
        return faces;
    }

    /** Assigns a point to the first face that it lies outside of. */
    private static void share(double[] p, int point, List<Face> faces, int first) {
        for (int k = first; k < faces.size(); k++) {
            if (faces.get(k).take(p, point)) {
                return;
            }
        }
    }

    private static void add(double[] p, int point, List<Face> faces) {
        Map<Long, int[]> rim = new LinkedHashMap<>();
        List<Integer> homeless = new ArrayList<>();
        int kept = 0;
        for (int i = 0; i < faces.size(); i++) {
            Face face = faces.get(i);
            if (face.height(p, point) > NOTHING) {
                toggle(rim, face.a, face.b);
                toggle(rim, face.b, face.c);
                toggle(rim, face.c, face.a);
                homeless.addAll(face.outside);
            } else {
                faces.set(kept++, face);
            }
        }
        faces.subList(kept, faces.size()).clear();
        for (int[] edge : rim.values()) {
            faces.add(new Face(p, edge[0], edge[1], point));
        }
        for (int other : homeless) {
            if (other != point) {
                share(p, other, faces, kept);
            }
        }
    }

    private static void toggle(Map<Long, int[]> rim, int from, int to) {
        if (rim.remove((long) to << 32 | from) == null) {
            rim.put((long) from << 32 | to, new int[] {from, to});
        }
    }

    private static double[] cross(double[] p, int a, int b, int c) {
        double ux = p[3 * b] - p[3 * a];
        double uy = p[3 * b + 1] - p[3 * a + 1];
        double uz = p[3 * b + 2] - p[3 * a + 2];
        double wx = p[3 * c] - p[3 * a];
        double wy = p[3 * c + 1] - p[3 * a + 1];
        double wz = p[3 * c + 2] - p[3 * a + 2];
        return new double[] {uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx};
    }

    /** Returns the corners in a face's plane, in order around its normal. */
    private int[] polygon(Face face) {
        List<Integer> in = new ArrayList<>();
        double[] middle = new double[3];
        for (int i = 0; i < corners.length / 3; i++) {
            if (Math.abs(face.height(corners, i)) <= TOLERANCE) {
                in.add(i);
                for (int axis = 0; axis < 3; axis++) {
                    middle[axis] += corners[3 * i + axis];
                }
            }
        }
        double[] u = {corners[3 * in.get(0)] - middle[0] / in.size(), corners[3 * in.get(0) + 1]
            - middle[1] / in.size(), corners[3 * in.get(0) + 2] - middle[2] / in.size()};
        double[] v = {face.ny * u[2] - face.nz * u[1], face.nz * u[0] - face.nx * u[2],
            face.nx * u[1] - face.ny * u[0]};
        double[] angles = new double[corners.length / 3];
        for (int i : in) {
            double x = corners[3 * i] - middle[0] / in.size();
            double y = corners[3 * i + 1] - middle[1] / in.size();
            double z = corners[3 * i + 2] - middle[2] / in.size();
            angles[i] = Math.atan2(x * v[0] + y * v[1] + z * v[2], x * u[0] + y * u[1] + z * u[2]);
        }
        in.sort(Comparator.comparingDouble(i -> angles[i]));
        int count = Math.min(in.size(), ContactFeature.MOST / 2);
        int[] polygon = new int[count];
        for (int i = 0; i < count; i++) {
            polygon[i] = in.get(i * in.size() / count);
        }
        return polygon;
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners.length; i += 3) {
            double along = corners[i] * dx + corners[i + 1] * dy + corners[i + 2] * dz;
            if (along > most) {
                most = along;
                best = i;
            }
        }
        into[0] = corners[best];
        into[1] = corners[best + 1];
        into[2] = corners[best + 2];
    }

    /** Adds the face whose normal is closest to the direction. */
    @Override
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < planes.length; i += 4) {
            double along = planes[i] * dx + planes[i + 1] * dy + planes[i + 2] * dz;
            if (along > most) {
                most = along;
                best = i;
            }
        }
        for (int corner : polygons[best / 4]) {
            into.add(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2]);
        }
        into.setNormal(planes[best], planes[best + 1], planes[best + 2]);
    }

    /** The core is the hull shrunk towards its centre; all faces keep their normals. */
    @Override
    public void coreSupport(double dx, double dy, double dz, double[] into) {
        support(dx, dy, dz, into);
        for (int axis = 0; axis < 3; axis++) {
            into[axis] += drawn * (centre[axis] - into[axis]);
        }
    }

    @Override
    public double skin() {
        return drawn * radius;
    }
}
