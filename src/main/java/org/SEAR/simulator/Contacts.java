package org.SEAR.simulator;

import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.ManifoldPoint;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import java.util.Arrays;
import javax.vecmath.Vector3f;

/** The points of contact of one pair in one step; hands the best four to jbullet. */
final class Contacts {
    private static final int MOST = 4;
    private static final int FIELDS = 7;

    private double[] found = new double[16 * FIELDS];
    private int count;
    private final int[] chosen = new int[MOST];
    private final ManifoldPoint[] before = {new ManifoldPoint(), new ManifoldPoint(), new ManifoldPoint(), new ManifoldPoint()};
    private final Vector3f normal = new Vector3f();
    private final Vector3f point = new Vector3f();

    void clear() {
        count = 0;
    }

    /** @param nx direction from B to A @param x on B, world frame @param height of A above it, metres */
    void add(double nx, double ny, double nz, double x, double y, double z, double height) {
        if (FIELDS * (count + 1) > found.length) {
            found = Arrays.copyOf(found, 2 * found.length);
        }
        int i = FIELDS * count++;
        found[i] = nx;
        found[i + 1] = ny;
        found[i + 2] = nz;
        found[i + 3] = x;
        found[i + 4] = y;
        found[i + 5] = z;
        found[i + 6] = height;
    }

    private double height(int i) {
        return found[FIELDS * i + 6];
    }

    /** Tells robots what they come near to. */
    void announce(Body a, Body b) {
        for (int i = 0; i < count && (a.isRobot() || b.isRobot()); i++) {
            if (height(i) > ContactPatch.SKIN) {
                int at = FIELDS * i;
                a.near(b, found[at], found[at + 1], found[at + 2], found[at + 3], found[at + 4], found[at + 5], found[at + 6]);
                b.near(a, -found[at], -found[at + 1], -found[at + 2], found[at + 3], found[at + 4], found[at + 5], found[at + 6]);
            }
        }
    }

    /** Puts them in the place of the last step's points; what pushed there pushes on. */
    void give(PersistentManifold manifold, ManifoldResult result) {
        int old = manifold.getNumContacts();
        for (int i = 0; i < old; i++) {
            before[i].set(manifold.getContactPoint(i));
        }
        manifold.clearManifold();
        for (int i = choose() - 1; i >= 0; i--) {
            int at = FIELDS * chosen[i];
            normal.set((float) found[at], (float) found[at + 1], (float) found[at + 2]);
            point.set((float) found[at + 3], (float) found[at + 4], (float) found[at + 5]);
            result.addContactPoint(normal, point, (float) found[at + 6] - ContactPatch.SKIN);
        }
        for (int i = 0; i < manifold.getNumContacts(); i++) {
            inherit(manifold.getContactPoint(i), old);
        }
    }

    private void inherit(ManifoldPoint now, int old) {
        float least = ContactPatch.BREAKING * ContactPatch.BREAKING;
        for (int i = 0; i < old; i++) {
            point.sub(before[i].localPointB, now.localPointB);
            if (point.lengthSquared() < least) {
                least = point.lengthSquared();
                now.appliedImpulse = before[i].appliedImpulse;
                now.appliedImpulseLateral1 = before[i].appliedImpulseLateral1;
                now.appliedImpulseLateral2 = before[i].appliedImpulseLateral2;
                now.lifeTime = before[i].lifeTime;
            }
        }
    }

    /** The lowest, and those farthest from the ones chosen so far; what touches goes before what does not. */
    private int choose() {
        int taken = 0;
        while (taken < Math.min(MOST, count)) {
            int best = -1;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                double worth = taken == 0 ? -height(i) : room(i, taken) - (height(i) > ContactPatch.SKIN ? 1e6 : 0);
                if (worth > most) {
                    most = worth;
                    best = i;
                }
            }
            chosen[taken++] = best;
        }
        return taken;
    }

    /** The square of the distance from the nearest chosen point. */
    private double room(int i, int taken) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < taken; k++) {
            int a = FIELDS * i;
            int b = FIELDS * chosen[k];
            double square = 0;
            for (int axis = 3; axis < 6; axis++) {
                square += (found[a + axis] - found[b + axis]) * (found[a + axis] - found[b + axis]);
            }
            least = Math.min(least, square);
        }
        return least;
    }
}
