// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import org.openqa.selenium.remote.RemoteWebElement;
import org.openqa.selenium.WebElement;

/**
 * Finds elements of a page with one call per selector instead of WebDriver's one or two per element. Each call costs
 * some milliseconds of CPU time in browser, driver and test, and most searches find nothing. Selenium's own function,
 * stored in the page, decides whether an element is displayed.
 */
final class Elements {
    private static final String KEPT = "document[Symbol.for('sear tests')]";
    private static final String FUNCTIONS = KEPT + " = (function(isDisplayed) {"
        + "function all(css) { return Array.from(document.querySelectorAll(css)) }"
        + "function shown(one) { return isDisplayed(one) }"
        + "function letters(text) { return text.replace(/\\s/g, '').toLowerCase() }"
        + "function first(css) { return all(css).find(shown) || null }"
        + "return {first: first, shown: function(css) { return all(css).filter(shown) },"
        + "withLetters: function(css, part) {"
        + "return all(css).filter(function(one) { return letters(one.textContent).includes(letters(part)) && "
        + "shown(one) }) },"
        + "clickable: function(css) { var one = first(css); return one && !one.matches(':disabled') ? one : null },"
        + "option: function(css, text) { var select = first(css);"
        + "return select && !select.matches(':disabled') && Array.from(select.options).find(function(one) { return "
        + "one.text === text }) || null }}})(" + seleniums("isDisplayed") + ");";

    private final Browser browser;

    Elements(Browser browser) {
        this.browser = browser;
    }

    private static String seleniums(String function) {
        try (InputStream in = RemoteWebElement.class.getResourceAsStream(function + ".js")) {
            return new String(Objects.requireNonNull(in, function).readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Object call(String function, Object... arguments) {
        String call = KEPT + "." + function + "(...arguments)";
        Object answer = browser.script("return " + KEPT + " ? " + call + " : 'a new page'", arguments);
        return answer instanceof String ? browser.script(FUNCTIONS + "return " + call, arguments) : answer;
    }

    /** Returns the first displayed element, or null. */
    WebElement first(String css) {
        return (WebElement) call("first", css);
    }

    /** Returns the first displayed element if it is enabled, or null. */
    WebElement clickable(String css) {
        return (WebElement) call("clickable", css);
    }

    /** Returns the option with this text of the first displayed element; null if it is missing or disabled. */
    WebElement option(String css, String text) {
        return (WebElement) call("option", css, text);
    }

    /** Returns all displayed elements. */
    @SuppressWarnings("unchecked")
    List<WebElement> shown(String css) {
        return (List<WebElement>) call("shown", css);
    }

    /**
     * Returns the displayed elements that may contain the text. The driver must confirm it, because it leaves out
     * invisible text and returns lines and capitals as displayed.
     */
    @SuppressWarnings("unchecked")
    List<WebElement> withLetters(String css, String part) {
        return (List<WebElement>) call("withLetters", css, part);
    }
}
