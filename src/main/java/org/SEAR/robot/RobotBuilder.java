// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Inertia;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.RobotBodies;
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
    /** Smallest share of a robot's mass that its links leave to the rest. */
    private static final double MIN_SHARE = 0.01;

    final SEARrobot object;
    final Dynamics dynamics;
    final List<Solid> wheelSolids = new ArrayList<>();
    public final Body body;
    /** Parts that servos and joints move, as bodies of their own; each after those that carry it. */
    public final List<RobotLink> links;
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
        links = RobotLink.of(robot, shapes);
        MassProperties masses = links.isEmpty() ? masses(solids, weights) : baseMasses(warnings);
        double[] centroid = masses.centre();
        double[] placed = CentreOfMass.place(centroid, weighed(), robot.getWheels());
        MassProperties own = dynamics.getInertia() != null ? stated(links.isEmpty() ? dynamics.getMass() : masses.mass)
            : masses.withCentre(placed).withMass(links.isEmpty() ? dynamics.getMass() : masses.mass);
        double[] centre = whole(own).centre();
        springs = SpringDesign.of(dynamics, robot.getWheels(), centre, lowest(), project.getGravity());
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
        Body whole = new Body(robot.getName(), whole(own), solids, all, start);
        body = divide(whole, own);
        hasFarWheels = UnitMistakes.report(robot, shapes, warnings);
        stability = new Stability(centre, feet(), Math.hypot(placed[0] - centroid[0], placed[2] - centroid[2])
            > MIN_MOVE, project.getGravity());
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

    private MassProperties stated(double mass) {
        Inertia of = dynamics.getInertia();
        return new MassProperties(mass, new double[] {of.getX(), of.getY(), of.getZ()},
            new InertiaTensor(of.getXx(), of.getYy(), of.getZz(), of.getXy(), of.getXz(), of.getYz()));
    }

    /** Returns the body of the parts that nothing moves, and makes those of the links. */
    private Body divide(Body whole, MassProperties own) {
        List<Solid> rest = new ArrayList<>(solids);
        links.forEach(link -> rest.removeAll(link.solids));
        Body base = links.isEmpty() ? whole : new Body(whole.name, own, rest, places(rest, whole), whole.getStart());
        RobotBodies bodies = new RobotBodies(base);
        bodies.setWhole(whole);
        bodies.setMachine(object.getMachine());
        links.forEach(link -> bodies.addLink(link.make(base, places(link.solids, whole))));
        return base;
    }

    private Pose[] places(List<Solid> of, Body whole) {
        return of.stream().map(solid -> whole.places[solids.indexOf(solid)]).toArray(Pose[]::new);
    }

    private MassProperties whole(MassProperties own) {
        List<MassProperties> parts = new ArrayList<>(List.of(own));
        links.forEach(link -> parts.add(link.masses));
        return links.isEmpty() ? own : MassProperties.sum(parts);
    }

    /**
     * Returns the mass properties of the parts that nothing moves: what the mass of Dynamics leaves to them, or all of
     * it if the links weigh as much.
     */
    private MassProperties baseMasses(List<String> warnings) {
        List<Solid> own = new ArrayList<>(solids);
        links.forEach(link -> own.removeAll(link.solids));
        if (own.isEmpty()) {
            add(bareBody(), Pose.IDENTITY, true, 1);
            own.add(solids.get(solids.size() - 1));
        }
        boolean weighs = own.stream().anyMatch(solid -> weights.get(solids.indexOf(solid)) > 0);
        List<Double> shares = new ArrayList<>();
        own.forEach(solid -> shares.add(weighs ? weights.get(solids.indexOf(solid)) : solid.volume()));
        double turned = links.stream().mapToDouble(link -> link.masses.mass).sum();
        double left = dynamics.getMass() - turned;
        if (left < MIN_SHARE * dynamics.getMass()) {
            left = dynamics.getMass();
            warnings.add(String.format(Locale.ROOT, "robot %s weighs %s kg in all: its moving parts weigh %s kg,"
                + " and the mass of its Dynamics, %s kg, should include them", object.getName(),
                Parameter.format(turned + left), Parameter.format(turned), Parameter.format(left)));
        }
        return masses(own, shares).withMass(left);
    }

    /** Returns the body of a shape. */
    public Body bodyOf(SearObject shape) {
        return links.stream().filter(link -> link.solids.contains(shapes.get(shape))).map(RobotLink::getBody)
            .findFirst().orElse(body);
    }

    /** Returns the index of a component's solid in the whole body. */
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
    private MassProperties masses(List<Solid> of, List<Double> shares) {
        List<MassProperties> parts = new ArrayList<>();
        for (int i = 0; i < of.size(); i++) {
            Solid solid = of.get(i);
            Pose place = places.get(solids.indexOf(solid)).times(solid.offset);
            parts.add(solid.perKilogram().withMass(shares.get(i)).inParent(place));
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
        addTo(scenes, owner, body, body.solids.size() - wheelSolids.size());
        links.forEach(link -> addTo(scenes, owner, link.getBody(), link.solids.size()));
    }

    private void addTo(RaycastScenes scenes, int owner, Body of, int count) {
        List<Boolean> seen = new ArrayList<>();
        of.solids.forEach(solid -> seen.add(visible.get(solids.indexOf(solid))));
        of.addTo(scenes, seen, owner, count);
    }
}
