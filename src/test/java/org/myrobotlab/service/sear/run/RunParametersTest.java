// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.math.BigInteger;
import java.util.List;
import java.util.Map;
import org.junit.After;
import org.junit.Test;

/** Parameters and results of scripts. */
public class RunParametersTest {
    private static final String LEGAL = "letters, digits and _, not a digit first, and none of row, seed, status, "
        + "message, version, digest";

    @After
    public void forget() {
        List.of("speed", "speeed", "name", "on", "count")
            .forEach(name -> System.clearProperty(RunParameters.PROPERTY + name));
        RunParameters.takeResults();
    }

    private static void given(String name, String text) {
        System.setProperty(RunParameters.PROPERTY + name, text);
    }

    private static String refused(Runnable call) {
        return assertThrows(IllegalArgumentException.class, call::run).getMessage();
    }

    @Test
    public void aParameterIsItsDefaultUntilItIsGiven() {
        assertEquals(0.3, RunParameters.get("speed", 0.3));
        assertEquals("T\u00fcr", RunParameters.get("name", "T\u00c3\u00bcr"));
        assertNull(RunParameters.get("name", null));
        given("speed", "1");
        given("name", "7");
        given("on", "True");
        given("count", "12");
        assertEquals(1.0, RunParameters.get("speed", 0.3));
        assertEquals("7", RunParameters.get("name", "x"));
        assertEquals(true, RunParameters.get("on", false));
        assertEquals(12, RunParameters.get("count", 1L));
        given("count", "12345678901");
        assertEquals(12345678901L, RunParameters.get("count", 1));
    }

    @Test
    public void valuesOfAnotherKindAreRejected() {
        given("speed", "fast");
        given("count", "0.5");
        given("on", "1");
        assertEquals("parameter speed is \"fast\", legal: a number, as its default 0.3 is",
            refused(() -> RunParameters.get("speed", 0.3)));
        assertEquals("parameter count is \"0.5\", legal: a whole number, as its default 1 is",
            refused(() -> RunParameters.get("count", 1)));
        assertEquals("parameter on is \"1\", legal: true or false, as its default true is",
            refused(() -> RunParameters.get("on", true)));
        assertEquals("parameter is called \"my speed\", legal: " + LEGAL,
            refused(() -> RunParameters.get("my speed", 1)));
    }

    @Test
    public void resultsAreStoredUntilTheyAreTaken() {
        RunParameters.setResult("way", 1.5f);
        RunParameters.setResult("steps", 3);
        RunParameters.setResult("way", 2.5);
        RunParameters.setResult("found", true);
        RunParameters.setResult("name", "T\u00c3\u00bcr");
        assertEquals(Map.of("way", 2.5, "steps", 3L, "found", true, "name", "T\u00fcr"), RunParameters.takeResults());
        assertEquals(Map.of(), RunParameters.takeResults());
    }

    @Test
    public void unusedParameterNamesAreKnown() {
        given("speeed", "1");
        given("lit", "true");
        assertTrue(RunParameters.unasked().containsAll(List.of("speeed", "lit")));
        RunParameters.get("lit", true);
        assertTrue(RunParameters.unasked().contains("speeed"));
        assertFalse(RunParameters.unasked().contains("lit"));
    }

    @Test
    public void invalidResultsAreRejected() {
        BigInteger large = BigInteger.TWO.pow(70);
        assertEquals("result way is 1180591620717411303424, legal: -2**63 to 2**63-1; float(value) keeps 15 "
            + "digits of it", refused(() -> RunParameters.setResult("way", large)));
        RunParameters.setResult("way", BigInteger.TWO.pow(62));
        assertEquals(Map.of("way", 1L << 62), RunParameters.takeResults());
        given("speed", "1");
        String names = ", legal: " + LEGAL + ", and no parameter's name";
        assertEquals("result is called \"seed\"" + names, refused(() -> RunParameters.setResult("seed", 1)));
        assertEquals("result is called \"speed\"" + names, refused(() -> RunParameters.setResult("speed", 1)));
        assertEquals("result way is a list, legal: a number, a text, True or False; give each value a name, such as "
            + "sear.setResult(\"way_0\", values[0])", refused(() -> RunParameters.setResult("way", List.of(1))));
        assertEquals("result way is null, legal: a number, a text, True or False",
            refused(() -> RunParameters.setResult("way", null)));
    }

    @Test
    public void theNumberOfResultsIsLimited() {
        assertEquals("result text has 10001 characters, legal: at most 10000",
            refused(() -> RunParameters.setResult("text", "a".repeat(10_001))));
        for (int i = 0; i < 1000; i++) {
            RunParameters.setResult("number" + i, i);
        }
        assertEquals("result more is one too many, legal: at most 1000 per run",
            refused(() -> RunParameters.setResult("more", 1)));
        RunParameters.setResult("number7", 8);
        Map<String, Object> taken = RunParameters.takeResults();
        assertEquals(1000, taken.size());
        assertEquals(8L, taken.get("number7"));
    }
}
