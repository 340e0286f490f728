package org.SEAR.web;

import org.openqa.selenium.Keys;

/** The editor of the Python tab as a user handles it. */
public final class PythonTab {
    private static final String FIELD = ".python-code .ace_text-input";

    private final Browser browser;

    public PythonTab(Browser browser) {
        this.browser = browser;
    }

    /** Waits until the editor is there. */
    public void await() {
        browser.see(".python-code .ace_content");
    }

    /** All that is in it. */
    public String text() {
        await();
        return (String) browser.script("return ace.edit(document.querySelector('.python-code')).getValue()");
    }

    /** Types at its end, or where the cursor is. */
    public void type(CharSequence... keys) {
        await();
        browser.script("ace.edit(document.querySelector('.python-code')).focus()");
        browser.all(FIELD).get(0).sendKeys(keys);
    }

    /** Puts text in the place of what is in it. */
    public void replace(String text) {
        type(Keys.chord(Keys.CONTROL, "a"), Keys.DELETE);
        browser.script("ace.edit(document.querySelector('.python-code')).insert(arguments[0])", text);
    }
}
