// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.Assert;

/** Accessibility errors of a panel: controls without name, names used twice, text with too little contrast. */
public final class Accessibility {
    /** Least contrast of text by the Web Content Accessibility Guidelines, level AA. */
    private static final double CONTRAST = 4.5;

    private static final String FUNCTIONS = String.join("\n",
        "function shown(e) { return e.getClientRects().length > 0 }",
        "function what(e) { return e.outerHTML.substring(0, 100) }",
        "function rgb(text) { var n = text.match(/[\\d.]+/g).map(Number); return n.length < 4 || n[3] > 0.5 ? "
        + "n.slice(0, 3) : null }", "function light(c) {",
        "    return c.reduce(function(sum, v, i) {",
        "        v /= 255",
        "        return sum + [0.2126, 0.7152, 0.0722][i] * (v <= 0.03928 ? v / 12.92 : Math.pow((v + 0.055) / "
        + "1.055, 2.4))", "    }, 0.05)",
        "}",
        "function behind(e) {",
        "    for (; e; e = e.parentElement) {",
        "        var colour = rgb(getComputedStyle(e).backgroundColor)",
        "        if (colour) { return colour }",
        "    }",
        "    return [255, 255, 255]",
        "}",
        "function ownText(e) {",
        "    return ['INPUT', 'SELECT'].indexOf(e.tagName) >= 0 && e.type !== 'color' || [].some.call(e.childNodes, "
        + "function(n) {", "        return n.nodeType === 3 && n.textContent.trim()",
        "    })",
        "}",
        "function name(e) {",
        "    return e.getAttribute('aria-label') || e.labels && e.labels.length && e.labels[0].textContent",
        "        || e.tagName === 'BUTTON' && e.textContent.trim()",
        "}",
        "var panel = document.querySelector(arguments[0]), found = []");

    private static final String LOOK = String.join("\n",
        "panel.querySelectorAll('input, select, button, a, svg, canvas, [tabindex]').forEach(function(e) {",
        "    if (shown(e) && !e.closest('[aria-hidden=true]') && !name(e)) { found.push('no name: ' + what(e)) }",
        "})",
        "panel.querySelectorAll('[id]').forEach(function(e) {",
        "    if (document.querySelectorAll('[id=\"' + e.id + '\"]').length > 1) { found.push('id used twice: ' "
        + "+ what(e)) }", "})",
        "panel.querySelectorAll('*').forEach(function(e) {",
        "    if (!shown(e) || e.disabled || e.tagName === 'OPTION' || !ownText(e)) { return }",
        "    var style = getComputedStyle(e), text = rgb(e instanceof SVGElement ? style.fill : style.color)",
        "    var a = light(text), b = light(behind(e)), contrast = Math.max(a, b) / Math.min(a, b)",
        "    if (contrast < " + CONTRAST + ") { found.push('contrast ' + contrast.toFixed(2) + ': ' + what(e)) }",
        "})",
        "return found");

    /** Script that returns axe-core's violations of impact serious or critical: rule and elements. */
    private static final String AXE = String.join("\n",
        "var done = arguments[arguments.length - 1]",
        "axe.run(document.querySelector(arguments[0]), {resultTypes: ['violations']}).then(function(results) {",
        "    done(results.violations.filter(function(one) { return one.impact === 'serious' || one.impact === "
        + "'critical' }).map(function(one) {",
        "        return one.id + ': ' + one.nodes.map(function(node) { return node.html.substring(0, 150) "
        + "}).join(', ')", "    }))",
        "})");

    private Accessibility() {
    }

    /**
     * Checks all visible parts of a panel in both themes.
     * @throws AssertionError that lists the errors
     */
    public static void check(Browser browser, String panel) {
        for (String theme : new String[] {"dark", "light"}) {
            browser.setTheme(theme);
            try {
                // colours change gradually
                browser.until("a panel that can be read", () -> isTheme(browser, theme) && problems(browser, panel)
                    .isEmpty());
                Assert.assertEquals("axe-core, in the " + theme + " theme", List.of(), faults(browser, panel));
            } catch (AssertionError e) {
                throw new AssertionError("in the " + theme + " theme: " + problems(browser, panel) + "; "
                    + e.getMessage(), e);
            }
        }
    }

    private static List<?> faults(Browser browser, String panel) {
        browser.script("if (!window.axe) { " + axe() + " }");
        return (List<?>) browser.driver().executeAsyncScript(AXE, panel);
    }

    private static String axe() {
        try (InputStream in = Accessibility.class.getResourceAsStream("/axe.min.js")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<?> problems(Browser browser, String panel) {
        return (List<?>) browser.script(FUNCTIONS + "\n" + LOOK, panel);
    }

    private static boolean isTheme(Browser browser, String theme) {
        return Boolean.TRUE.equals(browser.script("return window.matchMedia('(prefers-color-scheme: ' + arguments[0] + "
            + "')').matches", theme));
    }
}
