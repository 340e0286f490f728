// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Floor;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Simulation;

/**
 * Makes the worlds of the lessons and their pictures: runs each {@code world.py} in an empty project.
 * {@code gradle lessonWorlds} calls it.
 */
public final class LessonMaker {
    private static final int PIXELS = 360;
    private static final int AWAY = 50;

    private LessonMaker() {
    }

    /** @param args the folder of the lessons */
    public static void main(String[] args) throws IOException, ProjectException {
        for (Path script : scripts(Paths.get(args[0]))) {
            Path project = Files.createTempDirectory("sear-lesson").resolve("SEARproject");
            System.setProperty("sear.project", project.toString());
            ExampleMaker.run(script);
            Bundle.save(project, ExampleMaker.bundle(script));
            Files.write(script.resolveSibling("world.png"), picture(script, project));
            ProjectSwap.delete(project.getParent());
        }
    }

    /**
     * Takes a picture from above with north up, or of a slope from the south, by the camera of another, distant robot
     * in a separate project.
     */
    private static byte[] picture(Path script, Path made) throws IOException, ProjectException {
        Project world = Project.read(made);
        boolean slope = world.getEnvironment().stream().anyMatch(one -> one.getName().equals("ramp"));
        Floor floor = (Floor) world.getEnvironment().stream().filter(one -> one instanceof Floor).findFirst()
            .orElseThrow();
        double[] at = slope ? new double[] {-6, 1, 1.7}
            : new double[] {floor.getX(), 1.1 * floor.getLength(), floor.getZ()};
        Path project = Files.createTempDirectory("sear-lesson").resolve("SEARproject");
        System.setProperty("sear.project", project.toString());
        Path code = project.resolveSibling("world.py");
        Files.writeString(code, Files.readString(script)
            + String.format(Locale.ROOT, "from org.SEAR.POJOs import Camera%n"
            + "onlooker = Robots.chassis('onlooker')%nonlooker.move(%d, %d, %d)%ncamera = Camera('camera', %.3f, %.3f, "
            + "%.3f, %d, %d, 0)%n"
            + "camera.setSize(%d, %d)%ncamera.setFieldOfView(%d)%nonlooker.addComponent(camera)%n", AWAY, AWAY, AWAY,
            at[0] - AWAY, at[1] - AWAY,
            at[2] - AWAY, slope ? 6 : 90, 90, PIXELS, slope ? PIXELS / 2 : PIXELS, slope ? 40 : 52));
        ExampleMaker.run(code);
        byte[] png = ((CameraImage) Simulation.load(project, 1).read("camera")).png();
        ProjectSwap.delete(project.getParent());
        return png;
    }

    /** Returns the script of each lesson's world. */
    public static List<Path> scripts(Path lessons) throws IOException {
        try (Stream<Path> all = Files.list(lessons)) {
            return all.map(folder -> folder.resolve("world.py")).filter(Files::exists).sorted()
                .collect(Collectors.toList());
        }
    }
}
