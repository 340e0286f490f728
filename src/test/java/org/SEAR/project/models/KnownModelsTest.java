// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotSame;
import static org.junit.Assert.assertSame;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Loaded models are reused as long as their files are the same. */
public class KnownModelsTest {
    private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<String> warnings = new ArrayList<>();

    private Triangles load(Path folder, Model model) throws Exception {
        return ModelLoader.withoutPictures(new Assets(folder.resolve("assets")), warnings::add).triangles(model);
    }

    /** Like loadProject: the start uses the models loaded by the check, although the folder is renamed in between. */
    @Test
    public void checkedModelsAreNotLoadedAgain() throws Exception {
        project.put("assets/m.obj", CORNERS);
        Model model = new Model("m", "m.obj");
        Project.read(project.folder()).checkFiles();
        Triangles checked = load(project.folder(), model);
        Path renamed = project.getRoot().toPath().resolve("renamed");
        Files.move(project.folder(), renamed);
        assertSame(checked, load(renamed, model));
    }

    @Test
    public void changedFilesAreReloaded() throws Exception {
        project.put("assets/m.obj", CORNERS);
        Model model = new Model("m", "m.obj");
        load(project.folder(), model);
        // the same length, within the clock's resolution
        project.put("assets/m.obj", CORNERS.replace('2', '3').replace("f 1 3 3", "f 1 2 3"));
        assertEquals(3, load(project.folder(), model).vertices[7], 0);
        Triangles before = load(project.folder(), model);
        project.put("assets/beside.bin", "it may be a part of the model");
        assertNotSame(before, load(project.folder(), model));
    }

    @Test
    public void terrainsAndOthersOfOneFileStandWhereTheyShould() throws Exception {
        project.put("assets/m.obj", CORNERS);
        assertEquals(0, load(project.folder(), new Model("m", "m.obj")).vertices[0], 0);
        Model terrain = new Model("ground", "m.obj");
        terrain.setTerrain(true);
        assertEquals(-0.5, load(project.folder(), terrain).vertices[0], 0);
    }

    @Test
    public void unshowablePicturesAreReportedEachTime() throws Exception {
        project.put("assets/m.obj", "mtllib m.mtl\n" + CORNERS);
        Model model = new Model("m", "m.obj");
        load(project.folder(), model);
        load(project.folder(), model);
        assertEquals(2, warnings.size());
        assertEquals(warnings.get(0), warnings.get(1));
    }
}
