package org.SEAR.physics;

import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.ManifoldPoint;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ContactPoints;
import org.SEAR.collision.ManifoldClipper;

/** Hands the points of contact of a pair to jbullet, and to robots that come near. Simulation thread. */
final class ManifoldWriter {
    private final ManifoldPoint[] before = {new ManifoldPoint(), new ManifoldPoint(), new ManifoldPoint(), new ManifoldPoint()};
    private final Vector3f normal = new Vector3f();
    private final Vector3f point = new Vector3f();

    /** Tells robots what they come near to. */
    static void announce(ContactPoints contacts, Body a, Body b) {
        for (int i = 0; i < contacts.size() && (a.isRobot() || b.isRobot()); i++) {
            double height = contacts.height(i);
            if (height > ManifoldClipper.SKIN) {
                a.near(b, contacts.nx(i), contacts.ny(i), contacts.nz(i), contacts.x(i), contacts.y(i), contacts.z(i), height);
                b.near(a, -contacts.nx(i), -contacts.ny(i), -contacts.nz(i), contacts.x(i), contacts.y(i), contacts.z(i), height);
            }
        }
    }

    /** Puts them in the place of the last step's points; what pushed there pushes on (warm starting). */
    void give(ContactPoints contacts, PersistentManifold manifold, ManifoldResult result) {
        int old = manifold.getNumContacts();
        for (int i = 0; i < old; i++) {
            before[i].set(manifold.getContactPoint(i));
        }
        manifold.clearManifold();
        for (int i = contacts.choose() - 1; i >= 0; i--) {
            int from = contacts.chosen(i);
            normal.set((float) contacts.nx(from), (float) contacts.ny(from), (float) contacts.nz(from));
            point.set((float) contacts.x(from), (float) contacts.y(from), (float) contacts.z(from));
            result.addContactPoint(normal, point, (float) contacts.height(from) - ManifoldClipper.SKIN);
        }
        for (int i = 0; i < manifold.getNumContacts(); i++) {
            inherit(manifold.getContactPoint(i), old);
        }
    }

    private void inherit(ManifoldPoint now, int old) {
        float least = ManifoldClipper.BREAKING * ManifoldClipper.BREAKING;
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
}
