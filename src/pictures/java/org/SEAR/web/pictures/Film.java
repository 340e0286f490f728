// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.web.Browser;
import org.openqa.selenium.Keys;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Films a page while its mouse moves slowly enough for people to follow. */
final class Film {
    private static final int WIDTH = 800;
    private static final int GLIDES = 5;
    /** Time per frame, hundredths of a second. */
    private static final int GLIDE_TIME = 5;
    private static final int KEY_TIME = 12;
    /** Browsers without a display draw no pointer. */
    private static final String POINTER = "var hand = document.createElement('div'); hand.id = 'film-pointer'; "
        + "document.body.appendChild(hand);"
        + "hand.style.cssText = 'position:fixed;left:0;top:0;z-index:99999;pointer-events:none';"
        + "hand.innerHTML = '<svg width=\"26\" height=\"26\"><path d=\"M2 2v19l5-4 3 7 3-1-3-7h7z\" fill=\"white\" "
        + "stroke=\"black\"/></svg>';window.addEventListener('mousemove', function(event) {"
        + " hand.style.transform = 'translate(' + event.clientX + 'px,' + event.clientY + 'px)' }, true);";
    private static final String MIDDLE = "var box = arguments[0].getBoundingClientRect();"
        + "return [box.left + box.width / 2, box.top + box.height / 2]";

    private final Browser browser;
    private final AnimatedGif gif = new AnimatedGif();
    private double x;
    private double y;

    Film(Browser browser) {
        this.browser = browser;
        browser.script(POINTER);
    }

    /** Removes the pointer. */
    void end() {
        browser.script("document.getElementById('film-pointer').remove()");
    }

    /** @param hundredths display time of the current picture, hundredths of a second */
    void shoot(int hundredths) throws IOException {
        browser.driver().executeAsyncScript("var done = arguments[0]; requestAnimationFrame(function() { "
            + "requestAnimationFrame(done) })");
        BufferedImage shot = ImageIO.read(new ByteArrayInputStream(browser.driver().getScreenshotAs(OutputType.BYTES)));
        int height = WIDTH * shot.getHeight() / shot.getWidth();
        BufferedImage small = new BufferedImage(WIDTH, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = small.createGraphics();
        pen.drawImage(shot.getScaledInstance(WIDTH, height, Image.SCALE_AREA_AVERAGING), 0, 0, null);
        pen.dispose();
        gif.add(small, hundredths);
    }

    void write(Path file) throws IOException {
        gif.write(file);
    }

    private Actions mouse() {
        return new Actions(browser.driver(), Duration.ofMillis(20));
    }

    private void glide(double toX, double toY) throws IOException {
        double fromX = x;
        double fromY = y;
        for (int i = 1; i <= GLIDES; i++) {
            double share = (1 - Math.cos(Math.PI * i / GLIDES)) / 2;
            x = fromX + (toX - fromX) * share;
            y = fromY + (toY - fromY) * share;
            mouse().moveToLocation((int) Math.round(x), (int) Math.round(y)).perform();
            shoot(GLIDE_TIME);
        }
    }

    /** Moves the mouse to an element and clicks it. */
    void click(String css) throws IOException {
        WebElement element = browser.see(css);
        browser.script("arguments[0].scrollIntoView({block: 'nearest'})", element);
        double[] at = middle(element);
        click(at[0], at[1]);
    }

    /** Moves the mouse to a position of the page and clicks it. */
    void click(double toX, double toY) throws IOException {
        glide(toX, toY);
        mouse().click().perform();
    }

    /** Presses at one position and releases at another. */
    void drag(double[] from, double[] to) throws IOException {
        glide(from[0], from[1]);
        mouse().clickAndHold().perform();
        glide(to[0], to[1]);
        mouse().release().perform();
    }

    /** Replaces the text of a field by typing. */
    void type(String css, String text) throws IOException {
        click(css);
        WebElement field = browser.see(css);
        field.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        for (String key : text.split("")) {
            field.sendKeys(key);
            shoot(KEY_TIME);
        }
        field.sendKeys(Keys.ENTER);
    }

    @SuppressWarnings("unchecked")
    private double[] middle(WebElement element) {
        List<Number> at = (List<Number>) browser.script(MIDDLE, element);
        return new double[] {at.get(0).doubleValue(), at.get(1).doubleValue()};
    }
}
