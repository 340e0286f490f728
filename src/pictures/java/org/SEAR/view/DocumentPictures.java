// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import com.jme3.math.Vector3f;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.simulator.SimulationRunner;

/**
 * Draws the pictures of the documentation from the examples and the first script, on a separate X server:
 * {@code scripts/screenshots}.
 */
public final class DocumentPictures {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 600;
    private static final int SETTLE = 90;

    private static final String INSIDE = "inside";
    private static final List<String> WANTED = new ArrayList<>();

    private interface Scene {
        void set(Views view) throws Exception;
    }

    private DocumentPictures() {
    }

    /**
     * @param arguments the folder for the pictures and the names of the wanted ones, or none for all; preceded by
     *     {@code inside} in the process that has the display
     */
    public static void main(String[] arguments) throws Exception {
        if (!arguments[0].equals(INSIDE)) {
            List<String> inside = new ArrayList<>(List.of(INSIDE));
            inside.addAll(Arrays.asList(arguments));
            try (Xvfb server = new Xvfb()) {
                Process process = Xvfb.java(server.display(), List.of(), DocumentPictures.class.getName(),
                    inside.toArray(new String[0])).inheritIO().start();
                System.exit(process.waitFor());
            }
        }
        Path folder = Files.createDirectories(Paths.get(arguments[1]));
        WANTED.addAll(Arrays.asList(arguments).subList(2, arguments.length));
        draw("first-steps", () -> projectOf("resources/resource/SEAR/SEAR.py"), folder, view -> {
            view.world.simulation.post(simulation -> simulation.getRobots().get(0)
                .drive(0.3, Double.POSITIVE_INFINITY));
            drive(view, 3);
            onWindow(view, () -> view.scene().camera().orbit(2.6f, 0.7f, 0.5f));
        });
        draw("office", folder, view -> {
            view.world.runner.setPaused(true);
            onWindow(view, () -> view.scene().camera().orbit(3.2f, 0.75f, 0.62f));
        });
        draw("maze", folder, view -> onWindow(view, () -> view.scene().camera()
            .fly(new Vector3f(-4.9f, 5.8f, 0), (float) Math.PI / 2, 0.9f)));
        draw("ramps", folder, view -> {
            view.world.simulation.post(simulation -> simulation.getRobots().get(0)
                .drive(0.3, Double.POSITIVE_INFINITY));
            drive(view, 7);
            view.press("F3");
            onWindow(view, () -> view.scene().camera().orbit(2.6f, -0.8f, 0.45f));
        });
        draw("sensors", folder, view -> {
            view.press("F5");
            view.world.runner.setPaused(true);
            onWindow(view, () -> view.scene().camera().fly(new Vector3f(-4.2f, 3.4f, -3.6f), 0.85f, 0.42f));
        });
        draw("window-camera", () -> Examples.folder("ball"), folder, view -> {
            view.press("F6");
            Views.until("its picture", () -> view.is(() -> view.scene().hud().camera().shown() != null));
            view.world.runner.setPaused(true);
            onWindow(view, () -> view.scene().camera().orbit(3.2f, -0.9f, 0.5f));
        });
        draw("terrain", DocumentPictures::mountains, folder, view -> {
            view.press("F4");
            view.world.runner.setPaused(true);
            onWindow(view, () -> view.scene().camera().orbit(4.6f, -2.6f, 0.14f));
        });
        System.exit(0);
    }

    private static void drive(Views view, double seconds) throws InterruptedException {
        SimulationRunner runner = view.world.runner;
        runner.sleep(seconds);
        runner.setPaused(true);
    }

    private static void onWindow(Views view, Runnable action) throws Exception {
        view.ask(() -> {
            action.run();
            return null;
        });
    }

    /** Returns the example's rover with eight kilometres of mountains around it instead of two. */
    private static Path mountains() throws Exception {
        Path script = Files.createTempDirectory("scene").resolve("mountains.py");
        Files.writeString(script, Files.readString(Paths.get("examples/mountain.py"))
            .replace("2000, 2000", "8000, 8000"));
        return projectOf(script.toString());
    }

    /** Runs a script and returns the project that it made. */
    private static Path projectOf(String script) throws Exception {
        Path folder = Files.createTempDirectory("scene");
        int status = new ProcessBuilder(System.getProperty("java.home") + "/bin/java", "-cp",
            System.getProperty("java.class.path"),
            "org.SEAR.cli.SearCommand", Paths.get(script).toAbsolutePath().toString(), "--headless", "--speed", "max",
                "--port", "none")
            .directory(folder.toFile()).inheritIO().start().waitFor();
        if (status != 0) {
            throw new IllegalStateException(script + " ended with " + status);
        }
        return folder.resolve("SEARproject");
    }

    private static void draw(String example, Path folder, Scene scene) throws Exception {
        draw(example, () -> Examples.folder(example), folder, scene);
    }

    private static void draw(String name, Callable<Path> project, Path folder, Scene scene) throws Exception {
        if (!WANTED.isEmpty() && !WANTED.contains(name)) {
            return;
        }
        try (Views view = new Views(project.call(), new WindowOptions().setSize(WIDTH, HEIGHT).setSamples(4))) {
            view.frames(SETTLE);
            scene.set(view);
            view.frames(SETTLE);
            Views.until("no message is left", () -> view.is(() -> view.scene().hud().messagesText().isEmpty()));
            view.picture(name);
            Files.copy(Views.report().resolve(name + ".png"), folder.resolve(name + ".png"),
                StandardCopyOption.REPLACE_EXISTING);
            System.out.println(folder.resolve(name + ".png"));
        }
    }
}
