package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.PixelGrid;

/**
 * A camera's picture as panels show it: they ask for one after the other, while somebody looks.
 *
 * <pre>
 * {"name": of the camera, "path": of the record that it is of, "asked": when in that, "time": simulated seconds at which it was taken,
 *  "words": the reading, "numbers": [..], "picture": "data:image/..", "kind": "depth", "width": pixels of the camera, "height": ..,
 *  "range": ["0.410 m", "5.200 m"] that the false colours reach from and to, "column": of the pixel that was asked for, "row": ..,
 *  "pixel": "#b01010, about red, 1.234 m ahead"}
 * </pre>
 *
 * <p>What does not apply is left out. Any thread.
 */
public final class CameraPicture {
    /** Pixels of the longer side that panels may have. */
    private static final int LARGEST = 640;
    private static final int SMALLEST = 32;

    private CameraPicture() {
    }

    private static final class Answer extends JsonForm {
        String name;
        String path;
        Double asked;
        double time;
        String words;
        List<Double> numbers;
        String picture;
        String kind;
        int width;
        int height;
        List<String> range;
        Integer column;
        Integer row;
        String pixel;
    }

    /** What a panel wants of a picture. Immutable. */
    public static final class Wish {
        private final int longest;
        private final int column;
        private final int row;

        /**
         * A wish.
         *
         * @param longest pixels of the longer side; a smaller one is not enlarged
         * @param column of the pixel that is to be told in words; below 0 for none
         */
        public Wish(int longest, int column, int row) {
            this.longest = longest;
            this.column = column;
            this.row = row;
        }
    }

    /**
     * A picture of a running world.
     *
     * @param distance of what the pixel sees that is to be told, metres along the axis; not a number if it isn't known
     */
    public static Map<String, Object> of(String name, CameraImage image, double distance, Wish wish) {
        Answer answer = answer(image.grid(), distance, wish);
        answer.name = name;
        answer.time = image.getTime();
        answer.words = image.words("");
        answer.numbers = WorldJson.numbers(image.numbers());
        return answer.map();
    }

    /**
     * A picture of a record.
     *
     * @param asked seconds since the record began for which it was asked for
     * @param time at which it was taken
     */
    public static Map<String, Object> of(String path, String name, double asked, double time, PixelGrid grid, Wish wish) {
        Answer answer = answer(grid, Double.NaN, wish);
        answer.path = path;
        answer.name = name;
        answer.asked = asked;
        answer.time = time;
        return answer.map();
    }

    private static Answer answer(PixelGrid grid, double distance, Wish wish) {
        Answer answer = new Answer();
        answer.kind = grid.getKind();
        answer.width = grid.getWidth();
        answer.height = grid.getHeight();
        answer.picture = SmallPicture.of(grid.picture(), Math.max(SMALLEST, Math.min(LARGEST, wish.longest)));
        double[] range = grid.range();
        if (range != null) {
            answer.range = new ArrayList<>(List.of(grid.words(range[0]), grid.words(range[1])));
        }
        if (wish.column >= 0) {
            answer.column = wish.column;
            answer.row = wish.row;
            answer.pixel = grid.words(wish.column, wish.row, distance);
        }
        return answer;
    }
}
