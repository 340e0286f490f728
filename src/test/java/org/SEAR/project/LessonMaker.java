package org.SEAR.project;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.SEAR.learning.Episode;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;

/** Makes the worlds of the lessons and their pictures: runs each {@code world.py} in an empty project. {@code gradle lessonWorlds} calls it. */
public final class LessonMaker {
    private static final int PIXELS = 480;

    private LessonMaker() {
    }

    /**
     * Makes all.
     *
     * @param args the folder of the lessons
     */
    public static void main(String[] args) throws IOException, ProjectException {
        for (Path script : scripts(Paths.get(args[0]))) {
            Path project = Files.createTempDirectory("sear-lesson").resolve("SEARproject");
            System.setProperty("sear.project", project.toString());
            ExampleMaker.run(script);
            Bundle.save(project, ExampleMaker.bundle(script));
            Project world = Project.read(project);
            try (Episode episode = new Episode(world, world.getRobots().get(0).getName(), List.of(), List.of(), 1, 1)) {
                ImageIO.write(picture(episode.draw(PIXELS, PIXELS)), "png", script.resolveSibling("world.png").toFile());
            }
            ProjectSwap.delete(project.getParent());
        }
    }

    private static BufferedImage picture(byte... colors) {
        BufferedImage picture = new BufferedImage(PIXELS, PIXELS, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < PIXELS * PIXELS; i++) {
            picture.setRGB(i % PIXELS, i / PIXELS, (colors[3 * i] & 255) << 16 | (colors[3 * i + 1] & 255) << 8 | colors[3 * i + 2] & 255);
        }
        return picture;
    }

    /** The script of each lesson's world. */
    public static List<Path> scripts(Path lessons) throws IOException {
        try (Stream<Path> all = Files.list(lessons)) {
            return all.map(folder -> folder.resolve("world.py")).filter(Files::exists).sorted().collect(Collectors.toList());
        }
    }
}
