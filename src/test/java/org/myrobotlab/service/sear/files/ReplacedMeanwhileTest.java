// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import static org.junit.Assert.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.sear.panel.Preview;

/** A reader of the project sees the old or the new one, whole, while another thread replaces it. */
public class ReplacedMeanwhileTest {
    private static final int OBJECTS = 40;
    private static final int LOADS = 30;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final AtomicBoolean isDone = new AtomicBoolean();

    /** Saves a bundle with objects whose names begin with a letter. */
    private Path bundle(String letter) throws Exception {
        Path file = project.getRoot().toPath().resolve(letter + ".sear");
        for (int i = 0; i < OBJECTS; i++) {
            new Box(letter + i, 1, 1, 1).move(3.0 * i, 0.5, 0);
        }
        Bundle.save(project.folder(), file);
        Bundle.newProject(project.folder(), Progress.NONE);
        return file;
    }

    private static Set<String> letters(Project read) {
        return read.getEnvironment().stream().map(object -> object.getName().substring(0, 1))
            .collect(Collectors.toSet());
    }

    /** Reads the project repeatedly until all loads are done; each result must be of one project. */
    private Callable<String> looking(Callable<Project> look) {
        return () -> {
            while (!isDone.get()) {
                Project seen = look.call();
                if (seen != null && (seen.getEnvironment().size() != OBJECTS || letters(seen).size() != 1)) {
                    return "seen: " + seen.getEnvironment();
                }
            }
            return "";
        };
    }

    private Project saved() throws Exception {
        Path file = project.getRoot().toPath().resolve("saved.sear");
        Bundle.save(project.folder(), file);
        return Bundle.load(file, project.getRoot().toPath().resolve("unpacked"));
    }

    private Project started() throws Exception {
        try (Simulation start = Simulation.load(project.folder(), 1)) {
            return start.getProject();
        }
    }

    /** Reads a preview like the tab. */
    private Project previewed(Preview preview) {
        Map<String, Object> answer = ProjectSwap.undisturbed(() -> preview.of(project.folder(), ""));
        assertEquals(Arrays.asList(Collections.emptyList(), null),
            Arrays.asList(answer.get("problems"), answer.get("reason")));
        return null;
    }

    private String loading(Path... bundles) throws Exception {
        try {
            for (int i = 0; i < LOADS; i++) {
                Bundle.load(bundles[i % bundles.length], project.folder());
            }
            return "";
        } finally {
            isDone.set(true);
        }
    }

    @Test
    public void savingCheckingStartingAndPreviewsWait() throws Exception {
        Path[] bundles = {bundle("a"), bundle("b")};
        Bundle.load(bundles[0], project.folder());
        Preview preview = new Preview();
        ExecutorService threads = Executors.newCachedThreadPool();
        try {
            List<Future<String>> all = new ArrayList<>();
            all.add(threads.submit(() -> loading(bundles)));
            all.add(threads.submit(looking(this::saved)));
            all.add(threads.submit(looking(() -> Project.read(project.folder()))));
            all.add(threads.submit(looking(this::started)));
            all.add(threads.submit(looking(() -> previewed(preview))));
            for (Future<String> one : all) {
                assertEquals("", one.get());
            }
        } finally {
            isDone.set(true);
            threads.shutdownNow();
        }
    }
}
