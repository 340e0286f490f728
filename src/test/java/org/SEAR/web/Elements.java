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
 * Looks for elements of a page: what WebDriver asks by a call or two for each element, by one call for all of a selector. For every call the
 * browser, its driver and the test take some milliseconds of processor time, and most looks are in vain. Whether an element is displayed is said by
 * Selenium's own function as ever, only that the page keeps it.
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
        + "return all(css).filter(function(one) { return letters(one.textContent).includes(letters(part)) && shown(one) }) },"
        + "clickable: function(css) { var one = first(css); return one && !one.matches(':disabled') ? one : null },"
        + "option: function(css, text) { var select = first(css);"
        + "return select && !select.matches(':disabled') && Array.from(select.options).find(function(one) { return one.text === text }) || null }}"
        + "})(" + seleniums("isDisplayed") + ");";

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

    /** The first that is displayed, or null. */
    WebElement first(String css) {
        return (WebElement) call("first", css);
    }

    /** The same if it is enabled, too. */
    WebElement clickable(String css) {
        return (WebElement) call("clickable", css);
    }

    /** The option with this text of the first that is displayed; null if there is none, or that is not enabled. */
    WebElement option(String css, String text) {
        return (WebElement) call("option", css, text);
    }

    /** All that are displayed. */
    @SuppressWarnings("unchecked")
    List<WebElement> shown(String css) {
        return (List<WebElement>) call("shown", css);
    }

    /** Those of them that may have a text: the driver, which is to say so, leaves out what can't be seen and writes lines and capitals as seen. */
    @SuppressWarnings("unchecked")
    List<WebElement> withLetters(String css, String part) {
        return (List<WebElement>) call("withLetters", css, part);
    }
}
