// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Paths;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.view.process.PipeLink;
import org.SEAR.view.process.WindowProtocol;

/**
 * Main class of the window's process. It isolates crashes of the graphics driver, and on macOS a window needs a
 * process's first thread, which MyRobotLab occupies. Reads states from standard input and writes
 * {@link WindowProtocol} to standard output. Ends when its input ends.
 */
public final class WindowProcess {
    private WindowProcess() {
    }

    /** @param arguments project folder, title, width, height, debug shapes (true or false), folder for pictures */
    public static void main(String[] arguments) throws IOException, ProjectException, InterruptedException {
        DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new FileOutputStream(FileDescriptor.out)));
        System.setOut(System.err);
        PipeLink world = new PipeLink(Project.read(Paths.get(arguments[0])), out);
        WindowOptions options = new WindowOptions().setTitle(arguments[1])
            .setSize(Integer.parseInt(arguments[2]), Integer.parseInt(arguments[3]))
            .setDebugShapes(Boolean.parseBoolean(arguments[4])).setScreenshotFolder(Paths.get(arguments[5]))
            .setWarnings(warning -> world.say(WindowProtocol.WARNING, warning)).setOnClosed(() -> {
                world.say(WindowProtocol.CLOSED);
                Runtime.getRuntime().halt(0);
            });
        Thread receiver = new Thread(() -> receive(world), "SEAR window feed");
        receiver.setDaemon(true);
        receiver.start();
        // Ctrl-C in a terminal reaches this process too, which waits for the simulation's to end
        Runtime.getRuntime().addShutdownHook(new Thread(LockSupport::park));
        String problem = open(world, options);
        if (problem != null) {
            world.say(WindowProtocol.PROBLEM, problem);
        }
    }

    private static String open(PipeLink world, WindowOptions options) throws InterruptedException {
        try {
            return WindowStart.open(world, options, () -> world.say(WindowProtocol.OPENED)).problem();
        } catch (RuntimeException | LinkageError e) {
            return "jMonkeyEngine or its native libraries can't be loaded: " + e;
        }
    }

    private static void receive(PipeLink world) {
        try {
            world.receive(new DataInputStream(new BufferedInputStream(System.in)));
        } catch (IOException e) {
            Runtime.getRuntime().halt(0);
        }
    }
}
