package org.SEAR.project.models;

import java.io.IOException;
import java.nio.file.Path;
import java.util.TreeMap;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.geometry.Triangles;

/** A small whole model in each format, for tests that change them. */
public final class MutableModels {
    private MutableModels() {
    }

    /** Returns the models by file name extension. */
    public static TreeMap<String, byte[]> all() throws IOException {
        TreeMap<String, byte[]> all = new TreeMap<>();
        for (String ending : ModelLoader.ENDINGS) {
            all.put(ending, BrokenModels.TRIANGLE.bytes(ending));
        }
        return all;
    }

    /** Returns the triangles of a model in a project folder. */
    public static Triangles load(Path folder, Model model) throws IOException {
        return ModelLoader.withoutPictures(new Assets(folder.resolve("assets")), warning -> { }).triangles(model);
    }
}
