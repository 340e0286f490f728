// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.joint.HingeJoint;
import org.SEAR.project.ObjectPose;
import org.SEAR.robot.servo.ServoDrive;
import org.SEAR.sensors.Sensor;

/**
 * Servos of one robot and the sensors and parts mounted on them. A servo that turns shapes is a hinge between two
 * bodies of the physics. Simulation thread.
 */
final class ServoMounts {
    private final List<SearObject> parts;
    private final Body body;
    private final List<RobotLink> links;
    /** Per component: its servo, or null; its link, or null; and the index of the servo that turns it, or NONE. */
    private final ServoDrive[] servos;
    private final RobotLink[] linkOf;
    private final int[] carriers;
    private final Pose[] homes;
    private final List<Sensor<?>> sensors = new ArrayList<>();
    private final boolean any;
    private List<Pose> poses = List.of();

    /**
     * Servos of a robot.
     *
     * @param reported takes warnings during the run
     * @param holds whether the robot holds an object
     */
    ServoMounts(RobotBuilder from, Consumer<String> reported, BooleanSupplier holds) {
        SEARrobot robot = from.object;
        parts = robot.getComponents();
        body = from.body;
        links = from.links;
        servos = new ServoDrive[parts.size()];
        linkOf = new RobotLink[parts.size()];
        carriers = new int[parts.size()];
        homes = new Pose[parts.size()];
        boolean found = false;
        for (int i = 0; i < servos.length; i++) {
            homes[i] = ObjectPose.of(parts.get(i));
            carriers[i] = RobotLink.carrier(parts, i);
            if (parts.get(i) instanceof Servo) {
                servos[i] = new ServoDrive((Servo) parts.get(i), robot.getName(), reported, holds);
                found = true;
            }
        }
        any = found;
        links.forEach(link -> linkOf[link.servo] = link);
        if (any) {
            restart();
        }
    }

    /** Adds the bodies and hinges of its servos to the physics. */
    void addTo(PhysicsWorld physics) {
        for (RobotLink link : links) {
            Body carrier = carrier(link);
            HingeJoint hinge = new HingeJoint(carrier.forJoints(), link.getBody().forJoints());
            servos[link.servo].setHinge(hinge, () -> isTouched(link));
            physics.add(hinge, true, carrier, link.getBody());
        }
    }

    private Body carrier(RobotLink link) {
        return link.carrier == null ? body : link.carrier.getBody();
    }

    /** Whether something touches a link, or one that it carries. */
    private boolean isTouched(RobotLink link) {
        return links.stream().anyMatch(other -> {
            RobotLink one = other;
            while (one != null && one != link) {
                one = one.carrier;
            }
            return one == link && !other.getBody().isFree();
        });
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
            for (RobotLink link : links) {
                link.getBody().setStart(carrier(link).getStart().times(servos[link.servo].turn()));
            }
            place();
        }
    }

    /** Attaches the hinges to their bodies; after the physics has restarted. */
    void attach() {
        for (RobotLink link : links) {
            servos[link.servo].attach(carrier(link).getPose(), link.getBody().getPose());
        }
    }

    /**
     * Teleports the bodies of its servos along with the robot; the servos keep their angles.
     * @param start of the robot's body
     * @param to pose of the robot's body, which has not moved yet
     */
    void move(PhysicsWorld physics, Pose start, Pose to) {
        for (RobotLink link : links) {
            Body one = link.getBody();
            physics.move(one, start.times(relative(body.getStart(), one.getStart())), to.times(within(one)));
        }
    }

    /**
     * Begins a step of the servos.
     * @return whether a servo moves
     */
    boolean step() {
        boolean moves = false;
        boolean turned = false;
        for (int i = 0; any && i < servos.length; i++) {
            if (servos[i] != null) {
                boolean one = servos[i].step();
                moves |= one;
                turned |= one && linkOf[i] == null;
            }
        }
        if (turned) {
            place();
        }
        return moves;
    }

    /** Takes over the angles after a physics step. */
    void follow() {
        for (int i = 0; i < links.size(); i++) {
            servos[links.get(i).servo].follow();
        }
        if (!links.isEmpty()) {
            place();
        }
    }

    private void place() {
        Pose[] now = new Pose[homes.length];
        for (int i = 0; i < now.length; i++) {
            now[i] = carriers[i] == RobotLink.NONE ? homes[i] : frame(carriers[i]).times(homes[i]);
        }
        poses = List.of(now);
        sensors.forEach(this::follow);
    }

    /** Returns the pose of a servo's parts in the robot's frame; the identity with all servos at 0 degrees. */
    private Pose frame(int servo) {
        if (linkOf[servo] != null) {
            return within(linkOf[servo].getBody());
        }
        Pose own = servos[servo].turn();
        return carriers[servo] == RobotLink.NONE ? own : frame(carriers[servo]).times(own);
    }

    private Pose within(Body link) {
        return relative(body.getPose(), link.getPose());
    }

    private static Pose relative(Pose frame, Pose pose) {
        double[] at = frame.rotateBack(pose.x - frame.x, pose.y - frame.y, pose.z - frame.z);
        Pose turned = new Pose(0, 0, 0, -frame.qx, -frame.qy, -frame.qz, frame.qw)
            .times(new Pose(0, 0, 0, pose.qx, pose.qy, pose.qz, pose.qw));
        return new Pose(at[0], at[1], at[2], turned.qx, turned.qy, turned.qz, turned.qw);
    }

    private void follow(Sensor<?> sensor) {
        int index = parts.indexOf(sensor.getParameters());
        if (any && carriers[index] != RobotLink.NONE) {
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
