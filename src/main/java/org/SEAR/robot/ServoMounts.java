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
import org.SEAR.project.PartCarriers;
import org.SEAR.robot.servo.ServoDrive;
import org.SEAR.sensors.Sensor;

/**
 * Servos of one robot, and the sensors and parts that they and the robot's joints move. A servo that turns shapes is a
 * hinge between two bodies of the physics. Simulation thread.
 */
final class ServoMounts {
    private final List<SearObject> parts;
    private final Body body;
    private final List<RobotLink> links;
    /** Per component: its servo, or null; its link, or null; and the index of the servo or joint that moves it. */
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
        boolean found = !links.isEmpty();
        PartCarriers movers = new PartCarriers(parts);
        for (int i = 0; i < servos.length; i++) {
            homes[i] = ObjectPose.of(parts.get(i));
            carriers[i] = movers.mover(i);
            if (parts.get(i) instanceof Servo) {
                servos[i] = new ServoDrive((Servo) parts.get(i), robot.getName(), reported, holds);
                found = true;
            }
        }
        any = found;
        links.forEach(link -> linkOf[link.mover] = link);
        if (any) {
            restart();
        }
    }

    /** Adds the hinges of its servos to the physics. */
    void addTo(PhysicsWorld physics) {
        for (RobotLink link : links) {
            if (servos[link.mover] != null) {
                Body carrier = carrier(link);
                HingeJoint hinge = new HingeJoint(carrier.forJoints(), link.getBody().forJoints());
                servos[link.mover].setHinge(hinge, () -> isTouched(link));
                physics.add(hinge, true, carrier, link.getBody());
            }
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
                Pose start = carrier(link).getStart();
                ServoDrive servo = servos[link.mover];
                link.getBody().setStart(servo == null ? start : start.times(servo.turn()));
            }
            place();
        }
    }

    /** Attaches the hinges of servos to their bodies; after the physics has restarted. */
    void attach() {
        for (RobotLink link : links) {
            if (servos[link.mover] != null) {
                servos[link.mover].attach(carrier(link).getPose(), link.getBody().getPose());
            }
        }
    }

    /**
     * Teleports the bodies of its links along with the robot; servos and joints keep their positions.
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
            if (servos[links.get(i).mover] != null) {
                servos[links.get(i).mover].follow();
            }
        }
        if (!links.isEmpty()) {
            place();
        }
    }

    private void place() {
        Pose[] now = new Pose[homes.length];
        for (int i = 0; i < now.length; i++) {
            now[i] = carriers[i] == PartCarriers.NONE ? homes[i] : frame(carriers[i]).times(homes[i]);
        }
        poses = List.of(now);
        sensors.forEach(this::follow);
    }

    /** Returns the pose of moved parts in the robot's frame; the identity with all servos and joints at their start. */
    private Pose frame(int mover) {
        if (linkOf[mover] != null) {
            return within(linkOf[mover].getBody());
        }
        Pose own = servos[mover].turn();
        return carriers[mover] == PartCarriers.NONE ? own : frame(carriers[mover]).times(own);
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
        if (any && carriers[index] != PartCarriers.NONE) {
            sensor.setMount(poses.get(index));
        }
    }

    /**
     * Pose of each component in the body frame; empty without servos and joints, when the components stay at the poses
     * of their objects. Immutable.
     */
    List<Pose> getPoses() {
        return poses;
    }
}
