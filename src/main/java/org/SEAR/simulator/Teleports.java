// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.RobotBuilder;
import org.SEAR.robot.RobotModel;

/** Moves objects and robots to other places while the world runs. Simulation thread. */
final class Teleports {
    /** Number of remembered moves that can be undone; equal to that of edits. */
    private static final int MOST = 500;
    /** Tolerance within which two places are the same, metres. */
    private static final double SAME = 1e-4;
    /** Maximum height above a robot's present one onto which it is placed, metres; otherwise it is placed below. */
    private static final double CLIMB = 0.5;

    private final World world;
    private final Map<String, Body> things = new HashMap<>();
    private final Map<String, RobotModel> robots = new HashMap<>();
    private final Deque<Move> done = new ArrayDeque<>();
    private final WallExit exits;

    /** A moved object with its start and its pose before the move. */
    private static final class Move {
        private final String name;
        private final Pose start;
        private final Pose stood;

        Move(String name, Pose start, Pose stood) {
            this.name = name;
            this.start = start;
            this.stood = stood;
        }
    }

    /** @param reported receives warnings during the run */
    Teleports(World world, Consumer<String> reported) {
        this.world = world;
        exits = new WallExit(world, this::put, reported);
        world.getEnvironment().stream().filter(body -> body != null).forEach(body -> things.put(body.name, body));
        world.getRobots().forEach(robot -> robots.put(robot.getObject().getName(), robot));
    }

    /** Forgets all moves, as everything is at its start. */
    void restart() {
        done.clear();
    }

    /** Returns the body of an object or robot; null if the name is unknown. */
    Body body(String name) {
        return robots.containsKey(name) ? robots.get(name).getBody() : things.get(name);
    }

    /**
     * Start of an object in a newer state of the project, moved out of what stands there now.
     *
     * @return null if this world doesn't have it
     * @throws ProjectException if it has no valid place there
     */
    Pose start(String name, Project now) throws ProjectException {
        Body body = body(name);
        SearObject object = named(robots.containsKey(name) ? now.getRobots() : now.getEnvironment(), name);
        if (body == null || object == null) {
            return null;
        }
        GroundPlacement places = new GroundPlacement(now.getOrigin(), world.getScenes());
        Body fresh;
        if (object instanceof SEARrobot) {
            RobotBuilder builder = RobotBuilder.of((SEARrobot) object, now, new ArrayList<>());
            fresh = RobotBodies.whole(builder.body);
            places.setDownRobot((SEARrobot) object, fresh, builder.feet());
        } else {
            fresh = World.body(object, now, new ArrayList<>());
            places.setDown((PlacedObject) object, fresh);
        }
        places.end();
        if (!body.isFixed()) {
            List<Body> others = new ArrayList<>(world.getPhysics().getBodies());
            others.removeIf(other -> RobotBodies.base(other) == body);
            StartPoses.moveOut(fresh, others, world.getScenes().grounds());
        }
        return fresh.getStart();
    }

    private static SearObject named(List<? extends SearObject> objects, String name) {
        return objects.stream().filter(object -> object.getName().equals(name)).findFirst().orElse(null);
    }

    /** Stores the pose of an object before it is moved. */
    void remember(String name) {
        Body body = body(name);
        done.add(new Move(name, body.getStart(), body.getPose()));
        if (done.size() > MOST) {
            done.remove();
        }
    }

    /**
     * Returns the pose that an object had before it was moved away from a start. Forgets that move and later moves of
     * the object.
     *
     * @return the start itself if no move from there is stored
     */
    Pose undo(String name, Pose start) {
        Iterator<Move> moves = done.descendingIterator();
        while (moves.hasNext()) {
            Move move = moves.next();
            if (move.name.equals(name)) {
                moves.remove();
                if (isSame(move.start, start)) {
                    return move.stood;
                }
            }
        }
        return start;
    }

    private static boolean isSame(Pose a, Pose b) {
        double cosine = Math.abs(a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw);
        return Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + Math.abs(a.z - b.z) < SAME && cosine > 1 - SAME * SAME;
    }

    /**
     * Moves an object or robot, at rest, and sets its start. Objects that are then inside walls leave them. Commits the
     * scenes.
     */
    void move(String name, Pose start, Pose to) {
        put(name, start, to);
        world.getScenes().settle();
        exits.search(true);
        world.getScenes().settle();
    }

    /** Lets objects leave walls that they are inside, now and then. After a step. */
    void look() {
        exits.look();
    }

    private void put(String name, Pose start, Pose to) {
        if (robots.containsKey(name)) {
            robots.get(name).move(world.getPhysics(), start, to);
        } else {
            Body body = body(name);
            world.getPhysics().move(body, start, to);
            body.mirror(world.getScenes());
        }
    }

    /** Updates a moved robot with its definition in the newer project. */
    void write(String name, Project now) {
        if (robots.containsKey(name)) {
            robots.get(name).setWritten((SEARrobot) named(now.getRobots(), name));
        }
    }

    boolean has(String name) {
        return body(name) != null;
    }

    /** See {@link Simulation#rise}. */
    double rise(String name, Pose by) {
        RobotModel robot = robots.get(name);
        if (robot == null) {
            return 0;
        }
        Pose to = by.times(robot.getStart());
        Pose level = new Pose(to.x, robot.getPose().y, to.z, to.qx, to.qy, to.qz, to.qw);
        double height = robot.standing(level, CLIMB);
        return Double.isNaN(height) ? level.y - to.y : height - to.y;
    }
}
