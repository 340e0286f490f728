// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.junit.Assert;
import org.junit.rules.ExternalResource;
import org.junit.rules.TestRule;
import org.junit.runner.Description;
import org.junit.runners.model.Statement;
import org.openqa.selenium.By;
import org.openqa.selenium.WebElement;

/**
 * The MyRobotLab shared by this process, in which a script of the class starts services, and the shared browser with a
 * new tab for the tests.
 * <pre>
 * &#64;ClassRule
 * public static final Tabs TABS = new Tabs("Runtime.start('sear', 'SEAR')");
 * &#64;Rule
 * public final TestRule page = TABS.page("sear");
 * </pre>
 * <p>Each test begins with a freshly loaded page that shows the tab, with project, messages and scripts unfolded and
 * all else in its initial state. It ends with a check that the browser's console has no errors. When a test fails, the
 * page's screenshot is saved to {@code build/reports/web}.
 */
public final class Tabs extends ExternalResource {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 1000;
    private static final int MOST_WORDS = 2000;
    /** Unfolds the sections that the tests need; the others are in their initial state. */
    private static final String OPEN = "localStorage.setItem('sear.folds', '{\"project\":false,\"messages\":false,"
        + "\"scripts\":false}')";
    private static final Path PICTURES = Paths.get(System.getProperty("sear.root", "."), "build/reports/web");

    private final String script;
    private final boolean isAlone;
    private MyRobotLab robotLab;
    private Browser browser;
    private int loads;

    /** @param script Jython code that starts what the class needs */
    public Tabs(String script) {
        this(script, false);
    }

    private Tabs(String script, boolean isAlone) {
        this.script = script;
        this.isAlone = isAlone;
    }

    /** Returns tabs of a separate MyRobotLab, for a script that changes more than services and files. */
    public static Tabs alone(String script) {
        return new Tabs(script, true);
    }

    @Override
    protected void before() throws IOException, InterruptedException {
        browser = Browser.shared(WIDTH, HEIGHT);
        robotLab = isAlone ? new MyRobotLab(script) : MyRobotLab.shared(script);
        browser.forgetPages(robotLab.url());
    }

    @Override
    protected void after() {
        try {
            browser.driver().get("about:blank");    // so that the page doesn't look for released services
        } finally {
            if (isAlone) {
                robotLab.close();
            }
        }
    }

    public MyRobotLab robotLab() {
        return robotLab;
    }

    public Browser browser() {
        return browser;
    }

    /** Brings a service to the front by its tab, or by the menu if it is there. */
    public void show(String service) {
        String tab = "#tab-" + service;
        browser.until("a tab of " + service, () -> !browser.all(tab).isEmpty());
        if (browser.all(tab).stream().noneMatch(WebElement::isDisplayed)) {
            browser.click("#shell-more");
        }
        browser.click(tab);
    }

    /** Reloads the page, shows a service's tab and returns when its panel is there. */
    public void open(String service) {
        open(browser, service);
    }

    /** Shows the tab in another browser. */
    public void open(Browser other, String service) {
        other.driver().get(robotLab.url() + "?load=" + ++loads + "#/" + service);
        other.see("mrl-panel[name='" + service + "'] > *");
        other.until("the modules of " + service, () -> other.all("mrl-panel[name='" + service + "'] .sear-loading")
            .isEmpty());
    }

    /**
     * Returns the rule for each test.
     * @param service whose tab is shown at the start
     */
    public TestRule page(String service) {
        return (test, description) -> new Statement() {
            @Override
            public void evaluate() throws Throwable {
                browser.forget();
                if (!browser.driver().getCurrentUrl().startsWith(robotLab.url())) {
                    browser.driver().get(robotLab.url() + "icon.svg");      // a small page of that address
                    browser.expectErrors("/favicon.ico");
                }
                browser.script(OPEN);
                try {
                    open(service);
                    test.evaluate();
                    Assert.assertEquals("errors in the browser's console", List.of(), browser.errors());
                } catch (Throwable e) {
                    keepPicture(description);
                    e.addSuppressed(new AssertionError("the page said: " + words()));
                    throw e;
                }
            }
        };
    }

    /** Returns the visible text of the page, for the output of a failed run. */
    private String words() {
        try {
            String text = browser.driver().findElement(By.tagName("body")).getText();
            return text.substring(0, Math.min(text.length(), MOST_WORDS));
        } catch (RuntimeException e) {
            return "nothing, " + e;
        }
    }

    private void keepPicture(Description test) {
        Path file = PICTURES.resolve(test.getTestClass().getSimpleName() + "." + test.getMethodName() + ".png");
        try {
            browser.picture(file);
            System.err.println(test + " failed, see " + file + "; console: " + browser.errors()
                + "; MyRobotLab printed:\n" + robotLab.log());
        } catch (IOException | RuntimeException e) {
            System.err.println(test + " failed, and there is no picture of it: " + e);
        }
    }
}
