// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.web.Browser;

/** MyRobotLab's page in a browser, with its panels. */
final class Page implements AutoCloseable {
    static final String SEAR = ".sear-main";
    private static final Path PICTURES = RealMrlCopy.BUILD.resolve("pictures");
    /** Source of the console messages of MyRobotLab's own scripts. */
    private static final String OWN = "/lib/atmosphere-";
    private static final String CLICK = "var name = arguments[0], one = "
        + "[].find.call(document.querySelectorAll('#mySidenav a'),"
        + " function(a) { return a.textContent.trim() === name }); if (one) { one.click() } return Boolean(one)";

    final Browser browser;
    private int loads;

    Page() throws IOException {
        browser = Browser.whole(1366, 768);
    }

    /** Loads the page as on a first visit, without stored settings. */
    void open(RealMrl mrl, String service) {
        String url = "http://localhost:" + mrl.port() + "/";
        if (browser.driver().getCurrentUrl().startsWith(url)) {
            browser.script("localStorage.clear()");
        }
        browser.errors();
        browser.expectErrors(OWN);
        browser.driver().get(url + "?load=" + ++loads + "#/service/" + service);
        see(service);
    }

    /** Shows a service by a click on its name in the list. */
    void show(String service) {
        browser.until(service + " in the list", () -> Boolean.TRUE.equals(browser.script(CLICK, service)));
        see(service);
    }

    private void see(String service) {
        browser.until("the header of " + service, () -> browser.texts(".tab-header .dropdown-toggle").stream()
            .anyMatch(text -> text.replace('\u00a0', ' ').trim().endsWith(" " + service)));
        browser.until("the modules of all panels", () -> browser.all(".sear-loading").isEmpty());
    }

    void setSize(int width, int height) {
        browser.setPageSize(width, height);
    }

    /** Saves a screenshot of the window. */
    Path keep(String name) throws IOException {
        Path file = PICTURES.resolve(name + ".png");
        browser.picture(file);
        return file;
    }

    boolean isTrue(String expression) {
        return Boolean.TRUE.equals(browser.scope(SEAR, expression));
    }

    double number(String expression) {
        return browser.number(SEAR, expression);
    }

    void await(String what, String expression) {
        browser.until(what, () -> isTrue(expression));
    }

    void checkConsole() {
        assertEquals("errors in the browser's console", List.of(), browser.errors());
    }

    @Override
    public void close() {
        browser.close();
    }
}
