package org.SEAR.simulator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.RobotBuilder;
import org.SEAR.robot.RobotModel;

/** Things of the environment and robots that are put elsewhere while the world runs. Simulation thread. */
final class Teleports {
    /** So many moves are remembered, to be taken back; as many as edits. */
    private static final int MOST = 500;
    /** Places nearer than this are the same, metres. */
    private static final double SAME = 1e-4;
    /** A robot is put onto what is at most so much higher than it stands, else below it, metres. */
    private static final double CLIMB = 0.5;

    private final World world;
    private final Map<String, Body> things = new HashMap<>();
    private final Map<String, RobotModel> robots = new HashMap<>();
    private final Deque<Move> done = new ArrayDeque<>();

    /** What was moved, and where it started and stood before. */
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

    Teleports(World world) {
        this.world = world;
        world.getEnvironment().stream().filter(body -> body != null).forEach(body -> things.put(body.name, body));
        world.getRobots().forEach(robot -> robots.put(robot.getObject().getName(), robot));
    }

    /** Everything is back at its start: nothing can be taken back. */
    void restart() {
        done.clear();
    }

    /** The body of a thing or robot; null if there is none of that name. */
    Body body(String name) {
        return robots.containsKey(name) ? robots.get(name).getBody() : things.get(name);
    }

    /**
     * Where something starts in a newer state of the project, lifted out of all that stands there now.
     *
     * @return null if this world doesn't have it
     * @throws ProjectException if it has no place there
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
            fresh = builder.body;
            places.setDownRobot((SEARrobot) object, fresh, builder.feet());
        } else {
            fresh = World.body(object, now, new ArrayList<>());
            places.setDown((PlacedObject) object, fresh);
        }
        places.end();
        if (!body.isFixed()) {
            List<Body> others = new ArrayList<>(world.getPhysics().getBodies());
            others.remove(body);
            StartPoses.liftOut(fresh, others);
        }
        return fresh.getStart();
    }

    private static SearObject named(List<? extends SearObject> objects, String name) {
        return objects.stream().filter(object -> object.getName().equals(name)).findFirst().orElse(null);
    }

    /** Remembers where something stands, before it is moved. */
    void remember(String name) {
        Body body = body(name);
        done.add(new Move(name, body.getStart(), body.getPose()));
        if (done.size() > MOST) {
            done.remove();
        }
    }

    /**
     * Where something stood before it was moved away from a start, which is forgotten, and what came after it.
     *
     * @return the start itself if nobody has moved it from there
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

    /** Puts it elsewhere, at rest, and says where it starts from then on. */
    void move(String name, Pose start, Pose to) {
        if (robots.containsKey(name)) {
            robots.get(name).move(world.getPhysics(), start, to);
        } else {
            Body body = body(name);
            world.getPhysics().move(body, start, to);
            body.mirror(world.getScenes());
        }
    }

    /** Says what the file of a robot that was moved says now. */
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
