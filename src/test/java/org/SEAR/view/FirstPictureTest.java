package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.Color;
import java.awt.Robot;
import java.util.concurrent.CompletableFuture;
import org.junit.Test;
import org.junit.runner.RunWith;

/** What a user sees first of the window. */
@RunWith(UnderXvfb.class)
public class FirstPictureTest {
    private static final int MIDDLE_X = 640;
    private static final int MIDDLE_Y = 400;

    /** The screen is white where no window is. */
    @Test
    public void theFirstPictureIsTheSceneNotABlackWindow() throws Exception {
        Robot eye = new Robot();
        assertEquals("the screen", Color.WHITE, eye.getPixelColor(MIDDLE_X, MIDDLE_Y));
        CompletableFuture<Color> first = CompletableFuture.supplyAsync(() -> {
            Color[] seen = new Color[1];
            Views.until("a window", () -> {
                seen[0] = eye.getPixelColor(MIDDLE_X, MIDDLE_Y);
                return !seen[0].equals(Color.WHITE);
            });
            return seen[0];
        });
        try (Views view = new Views(ViewProjects.room(), new WindowOptions())) {
            assertEquals(0, view.warnings.size());
            Color color = first.get();
            assertTrue("what is seen first is " + color, color.getRed() + color.getGreen() + color.getBlue() > 100);
        }
    }
}
