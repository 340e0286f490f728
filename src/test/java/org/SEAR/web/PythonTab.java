// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import org.openqa.selenium.Keys;

/** Drives the editor of the Python tab as a user does. */
public final class PythonTab {
    private static final String FIELD = ".python-code .ace_text-input";

    private final Browser browser;

    public PythonTab(Browser browser) {
        this.browser = browser;
    }

    /** Waits for the editor. */
    public void await() {
        browser.see(".python-code .ace_content");
    }

    /** Returns the editor's text. */
    public String text() {
        await();
        return (String) browser.script("return ace.edit(document.querySelector('.python-code')).getValue()");
    }

    /** Types at the end, or at the cursor. */
    public void type(CharSequence... keys) {
        await();
        browser.script("ace.edit(document.querySelector('.python-code')).focus()");
        browser.all(FIELD).get(0).sendKeys(keys);
    }

    /** Replaces the editor's text. */
    public void replace(String text) {
        type(Keys.chord(Keys.CONTROL, "a"), Keys.DELETE);
        browser.script("ace.edit(document.querySelector('.python-code')).insert(arguments[0])", text);
    }
}
