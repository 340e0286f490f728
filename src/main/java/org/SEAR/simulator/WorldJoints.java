// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.GuidedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Rope;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Slider;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.joint.DistanceJoint;
import org.SEAR.physics.joint.GearJoint;
import org.SEAR.physics.joint.HingeJoint;
import org.SEAR.physics.joint.Joint;
import org.SEAR.physics.joint.JointAxis;
import org.SEAR.physics.joint.JointedBody;
import org.SEAR.physics.joint.SliderJoint;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.PartNames;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.RobotModel;
import org.SEAR.robot.StartPose;
import org.SEAR.robot.servo.JointMotor;
import org.SEAR.sensors.JointReading;

/** The joints of a world: from objects of the grammar to the physics, and by name. Simulation thread. */
public final class WorldJoints {
    /** Position error at which a motor has full power: of a hinge, degrees, and of a slider or rope, metres. */
    private static final double FULL_POWER_DEGREES = 1;
    private static final double FULL_POWER_METRES = 0.001;
    /** Largest number of couplings of a mechanism: a chain has one per joint, n joints of one object n^2 / 2. */
    private static final int MAX_COUPLINGS = 10_000;

    private final List<Made> all = new ArrayList<>();
    private final Map<String, Made> named = new TreeMap<>();
    /** Joints within robots. */
    private final PartNames<Made> inRobots = new PartNames<>();
    private final Map<String, Map<String, Made>> ofRobots = new HashMap<>();
    private final List<GearJoint> gears = new ArrayList<>();
    /** Joints that can break and have not yet. */
    private final List<Made> breakable = new ArrayList<>();
    private final Consumer<String> reported;

    /** A joint of the grammar and that of the physics. */
    private static final class Made {
        final org.SEAR.POJOs.Joint object;
        final Joint joint;
        /** Bodies that it joins; the first one is null for the world. */
        final Body first;
        final Body second;
        /** Frame of the joint in each object, that of the world without a first object. */
        Pose onFirst;
        final Pose onSecond;
        /** Converts positions to metres or radians. */
        final double unit;

        /**
         * @param firstFrame frame of the first object, where the joint's pose is written
         * @param secondFrame frame of the second object
         */
        Made(org.SEAR.POJOs.Joint object, Body first, Pose firstFrame, Body second, Pose secondFrame) {
            this.object = object;
            this.first = first;
            this.second = second;
            joint = make(object, first == null ? null : first.forJoints(), second.forJoints());
            Pose frame = ObjectPose.of(object);
            onFirst = inFrame(firstFrame, frame);
            onSecond = inFrame(secondFrame, object instanceof Rope ? end((Rope) object) : frame);
            unit = object instanceof Hinge ? Math.toRadians(1) : 1;
        }

        void wake() {
            second.wake();
            if (first != null) {
                first.wake();
            }
        }
    }

    /**
     * Makes the joints of a project and adds them to the physics.
     * @param physics has all bodies
     * @param parts bodies of the shapes of robots
     * @param reported receives the joints that break
     */
    WorldJoints(Project project, PhysicsWorld physics, Map<SearObject, Body> parts, Consumer<String> reported) {
        this.reported = reported;
        Map<String, Body> bodies = new HashMap<>();
        physics.getBodies().forEach(body -> bodies.putIfAbsent(body.name, body));
        Map<String, Pose> written = new HashMap<>();
        written.put(null, Pose.IDENTITY);
        project.getEnvironment().forEach(thing -> written.put(thing.getName(), ObjectPose.of(thing)));
        project.getRobots().forEach(robot -> written.put(robot.getName(), StartPose.of(robot)));
        for (org.SEAR.POJOs.Joint object : project.getJoints()) {
            add(new Made(object, bodies.get(object.getFirst()), written.get(object.getFirst()),
                bodies.get(object.getSecond()), written.get(object.getSecond())), object.isCollide(), physics);
        }
        for (SEARrobot robot : project.getRobots()) {
            Map<String, Made> own = new LinkedHashMap<>();
            ofRobots.put(robot.getName(), own);
            robot.getComponents().stream().filter(part -> part instanceof org.SEAR.POJOs.Joint).forEach(part -> {
                org.SEAR.POJOs.Joint object = (org.SEAR.POJOs.Joint) part;
                Body first = object.getFirst() == null ? bodies.get(robot.getName())
                    : parts.get(robot.getPart(object.getFirst()));
                Made made = new Made(object, first, Pose.IDENTITY, parts.get(robot.getPart(object.getSecond())),
                    Pose.IDENTITY);
                add(made, true, physics);
                own.put(object.getName(), made);
                inRobots.add(robot.getName(), object.getName(), made);
            });
            own.values().forEach(made -> addGear(made, own, physics));
        }
        project.getJoints().forEach(object -> addGear(named.get(object.getName()), named, physics));
    }

    private void add(Made made, boolean collide, PhysicsWorld physics) {
        all.add(made);
        named.put(made.object.getFullName(), made);
        physics.add(made.joint, collide, made.first, made.second);
        if (made.object.getBreakingForce() != null) {
            made.joint.setBreakingForce(made.object.getBreakingForce());
        }
    }

    /** @param by joints that it may follow, by their names */
    private void addGear(Made made, Map<String, Made> by, PhysicsWorld physics) {
        if (!(made.object instanceof AxisJoint) || ((AxisJoint) made.object).getGear() == null) {
            return;
        }
        Made other = by.get(((AxisJoint) made.object).getGear());
        GearJoint gear = new GearJoint((org.SEAR.physics.joint.AxisJoint) made.joint,
            (org.SEAR.physics.joint.AxisJoint) other.joint,
            ((AxisJoint) made.object).getRatio() * made.unit / other.unit);
        gears.add(gear);
        physics.add(gear, true, made.first, made.second, other.first, other.second);
    }

    /** Whether an unbroken joint holds a body, or it is a link of a robot. */
    boolean holds(Body body) {
        return RobotBodies.isLink(body)
            || all.stream().anyMatch(made -> !made.joint.isBroken() && (made.first == body || made.second == body));
    }

    private static Joint make(org.SEAR.POJOs.Joint object, JointedBody first, JointedBody second) {
        if (object instanceof BallJoint) {
            return new org.SEAR.physics.joint.BallJoint(first, second);
        }
        if (object instanceof FixedJoint) {
            return new org.SEAR.physics.joint.FixedJoint(first, second);
        }
        return object instanceof Hinge ? new HingeJoint(first, second)
            : object instanceof Slider ? new SliderJoint(first, second) : new DistanceJoint(first, second);
    }

    /** Attaches all joints to the bodies at their start poses. After the restart of the physics. */
    void restart() {
        breakable.clear();
        for (Made made : all) {
            if (made.object.getBreakingForce() != null) {
                breakable.add(made);
            }
            if (made.object instanceof AxisJoint) {
                configure((AxisJoint) made.object, axis(made), made.unit);
            }
            Pose end = made.second.getStart().times(made.onSecond);
            if (made.object instanceof Rope) {
                ((DistanceJoint) made.joint).attachEnds(made.first == null ? made.onFirst
                    : made.first.getStart().times(made.onFirst), end);
            } else {
                Pose begin = end.times(back(made));
                made.joint.attach(begin, end);
                made.onFirst = made.first == null ? begin : inFrame(made.first.getStart(), begin);
            }
            hold(made);
        }
        gears.forEach(GearJoint::engage);
    }

    /** Returns the displacement of the second object from the start to position 0, in the joint's frame. */
    private static Pose back(Made made) {
        if (!(made.object instanceof GuidedJoint)) {
            return Pose.IDENTITY;
        }
        double start = made.unit * ((GuidedJoint) made.object).getStart();
        ((org.SEAR.physics.joint.AxisJoint) made.joint).setStart(start);
        return made.object instanceof Slider ? new Pose(0, -start, 0, 0, 0, 0, 1)
            : new Pose(0, 0, 0, 0, -Math.sin(start / 2), 0, Math.cos(start / 2));
    }

    /**
     * Warns of joints that can't move.
     *
     * @throws ProjectException if a mechanism has too many couplings for memory and time
     */
    void check(Project project, PhysicsWorld physics, List<String> warnings) throws ProjectException {
        JointAdvice.of(project).forEach((name, why) ->
            warnings.add(found(name).object + " does not move: " + why));
        if (physics.getCouplings() > MAX_COUPLINGS) {
            throw new ProjectException(List.of(new Problem("environment", 0, "", physics.getCouplings()
                + " pairs of joints act on a common object, directly or by other joints", "at most " + MAX_COUPLINGS
                    + ": fewer joints per object")));
        }
    }

    /** Reports the joints that broke in this step. */
    void reportBroken() {
        for (int i = breakable.size() - 1; i >= 0; i--) {
            if (breakable.get(i).joint.isBroken()) {
                org.SEAR.POJOs.Joint object = breakable.remove(i).object;
                reported.accept(object + " broke: its force was above its breakingForce, "
                    + Parameter.format(object.getBreakingForce()) + " N");
            }
        }
    }

    private static Pose end(Rope rope) {
        return new Pose(rope.getEndX(), rope.getEndY(), rope.getEndZ(), 0, 0, 0, 1);
    }

    /** Returns a pose in the frame of an object. */
    private static Pose inFrame(Pose frame, Pose pose) {
        double[] at = frame.rotateBack(pose.x - frame.x, pose.y - frame.y, pose.z - frame.z);
        Pose back = new Pose(0, 0, 0, -frame.qx, -frame.qy, -frame.qz, frame.qw);
        Pose turned = back.times(new Pose(0, 0, 0, pose.qx, pose.qy, pose.qz, pose.qw));
        return new Pose(at[0], at[1], at[2], turned.qx, turned.qy, turned.qz, turned.qw);
    }

    private static void configure(AxisJoint from, JointAxis axis, double unit) {
        axis.setLimits(from.getLower() == null ? Double.NEGATIVE_INFINITY : unit * from.getLower(),
            from.getUpper() == null ? Double.POSITIVE_INFINITY : unit * from.getUpper(), from.getRestitution());
        axis.setLosses(from.getFriction(), from.getDamping());
        axis.setSpring(from.getStiffness(), unit * from.getRest());
        axis.setMotor(from.getStallForce(), from.getNoLoadSpeed() == null ? Double.POSITIVE_INFINITY
            : unit * from.getNoLoadSpeed(),
            from instanceof Hinge ? unit * FULL_POWER_DEGREES : FULL_POWER_METRES);
    }

    /** A motor holds its position until the first command. */
    private static void hold(Made made) {
        if (made.object instanceof AxisJoint) {
            boolean motor = ((AxisJoint) made.object).getStallForce() > 0;
            axis(made).drive(motor ? JointAxis.Drive.POSITION : JointAxis.Drive.NONE, axis(made).getPosition());
        }
    }

    private static JointAxis axis(Made made) {
        return ((org.SEAR.physics.joint.AxisJoint) made.joint).getAxis();
    }

    /**
     * Commands a motor.
     * @param value position, degrees or metres; speed, the same a second; or power, -1 to 1
     * @throws IllegalArgumentException if the joint has no motor, or the value is outside the legal range
     */
    void drive(String name, JointAxis.Drive drive, double value) {
        Made made = axisJoint(name);
        if (((AxisJoint) made.object).getStallForce() == 0) {
            throw new IllegalArgumentException(made.object + " has no motor; " + made.object.getName()
                + ".setMotor(force, speed) adds one");
        }
        double most = drive == JointAxis.Drive.POWER ? 1 : Double.MAX_VALUE;
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException(made.object + ": " + drive.name().toLowerCase(Locale.ROOT) + " is "
                + value + ", legal: "
                + (most == 1 ? "-1 to 1" : "a number"));
        }
        AxisJoint object = (AxisJoint) made.object;
        double least = drive == JointAxis.Drive.POSITION && object.getLower() != null ? object.getLower()
            : Double.NEGATIVE_INFINITY;
        double greatest = drive == JointAxis.Drive.POSITION && object.getUpper() != null ? object.getUpper()
            : Double.POSITIVE_INFINITY;
        if (value < least || value > greatest) {
            throw new IllegalArgumentException(made.object + ": position is " + value + ", legal: " + least + " to "
                + greatest);
        }
        axis(made).drive(drive, drive == JointAxis.Drive.POWER ? value : made.unit * value);
        made.wake();
    }

    /** Connects the motors of a robot with the joints that they drive. */
    void connect(RobotModel robot) {
        for (JointMotor motor : robot.getJointMotors()) {
            Made made = ofRobots.get(robot.getObject().getName()).get(motor.getObject().getJoint());
            motor.connect(axis(made), made::wake);
        }
    }

    /** Returns the names of all joints, sorted. Any thread. */
    public Set<String> getNames() {
        return Collections.unmodifiableSet(named.keySet());
    }

    /** Returns names of sensors, then those of the joints with a reading: hinges, sliders and ropes. Any thread. */
    public List<String> after(List<String> sensors) {
        List<String> names = new ArrayList<>(sensors);
        named.keySet().stream().filter(this::isRead).forEach(names::add);
        return names;
    }

    /** Whether a joint of this name has a reading. Any thread. */
    public boolean isRead(String name) {
        Made made = find(name);
        return made != null && made.object instanceof AxisJoint;
    }

    /**
     * Returns position, speed and force of the motor.
     * @throws IllegalArgumentException that lists the valid names, or if the joint has no position
     */
    public JointReading reading(String name) {
        Made made = axisJoint(name);
        JointAxis axis = axis(made);
        boolean moves = made.second.isActive() || made.first != null && made.first.isActive();
        return new JointReading(made.object instanceof Hinge, axis.getPosition() / made.unit,
            moves ? axis.getSpeed() / made.unit : 0, axis.getEffort());
    }

    /**
     * Returns the present frame of a joint on its first object and on its second, in the world. Throws for an unknown
     * name.
     */
    public Pose[] frames(String name) {
        Made made = found(name);
        return new Pose[] {made.first == null ? made.onFirst : made.first.getPose().times(made.onFirst),
            made.second.getPose().times(made.onSecond)};
    }

    /** Whether a joint has broken in this run. Throws for an unknown name. */
    public boolean isBroken(String name) {
        return found(name).joint.isBroken();
    }

    /**
     * Returns the mean force and torque of the last step on a joint's second object, at the joint: {fx, fy, fz, tx, ty,
     * tz}, N and N m, world frame.
     * @throws IllegalArgumentException that lists the valid names
     */
    public double[] wrench(String name) {
        double[] wrench = new double[6];
        found(name).joint.wrench(wrench, TimeStep.SECONDS);
        return wrench;
    }

    /** Returns a function that copies the numbers of {@link #wrench(String)}, for the sensors of a robot. */
    BiConsumer<String, double[]> wrenches(String robot) {
        Map<String, Made> own = ofRobots.get(robot);
        return (name, into) -> (own.containsKey(name) ? own.get(name) : found(name)).joint
            .wrench(into, TimeStep.SECONDS);
    }

    /** Returns a joint by its name, or by robot/name within a robot; null for an unknown name. */
    private Made find(String name) {
        Made made = named.get(name);
        return made == null ? inRobots.find(name) : made;
    }

    private Made axisJoint(String name) {
        Made made = found(name);
        if (!(made.object instanceof AxisJoint)) {
            throw new IllegalArgumentException(made.object + " has no position, legal: a Hinge, Slider or Rope");
        }
        return made;
    }

    private Made found(String name) {
        Made made = find(name);
        if (made == null) {
            throw new IllegalArgumentException("no joint is called \"" + name + "\", legal: "
                + (named.isEmpty() ? "none, the project has no joint" : String.join(" ", named.keySet())));
        }
        return made;
    }
}
