// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.Test;
import picocli.CommandLine;

/** Help and errors of {@code sear}. */
public class CommandHelpTest {
    private static String answer(String... arguments) {
        StringWriter out = new StringWriter();
        CommandLine line = SearCommand.commandLine();
        line.setOut(new PrintWriter(out)).setErr(new PrintWriter(out));
        return line.execute(arguments) + "\n" + out.toString().replace("\r\n", "\n");
    }

    @Test
    public void anInvalidOptionIsAnsweredInTwoLines() {
        assertEquals("2\nsear: Unknown option: '--hedless': did you mean --headless?\nTry sear --help.\n",
            answer("--hedless"));
        assertEquals("2\nsear grade: Unknown option: '--leson=square': did you mean --lesson?\n"
            + "Try sear grade --help.\n", answer("grade", "--leson=square", "x.py"));
        assertEquals("2\nsear: --speed is \"fast\", legal: a number of 0.001 or more, or max\nTry sear --help.\n",
            answer("--speed", "fast"));
    }

    @Test
    public void helpGroupsOptionsAndCommands() {
        String help = answer("--help");
        int[] places = {help.indexOf("The run:"), help.indexOf("--headless  "),
            help.indexOf("The tabs in the browser:"),
            help.indexOf("      --token-file=FILE "), help.indexOf("Commands for projects:"), help.indexOf("\n  check"),
            help.indexOf("Commands for teaching:"), help.indexOf("\n  grade")};
        for (int i = 0; i < places.length; i++) {
            assertTrue(i + "\n" + help, places[i] > (i == 0 ? 0 : places[i - 1]));
        }
        assertFalse("every option and command has a group", help.contains("Other"));
    }
}
