// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;

/**
 * A robot in URDF (ROS, "XML Robot Description Format"): links and joints. Frames have SEAR's axes: URDF's x, which
 * points ahead, is z; its y is x; its z is y. One use, one thread.
 */
final class UrdfFile {
    private static final int MAX_PARTS = 1000;
    private static final double FAR = 10_000;
    private static final double HEAVY = 1e6;
    private static final double LARGE_TENSOR = 1e9;
    private static final double STRONG = 1e9;
    /** Joint limits beyond are none, radians or metres. */
    private static final double UNLIMITED = 1e4;
    private static final double MOST = Double.MAX_VALUE;
    private static final double TURNS = 1e4;

    /** A shape of a link. */
    static final class Form {
        int line;
        Pose place;
        /** box, cylinder, sphere, capsule or mesh. */
        String kind;
        /** Box: x, y, z of URDF; cylinder and capsule: radius, length; sphere: radius; mesh: scale. */
        double[] size;
        String mesh;
        double[] color;
    }

    /** A link. */
    static final class Link {
        final String name;
        final int line;
        double mass;
        Pose centre = Pose.IDENTITY;
        InertiaTensor inertia = InertiaTensor.ZERO;
        final List<Form> collisions = new ArrayList<>();
        final List<Form> visuals = new ArrayList<>();
        /** Coefficients; null for the defaults. */
        Double friction;
        Double rollingFriction;
        Double restitution;
        UrdfJoint parent;
        final List<UrdfJoint> joints = new ArrayList<>();

        Link(String name, int line) {
            this.name = name;
            this.line = line;
        }
    }

    /** A joint. */
    static final class UrdfJoint {
        String name;
        int line;
        String type;
        Link parent;
        Link child;
        Pose origin;
        double[] axis;
        /** Limits, radians or metres; null for none. */
        Double lower;
        Double upper;
        double effort;
        double velocity;
        double damping;
        double friction;
        /** Joint whose position it follows; null for none. */
        UrdfJoint mimics;
        double multiplier;
        double offset;

        boolean isSlider() {
            return type.equals("prismatic");
        }

        boolean hasAxis() {
            return type.equals("revolute") || type.equals("continuous") || isSlider();
        }
    }

    final Map<String, Link> links = new LinkedHashMap<>();
    final Map<String, UrdfJoint> joints = new LinkedHashMap<>();
    final UrdfNotes notes = new UrdfNotes();
    String name;
    Link root;
    private final String file;
    private final Map<String, double[]> colors = new HashMap<>();

    /** @param file its name in errors */
    UrdfFile(String file, byte[] bytes) throws IOException {
        this.file = file;
        UrdfElement robot = UrdfReader.read(file, bytes);
        if (!robot.tag.equals("robot")) {
            throw FileLimits.wrong(file, "the root element", "<" + robot.tag + ">", "<robot> of a URDF"
                + UrdfElement.EXPAND);
        }
        for (UrdfElement each : robot.children()) {
            if (each.tag.startsWith("xacro:")) {
                throw FileLimits.wrong(file, "line " + each.line, "<" + each.tag + ">", "a URDF" + UrdfElement.EXPAND);
            }
        }
        name = robot.text("name").isEmpty() ? "robot" : robot.text("name");
        for (UrdfElement each : robot.children("material")) {
            color(each);
        }
        List<UrdfElement> parts = robot.children("link");
        FileLimits.range(file, "the number of links", parts.size(), 1, MAX_PARTS);
        for (UrdfElement each : parts) {
            link(each);
        }
        for (UrdfElement each : robot.children("joint")) {
            joint(each);
        }
        for (UrdfElement each : robot.children("joint")) {
            mimic(each);
        }
        checkTree();
        checkMimics();
        robot.noteRest(notes);
    }

    /** Returns the pose of an origin, in SEAR's axes. */
    private Pose origin(UrdfElement of) throws IOException {
        UrdfElement origin = of.child("origin");
        double[] p = {0, 0, 0};
        double[] a = p;
        if (origin != null) {
            p = origin.numbers("xyz", notes, FAR, 0, 0, 0);
            a = origin.numbers("rpy", notes, TURNS, 0, 0, 0);
        }
        double cr = Math.cos(a[0] / 2);
        double sr = Math.sin(a[0] / 2);
        double cp = Math.cos(a[1] / 2);
        double sp = Math.sin(a[1] / 2);
        double cy = Math.cos(a[2] / 2);
        double sy = Math.sin(a[2] / 2);
        return new Pose(p[1], p[2], p[0], cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy,
            sr * cp * cy - cr * sp * sy, cr * cp * cy + sr * sp * sy);
    }

    private double[] color(UrdfElement material) throws IOException {
        UrdfElement color = material.child("color");
        if (color != null) {
            colors.put(material.text("name"), color.numbers("rgba", notes, MOST, 1, 1, 1, 1));
        }
        return colors.get(material.text("name"));
    }

    private void link(UrdfElement of) throws IOException {
        Link link = new Link(of.text("name"), of.line);
        if (links.putIfAbsent(link.name, link) != null) {
            throw of.wrong("name", link.name, "a name that no other link has");
        }
        UrdfElement inertial = of.child("inertial");
        if (inertial != null) {
            UrdfElement mass = inertial.child("mass");
            link.mass = mass == null ? 0 : mass.number("value", 0, 0, HEAVY);
            link.centre = origin(inertial);
            UrdfElement tensor = inertial.child("inertia");
            link.inertia = tensor == null ? InertiaTensor.ZERO : new InertiaTensor(moment(tensor, "iyy"),
                moment(tensor, "izz"), moment(tensor, "ixx"), moment(tensor, "iyz"), moment(tensor, "ixy"),
                moment(tensor, "ixz"));
        }
        for (UrdfElement each : of.children("collision")) {
            add(link.collisions, each);
        }
        for (UrdfElement each : of.children("visual")) {
            add(link.visuals, each);
        }
        UrdfElement contact = of.child("contact");
        if (contact != null) {
            link.friction = coefficient(contact, "lateral_friction", 10);
            link.rollingFriction = coefficient(contact, "rolling_friction", 1);
            link.restitution = coefficient(contact, "restitution", 1);
        }
    }

    private static double moment(UrdfElement of, String element) throws IOException {
        return of.number(element, 0, -LARGE_TENSOR, LARGE_TENSOR);
    }

    private static Double coefficient(UrdfElement contact, String tag, double most) throws IOException {
        UrdfElement of = contact.child(tag);
        return of == null || !of.has("value") ? null : Double.valueOf(of.number("value", 0, 0, most));
    }

    private void add(List<Form> to, UrdfElement of) throws IOException {
        UrdfElement geometry = of.child("geometry");
        UrdfElement shape = geometry == null || geometry.children().isEmpty() ? null : geometry.children().get(0);
        Form form = new Form();
        form.line = of.line;
        form.place = origin(of);
        UrdfElement material = of.child("material");
        form.color = material == null ? null : color(material);
        form.kind = shape == null ? "" : shape.tag;
        switch (form.kind) {
            case "box":
                form.size = shape.take().numbers("size", notes, FAR, 0, 0, 0);
                break;
            case "cylinder":
            case "capsule":
                form.size = new double[] {shape.take().number("radius", 0, 0, FAR), shape.number("length", 0, 0, FAR)};
                break;
            case "sphere":
                form.size = new double[] {shape.take().number("radius", 0, 0, FAR)};
                break;
            case "mesh":
                form.size = scale(shape.take());
                form.mesh = shape.text("filename");
                break;
            default:
                notes.add("<" + of.tag + "> of " + of.owner() + " has no box, cylinder, sphere, capsule or mesh and is "
                    + "left out", of.line);
                return;
        }
        to.add(form);
    }

    private double[] scale(UrdfElement mesh) throws IOException {
        if (mesh.has("scale") && !mesh.text("scale").matches(".*[\\s,].*")) {
            double all = mesh.number("scale", 1, -FAR, FAR);
            return new double[] {all, all, all};
        }
        return mesh.numbers("scale", notes, FAR, 1, 1, 1);
    }

    private Link end(UrdfElement joint, String tag) throws IOException {
        UrdfElement end = joint.child(tag);
        Link link = end == null ? null : links.get(end.text("link"));
        if (link == null) {
            throw (end == null ? joint : end).wrong(end == null ? "<" + tag + ">" : "link", end == null ? "missing"
                : end.text("link"), "the name of a link");
        }
        return link;
    }

    private void joint(UrdfElement of) throws IOException {
        UrdfJoint joint = new UrdfJoint();
        joint.name = of.text("name");
        joint.line = of.line;
        joint.type = of.text("type");
        if (!Set.of("revolute", "continuous", "prismatic", "fixed", "floating", "spherical", "planar")
            .contains(joint.type)) {
            throw of.wrong("type", joint.type, "continuous, fixed, floating, planar, prismatic, revolute or spherical");
        }
        if (joint.type.equals("planar")) {
            notes.add("a planar joint: its link moves freely", of.line);
            joint.type = "floating";
        }
        joint.parent = end(of, "parent");
        joint.child = end(of, "child");
        joint.origin = origin(of);
        UrdfElement direction = of.child("axis");
        double[] axis = direction == null ? new double[] {1, 0, 0} : direction.numbers("xyz", notes, FAR, 1, 0, 0);
        joint.axis = new double[] {axis[1], axis[2], axis[0]};
        if (Math.hypot(Math.hypot(axis[0], axis[1]), axis[2]) < 1e-9 && joint.hasAxis()) {
            throw direction.wrong("xyz", direction.text("xyz"), "a direction");
        }
        limits(joint, of.child("limit"));
        UrdfElement dynamics = of.child("dynamics");
        if (dynamics != null) {
            joint.damping = dynamics.number("damping", 0, 0, STRONG);
            joint.friction = dynamics.number("friction", 0, 0, STRONG);
        }
        if (joint.child.parent != null) {
            throw of.wrong("child", joint.child.name, "a link that no other joint moves");
        }
        if (joints.putIfAbsent(joint.name, joint) != null) {
            throw of.wrong("name", joint.name, "a name that no other joint has");
        }
        joint.child.parent = joint;
        joint.parent.joints.add(joint);
    }

    private void limits(UrdfJoint joint, UrdfElement limit) throws IOException {
        if (limit == null) {
            return;
        }
        double lower = limit.number("lower", 0, -MOST, MOST);
        double upper = limit.number("upper", 0, -MOST, MOST);
        joint.effort = limit.number("effort", 0, -MOST, MOST);
        joint.velocity = limit.number("velocity", 0, -MOST, MOST);
        boolean stated = (limit.has("lower") || limit.has("upper")) && joint.hasAxis()
            && !joint.type.equals("continuous");
        if (stated && lower > upper) {
            notes.add("lower above upper of <limit>: joint " + joint.name + " has no limits", limit.line);
        } else if (stated) {
            joint.lower = lower < -UNLIMITED ? null : Double.valueOf(lower);
            joint.upper = upper > UNLIMITED ? null : Double.valueOf(upper);
        }
    }

    private void mimic(UrdfElement of) throws IOException {
        UrdfElement mimic = of.child("mimic");
        UrdfJoint joint = joints.get(of.text("name"));
        if (mimic == null) {
            return;
        }
        UrdfJoint other = joints.get(mimic.text("joint"));
        if (other == null || other == joint) {
            throw mimic.wrong("joint", mimic.text("joint"), "the name of another joint");
        }
        if (!other.hasAxis() || !joint.hasAxis()) {
            notes.add("<mimic> of a joint that does not move, or follows one, is left out", mimic.line);
            return;
        }
        joint.multiplier = mimic.number("multiplier", 1, -STRONG, STRONG);
        joint.offset = mimic.number("offset", 0, -UNLIMITED, UNLIMITED);
        if (joint.multiplier == 0) {
            throw mimic.wrong("multiplier", 0, "any number but 0");
        }
        joint.mimics = other;
    }

    private void checkMimics() throws IOException {
        for (UrdfJoint joint : joints.values()) {
            int steps = 0;
            for (UrdfJoint at = joint.mimics; at != null; at = at.mimics) {
                if (++steps > joints.size()) {
                    throw FileLimits.wrong(file, "line " + joint.line + ": <mimic> of joint " + joint.name,
                        "a ring of joints that follow each other", "a joint that follows none of them");
                }
            }
        }
    }

    private void checkTree() throws IOException {
        for (Link link : links.values()) {
            Set<Link> seen = new HashSet<>();
            Link at = link;
            while (at.parent != null) {
                if (!seen.add(at)) {
                    throw FileLimits.wrong(file, "line " + at.line + ": link " + at.name, "its own ancestor",
                        "a tree of links");
                }
                at = at.parent.parent;
            }
            if (root != null && root != at) {
                throw FileLimits.wrong(file, "line " + at.line + ": link " + at.name, "a second link without a parent",
                    "one such link");
            }
            root = at;
        }
    }
}
