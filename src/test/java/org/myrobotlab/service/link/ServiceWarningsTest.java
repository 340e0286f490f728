// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;

/** A warning of a service is a status for panels and scripts and a line in the log. */
public class ServiceWarningsTest {
    private final PrintStream console = System.err;

    @After
    public void release() {
        System.setErr(console);
        Runtime.releaseService("warned");
    }

    @Test
    public void aWarningIsPublishedAndLoggedOnce() throws Exception {
        Heard service = (Heard) Runtime.start("warned", "Heard");
        service.addListener("publishStatus", "warned", "onStatus");
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        System.setErr(new PrintStream(log, true, "UTF-8"));
        ServiceWarnings.publish((Service<?>) service, "%d crates lie in the way", 3);
        System.setErr(console);
        assertTrue(service.awaitStatus("warn: 3 crates lie in the way"));
        List<String> lines = log.toString(StandardCharsets.UTF_8).lines().filter(line -> line.contains("3 crates lie"))
            .collect(Collectors.toList());
        assertEquals(log.toString(StandardCharsets.UTF_8), 1, lines.size());
        assertTrue(lines.get(0), lines.get(0).contains("WARN") && lines.get(0)
            .endsWith("warned: 3 crates lie in the way"));
    }
}
