// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import static org.junit.Assert.assertArrayEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.util.stream.StreamSupport;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/**
 * Poses from degrees, their products and interpolation equal those of {@code poses.json}. The page's
 * {@code geometry.test.js} compares the same numbers.
 */
public class PagePosesTest {
    @Test
    public void theNumbersAreThoseOfThePage() throws IOException {
        try (InputStream in = PagePosesTest.class.getResourceAsStream("/poses.json")) {
            for (JsonNode one : new ObjectMapper().readTree(in)) {
                Pose a = pose(one.get("a"));
                Pose b = pose(one.get("b"));
                same("frame", one, a);
                same("times", one, a.times(b));
                same("between", one, Movement.between(a, b, one.get("share").asDouble(), one.get("seconds")
                    .asDouble()));
            }
        }
    }

    private static double[] numbers(JsonNode list) {
        return StreamSupport.stream(list.spliterator(), false).mapToDouble(JsonNode::asDouble).toArray();
    }

    /** Returns the pose of x, y, z in metres and three angles in degrees. */
    private static Pose pose(JsonNode list) {
        double[] at = numbers(list);
        return Pose.ofDegrees(at[0], at[1], at[2], at[3], at[4], at[5]);
    }

    private static void same(String what, JsonNode wanted, Pose pose) {
        assertArrayEquals(what + " of " + wanted, numbers(wanted.get(what)),
            new double[] {pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw}, 1e-12);
    }
}
