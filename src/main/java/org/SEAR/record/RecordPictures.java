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

/** Which pictures of cameras a record has, and where: each is read from the file when it is asked for. Immutable, any thread. */
public final class RecordPictures {
    /** Pictures whose place is known, of all cameras together; of more, every second, fourth ... */
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
                ThinnedList<Place> of = found.computeIfAbsent(sensors.get(sensor), name -> new ThinnedList<>(MOST / sensors.size()));
                if (of.isNextKept()) {
                    of.add(new Place(kind, time, offset, length));
                } else {
                    of.pass();
                }
            }
        });
        found.forEach((name, all) -> places.put(name, all.stream().collect(Collectors.toList())));
    }

    /** One picture. Immutable. */
    public static final class Place {
        /** Simulated seconds since the record began at which it was taken. */
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

    /** Finds those of a record, which may still be written. */
    public static RecordPictures of(RunRecord record) throws IOException {
        return new RecordPictures(record);
    }

    /** Full names of the cameras that it has pictures of. */
    public Set<String> cameras() {
        return new TreeSet<>(places.keySet());
    }

    /** How many it has of a camera. */
    public int count(String camera) {
        return places.getOrDefault(camera, List.of()).size();
    }

    /** The last one that a camera had taken at a time; null if there is none. */
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
     * Reads one.
     *
     * @throws IOException if it can't be read
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
