// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.solid.Hinge;
import org.SEAR.physics.solid.Solid;
import org.SEAR.project.ObjectPose;
import org.SEAR.robot.servo.ServoDrive;
import org.SEAR.sensors.Sensor;

/**
 * Servos of one robot and the sensors and parts mounted on them. A turning part pushes bodies that it touches; the
 * robot's mass distribution stays as at the start. Simulation thread.
 */
final class ServoMounts {
    private static final int NONE = -1;

    private final List<SearObject> parts;
    private final Body body;
    private final RobotBuilder shapes;
    /** Per component: its servo, or null; and the index of the servo that turns it, or NONE. */
    private final ServoDrive[] servos;
    private final int[] carriers;
    private final Pose[] homes;
    private final Pose[] turns;
    private final List<Sensor<?>> sensors = new ArrayList<>();
    private final boolean any;
    private List<Pose> poses = List.of();

    /** @param reported takes warnings during the run */
    ServoMounts(RobotBuilder from, Consumer<String> reported) {
        shapes = from;
        parts = from.object.getComponents();
        body = from.body;
        servos = new ServoDrive[parts.size()];
        carriers = new int[parts.size()];
        homes = new Pose[parts.size()];
        turns = new Pose[parts.size()];
        boolean found = false;
        for (int i = 0; i < servos.length; i++) {
            homes[i] = ObjectPose.of(parts.get(i));
            carriers[i] = carrier(parts.get(i));
            if (parts.get(i) instanceof Servo) {
                servos[i] = new ServoDrive((Servo) parts.get(i), from.object.getName(), reported);
                found = true;
            }
        }
        any = found;
        if (any) {
            weigh();
            body.setLeastReach(reach());
            body.inner().onYield(this::giveWay);
            place(this::put);
        }
    }

    private int carrier(SearObject part) {
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i) instanceof Servo && ((Servo) parts.get(i)).getPartNames().contains(part.getName())) {
                return i;
            }
        }
        return NONE;
    }

    /** Adds the masses on each servo to its load. */
    private void weigh() {
        for (int i = 0; i < servos.length; i++) {
            Solid solid = shapes.shapes.get(parts.get(i));
            double mass = solid == null ? 0 : ((Shape) parts.get(i)).getMass();
            for (int carrier = carriers[i]; mass > 0 && carrier != NONE; carrier = carriers[carrier]) {
                servos[carrier].getLoad().add(i, solid.perKilogram().withMass(mass).inParent(solid.offset));
            }
        }
    }

    /** Returns an upper bound of the distance from the centre of mass that a turning part can reach, metres. */
    private double reach() {
        double most = 0;
        double[] centre = body.getCentre();
        for (int i = 0; i < homes.length; i++) {
            if (carriers[i] != NONE && shapes.shapes.containsKey(parts.get(i))) {
                double way = shapes.shapes.get(parts.get(i)).convex().radius()
                    + distance(shapes.shapes.get(parts.get(i)).offset, Pose.IDENTITY);
                Pose from = homes[i];
                for (int carrier = carriers[i]; carrier != NONE; carrier = carriers[carrier]) {
                    way += distance(from, homes[carrier]);
                    from = homes[carrier];
                }
                most = Math.max(most, way + distance(from, new Pose(centre[0], centre[1], centre[2], 0, 0, 0, 1)));
            }
        }
        return most;
    }

    private static double distance(Pose a, Pose b) {
        return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }

    void add(Sensor<?> sensor) {
        sensors.add(sensor);
        follow(sensor);
    }

    ServoDrive find(String name) {
        for (ServoDrive servo : servos) {
            if (servo != null && servo.getName().equals(name)) {
                return servo;
            }
        }
        return null;
    }

    /** Moves all servos to their start; before the physics restarts. */
    void restart() {
        if (any) {
            for (ServoDrive servo : servos) {
                if (servo != null) {
                    servo.restart();
                }
            }
            place(this::put);
        }
    }

    /**
     * Turns the servos and their parts for one step.
     * @return whether a servo has turned
     */
    boolean step() {
        boolean turned = false;
        for (int i = 0; any && i < servos.length; i++) {
            turned |= servos[i] != null && servos[i].step(body.getPose(), PhysicsWorld.GRAVITY, poses.get(i));
        }
        if (turned) {
            place(body::move);
        }
        return turned;
    }

    /** Corrects the angles of servos that were blocked by a contact. */
    private void giveWay() {
        for (ServoDrive servo : servos) {
            if (servo != null && servo.getHinge() != null) {
                servo.giveWay();
            }
        }
        place(body::move);
    }

    private void put(int solid, Pose place, Hinge hinge) {
        body.setPlace(solid, place);
    }

    /** Receives the poses of its shapes. */
    private interface Places {
        void put(int solid, Pose place, Hinge hinge);
    }

    private void place(Places of) {
        Pose[] now = new Pose[homes.length];
        Arrays.fill(turns, null);
        for (int i = 0; i < now.length; i++) {
            now[i] = carriers[i] == NONE ? homes[i] : turned(carriers[i]).times(homes[i]);
            if (carriers[i] != NONE && shapes.shapes.containsKey(parts.get(i))) {
                of.put(shapes.solidOf(parts.get(i)), now[i].times(shapes.shapes.get(parts.get(i)).offset),
                    hinge(carriers[i]));
            }
        }
        for (int i = 0; i < servos.length; i++) {
            if (servos[i] != null) {
                servos[i].getLoad().place(now, i);
            }
        }
        poses = List.of(now);
        sensors.forEach(this::follow);
    }

    /**
     * Returns the nearest hinge that turns in this step, of a servo and those that it is mounted on; this hinge yields.
     */
    private Hinge hinge(int servo) {
        Hinge found = null;
        for (int carrier = servo; carrier != NONE && found == null; carrier = carriers[carrier]) {
            found = servos[carrier].getHinge();
        }
        return found;
    }

    /** Returns the rotation that a servo, and those that it is mounted on, apply to its parts. */
    private Pose turned(int servo) {
        if (turns[servo] == null) {
            Pose own = servos[servo].turn();
            turns[servo] = carriers[servo] == NONE ? own : turned(carriers[servo]).times(own);
        }
        return turns[servo];
    }

    private void follow(Sensor<?> sensor) {
        int index = parts.indexOf(sensor.getParameters());
        if (any && carriers[index] != NONE) {
            sensor.setMount(poses.get(index));
        }
    }

    /**
     * Pose of each component in the body frame; empty without servos, when the components stay at the poses of their
     * objects. Immutable.
     */
    List<Pose> getPoses() {
        return poses;
    }
}
