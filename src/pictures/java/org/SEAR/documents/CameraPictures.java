// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.sensors.Picture;
import org.SEAR.web.MyRobotLab;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.readings.ScriptCameras;
import org.myrobotlab.service.sear.run.SimulationControl;

/** Takes the pictures of docs/cameras.md with simulated cameras: {@code ./gradlew cameraPictures}. */
public final class CameraPictures {
    private static final int BETWEEN = 10;

    private CameraPictures() {
    }

    /** @param arguments the folder for the pictures */
    public static void main(String[] arguments) throws Exception {
        Path folder = Paths.get(arguments[0]);
        Path made = Files.createTempDirectory("sear-cameras");
        write(240, folder.resolve("cameras.png"), look(made.resolve("SEARproject"), "eye", "kinect", "thermal"));
        try (MyRobotLab robotLab = new MyRobotLab("sear = Runtime.start('sear', 'SEAR')")) {
            write(360, folder.resolve("opencv.png"), example(robotLab, made, "opencv_lines"),
                example(robotLab, made, "docking"));
        } finally {
            MyRobotLab.deleteFolder(made);
        }
        System.exit(0);
    }

    /** Returns the pictures of cameras in examples/ball.sear after a second, as the tab shows them. */
    private static BufferedImage[] look(Path project, String... names) throws Exception {
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.project", project.toString());
        Bundle.load(MyRobotLab.example("ball"), project);
        SimulationControl control = new SimulationControl(new RecordingHost(), () -> project);
        ScriptCameras cameras = new ScriptCameras(control);
        control.start(false);
        control.session().simSleep(1);
        control.session().pause();
        BufferedImage[] seen = new BufferedImage[names.length];
        for (int i = 0; i < names.length; i++) {
            seen[i] = image(cameras.look(names[i]).picture());
        }
        control.stop();
        return seen;
    }

    private static BufferedImage image(Picture picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, width, height, picture.getPixels(), 0, width);
        return image;
    }

    /** Returns the picture that a program of examples/python3 saves. */
    private static BufferedImage example(MyRobotLab robotLab, Path folder, String name)
        throws IOException, InterruptedException {
        File file = folder.resolve(name + ".png").toFile();
        ProcessBuilder builder = new ProcessBuilder("python3", "-B", "examples/python3/" + name + ".py",
            "--fast", "--server", robotLab.url().replaceAll("/$", ""), "--save", file.toString());
        builder.environment().put("PYTHONPATH", System.getProperty("sear.opencv"));
        int status = builder.inheritIO().start().waitFor();
        if (status != 0) {
            throw new IllegalStateException(name + " ended with " + status);
        }
        return ImageIO.read(file);
    }

    /** Writes pictures side by side, scaled to this height in pixels. */
    private static void write(int height, Path file, BufferedImage... pictures) throws IOException {
        List<BufferedImage> all = Arrays.asList(pictures);
        int width = all.stream().mapToInt(picture -> picture.getWidth() * height / picture.getHeight() + BETWEEN)
            .sum() - BETWEEN;
        BufferedImage whole = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = whole.createGraphics();
        graphics.fillRect(0, 0, width, height);
        int left = 0;
        for (BufferedImage picture : all) {
            int wide = picture.getWidth() * height / picture.getHeight();
            graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, picture.getHeight() * 2 > height
                ? RenderingHints.VALUE_INTERPOLATION_BICUBIC : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            graphics.drawImage(picture, left, 0, wide, height, null);
            left += wide + BETWEEN;
        }
        graphics.dispose();
        ImageIO.write(whole, "png", file.toFile());
    }
}
