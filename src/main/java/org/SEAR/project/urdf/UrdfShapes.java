// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;

/** Makes the shapes of links. One use, one thread. */
final class UrdfShapes {
    /** Coefficient of friction of links without one. */
    private static final double FRICTION = 0.8;
    private static final double ROUNDING = 1e-12;
    /** Least extent of a shape, and scale of a mesh. */
    private static final double LEAST = 0.0001;
    private static final double LARGEST_SCALE = 10_000;
    /** From the frame of a mesh, with z up, to SEAR's axes. */
    private static final Pose MESH = new Pose(0, 0, 0, -0.5, -0.5, -0.5, 0.5);
    /** From the frame in which SEAR reads a COLLADA model with z up, to that of its file. */
    private static final Pose Z_UP = Pose.ofDegrees(0, 0, 0, 90, 0, 0);

    private final UrdfMeshes meshes;
    private final UrdfNotes notes;
    private final UnaryOperator<String> names;
    /** The shapes of each link, and the meshes among them. */
    private final Map<UrdfFile.Link, List<UrdfFile.Form>> used = new HashMap<>();
    private final Map<UrdfFile.Form, UrdfMeshes.Mesh> found = new HashMap<>();

    /** @param names returns an unused name like another */
    UrdfShapes(UrdfMeshes meshes, UrdfNotes notes, UnaryOperator<String> names) {
        this.meshes = meshes;
        this.notes = notes;
        this.names = names;
    }

    /** Selects the shapes of a link and reads its meshes. */
    void prepare(UrdfFile.Link link) {
        List<UrdfFile.Form> forms = usable(link.collisions);
        if (forms.isEmpty()) {
            forms = usable(link.visuals);
            if (!forms.isEmpty()) {
                notes.add("a link without collision shapes: its visual ones collide", link.line);
            }
        } else if (!link.visuals.isEmpty()) {
            notes.add("<visual> of a link with <collision> is left out: it shows its collision shapes", link.line);
        }
        used.put(link, forms);
    }

    private List<UrdfFile.Form> usable(List<UrdfFile.Form> forms) {
        List<UrdfFile.Form> usable = new ArrayList<>();
        for (UrdfFile.Form form : forms) {
            if (form.kind.equals("mesh") ? isMesh(form) : isThick(form)) {
                usable.add(form);
            }
        }
        return usable;
    }

    private boolean isThick(UrdfFile.Form form) {
        for (double size : form.size) {
            if (size < LEAST) {
                notes.add("a " + form.kind + " of less than " + LEAST + " m is left out", form.line);
                return false;
            }
        }
        return true;
    }

    private boolean isMesh(UrdfFile.Form form) {
        for (double scale : form.size) {
            if (Math.abs(scale) < LEAST || Math.abs(scale) > LARGEST_SCALE) {
                notes.add("a mesh with a scale of " + scale + " is left out, legal: " + LEAST + " to " + LARGEST_SCALE,
                    form.line);
                return false;
            }
            if (scale < 0) {
                notes.add("a mesh with a negative scale is not mirrored", form.line);
            }
        }
        try {
            UrdfMeshes.Mesh mesh = meshes.mesh(form.mesh, form.line);
            found.put(form, mesh);
            return mesh != null;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns whether a link has no shapes; after {@link #prepare}. */
    boolean isBare(UrdfFile.Link link) {
        return used.get(link).isEmpty();
    }

    /** Returns the height of the lowest point of a link's shapes in the world, metres; infinite without shapes. */
    double lowest(UrdfFile.Link link, Pose place) {
        double lowest = Double.POSITIVE_INFINITY;
        for (UrdfFile.Form form : used.get(link)) {
            Pose at = place.times(form.place);
            double[] up = {at.rotateBack(0, 1, 0)[0], at.rotateBack(0, 1, 0)[1], at.rotateBack(0, 1, 0)[2]};
            lowest = Math.min(lowest, at.y - (form.kind.equals("mesh") ? depth(found.get(form), scale(form), frame(form)
                .rotateBack(up[0], up[1], up[2])) : depth(form, up)));
        }
        return lowest;
    }

    /** Returns the largest distance of a shape's points below its origin, metres. */
    private static double depth(UrdfFile.Form form, double[] up) {
        double[] size = form.size;
        switch (form.kind) {
            case "box":
                return (size[1] * Math.abs(up[0]) + size[2] * Math.abs(up[1]) + size[0] * Math.abs(up[2])) / 2;
            case "sphere":
                return size[0];
            case "capsule":
                return size[0] + size[1] / 2 * Math.abs(up[1]);
            default:
                return size[0] * Math.hypot(up[0], up[2]) + size[1] / 2 * Math.abs(up[1]);
        }
    }

    private static double depth(UrdfMeshes.Mesh mesh, double[] scale, double[] up) {
        float[] v = mesh.triangles.vertices;
        double depth = Double.NEGATIVE_INFINITY;
        for (int i = 0; i + 2 < v.length; i += 3) {
            depth = Math.max(depth, -(up[0] * scale[0] * v[i] + up[1] * scale[1] * v[i + 1]
                + up[2] * scale[2] * v[i + 2]));
        }
        return depth;
    }

    /** Returns the scale of a mesh along its axes in SEAR. */
    private double[] scale(UrdfFile.Form form) {
        double[] s = {Math.abs(form.size[0]), Math.abs(form.size[1]), Math.abs(form.size[2])};
        return found.get(form).isZUp ? new double[] {s[0], s[2], s[1]} : s;
    }

    private Pose frame(UrdfFile.Form form) {
        return found.get(form).isZUp ? MESH.times(Z_UP) : MESH;
    }

    /**
     * Adds the shapes of a link to a robot.
     *
     * @param place of the link in the robot's frame
     */
    void add(SEARrobot robot, UrdfFile.Link link, Pose place) {
        double[] color = link.visuals.isEmpty() ? null : link.visuals.get(0).color;
        for (UrdfFile.Form form : used.get(link)) {
            double[] own = form.color == null ? color : form.color;
            for (Shape shape : shapes(form, robot.getName(), place.times(form.place))) {
                if (own != null) {
                    shape.setColor(String.format(Locale.ROOT, "#%02x%02x%02x", channel(own[0]), channel(own[1]),
                        channel(own[2])));
                }
                shape.setFriction(link.friction == null ? FRICTION : link.friction);
                if (link.rollingFriction != null) {
                    shape.setRollingFriction(link.rollingFriction);
                }
                if (link.restitution != null) {
                    shape.setRestitution(link.restitution);
                }
                robot.addComponent(shape);
            }
        }
    }

    private static int channel(double value) {
        return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
    }

    private List<Shape> shapes(UrdfFile.Form form, String of, Pose at) {
        double[] size = form.size;
        List<Shape> all = new ArrayList<>();
        switch (form.kind) {
            case "box":
                all.add(put(new Box(names.apply(of + " box"), size[1], size[0], size[2]), at));
                break;
            case "sphere":
                all.add(put(new Sphere(names.apply(of + " ball"), size[0]), at));
                break;
            case "mesh":
                double[] scale = scale(form);
                Model model = new Model(names.apply(of + " mesh"), found.get(form).path);
                if (scale[0] != 1 || scale[1] != 1 || scale[2] != 1) {
                    model.scale(scale[0], scale[1], scale[2]);
                }
                all.add(put(model, at.times(frame(form))));
                break;
            default:
                all.add(put(new Cylinder(names.apply(of + " cylinder"), size[0], size[1]), at));
                for (int end = -1; end <= 1 && form.kind.equals("capsule"); end += 2) {
                    all.add(put(new Sphere(names.apply(of + " ball"), size[0]),
                        at.times(new Pose(0, end * size[1] / 2, 0, 0, 0, 0, 1))));
                }
        }
        return all;
    }

    /** Places an object. */
    static <S extends SearObject> S put(S object, Pose at) {
        double[] turn = at.degrees();
        object.move(clean(at.x, ROUNDING), clean(at.y, ROUNDING), clean(at.z, ROUNDING));
        object.rotate(clean(turn[0], ROUNDING), clean(turn[1], ROUNDING), clean(turn[2], ROUNDING));
        return object;
    }

    /** Returns 0 for a number that only rounding keeps from 0. */
    static double clean(double value, double least) {
        return Math.abs(value) < least ? 0 : value;
    }
}
