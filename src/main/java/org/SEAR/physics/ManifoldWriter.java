package org.SEAR.physics;

import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.ManifoldPoint;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ContactPoints;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.physics.solid.Solid;

/** Hands the points of contact of a pair to jbullet, and to robots that come near. Simulation thread. */
final class ManifoldWriter {
    /** What comes slower than this does not bounce, m/s: else what rests would tremble. */
    private static final double LEAST_BOUNCE = 0.3;

    private final double[] speedOfA = new double[3];
    private final double[] speedOfB = new double[3];
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
    void give(ContactPoints contacts, Solid solidA, Solid solidB, PersistentManifold manifold, ManifoldResult result) {
        int old = manifold.getNumContacts();
        double pressed = 0;
        for (int i = 0; i < old; i++) {
            before[i].set(manifold.getContactPoint(i));
            pressed += before[i].appliedImpulse;
        }
        manifold.clearManifold();
        Body a = (Body) ((CollisionObject) manifold.getBody0()).getUserPointer();
        Body b = (Body) ((CollisionObject) manifold.getBody1()).getUserPointer();
        double restitution = Math.max(solidA.getSurface().restitution(), solidB.getSurface().restitution());
        float friction = (float) (solidA.getSurface().friction(a.isRobot()) * solidB.getSurface().friction(b.isRobot()));
        boolean bounces = false;
        for (int i = contacts.choose() - 1; i >= 0; i--) {
            int from = contacts.chosen(i);
            boolean bounce = restitution > 0 && approach(contacts, from, a, b) > LEAST_BOUNCE;
            if (bounce && contacts.height(from) > ManifoldClipper.SKIN) {
                continue;
            }
            normal.set((float) contacts.nx(from), (float) contacts.ny(from), (float) contacts.nz(from));
            point.set((float) contacts.x(from), (float) contacts.y(from), (float) contacts.z(from));
            result.addContactPoint(normal, point, (float) contacts.height(from) - ManifoldClipper.SKIN);
            bounces |= bounce;
        }
        for (int i = 0; i < manifold.getNumContacts(); i++) {
            ManifoldPoint now = manifold.getContactPoint(i);
            now.combinedRestitution = bounces ? (float) restitution : 0;
            now.combinedFriction = friction;
            now.index0 = numberOf(solidA, a);
            now.index1 = numberOf(solidB, b);
            inherit(now, old);
        }
        if (manifold.getNumContacts() > 0) {
            touch(a, bounces, manifold);
            touch(b, bounces, manifold);
        }
        double rolling = (solidA.getSurface().rollingFriction() + solidB.getSurface().rollingFriction()) * pressed;
        if (manifold.getNumContacts() > 0 && rolling > 0) {
            resist(a, b, rolling, manifold.getContactPoint(0));
            resist(b, a, rolling, manifold.getContactPoint(0));
        }
    }

    /** Which of a robot's solids it is; 0 in all other bodies. */
    private static int numberOf(Solid solid, Body body) {
        return body.isRobot() ? body.solids.indexOf(solid) : 0;
    }

    private static void touch(Body body, boolean bounce, PersistentManifold manifold) {
        for (int i = 0; i < manifold.getNumContacts() && body.getMotion() != null; i++) {
            body.getMotion().touch(bounce, manifold.getContactPoint(i).normalWorldOnB);
        }
    }

    /** @param impulse that the coefficient of rolling friction allows, Ns, by the force of the last step */
    private void resist(Body body, Body on, double impulse, ManifoldPoint at) {
        if (body.getRolling() != null) {
            body.getRigid().getCenterOfMassPosition(point);
            point.sub(at.positionWorldOnB);
            body.getRolling().add(impulse * Math.abs(point.dot(at.normalWorldOnB)), on.getRigid());
        }
    }

    /** How fast both come together at a point, m/s. */
    private double approach(ContactPoints contacts, int i, Body a, Body b) {
        a.velocityAt(contacts.x(i), contacts.y(i), contacts.z(i), speedOfA);
        b.velocityAt(contacts.x(i), contacts.y(i), contacts.z(i), speedOfB);
        return (speedOfB[0] - speedOfA[0]) * contacts.nx(i) + (speedOfB[1] - speedOfA[1]) * contacts.ny(i)
            + (speedOfB[2] - speedOfA[2]) * contacts.nz(i);
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
