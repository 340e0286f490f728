// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.SEAR.project.problems.ProjectException;

/**
 * Takes pictures of a {@link PictureWorld} on command, alternating with other programs that draw the same world. Writes
 * the world for them. Reads lines from standard input: "colors SECONDS" or "depths SECONDS" returns "PICTURES
 * CPU_SECONDS SECONDS HASH". CPU_SECONDS is the time of the one drawing thread; the hash is of a whole turn. "save TURN
 * FILE" writes a depth picture as little-endian 32-bit floats.
 */
public final class Cameras {
    private final PictureWorld world;

    private Cameras(PictureWorld world) {
        this.world = world;
    }

    /** @param args world name, and optionally file for the world */
    public static void main(String[] args) throws IOException, ProjectException {
        PrintStream out = System.out;
        System.setOut(System.err);
        PictureWorld world = new PictureWorld(args[0]);
        if (args.length > 1) {
            world.write(Path.of(args[1]));
        }
        Cameras cameras = new Cameras(world);
        out.println("ready");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String[] words = line.split(" ", 3);
            if (words[0].equals("save")) {
                out.println(cameras.save(Integer.parseInt(words[1]), Path.of(words[2])));
            } else {
                out.println(cameras.take(words[0].equals("colors"), Double.parseDouble(words[1])));
            }
        }
    }

    private String save(int turn, Path file) throws IOException {
        float[] depths = world.depths(turn);
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * depths.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(depths);
        Files.write(file, bytes.array());
        return "saved";
    }

    /** Takes whole turns until they have used the given seconds of processor time. */
    private String take(boolean colors, double seconds) {
        int count = 0;
        int hash = 0;
        double began = cpu();
        long from = System.nanoTime();
        while (count == 0 || cpu() - began < seconds) {
            hash = 0;
            for (int turn = 0; turn < PictureWorld.TURNS; turn++) {
                hash = 31 * hash + (colors ? Arrays.hashCode(world.colors(turn)) : Arrays.hashCode(world.depths(turn)));
                count++;
            }
        }
        return String.format(Locale.ROOT, "%d %.6f %.6f %08x", count, cpu() - began,
            (System.nanoTime() - from) * 1e-9, hash);
    }

    private static double cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
    }
}
