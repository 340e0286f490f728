// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.Test;

/** The Windows launcher, which these tests cannot run, starts Java as the shell launcher does. */
public class LaunchersTest {
    private static final Path BIN = Path.of(System.getProperty("sear.root", "."), "src/dist/bin");

    private static String text(String name) throws IOException {
        return Files.readString(BIN.resolve(name), StandardCharsets.US_ASCII);
    }

    /** Returns the line that starts Java, in the shell launcher's form. */
    private static List<String> javaLine(String text) {
        List<String> words = new ArrayList<>();
        String line = text.lines().filter(each -> each.contains("org.SEAR.cli.SearCommand"))
            .collect(Collectors.joining("\n"));
        Matcher word = Pattern.compile("(?:[^\\s\"]|\"[^\"]*\")+").matcher(line);
        while (word.find()) {
            words.add(word.group().replace("%HOME_DIR%", "$home").replace("%JAVA_CMD%", "$java")
                .replace("%JAVA_OPTS%", "$JAVA_OPTS")
                .replace("%QUIET%", "$quiet").replace("%MEMORY%", "$memory").replace("%COMPILER%", "$compiler")
                .replace("%ARCHIVE%", "${archive:+\"$archive\"}").replace("%*", "\"$@\"").replace("\\", "/")
                .replace(";", ":").replace("-Dsear.home=\"$home\"", "-Dsear.home=$home"));
        }
        words.remove("exec");
        return words;
    }

    @Test
    public void bothStartJavaAlike() throws IOException {
        List<String> expected = List.of("\"$java\"", "$quiet", "$memory", "$compiler", "${archive:+\"$archive\"}",
            "$JAVA_OPTS", "-Dsear.home=$home",
            "-cp", "\"$home/plugin/*:$home/lib/*\"", "org.SEAR.cli.SearCommand", "\"$@\"");
        assertEquals(expected, javaLine(text("sear")));
        assertEquals(expected, javaLine(text("sear.bat")));
        assertEquals(options("quiet=\"(.*)\"", text("sear")), options("set \"QUIET=(.*)\"", text("sear.bat")));
        assertEquals(options("memory=\"(.*)\"", text("sear")), options("set \"MEMORY=(.*)\"", text("sear.bat")));
        assertEquals(options("compiler=\"(.*)\"", text("sear")), options("set \"COMPILER=(.*)\"", text("sear.bat")));
    }

    /** The Python 3 package starts Java inside its own process with the same options. */
    @Test
    public void pythonStartsJavaAlike() throws IOException {
        String python = Files.readString(BIN.resolve("../../../python/src/sear/_jvm.py"));
        for (String name : List.of("quiet", "memory", "compiler")) {
            for (String option : options(name + "=\"(.*)\"", text("sear")).split(" ")) {
                assertTrue(option, python.contains("\"" + option + "\""));
            }
        }
    }

    private static String options(String pattern, String text) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertTrue(pattern, matcher.find());
        return matcher.group(1);
    }

    @Test
    public void theWindowsLauncherHasWindowsLineEnds() throws IOException {
        String bat = text("sear.bat");
        assertEquals(bat.replace("\r\n", "").length(), bat.replaceAll("[\r\n]", "").length());
        assertTrue(bat.endsWith("\r\n"));
    }

    @Test
    public void bothUseJavaHomeAndReportAMissingJava() throws IOException {
        String bat = text("sear.bat");
        assertTrue(bat, bat.contains("if defined JAVA_HOME if exist \"%JAVA_HOME%\\bin\\java.exe\" set "
            + "\"JAVA_CMD=%JAVA_HOME%\\bin\\java.exe\""));
        Pattern missing = Pattern.compile("needs Java 11 or newer on the PATH \\(or JAVA_HOME set\\)");
        assertTrue(missing.matcher(text("sear")).find());
        assertTrue(missing.matcher(bat.replace("^", "")).find());
        assertTrue(bat, bat.endsWith("exit /b %ERRORLEVEL%\r\n"));
    }

    /**
     * A parenthesis in a folder's name, as in "Program Files (x86)", ends a block of cmd.exe early, so the launcher
     * contains no block.
     */
    @Test
    public void noBlockOfCommandsExpandsAFolder() throws IOException {
        assertEquals(List.of(), text("sear.bat").lines().filter(line -> line.trim().endsWith("("))
            .collect(Collectors.toList()));
    }
}
