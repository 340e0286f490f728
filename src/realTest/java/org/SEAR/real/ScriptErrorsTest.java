// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.junit.runners.Parameterized;

/**
 * Mistakes of {@code mistakes.txt}, which the embedded MyRobotLab and Python 3 also get, by the button of the Python
 * tab: SEAR warns with the same words. MyRobotLab forgets the script's text, so hints that need the line's words are
 * not among them.
 */
@RunWith(Parameterized.class)
public class ScriptErrorsTest extends InRealMrl {
    /** Deletes the variables of other tests' scripts, which hints would name too. */
    private static final String FORGET = "for one in [name for name, value in globals().items() if name == 'math' "
        + "or name not in"
        + " ('sear', 'python', 'runtime') and type(value).__module__ in ('org.SEAR.POJOs', 'org.myrobotlab.service')]: "
        + "del globals()[one]";

    private final String title;

    public ScriptErrorsTest(String title) {
        this.title = title;
    }

    @Parameterized.Parameters(name = "{0}")
    public static List<String> titles() {
        return List.of("a service made as an object", "a package with parts in C", "an object that there is not",
            "a call in other letters",
            "a call without its service", "a call that there is not", "a box of two sizes", "a number as a text",
            "a part by its name",
            "a word where a number is wanted", "a ready robot in capitals", "a ready robot without a name",
            "a place with two numbers",
            "a place that is assigned", "a drive call with one number", "a module that is not imported",
            "a function of a module",
            "nothing by another name", "a number behind a text", "an end by exit", "a robot that is told to drive",
            "a sensor that is asked itself",
            "a comparison by one =", "plus plus", "an error without as", "a unit behind a number", "no colon");
    }

    @Test
    public void searWarnsWithTheWordsOfTheEmbeddedMyRobotLab() throws Exception {
        String[] parts = mistake().split("\n=> .*\n");
        List<String> words = Arrays.stream(parts[1].split("\n"))
            .map(one -> one.replaceAll("^in Jython |,? ?\\(?line \\d+( of script\\.py)?\\)?", ""))
            .flatMap(one -> Arrays.stream(one.split(",? ?legal: |(?<=\\)), ")))
            .filter(one -> !one.isBlank()).collect(Collectors.toList());
        mrl.python("sear = Runtime.start('sear', 'SEAR')");
        mrl.python(FORGET);
        int before = mrl.log().length();
        String script = parts[0].replace("import *", "import Box, Camera, Distance, Dynamics, Floor, Robots, "
            + "SEARrobot, Wheel");
        mrl.call("python/exec", "[\"" + script.replace("\\", "\\\\").replace("\"", "\\\"")
            .replace("\n", "\\n") + "\"]");
        mrl.await("the hint " + words, () -> {
            String log = mrl.log().substring(before);
            return words.stream().allMatch(log.substring(Math.max(0, log.indexOf("[script error]")))::contains);
        });
    }

    private String mistake() throws IOException {
        String all = Files.readString(ROOT.resolve("src/test/resources/org/SEAR/cli/mistakes.txt"));
        return all.substring(all.indexOf("== " + title + "\n") + title.length() + 4).split("\n\n==")[0];
    }
}
