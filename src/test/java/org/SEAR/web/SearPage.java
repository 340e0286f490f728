// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.rules.TestRule;

/** Tests on the SEAR tab; each begins without a simulation. The service's name and variable is {@code sear}. */
public abstract class SearPage {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    @Rule
    public final TestRule page = TABS.page("sear");
    protected final Browser browser = TABS.browser();
    protected final MyRobotLab robotLab = TABS.robotLab();
    protected final SearTab tab = new SearTab(TABS);

    @Before
    public void stopped() {
        tab.stopAll();
    }
}
