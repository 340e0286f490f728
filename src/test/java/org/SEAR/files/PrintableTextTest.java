// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import static org.junit.Assert.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.Test;

/** Text of users on a terminal. */
public class PrintableTextTest {
    @Test
    public void escapeSequencesLoseTheirControlCharacters() {
        assertEquals("?[2Jred?[0m ?]0;title? ?31m",
            PrintableText.of("\u001b[2Jred\u001b[0m \u001b]0;title\u0007 \u009b31m"));
        assertEquals("over?write", PrintableText.of("over\rwrite"));
    }

    @Test
    public void linesTabsAndOtherLettersStay() {
        String text = "Zoë 機\r\n\tnext\n\ud83e\udd16";
        assertEquals(text, PrintableText.of(text));
    }

    @Test
    public void onOneLineTabsAndLineBreaksAreReplacedToo() {
        assertEquals("a?b??c ?[31m", PrintableText.line("a\tb\r\nc \u001b[31m"));
    }

    @Test
    public void aWriterReplacesInAllItsMethods() {
        StringWriter to = new StringWriter();
        PrintWriter writer = PrintableText.writer(to);
        writer.print('\u001b');
        writer.write(new char[] {'a', '\u001b', 'b'}, 1, 2);
        writer.printf("%s", "\u001b[1m");
        writer.append("c\u001b", 0, 2);
        writer.flush();
        assertEquals("??b?[1mc?", to.toString());
    }
}
