// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.SEAR.sensors.PixelGrid;

/** Index of the camera pictures of a record. Reads each picture from the file on demand. Immutable; any thread. */
public final class RecordPictures {
    /** Maximum number of indexed pictures of all cameras; above it, every second, fourth ... is kept. */
    private static final int MOST = 200_000;

    private final RunRecord record;
    private final Map<String, List<Place>> places = new HashMap<>();

    private RecordPictures(RunRecord record) throws IOException {
        this.record = record;
        List<String> sensors = record.getHeader().sensors;
        Map<String, ThinnedList<Place>> found = new HashMap<>();
        record.read(new RunRecord.Visitor() {
            @Override
            public void picture(int sensor, String kind, double time, long offset, int length) {
                ThinnedList<Place> of = found.computeIfAbsent(
                    sensors.get(sensor), name -> new ThinnedList<>(MOST / sensors.size()));
                if (of.isNextKept()) {
                    of.add(new Place(kind, time, offset, length));
                } else {
                    of.pass();
                }
            }
        });
        found.forEach((name, all) -> places.put(name, all.stream().collect(Collectors.toList())));
    }

    /** Location of one picture. Immutable. */
    public static final class Place {
        /** When the picture was taken, simulated seconds since the record began. */
        public final double time;
        private final String kind;
        private final long offset;
        private final int length;

        Place(String kind, double time, long offset, int length) {
            this.kind = kind;
            this.time = time;
            this.offset = offset;
            this.length = length;
        }
    }

    /** Indexes the pictures of a record, which may still be growing. */
    public static RecordPictures of(RunRecord record) throws IOException {
        return new RecordPictures(record);
    }

    /** Returns the full names of the cameras with pictures. */
    public Set<String> cameras() {
        return new TreeSet<>(places.keySet());
    }

    public int count(String camera) {
        return places.getOrDefault(camera, List.of()).size();
    }

    /** Returns the last picture that a camera had taken at a time; null if there is none. */
    public Place at(String camera, double time) {
        List<Place> all = places.getOrDefault(camera, List.of());
        int low = 0;
        int high = all.size();
        while (low < high) {
            int middle = (low + high) / 2;
            if (all.get(middle).time <= time) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low == 0 ? null : all.get(low - 1);
    }

    /**
     * Reads a picture from the file.
     *
     * @throws IOException if it cannot be read
     */
    public PixelGrid read(Place place) throws IOException {
        byte[] bytes = new byte[place.length];
        try (RandomAccessFile file = new RandomAccessFile(record.getPath().toFile(), "r")) {
            file.seek(place.offset);
            file.readFully(bytes);
        }
        return PixelGrid.read(place.kind, bytes);
    }
}
