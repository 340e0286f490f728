// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import org.SEAR.POJOs.Terrain;
import org.SEAR.project.ProjectRule;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** The problems of a project that getProblems(), checkProject() and a start report. */
public class ProblemsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private SEAR sear;

    @Before
    public void start() {
        sear = (SEAR) Runtime.start("problems", "SEAR");
    }

    @After
    public void release() {
        Runtime.releaseService("problems");
    }

    @Test
    public void problemsIncludeThoseThatOnlyAStartFinds() throws Exception {
        project.put("assets/word.asc", "ncols 2\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.001\n1 2 3 four\n");
        new Terrain("ground", "word.asc");
        IllegalStateException start = assertThrows(IllegalStateException.class, sear::startSimulation);
        assertEquals(1, sear.getProblems().size());
        assertEquals(sear.getProblems().get(0).toString(), start.getMessage());
        assertEquals(sear.getProblems().toString(), sear.checkProject().get("problems").toString());
    }
}
