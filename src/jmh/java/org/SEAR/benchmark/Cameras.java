package org.SEAR.benchmark;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import org.SEAR.project.problems.ProjectException;

/**
 * Takes pictures of a {@link PictureWorld} whenever it is told to, so that it can go in turns with other programs which draw the same: reads lines
 * "colors SECONDS" or "depths SECONDS", answers each with a line "PICTURES CPU_SECONDS SECONDS HASH", where CPU_SECONDS are those of the one thread
 * that takes them, and the hash is of the last whole turn.
 */
public final class Cameras {
    private final PictureWorld world;

    private Cameras(PictureWorld world) {
        this.world = world;
    }

    /** @param args the world's name */
    public static void main(String[] args) throws IOException, ProjectException {
        PrintStream out = System.out;
        System.setOut(System.err);
        Cameras cameras = new Cameras(new PictureWorld(args[0]));
        out.println("ready");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String[] words = line.split(" ");
            out.println(cameras.take(words[0].equals("colors"), Double.parseDouble(words[1])));
        }
    }

    /** Whole turns, until they have taken so many seconds of the thread's time. */
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
        return String.format(Locale.ROOT, "%d %.6f %.6f %08x", count, cpu() - began, (System.nanoTime() - from) * 1e-9, hash);
    }

    private static double cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9;
    }
}
