// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.solid.BoxSolid;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.RoundSolid;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.wheel.CentreOfMass;
import org.SEAR.robot.wheel.Obstacle;
import org.SEAR.robot.wheel.Spring;
import org.SEAR.robot.wheel.SpringDesign;

/**
 * Builds a robot's rigid body from its components: their shapes, the mass of its Dynamics, and a guard per wheel. The
 * guard is a smaller cylinder at the top of the wheel's travel, which touches walls but never the floor.
 */
public final class RobotBuilder {
    /** Height of the box around the wheels of a robot without shapes, metres; also its smallest size. */
    private static final double BARE = 0.02;
    /** Smallest displacement of a centre of mass that counts, metres. */
    private static final double MIN_MOVE = 1e-9;

    final SEARrobot object;
    final Dynamics dynamics;
    final List<Solid> wheelSolids = new ArrayList<>();
    public final Body body;
    final Stability stability;
    final Spring[] springs;
    /** Greatest distance of the components from the vertical axis, metres. */
    final double radius;
    /** Whether a wheel is too large or too far away for checks of the robot's stand. */
    final boolean hasFarWheels;
    /** Solids of the components and wheels that have one. */
    public final Map<SearObject, Solid> shapes = new IdentityHashMap<>();
    private final List<Solid> solids = new ArrayList<>();
    private final List<Pose> places = new ArrayList<>();
    private final List<Boolean> visible = new ArrayList<>();
    private final List<Double> weights = new ArrayList<>();

    private RobotBuilder(SEARrobot robot, Project project, List<String> warnings) throws ProjectException {
        object = robot;
        dynamics = dynamics(robot);
        components(project, warnings);
        boolean bare = solids.isEmpty();
        if (bare) {
            add(bareBody(), Pose.IDENTITY, true, 1);
        }
        radius = reach();
        MassProperties masses = masses();
        double[] centroid = masses.centre();
        double[] centre = CentreOfMass.place(centroid, weighed(), robot.getWheels());
        springs = SpringDesign.of(dynamics, robot.getWheels(), centre, lowest());
        for (Wheel wheel : robot.getWheels()) {
            Solid solid = Solids.of(wheel, project, warnings);
            wheelSolids.add(solid);
            shapes.put(wheel, solid);
            Pose at = Pose.ofDegrees(wheel.getX(), wheel.getY(), wheel.getZ(), 0, wheel.getRy(), 0);
            add(RoundSolid.wheel(solid.halfX * Obstacle.GUARD, solid.halfY), at, false, 0);
        }
        Pose[] all = new Pose[solids.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = places.get(i).times(solids.get(i).offset);
        }
        Pose start = StartPose.of(robot, dynamics, warnings);
        body = new Body(robot.getName(), masses.withCentre(centre).withMass(dynamics.getMass()), solids, all, start);
        body.setRobot();
        hasFarWheels = UnitMistakes.report(robot, shapes, warnings);
        stability = new Stability(centre, feet(), Math.hypot(centre[0] - centroid[0], centre[2] - centroid[2])
            > MIN_MOVE);
    }

    /**
     * @param warnings takes warnings for the user
     * @throws ProjectException if it can't be a robot of a world
     */
    public static RobotBuilder of(SEARrobot robot, Project project, List<String> warnings) throws ProjectException {
        return new RobotBuilder(robot, project, warnings);
    }

    private static Dynamics dynamics(SEARrobot robot) throws ProjectException {
        for (SearObject part : robot.getComponents()) {
            if (part instanceof Dynamics) {
                return (Dynamics) part;
            }
        }
        throw new ProjectException(Collections.singletonList(
            new Problem("robot/" + robot.getName() + ".xml", 0, "", "robot " + robot.getName()
            + " has no Dynamics", "one Dynamics: robot.addComponent(Dynamics(name, mass)) gives it mass, suspension "
                + "and start pose")));
    }

    /** Returns the index of a component's solid in the body. */
    int solidOf(SearObject part) {
        return solids.indexOf(shapes.get(part));
    }

    private void components(Project project, List<String> warnings) throws ProjectException {
        for (SearObject part : object.getComponents()) {
            Solid solid = Solids.of(part, project, warnings);
            if (solid != null) {
                shapes.put(part, solid);
                add(solid, ObjectPose.of(part), ((Shape) part).isVisibleToSensors(), weight((Shape) part, solid));
            }
        }
    }

    /** Masses determine the distribution if there are any, otherwise volumes do. */
    private double weight(Shape part, Solid solid) {
        return isWeighed() ? part.getMass() : solid.volume();
    }

    private boolean isWeighed() {
        return weighed() > 0;
    }

    private long weighed() {
        return object.getComponents().stream()
            .filter(part -> part instanceof Shape && ((Shape) part).getMass() > 0).count();
    }

    private void add(Solid solid, Pose place, boolean seen, double weight) {
        solids.add(solid);
        places.add(place);
        visible.add(seen);
        weights.add(weight);
    }

    /**
     * Returns the contact points of its wheels when it stands level, casters as when it drives forward: {x, y, z} in
     * the body frame.
     */
    public double[][] feet() {
        double[][] feet = new double[springs.length][];
        for (int i = 0; i < feet.length; i++) {
            Wheel wheel = object.getWheels().get(i);
            feet[i] = new double[] {CentreOfMass.footX(wheel), wheel.getY() - springs[i].hangs
                - wheel.getRadius() * wheel.getScaleY(),
                CentreOfMass.footZ(wheel)};
        }
        return feet;
    }

    private Solid bareBody() {
        double halfX = BARE;
        double halfZ = BARE;
        for (Wheel wheel : object.getWheels()) {
            halfX = Math.max(halfX, Math.abs(wheel.getX()));
            halfZ = Math.max(halfZ, Math.abs(wheel.getZ()));
        }
        return new BoxSolid(halfX, BARE / 2, halfZ, Pose.IDENTITY);
    }

    /** Returns the mass properties of the components in the body frame, with their weights for masses. */
    private MassProperties masses() {
        List<MassProperties> parts = new ArrayList<>();
        for (int i = 0; i < solids.size(); i++) {
            Pose place = places.get(i).times(solids.get(i).offset);
            parts.add(solids.get(i).perKilogram().withMass(weights.get(i)).inParent(place));
        }
        return MassProperties.sum(parts);
    }

    /** Returns y of the lowest point of the components in the body frame, metres. */
    private double lowest() {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < solids.size(); i++) {
            Pose place = places.get(i).times(solids.get(i).offset);
            double[] down = place.rotateBack(0, -1, 0);
            double[] point = solids.get(i).farthest(down[0], down[1], down[2]);
            lowest = Math.min(lowest, place.transform(point[0], point[1], point[2])[1]);
        }
        return lowest;
    }

    private double reach() {
        double most = 0;
        for (int i = 0; i < solids.size(); i++) {
            Solid solid = solids.get(i);
            Pose place = places.get(i).times(solid.offset);
            most = Math.max(most, Math.hypot(place.x, place.z) + Math.max(solid.halfX, solid.halfZ));
        }
        return most;
    }

    /** Adds the components to the scenes, invisible to the robot's own rays. The wheels' guards are not added. */
    public void addTo(RaycastScenes scenes, int owner) {
        body.addTo(scenes, visible, owner, solids.size() - wheelSolids.size());
    }
}
