// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SearObject;
import org.SEAR.camera.image.Blobs;
import org.SEAR.files.AtomicFile;
import org.SEAR.geometry.TimeStep;
import org.SEAR.grammar.ColorNames;
import org.SEAR.grammar.ScriptText;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.CameraSensor;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/** Cameras' pictures for scripts. Any thread. */
public final class ScriptCameras {
    private static final String ENDING = ".png";
    private static final int HEX = 16;
    /** Least pixels of a blob. */
    private static final int MIN_BLOB = 4;

    private final SimulationControl control;

    public ScriptCameras(SimulationControl control) {
        this.control = control;
    }

    /**
     * Returns the last picture that was due.
     *
     * @throws IllegalArgumentException with the available cameras
     */
    private CameraImage image(String asked) throws InterruptedException {
        String name = ScriptText.of(asked);
        return control.session().ask(world -> {
            mustBeThere(world, name);
            return (CameraImage) world.read(name);
        });
    }

    private static void mustBeThere(Simulation world, String name) {
        SearObject object = name == null ? null : world.getSensor(name).getParameters();
        if (!(object instanceof Camera)) {
            throw new IllegalArgumentException(
                (name == null ? "the name is missing (None)" : "sensor " + name + " is a "
                + object.getClass().getSimpleName() + ", not a Camera") + ", legal: " + cameras(world));
        }
    }

    private static String cameras(Simulation world) {
        List<String> names = world.getSensorNames().stream().filter(name -> world.getSensor(name).takesPictures())
            .collect(Collectors.toList());
        return names.isEmpty() ? "none, the project has no cameras" : String.join(", ", names);
    }

    private CameraImage image(String asked, String kind) throws InterruptedException {
        CameraImage image = image(asked);
        if (!image.getKind().equals(kind)) {
            throw new IllegalArgumentException("camera " + ScriptText.of(asked) + " makes pictures of kind "
                + image.getKind() + ", legal: setKind(\"" + kind + "\") before the start");
        }
        return image;
    }

    /** Returns whether a sensor is a camera. */
    boolean isCamera(String name) {
        Simulation world = control.session().getSimulation();
        return !world.getJoints().isRead(name) && world.getSensor(name).takesPictures();
    }

    /**
     * Checks that a camera exists, if a simulation runs.
     *
     * @return the name
     * @throws IllegalArgumentException with the available cameras
     */
    public String check(String asked) {
        String name = ScriptText.of(asked);
        SimulationSession session = control.sessionOrNull();
        if (session != null) {
            mustBeThere(session.getSimulation(), name);
        } else if (name == null) {
            throw new IllegalArgumentException("the name is missing (None), legal: a camera's name");
        }
        return name;
    }

    /** Returns the number of pictures due since the start; -1 if no simulation with such a camera runs. */
    public long due(String name) {
        SimulationSession session = control.sessionOrNull();
        if (session == null || !isThere(session.getSimulation(), name)) {
            return -1;
        }
        return TimeStep.periods(session.time(), ((Camera) session.getSimulation().getSensor(name).getParameters())
            .getRate());
    }

    /** Returns the last picture that was due; null if no simulation with such a camera runs. */
    public CameraImage look(String name) throws InterruptedException {
        return control.look((world, session) -> isThere(world, name) ? (CameraImage) world.read(name) : null, null);
    }

    /** Returns the distance at a pixel of that picture, metres along the axis; NaN without a picture or pixel. */
    public double distance(String name, CameraImage image, int column, int row) throws InterruptedException {
        if (column < 0 || row < 0 || column >= image.getWidth() || row >= image.getHeight()) {
            return Double.NaN;
        }
        return control.look((world, session) -> isThere(world, name) && world.read(name) == image
            ? ((CameraSensor) world.getSensor(name)).depth(row * image.getWidth() + column) : Double.NaN, Double.NaN);
    }

    private static boolean isThere(Simulation world, String name) {
        return world.getSensorNames().contains(name) && world.getSensor(name).takesPictures();
    }

    /** Returns a PNG file. */
    public byte[] png(String name) throws InterruptedException {
        return image(name).png();
    }

    /** Returns 0xRRGGBB of each pixel; depths and temperatures in false colours. */
    public int[] pixels(String name) throws InterruptedException {
        return image(name).picture().getPixels();
    }

    /** Returns metres along the axis. */
    public float[] depths(String name) throws InterruptedException {
        return image(name, Camera.DEPTH).getValues();
    }

    /** Returns degrees Celsius. */
    public float[] temperatures(String name) throws InterruptedException {
        return image(name, Camera.INFRARED).getValues();
    }

    /** Returns x, y and z of each point, metres. */
    public float[] points(String name, boolean world) throws InterruptedException {
        return image(name, Camera.DEPTH).getPoints(world);
    }

    /** Returns [x, y, width, height, area] of each region of a colour, pixels, largest first. */
    public List<double[]> blobs(String name, String color) throws InterruptedException {
        String text = ScriptText.of(color);
        String hex = text == null ? null : ColorNames.hex(text);
        if (hex == null || !Blobs.hasHue(Integer.parseInt(hex.substring(1), HEX))) {
            throw new IllegalArgumentException("the colour is " + (text == null ? "missing (None)" : "\"" + text + "\"")
                + ", legal: one with a hue, such as red, orange or #2060ff; white, grey and black have none");
        }
        List<double[]> blobs = new ArrayList<>();
        for (Blobs.Blob blob : image(name, Camera.COLOR).blobs(Integer.parseInt(hex.substring(1), HEX), MIN_BLOB)) {
            blobs.add(new double[] {blob.x, blob.y, blob.width, blob.height, blob.area});
        }
        return blobs;
    }

    /**
     * Writes a PNG file; creates missing folders.
     *
     * @return its absolute path
     */
    public Path save(String name, String path) throws InterruptedException, IOException {
        String text = ScriptText.of(path);
        if (text == null || !text.toLowerCase(Locale.ROOT).endsWith(ENDING)) {
            throw new IllegalArgumentException("the path is " + (text == null ? "missing (None)" : "\"" + text + "\"")
                + ", legal: a file that ends with " + ENDING);
        }
        byte[] file = png(name);
        Path to = ScriptText.path(text).toAbsolutePath().normalize();
        Files.createDirectories(to.getParent());
        AtomicFile.write(to, file);
        return to;
    }
}
