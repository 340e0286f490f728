// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.project.ProjectRule;

/** A project with generated model files. */
public final class FormatRule extends ProjectRule {
    /** Warnings of the last load. */
    final List<String> warnings = new ArrayList<>();

    FormatRule with(String file, String content) throws IOException {
        return with(file, content.getBytes(StandardCharsets.UTF_8));
    }

    FormatRule with(String file, byte[] content) throws IOException {
        Path assets = Files.createDirectories(folder().resolve("assets"));
        Files.write(assets.resolve(file), content);
        return this;
    }

    Assets assets() {
        return new Assets(folder().resolve("assets"));
    }

    /** Loads a model as the simulation does. */
    Measures load(String file) throws IOException {
        warnings.clear();
        return new Measures(ModelLoader.withoutPictures(assets(), warnings::add).triangles(new Model("m", file)));
    }

    /** Loads a model as window and cameras do. */
    ModelAppearance look(String file) throws IOException {
        return new ModelLoader(assets()).look(new Model("m", file));
    }

    /** The model is refused with a message that has a part. */
    void refuses(String file, String part) throws IOException {
        try {
            load(file);
            fail(file + " was loaded");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(part) && e.getMessage().contains(", legal: "));
        }
    }
}
