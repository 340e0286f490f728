// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.sensors.CameraImage;
import org.SEAR.sensors.PixelGrid;

/**
 * A camera's picture for panels, which request one after the other while a user watches.
 *
 * <pre>
 * {"name": of the camera, "path": of the record, if recorded, "asked": requested time in the record,
 *  "time": simulated seconds of the picture, "words": the reading, "numbers": [..], "picture": "data:image/..",
 *  "kind": "depth", "width": pixels of the camera, "height": .., "range": ["0.410 m", "5.200 m"] of the false colours,
 *  "column": of the requested pixel, "row": .., "pixel": "#b01010, about red, 1.234 m ahead"}
 * </pre>
 *
 * <p>Omits fields that don't apply. Any thread.
 */
public final class CameraPicture {
    /** Upper limit of the longer side, pixels. */
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

    /** A panel's request for a picture. Immutable. */
    public static final class Wish {
        private final int longest;
        private final int column;
        private final int row;

        /**
         * Creates a request.
         *
         * @param longest pixels of the longer side; a smaller picture is not enlarged
         * @param column column of the pixel to describe; below 0 for none
         */
        public Wish(int longest, int column, int row) {
            this.longest = longest;
            this.column = column;
            this.row = row;
        }
    }

    /**
     * Returns a picture of a running world.
     *
     * @param distance distance of the described pixel along the axis, metres; NaN if unknown
     */
    public static Map<String, Object> of(String name, CameraImage image, double distance, Wish wish) {
        Answer answer = answer(image.grid(), distance, wish);
        answer.name = name;
        answer.time = image.getTime();
        answer.words = image.words("");
        answer.numbers = JsonNumbers.numbers(image.numbers());
        return answer.map();
    }

    /**
     * Returns a picture of a record.
     *
     * @param asked requested time, seconds since the record began
     * @param time time of the picture
     */
    public static Map<String, Object> of(String path, String name, double asked, double time, PixelGrid grid,
        Wish wish) {
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
