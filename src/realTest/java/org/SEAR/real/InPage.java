// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import org.junit.After;
import org.junit.AfterClass;
import org.junit.Before;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.rules.TestRule;
import org.junit.rules.TestWatcher;
import org.junit.runner.Description;

/**
 * Base of tests with MyRobotLab's page in a browser. The services SEAR, LIDAR and GPS run; the browser's console must
 * stay free of errors.
 */
abstract class InPage extends InRealMrl {
    /** Width and height, pixels. */
    static final int[][] SIZES = {{800, 1000}, {1024, 768}, {1366, 768}, {1920, 1080}};
    static Page page;

    @Rule
    public final TestRule pictures = new TestWatcher() {
        @Override
        protected void failed(Throwable e, Description test) {
            try {
                page.keep("failed-" + test.getMethodName().replaceAll("\\W+", "-"));
            } catch (IOException | RuntimeException second) {
                e.addSuppressed(second);
            }
        }
    };

    @BeforeClass
    public static void openTheBrowser() throws IOException {
        page = new Page();
    }

    @AfterClass
    public static void closeTheBrowser() {
        page.close();
    }

    @Before
    public void startTheServices() throws Exception {
        assertEquals("", mrl.python("sear = Runtime.start('sear', 'SEAR')", "lidar = Runtime.start('lidar', 'LIDAR')",
            "gps = Runtime.start('gps', 'GPS')"));
    }

    @After
    public void lookAtTheConsole() {
        page.checkConsole();
    }
}
