package org.SEAR.record;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.simulator.Simulation;

/** Where everything was at some times of a record, for panels that show it again. Not changed once made, any thread. */
public final class Frames {
    /** Most numbers of all frames together. */
    private static final int MOST_NUMBERS = 100000;
    private static final int POSE = 7;

    /** Simulated seconds since the record began. */
    public final List<Double> times = new ArrayList<>();
    /** By time and robot: x, y, z and the quaternion x, y, z, w. */
    public final List<List<double[]>> robots = new ArrayList<>();
    /** By time and object that moved in the record, as {@link #moved} lists them. */
    public final List<List<double[]>> objects = new ArrayList<>();
    /** Numbers of the objects that moved. */
    public final List<Integer> moved = new ArrayList<>();
    /** Whether the record is whole; it was cut off otherwise. */
    public final boolean whole;

    private Frames(RunRecord record, int most) throws IOException {
        int robotCount = record.getHeader().robots.size();
        int objectCount = record.getHeader().objects.size();
        boolean[] moves = new boolean[objectCount];
        double[] first = new double[objectCount * POSE];
        boolean[] begun = {false};
        record.read(new RunRecord.Visitor() {
            @Override
            public void frame(double[] robotPoses, double[] objectPoses, double[] readings) {
                if (!begun[0]) {
                    System.arraycopy(objectPoses, 0, first, 0, first.length);
                }
                begun[0] = true;
                for (int i = 0; i < objectCount; i++) {
                    moves[i] |= !Arrays.equals(first, i * POSE, (i + 1) * POSE, objectPoses, i * POSE, (i + 1) * POSE);
                }
            }
        });
        for (int i = 0; i < objectCount; i++) {
            if (moves[i]) {
                moved.add(i);
            }
        }
        int numbers = POSE * (robotCount + moved.size()) + 1;
        Thinned<double[][]> kept = new Thinned<>(Math.min(most, MOST_NUMBERS / numbers));
        whole = record.read(new Keeper(kept, robotCount));
        kept.stream().forEach(frame -> {
            times.add(frame[0][0]);
            robots.add(cut(frame[1]));
            objects.add(cut(frame[2]));
        });
    }

    private static List<double[]> cut(double[] poses) {
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i < poses.length; i += POSE) {
            all.add(Arrays.copyOfRange(poses, i, i + POSE));
        }
        return all;
    }

    private final class Keeper implements RunRecord.Visitor {
        private final Thinned<double[][]> kept;
        private final int robotCount;
        private long steps;

        Keeper(Thinned<double[][]> kept, int robotCount) {
            this.kept = kept;
            this.robotCount = robotCount;
        }

        @Override
        public void step() {
            steps++;
        }

        @Override
        public void frame(double[] robotPoses, double[] objectPoses, double[] readings) {
            if (!kept.isNextKept()) {
                kept.pass();
                return;
            }
            double[] bodies = new double[robotCount * POSE];
            for (int i = 0; i < robotCount; i++) {
                System.arraycopy(robotPoses, i * RunRecord.ROBOT, bodies, i * POSE, POSE);
            }
            double[] things = new double[moved.size() * POSE];
            for (int i = 0; i < moved.size(); i++) {
                System.arraycopy(objectPoses, moved.get(i) * POSE, things, i * POSE, POSE);
            }
            kept.add(new double[][] {{steps * Simulation.STEP}, bodies, things});
        }
    }

    /**
     * Reads them.
     *
     * @param most frames; of more, every second, fourth ... one is kept
     */
    public static Frames of(RunRecord record, int most) throws IOException {
        return new Frames(record, most);
    }
}
