// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;

/** Corrects impossible start poses, each with a warning. */
public final class StartPoses {
    /** Largest overlap of two bodies at the start, metres. */
    private static final double ALLOWED = 1e-3;
    /** Overlap that counts as touching, metres. */
    private static final double TOUCHING = 1e-6;
    /** Largest number of warnings about overlaps. */
    private static final int MAX_REPORTED = 20;
    /** Largest number of pairs that start inside each other; with more, a step takes seconds. */
    private static final int MAX_PAIRS = 50_000;
    /** Largest number of obstacles named in a warning. */
    private static final int MAX_OBSTACLES = 3;
    /** Rounds of moves: a body moved out of one obstacle may be inside the next. */
    private static final int ROUNDS = 16;
    private static final int HALVINGS = 24;
    /** Horizontal directions along an obstacle's axes, and the least length of such an axis seen from above. */
    private static final int SIDES = 4;
    private static final double UPRIGHT = 0.7;

    private StartPoses() {
    }

    /**
     * Moves all bodies with mass out of fixed ones, the shortest way: up or sideways.
     * @param grounds bodies that others leave upwards only
     */
    public static void moveOut(List<Body> bodies, Collection<Body> grounds, List<String> warnings) {
        List<Body> fixed = bodies.stream().filter(Body::isFixed).collect(Collectors.toList());
        for (Body body : bodies) {
            if (!body.isFixed()) {
                Pose before = body.getStart();
                moveOut(body, fixed, grounds);
                Pose after = body.getStart();
                if (after != before) {
                    String inside = obstacles(body, before, fixed).map(obstacle -> obstacle.name).limit(MAX_OBSTACLES)
                        .collect(Collectors.joining(" and "));
                    boolean up = after.x == before.x && after.z == before.z;
                    warnings.add(body.name + " started inside a fixed object (" + inside + "); SEAR " + (up
                        ? String.format(Locale.ROOT, "lifted it by %.3f m. Raise y in its move(x, y, z) by that, or "
                            + "change x or z",
                            after.y - before.y)
                        : String.format(Locale.ROOT, "moved it by (%.3f, %.3f, %.3f) m, the shortest way out. Change "
                            + "its move(x, y, z) by that",
                            after.x - before.x, after.y - before.y, after.z - before.z)));
                }
            }
        }
    }

    /**
     * Moves the start of a body out of others at their present poses, up or sideways.
     * @param grounds bodies that it leaves upwards only
     */
    public static void moveOut(Body body, List<Body> others, Collection<Body> grounds) {
        int round = 0;
        while (round < ROUNDS && moveOnce(body, others, grounds)) {
            round++;
        }
    }

    /**
     * Returns the pose in which a body has left fixed ones at its present pose; its present pose if it is in none.
     * @param grounds bodies that it leaves upwards only
     */
    public static Pose leave(Body body, List<Body> fixed, Collection<Body> grounds) {
        Pose start = body.getStart();
        body.setStart(body.getPose());
        moveOut(body, fixed, grounds);
        Pose out = body.getStart();
        body.setStart(start);
        return out;
    }

    /**
     * Finds too many overlapping bodies with mass, since each step would test every pair.
     * @return description of the pairs; null if there are not too many
     */
    public static String crowd(List<Body> bodies) {
        List<Body> moving = bodies.stream().filter(body -> !body.isFixed()).collect(Collectors.toList());
        List<Aabb> boxes = moving.stream().map(body -> new Overlap(body).bounds(body.getStart()))
            .collect(Collectors.toList());
        Integer[] order = IntStream.range(0, boxes.size()).boxed()
            .sorted(Comparator.comparingDouble(i -> boxes.get(i).minX))
            .toArray(Integer[]::new);
        int pairs = 0;
        for (int i = 0; i < order.length; i++) {
            Aabb box = boxes.get(order[i]);
            for (int k = i + 1; k < order.length && boxes.get(order[k]).minX <= box.maxX; k++) {
                pairs += box.overlaps(boxes.get(order[k])) ? 1 : 0;
                if (pairs > MAX_PAIRS) {
                    return "more than " + MAX_PAIRS + " pairs of objects with mass start inside each other, such as "
                        + moving.get(order[i]).name
                        + " and " + moving.get(order[k]).name;
                }
            }
        }
        return null;
    }

    /** Warns of bodies with mass that start inside each other: the first step pushes them apart. */
    public static void reportOverlaps(List<Body> bodies, List<String> warnings) {
        List<Body> moving = bodies.stream().filter(body -> !body.isFixed()).collect(Collectors.toList());
        List<Overlap> overlaps = moving.stream().map(Overlap::new).collect(Collectors.toList());
        List<Aabb> boxes = new ArrayList<>();
        int reported = 0;
        for (int i = 0; i < moving.size(); i++) {
            Overlap mine = overlaps.get(i);
            Pose start = moving.get(i).getStart();
            boxes.add(mine.bounds(start));
            for (int k = 0; k < i; k++) {
                if (reported == MAX_REPORTED) {
                    warnings.add("more objects start inside each other; SEAR names the first "
                        + MAX_REPORTED + " only");
                    return;
                }
                if (!moving.get(i).ignores(moving.get(k)) && boxes.get(i).overlaps(boxes.get(k))
                    && mine.overlaps(start, overlaps.get(k), ALLOWED)) {
                    reported++;
                    warnings.add(String.format(Locale.ROOT, "%s and %s start %.3f m inside each other and will be "
                        + "pushed apart;"
                        + " move one of them", moving.get(k).name, moving.get(i).name,
                            mine.depth(start, overlaps.get(k))));
                }
            }
        }
    }

    /**
     * Sets a body down on the ground, as low as possible with no part below the ground. The scenes hold the ground at
     * its start.
     * @param at its pose; the height is ignored
     * @param feet points of the body's frame that it stands on, such as wheel contacts; empty: the lowest points of its
     *     solids
     * @return whether there is ground below
     */
    public static boolean stand(Body body, Pose at, double[][] feet, RaycastScenes scenes) {
        Pose level = new Pose(at.x, 0, at.z, at.qx, at.qy, at.qz, at.qw);
        Overlap mine = new Overlap(body);
        double height = Double.NEGATIVE_INFINITY;
        for (double[] foot : feet.length > 0 ? feet : mine.lowest(level)) {
            double[] point = level.transform(foot[0], foot[1], foot[2]);
            double ground = scenes.groundHeight(point[0], point[2]);
            height = ground - point[1] > height ? ground - point[1] : height;
        }
        if (height == Double.NEGATIVE_INFINITY) {
            return false;
        }
        double in = height;
        double out = height;
        for (double more = ALLOWED; overlapsGround(body, mine, up(level, out), scenes); more *= 2) {
            in = out;
            out += more;
        }
        for (int i = 0; i < HALVINGS && in < out; i++) {
            double middle = (in + out) / 2;
            if (overlapsGround(body, mine, up(level, middle), scenes)) {
                in = middle;
            } else {
                out = middle;
            }
        }
        body.setStart(up(level, out));
        return true;
    }

    private static boolean overlapsGround(Body body, Overlap mine, Pose pose, RaycastScenes scenes) {
        Aabb box = mine.bounds(pose);
        for (Body ground : scenes.grounds()) {
            Overlap other = new Overlap(ground);
            if (ground != body && box.overlaps(other.bounds(ground.getStart()))
                && mine.overlaps(pose, other, TOUCHING)) {
                return true;
            }
        }
        return false;
    }

    /** Returns the other bodies that a body overlaps at a pose. */
    private static Stream<Body> obstacles(Body body, Pose at, List<Body> others) {
        Overlap mine = new Overlap(body);
        Aabb box = mine.bounds(at);
        return others.stream().filter(other -> !body.ignores(other)
            && box.overlaps(new Overlap(other).bounds(other.getPose()))
            && mine.isStuck(at, new Overlap(other), other.getPose(), ALLOWED));
    }

    private static boolean moveOnce(Body body, List<Body> others, Collection<Body> grounds) {
        Overlap mine = new Overlap(body);
        Aabb box = mine.bounds(body.getStart());
        boolean moved = false;
        for (Body obstacle : others) {
            Overlap other = new Overlap(obstacle);
            Aabb around = other.bounds(obstacle.getPose());
            if (body.ignores(obstacle) || !box.overlaps(around)
                || !mine.isStuck(body.getStart(), other, obstacle.getPose(), ALLOWED)) {
                continue;
            }
            Pose out = out(mine, obstacle, 0, 1, 0, Double.POSITIVE_INFINITY);
            for (int side = 0; side < SIDES && !grounds.contains(obstacle); side++) {
                double[] way = obstacle.getPose().rotate(side == 0 ? 1 : side == 1 ? -1 : 0, 0, side == 2 ? 1
                    : side == 3 ? -1 : 0);
                double length = Math.hypot(way[0], way[2]);
                Pose beside = length < UPRIGHT ? null
                    : out(mine, obstacle, way[0] / length, 0, way[2] / length,
                        distance(out, body.getStart()) - ALLOWED);
                out = beside != null && obstacles(body, beside, others).count() == 0 ? beside : out;
            }
            body.setStart(out);
            box = mine.bounds(out);
            moved = true;
        }
        return moved;
    }

    private static double distance(Pose a, Pose b) {
        return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }

    /**
     * Returns the pose in which a body has left another along a direction.
     * @param most largest distance, metres
     * @return null if it is larger
     */
    private static Pose out(Overlap mine, Body obstacle, double x, double y, double z, double most) {
        Overlap other = new Overlap(obstacle);
        Pose there = obstacle.getPose();
        Pose start = mine.getBody().getStart();
        Aabb box = mine.bounds(start);
        Aabb around = other.bounds(there);
        double in = 0;
        double out = Double.POSITIVE_INFINITY;
        out = Math.min(out, x == 0 ? out
            : (x > 0 ? around.maxX - box.minX + ALLOWED : around.minX - box.maxX - ALLOWED) / x);
        out = Math.min(out, y == 0 ? out : around.maxY - box.minY + ALLOWED);
        out = Math.min(out, z == 0 ? out
            : (z > 0 ? around.maxZ - box.minZ + ALLOWED : around.minZ - box.maxZ - ALLOWED) / z);
        if (out > most && mine.isIn(along(start, x, y, z, most), other, there)) {
            return null;
        }
        out = Math.min(out, most);
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (in + out) / 2;
            if (mine.isIn(along(start, x, y, z, middle), other, there)) {
                in = middle;
            } else {
                out = middle;
            }
        }
        return along(start, x, y, z, out);
    }

    private static Pose along(Pose pose, double x, double y, double z, double metres) {
        return new Pose(pose.x + x * metres, pose.y + y * metres, pose.z + z * metres, pose.qx, pose.qy,
            pose.qz, pose.qw);
    }

    private static Pose up(Pose pose, double metres) {
        return new Pose(pose.x, pose.y + metres, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
    }
}
