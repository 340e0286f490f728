// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.BallJoint;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.GuidedJoint;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Inertia;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Slider;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;

/**
 * Makes objects from a URDF: a robot for each rigid body, which unites links that fixed joints connect, and a joint for
 * each other joint. A robot's frame is that of its first link. One use, one thread.
 */
public final class UrdfImport {
    private static final String ENDING = ".xml";
    private static final double ROUNDING = 1e-12;
    private static final double SMALLEST_MASS = 0.001;
    private static final double STRONGEST = 1e9;
    private static final int LONGEST_NAME = 60;

    private final UrdfSource source;
    private final UrdfFile urdf;
    private final String name;
    private final UrdfNotes notes;
    private final UrdfShapes shapes;
    private final UrdfMeshes meshes;
    private final Set<String> names = new HashSet<>();
    private final Map<UrdfFile.UrdfJoint, Double> positions = new HashMap<>();
    /** Pose of each link in the world, and in the body that it belongs to. */
    private final Map<UrdfFile.Link, Pose> places = new HashMap<>();
    private final Map<UrdfFile.Link, Pose> inBody = new HashMap<>();
    private final Map<UrdfFile.Link, UrdfFile.Link> bodies = new LinkedHashMap<>();
    private final Map<UrdfFile.Link, SEARrobot> made = new HashMap<>();
    private final Map<UrdfFile.UrdfJoint, String> jointNames = new HashMap<>();
    private final Map<UrdfFile.UrdfJoint, GuidedJoint> guided = new HashMap<>();

    private UrdfImport(UrdfSource source, Path project, Map<String, Double> given) throws IOException {
        this.source = source;
        Path file = source.getFile();
        FileLimits.range(source.getName(), "the size in bytes", Files.size(file), 1, UrdfReader.MAX_FILE);
        urdf = new UrdfFile(source.getName(), Files.readAllBytes(file));
        notes = urdf.notes;
        addNamesOf(project.resolve(ProjectFolder.ENVIRONMENT));
        addNamesOf(project.resolve(ProjectFolder.ROBOT));
        name = unique(legal(urdf.name));
        for (UrdfFile.UrdfJoint joint : urdf.joints.values()) {
            if (!joint.type.equals("fixed")) {
                jointNames.put(joint, unique(name + " " + legal(joint.name)));
            }
        }
        meshes = new UrdfMeshes(file, source.getWithin(), project, name, notes);
        shapes = new UrdfShapes(meshes, notes, this::unused);
        start(given);
    }

    /**
     * Adds the robot of a file to the project of the calling thread.
     *
     * @param file a URDF, a zip file that contains one, or a URDF in a zip file: {@code robots.zip/arm/arm.urdf}
     * @param project its folder
     * @param place of the base in the world; null for the world's origin, lifted onto the ground if the base moves
     * @param fixed whether the base is fixed to the world
     * @param positions of joints at the start by name, degrees or metres; of others 0, or the nearest legal one
     * @param notes receives what SEAR leaves out or changes, with lines
     * @return name of the robot's base
     * @throws IOException with the file, the line, the value and the legal values; the project stays unchanged
     */
    public static String add(Path file, Path project, Pose place, boolean fixed, Map<String, Double> positions,
        List<String> notes) throws IOException {
        try (UrdfSource source = UrdfSource.of(file)) {
            UrdfImport made = new UrdfImport(source, project, positions);
            boolean done = false;
            try {
                Assembly.whole(() -> {
                    made.make(place, fixed);
                    return made.name;
                });
                done = true;
            } catch (UncheckedIOException e) {
                throw e.getCause();
            } finally {
                if (!done) {
                    made.meshes.undo();
                }
            }
            notes.addAll(made.notes.all());
            return made.name;
        }
    }

    /** Returns whether a file is a URDF, or a zip file that contains one. */
    public static boolean isRobot(Path file) throws IOException, ProjectException {
        String lower = file.toString().toLowerCase(Locale.ROOT);
        return lower.endsWith(".urdf") || lower.endsWith(".zip") && Bundle.hasFile(file, ".urdf");
    }

    /** Adds the names of all objects and parts below a folder, which are those of their files. */
    private void addNamesOf(Path folder) throws IOException {
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                files.map(file -> file.getFileName().toString().toLowerCase(Locale.ROOT))
                    .filter(file -> file.endsWith(ENDING))
                    .forEach(file -> names.add(file.substring(0, file.length() - ENDING.length())));
            }
        }
    }

    private String unique(String wanted) throws IOException {
        String free = wanted;
        for (int i = 2; names.contains(free.toLowerCase(Locale.ROOT)) || Assembly.replaces(free); i++) {
            free = wanted + "_" + i;
        }
        names.add(free.toLowerCase(Locale.ROOT));
        return free;
    }

    /** Returns a name for objects and files. */
    static String legal(String text) {
        String made = text.replaceAll("[/\\\\:*?\"<>|\\p{Cntrl}]", "_").replaceAll("^[. ]+|[. ]+$", "");
        int from = Math.max(0, made.length() - LONGEST_NAME);
        return made.isEmpty() ? "part" : made.substring(from).replaceAll("^[. ]+", "");
    }

    private String unused(String wanted) {
        try {
            return unique(wanted);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Sets the joints' positions at the start, radians or metres. */
    private void start(Map<String, Double> given) throws IOException {
        for (Map.Entry<String, Double> wanted : given.entrySet()) {
            UrdfFile.UrdfJoint joint = urdf.joints.get(wanted.getKey());
            if (joint == null || !joint.hasAxis()) {
                Set<String> legal = new TreeSet<>(urdf.joints.keySet());
                legal.removeIf(each -> !urdf.joints.get(each).hasAxis());
                throw FileLimits.wrong(source.getName(), "the position of joint " + wanted.getKey(),
                    wanted.getValue(),
                    "positions of its joints " + String.join(", ", legal));
            }
        }
        for (UrdfFile.UrdfJoint joint : urdf.joints.values()) {
            if (joint.hasAxis()) {
                position(joint, given);
            }
        }
    }

    private double position(UrdfFile.UrdfJoint joint, Map<String, Double> given) throws IOException {
        if (positions.containsKey(joint)) {
            return positions.get(joint);
        }
        double position;
        if (joint.mimics != null) {
            position = joint.multiplier * position(joint.mimics, given) + joint.offset;
        } else if (given.containsKey(joint.name)) {
            double wanted = given.get(joint.name);
            position = joint.isSlider() ? wanted : Math.toRadians(wanted);
            if (!(Math.abs(position) <= 1e4) || joint.lower != null && position < joint.lower - 1e-9
                || joint.upper != null && position > joint.upper + 1e-9) {
                throw FileLimits.wrong(source.getName(), "the position of joint " + joint.name, wanted,
                    inUnits(joint, joint.lower) + " to " + inUnits(joint, joint.upper));
            }
        } else {
            position = Math.max(joint.lower == null ? 0 : joint.lower, Math.min(joint.upper == null ? 0 : joint.upper,
                0));
            if (position != 0) {
                notes.add(String.format(Locale.ROOT, "0 is no position of joint %s, which starts at %s", joint.name,
                    inUnits(joint, position)), joint.line);
            }
        }
        positions.put(joint, position);
        return position;
    }

    private static String inUnits(UrdfFile.UrdfJoint joint, Double value) {
        return value == null ? "any" : String.format(Locale.ROOT, "%.6g %s", joint.isSlider() ? value
            : Math.toDegrees(value), joint.isSlider() ? "m" : "degrees");
    }

    private void make(Pose place, boolean fixed) {
        Pose at = place == null ? Pose.IDENTITY : place;
        place(at);
        boolean held = fixed || mass(urdf.root) == 0;
        for (UrdfFile.Link link : bodies.keySet()) {
            shapes.prepare(link);
        }
        double lowest = bodies.keySet().stream().mapToDouble(link -> shapes.lowest(link, places.get(link))).min()
            .orElse(Double.POSITIVE_INFINITY);
        if (place == null && !held && lowest < Double.POSITIVE_INFINITY) {
            place(new Pose(0, -lowest, 0, 0, 0, 0, 1));
        }
        for (UrdfFile.Link link : urdf.links.values()) {
            if (bodies.get(link) == link) {
                body(link);
            }
        }
        SEARrobot base = made.get(urdf.root);
        if (base != null && held) {
            new FixedJoint(unused(name + " base"), null, base, at.x, at.y, at.z);
        }
        urdf.joints.values().forEach(this::join);
        for (UrdfFile.UrdfJoint joint : urdf.joints.values()) {
            if (joint.mimics != null) {
                guided.get(joint).setGear(guided.get(joint.mimics), joint.multiplier * unit(joint)
                    / unit(joint.mimics));
            }
        }
    }

    private static double unit(UrdfFile.UrdfJoint joint) {
        return joint.isSlider() ? 1 : Math.toDegrees(1);
    }

    /** Places all links, parents first. */
    private void place(Pose root) {
        List<UrdfFile.Link> next = new ArrayList<>(List.of(urdf.root));
        places.put(urdf.root, root);
        for (int i = 0; i < next.size(); i++) {
            UrdfFile.Link link = next.get(i);
            boolean own = link.parent == null || !link.parent.type.equals("fixed");
            bodies.put(link, own ? link : bodies.get(link.parent.parent));
            inBody.put(link, own ? Pose.IDENTITY : inBody.get(link.parent.parent).times(link.parent.origin));
            for (UrdfFile.UrdfJoint joint : link.joints) {
                places.put(joint.child, places.get(link).times(joint.origin).times(moved(joint)));
                next.add(joint.child);
            }
        }
    }

    /** Returns the displacement of a joint's link from position 0. */
    private Pose moved(UrdfFile.UrdfJoint joint) {
        double position = positions.getOrDefault(joint, 0.0);
        double[] a = joint.axis;
        double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
        if (position == 0) {
            return Pose.IDENTITY;
        }
        double by = (joint.isSlider() ? position : Math.sin(position / 2)) / length;
        return joint.isSlider() ? new Pose(by * a[0], by * a[1], by * a[2], 0, 0, 0, 1)
            : new Pose(0, 0, 0, by * a[0], by * a[1], by * a[2], Math.cos(position / 2));
    }

    private double mass(UrdfFile.Link body) {
        return bodies.keySet().stream().filter(link -> bodies.get(link) == body).mapToDouble(link -> link.mass).sum();
    }

    private void body(UrdfFile.Link body) {
        List<UrdfFile.Link> links = new ArrayList<>(bodies.keySet());
        links.removeIf(link -> bodies.get(link) != body);
        double mass = mass(body);
        boolean isBase = body == urdf.root;
        if (isBase && mass == 0 && links.stream().allMatch(shapes::isBare)) {
            return;     // the world
        }
        SEARrobot robot = UrdfShapes.put(new SEARrobot(isBase ? name : unused(name + " " + legal(body.name))),
            places.get(body));
        robot.setMachine(name);
        made.put(body, robot);
        if (mass < SMALLEST_MASS && isBase) {
            notes.add("the base has no mass: it is fixed to the world", body.line);
        } else if (mass < SMALLEST_MASS) {
            notes.add("a moving link has less than " + SMALLEST_MASS + " kg: it has " + SMALLEST_MASS + " kg",
                body.line);
        }
        Dynamics dynamics = new Dynamics(unused(robot.getName() + " mass"), mass >= SMALLEST_MASS ? mass
            : isBase ? 1 : SMALLEST_MASS);
        if (mass >= SMALLEST_MASS) {
            inertia(dynamics, links, mass);
        }
        robot.addComponent(dynamics);
        for (UrdfFile.Link link : links) {
            shapes.add(robot, link, inBody.get(link));
        }
    }

    private void inertia(Dynamics dynamics, List<UrdfFile.Link> links, double mass) {
        double[] centre = new double[3];
        for (UrdfFile.Link link : links) {
            Pose at = inBody.get(link).times(link.centre);
            centre[0] += link.mass * at.x / mass;
            centre[1] += link.mass * at.y / mass;
            centre[2] += link.mass * at.z / mass;
        }
        InertiaTensor sum = InertiaTensor.ZERO;
        for (UrdfFile.Link link : links) {
            Pose at = inBody.get(link).times(link.centre);
            sum = sum.plus(link.inertia.inParent(at).displaced(link.mass, at.x - centre[0], at.y - centre[1],
                at.z - centre[2]));
        }
        try {
            double least = ROUNDING * Math.max(sum.xx, Math.max(sum.yy, sum.zz));
            dynamics.setInertia(new Inertia(UrdfShapes.clean(centre[0], ROUNDING),
                UrdfShapes.clean(centre[1], ROUNDING), UrdfShapes.clean(centre[2], ROUNDING), sum.xx, sum.yy, sum.zz,
                UrdfShapes.clean(sum.xy, least), UrdfShapes.clean(sum.xz, least), UrdfShapes.clean(sum.yz, least)));
        } catch (IllegalArgumentException e) {
            notes.add("an inertia without positive principal moments is left out: that of the shapes counts",
                links.get(0).line);
        }
    }

    private void join(UrdfFile.UrdfJoint joint) {
        if (joint.type.equals("fixed") || joint.type.equals("floating")) {
            return;
        }
        SEARrobot first = made.get(bodies.get(joint.parent));
        SEARrobot second = made.get(joint.child);
        Pose at = places.get(joint.child);
        String own = jointNames.get(joint);
        if (joint.type.equals("spherical")) {
            new BallJoint(own, first, second, at.x, at.y, at.z);
            return;
        }
        double[] turn = along(at.rotate(joint.axis[0], joint.axis[1], joint.axis[2])).degrees();
        boolean slides = joint.isSlider();
        double unit = unit(joint);
        GuidedJoint guide = slides ? new Slider(own, first, second, at.x, at.y, at.z, turn[0], turn[1], turn[2])
            : new Hinge(own, first, second, at.x, at.y, at.z, turn[0], turn[1], turn[2]);
        guided.put(joint, guide);
        if (positions.get(joint) != 0) {
            guide.setStart(unit * positions.get(joint));
        }
        if (joint.lower != null || joint.upper != null) {
            double most = 1e6;
            guide.setLimits(joint.lower == null ? -most : unit * joint.lower, joint.upper == null ? most
                : unit * joint.upper);
        }
        if (joint.damping > 0) {
            guide.setDamping(joint.damping);
        }
        if (joint.friction > 0) {
            guide.setFriction(joint.friction);
        }
        if (joint.effort > 0 && joint.velocity > 0 && joint.mimics == null) {
            guide.setMotor(Math.min(STRONGEST, joint.effort), Math.min(STRONGEST, unit * joint.velocity));
        }
    }

    /** Returns a pose whose y axis has a direction. */
    private static Pose along(double[] axis) {
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        double x = axis[0] / length;
        double y = axis[1] / length;
        double z = axis[2] / length;
        double w = Math.sqrt(Math.max(0, (1 + y) / 2));
        return w < 1e-6 ? new Pose(0, 0, 0, 1, 0, 0, 0) : new Pose(0, 0, 0, z / 2 / w, 0, -x / 2 / w, w);
    }
}
