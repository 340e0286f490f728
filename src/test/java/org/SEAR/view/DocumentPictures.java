package org.SEAR.view;

import com.jme3.math.Vector3f;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.List;
import org.SEAR.simulator.SimulationRunner;

/** Draws the pictures of the documentation from the examples, on an X server of its own: {@code scripts/screenshots}. */
public final class DocumentPictures {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 600;
    private static final int SETTLE = 90;

    private interface Scene {
        void set(Views view) throws Exception;
    }

    private DocumentPictures() {
    }

    /** @param arguments the folder for the pictures; with {@code inside} before it, in the process that has the display */
    public static void main(String[] arguments) throws Exception {
        if (arguments.length == 1) {
            try (Xvfb server = new Xvfb()) {
                Process process = Xvfb.java(server.display(), List.of(), DocumentPictures.class.getName(), "inside", arguments[0])
                    .inheritIO().start();
                System.exit(process.waitFor());
            }
        }
        Path folder = Files.createDirectories(Paths.get(arguments[1]));
        draw("office", folder, view -> {
            view.world.runner.setPaused(true);
            onWindow(view, () -> view.scene().camera().orbit(3.2f, 0.75f, 0.62f));
        });
        draw("maze", folder, view -> onWindow(view, () -> view.scene().camera().fly(new Vector3f(-5.2f, 6.2f, 0), (float) Math.PI / 2, 0.9f)));
        draw("ramps", folder, view -> {
            view.world.simulation.post(simulation -> simulation.getRobots().get(0).drive(0.3, Double.POSITIVE_INFINITY));
            drive(view, 7);
            view.press("F3");
            onWindow(view, () -> view.scene().camera().orbit(2.6f, -0.8f, 0.45f));
        });
        System.exit(0);
    }

    private static void drive(Views view, double seconds) throws InterruptedException {
        SimulationRunner runner = view.world.runner;
        runner.await(view.world.snapshot().time + seconds);
        runner.setPaused(true);
    }

    private static void onWindow(Views view, Runnable action) throws Exception {
        view.ask(() -> {
            action.run();
            return null;
        });
    }

    private static void draw(String example, Path folder, Scene scene) throws Exception {
        try (Views view = new Views(Examples.folder(example), new WindowOptions().setSize(WIDTH, HEIGHT).setSamples(4))) {
            view.frames(SETTLE);
            scene.set(view);
            view.frames(SETTLE);
            onWindow(view, () -> view.scene().surroundings().setShadows(true));
            view.picture(example);
            Files.copy(Views.report().resolve(example + ".png"), folder.resolve(example + ".png"),
                StandardCopyOption.REPLACE_EXISTING);
            System.out.println(folder.resolve(example + ".png"));
        }
    }
}
