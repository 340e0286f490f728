// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.vecmath.Vector3f;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.start.GroundDistanceCheck;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.physics.start.DensityCheck;
import org.SEAR.physics.start.HullCheck;
import org.SEAR.physics.start.SizeCheck;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.RobotBuilder;
import org.SEAR.robot.RobotModel;
import org.SEAR.robot.RobotTruth;
import org.SEAR.robot.StartChecks;
import org.SEAR.robot.VirtualWalls;
import org.SEAR.robot.surface.SurfaceColors;
import org.SEAR.sensors.Earth;
import org.SEAR.simulator.orders.BodyOrder;
import org.SEAR.simulator.orders.BodyOrders;
import org.SEAR.simulator.orders.DragSpring;

/** Objects of a project, environment and robots, in physics and in the ray casting scenes. Simulation thread. */
final class World implements PhysicsWorld.Touches {
    private static final int MAX_CONTACTS = 256;

    private final PhysicsWorld physics = new PhysicsWorld();
    private final Predicate<Body> awake = physics::isAwake;
    private final double startGravity;
    private final RaycastScenes scenes;
    private final List<Body> environment = new ArrayList<>();
    /** Environment bodies that are not fixed. */
    private final Body[] movable;
    private final List<RobotModel> robots = new ArrayList<>();
    /** Only looked up, never iterated: its order is not reproducible. */
    private final Map<Body, RobotModel> robotOf = new IdentityHashMap<>();
    private final List<String> warnings = new ArrayList<>();
    private final VirtualWalls virtualWalls;
    /** Solids of all objects with a shape. Only looked up, never iterated. */
    private final Map<SearObject, Solid> shapes = new IdentityHashMap<>();
    private List<Pose> poses;
    private final List<double[]> contacts = new ArrayList<>();
    private boolean wantsContacts;
    /** Measuring threads of this world; helper threads start on demand. */
    private final WorkerPool workers = new WorkerPool(WorkerPool.threadsOfMachine());
    private final KillPlane fallen;
    private final Teleports moves;
    private final BodyOrders orders = new BodyOrders();
    private final WorldJoints joints;
    /** Bodies of the shapes of robots. Only looked up, never iterated. */
    private final Map<SearObject, Body> bodies = new IdentityHashMap<>();

    /**
     * Builds the world of a project.
     *
     * @param groundVisible true: beams hit floors and terrain unless the object is invisible to sensors; false: beams
     *     hit no ground
     * @param reported receives warnings during the run
     */
    World(Project project, long seed, long epochMillis, boolean groundVisible, Consumer<String> reported)
        throws ProjectException {
        startGravity = project.getGravity();
        scenes = new RaycastScenes(!groundVisible || hasInvisible(project));
        virtualWalls = new VirtualWalls(scenes);
        SurfaceColors colors = new SurfaceColors(project.getAssets(), reported);
        for (SearObject object : project.getEnvironment()) {
            Body body = body(object, project, warnings);
            environment.add(body);
            if (body != null) {
                add((Shape) object, body, project, groundVisible, colors);
            }
        }
        environment.stream().filter(Objects::nonNull).forEach(body -> body.mirror(scenes));
        movable = environment.stream().filter(body -> body != null && !body.isFixed()).toArray(Body[]::new);
        scenes.commit();
        if (project.getGround() != null) {
            warnings.addAll(project.getGround().warnings);
        }
        GroundPlacement places = new GroundPlacement(project.getOrigin(), scenes);
        for (int i = 0; i < environment.size(); i++) {
            if (environment.get(i) != null) {
                places.setDown((PlacedObject) project.getEnvironment().get(i), environment.get(i));
            }
        }
        for (SEARrobot robot : project.getRobots()) {
            RobotBuilder builder = RobotBuilder.of(robot, project, warnings);
            places.setDownRobot(robot, RobotBodies.whole(builder.body), builder.feet());
            add(builder, Earth.of(project, robot), epochMillis, colors, reported);
        }
        places.end();
        joints = new WorldJoints(project, physics, bodies, reported);
        robots.forEach(joints::connect);
        moveOutAndCheck();
        fallen = new KillPlane(physics.getBodies(), reported);
        moves = new Teleports(this, reported);
        restart(seed);
        joints.check(project, physics, warnings);
        robots.forEach(robot -> StartChecks.check(robot, scenes, warnings));
    }

    private void add(Shape shape, Body body, Project project, boolean groundVisible, SurfaceColors colors)
        throws ProjectException {
        Solid solid = body.solids.get(0);
        shapes.put(shape, solid);
        physics.add(body);
        orders.add(shape, body);
        if (shape instanceof Terrain) {
            colors.addTerrain((Terrain) shape, solid, project.getGround());
            project.checkGroundPicture();
        } else {
            colors.add(shape, solid);
        }
        body.addTo(scenes, Collections.singletonList(shape.isVisibleToSensors()
            && (groundVisible || !shape.isGround())), -1, 1);
        if (shape.isGround()) {
            scenes.addGround(body);
        }
        virtualWalls.consider(body);
    }

    private void add(RobotBuilder builder, Earth earth, long epochMillis, SurfaceColors colors,
        Consumer<String> reported) {
        shapes.putAll(builder.shapes);
        builder.shapes.forEach((part, solid) -> colors.add((Shape) part, solid));
        builder.shapes.keySet().forEach(part -> bodies.put(part, builder.bodyOf(part)));
        builder.addTo(scenes, robots.size());
        RobotTruth truth = new RobotTruth(builder, scenes, colors, robots.size(), earth, epochMillis, workers);
        truth.setGravity(physics::getGravity);
        RobotModel model = new RobotModel(builder, robots.size(), scenes, truth, virtualWalls, reported);
        robots.add(model);
        robotOf.put(model.getBody(), model);
        model.addTo(physics);
    }

    /** Lifts bodies out of the ground, and warns of start poses, densities, hulls and sizes that are mistakes. */
    private void moveOutAndCheck() throws ProjectException {
        List<Body> bodies = RobotBodies.wholes(physics.getBodies());
        String crowd = StartPoses.crowd(bodies);
        if (crowd != null) {
            throw new ProjectException(Collections.singletonList(
                new Problem("environment", 0, "", crowd, "objects that start apart")));
        }
        StartPoses.moveOut(bodies, scenes.grounds(), warnings);
        StartPoses.reportOverlaps(bodies, warnings);
        GroundDistanceCheck.report(bodies, scenes, warnings);
        DensityCheck.report(bodies, warnings);
        HullCheck.report(bodies, warnings);
        SizeCheck.report(bodies, scenes.grounds(), warnings);
    }

    /**
     * Builds only the ground of a project.
     *
     * @throws ProjectException if the ground can't be built
     */
    static RaycastScenes ground(Project project) throws ProjectException {
        RaycastScenes scenes = new RaycastScenes(false);
        List<SearObject> grounds = new ArrayList<>(project.getEnvironment());
        grounds.removeIf(object -> !(object instanceof Shape && ((Shape) object).isGround()));
        List<Body> bodies = new ArrayList<>();
        for (SearObject object : grounds) {
            Body body = body(object, project, new ArrayList<>());
            bodies.add(body);
            body.addTo(scenes, Collections.singletonList(true), -1, 1);
            scenes.addGround(body);
            body.mirror(scenes);
        }
        scenes.commit();
        GroundPlacement places = new GroundPlacement(project.getOrigin(), scenes);
        for (int i = 0; i < bodies.size(); i++) {
            places.setDown((PlacedObject) grounds.get(i), bodies.get(i));
            bodies.get(i).mirror(scenes);
        }
        places.end();
        scenes.commit();
        return scenes;
    }

    /** See {@link Simulation#getGroundHeight}. */
    double groundHeight(double x, double z) {
        return groundHeight(scenes, x, z);
    }

    /** Height of the highest ground at a point, metres, see {@link Simulation#groundHeight}. */
    static double groundHeight(RaycastScenes scenes, double x, double z) {
        double height = scenes.groundHeight(x, z);
        if (Double.isNaN(height)) {
            throw new IllegalArgumentException("there is no ground at x " + x + ", z " + z
                + ", legal: a point of the terrain, a floor or a model"
                + " that is the terrain");
        }
        return height;
    }

    private static boolean hasInvisible(Project project) {
        List<SearObject> all = new ArrayList<>(project.getEnvironment());
        for (SEARrobot robot : project.getRobots()) {
            all.addAll(robot.getComponents());
            all.addAll(robot.getWheels());
        }
        return all.stream().anyMatch(object -> object instanceof Shape && !((Shape) object).isVisibleToSensors());
    }

    static Body body(SearObject object, Project project, List<String> warnings) throws ProjectException {
        Solid solid = Solids.of(object, project, warnings);
        if (solid == null) {
            return null;
        }
        double mass = ((Shape) object).getMass();
        MassProperties properties = mass > 0 ? solid.perKilogram().inParent(solid.offset).withMass(mass)
            : MassProperties.FIXED;
        return new Body(object.getName(), properties, Collections.singletonList(solid), new Pose[] {solid.offset},
            ObjectPose.of(object));
    }

    /**
     * Puts everything back to its start.
     *
     * @param seed chooses the errors of drives
     */
    void restart(long seed) {
        robots.forEach(RobotModel::rewind);
        physics.setGravity(startGravity);
        physics.restart();
        joints.restart();
        orders.restart();
        fallen.restart();
        moves.restart();
        for (Body body : environment) {
            if (body != null) {
                body.mirror(scenes);
            }
        }
        for (RobotModel robot : robots) {
            robot.restart(physics, seed);
            robot.mirror();
        }
        scenes.settle();
        contacts.clear();
        poses = poses();
    }

    /** Teleports an object, see {@link Teleports}. */
    void move(String name, Pose start, Pose to) {
        moves.move(name, start, to);
        orders.forget(moves.body(name));
        fallen.restart();
        poses = poses();
    }

    /**
     * Runs a command of {@link Simulation#order(BodyOrder)}.
     *
     * @throws IllegalArgumentException if no movable body has that name, or the force is too strong for it
     */
    void order(BodyOrder order) {
        if (order.kind == BodyOrder.Kind.GRAVITY) {
            physics.setGravity(0 - order.y);
            return;
        }
        orders.execute(order, moves.body(order.name));
    }

    /** See {@link Simulation#hold}. */
    void hold(DragSpring hand, String name) {
        orders.hold(hand, moves.body(name));
    }

    WorldJoints getJoints() {
        return joints;
    }

    Teleports getMoves() {
        return moves;
    }

    RaycastScenes getScenes() {
        return scenes;
    }

    /** Environment bodies in the project's order; null for an object without a shape. */
    List<Body> getEnvironment() {
        return environment;
    }

    /**
     * Physics of a step: wheels find their ground, bodies move, wheels turn, scenes follow.
     * @param reported receives the forces of drag springs
     */
    void step(Consumer<BodyOrder> reported) {
        for (int i = 0; i < robots.size(); i++) {
            robots.get(i).prepare();
        }
        orders.act(reported);
        physics.step();
        fallen.look();
        moves.look();
        joints.reportBroken();
        boolean moved = false;
        for (int i = 0; i < movable.length; i++) {
            Body body = movable[i];
            if (physics.isAwake(body)) {
                body.mirror(scenes);
                moved = true;
            }
        }
        for (int i = 0; i < robots.size(); i++) {
            RobotModel robot = robots.get(i);
            robot.follow(RobotBodies.isAny(robot.getBody(), awake));
        }
        contacts.clear();
        if (wantsContacts || !robots.isEmpty()) {
            physics.touches(this);
        }
        scenes.commit();
        if (moved) {
            poses = poses();
        }
    }

    /** Updates the ground truth after a step. */
    void observe(long step) {
        for (int i = 0; i < robots.size(); i++) {
            RobotModel robot = robots.get(i);
            robot.truth().update(step, RobotBodies.isAny(robot.getBody(), awake));
        }
    }

    @Override
    public void touch(Body a, int solidOfA, Body b, int solidOfB, Vector3f at, Vector3f normal) {
        touch(a, solidOfA, b, at, normal);
        touch(b, solidOfB, a, at, normal);
        if (wantsContacts && contacts.size() < MAX_CONTACTS) {
            contacts.add(new double[] {at.x, at.y, at.z});
        }
    }

    private void touch(Body body, int solid, Body other, Vector3f at, Vector3f normal) {
        if (body.isRobot()) {
            robotOf.get(RobotBodies.base(body)).touch(body, solid, other, at, normal);
        }
    }

    void setWantsContacts(boolean on) {
        wantsContacts = on;
    }

    private List<Pose> poses() {
        Pose[] all = new Pose[environment.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = environment.get(i) == null ? Pose.IDENTITY : environment.get(i).getPose();
        }
        return List.of(all);
    }

    /** Poses of the environment objects, in the project's order; the same list as long as nothing moves. */
    List<Pose> getPoses() {
        return poses;
    }

    /**
     * Returns mass, centre of mass and inertia tensor of an object or robot, in its own frame.
     * @throws IllegalArgumentException if nothing with a mass has this name
     */
    MassProperties getMassProperties(String name) {
        Body body = moves.body(name);
        if (body == null || body.isFixed()) {
            String reason = body == null ? "nothing with a mass is named \"" + name + "\""
                : name + " is fixed (mass 0)";
            throw new IllegalArgumentException(reason + ", legal: an object with a mass, or a robot");
        }
        return RobotBodies.whole(body).getMassProperties();
    }

    /** See {@link Solid#outline}. */
    double[][] getOutline(SearObject object) {
        return shapes.containsKey(object) ? shapes.get(object).outline() : new double[0][];
    }

    /** See {@link Solid#areas}. */
    double[][][] getAreas(SearObject object) {
        return shapes.containsKey(object) ? shapes.get(object).areas() : new double[0][][];
    }

    /** See {@link Simulation#getSurface}. */
    SurfaceMesh getSurface(Shape shape) {
        Solid solid = shapes.get(shape);
        SurfaceMesh look = solid == null ? null : Solids.look(solid, shape);
        return look == null ? null : look.placed(solid.offset);
    }

    List<double[]> getContacts() {
        return contacts.isEmpty() ? Collections.emptyList() : List.copyOf(contacts);
    }

    List<RobotModel> getRobots() {
        return robots;
    }

    /** Warnings from building the world. */
    List<String> getWarnings() {
        return warnings;
    }

    WorkerPool getWorkers() {
        return workers;
    }

    PhysicsWorld getPhysics() {
        return physics;
    }
}
