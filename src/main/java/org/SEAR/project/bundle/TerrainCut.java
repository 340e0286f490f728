// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.Xml;

/**
 * Replacement files for a bundle that contains only the used area of the terrain's maps: one cut map, and the terrain's
 * file that names it. The project stays unchanged. One use.
 */
final class TerrainCut {
    private final Project project;
    private final Path temporary;
    /** Files by their names in the bundle; null for a file of the project that is left out. */
    private final Map<String, Path> instead = new HashMap<>();

    /** @param temporary a folder for the files */
    TerrainCut(Project project, Path temporary) {
        this.project = project;
        this.temporary = temporary;
    }

    /**
     * Cuts the map.
     *
     * @return files by their names in the bundle, null for those left out; empty if there is nothing to cut
     */
    Map<String, Path> make() throws IOException, ProjectException {
        for (SearObject object : project.getEnvironment()) {
            byte[] map = object instanceof Terrain ? project.cutMap() : null;
            if (map != null) {
                put((Terrain) object, map);
            }
        }
        return instead;
    }

    private void put(Terrain terrain, byte[] map) throws IOException {
        Path assets = project.getAssets().getFolder();
        Set<String> used = pictures();
        for (String path : terrain.getPaths()) {
            if (Files.isRegularFile(assets.resolve(path)) && !used.contains(plain(path))) {
                leaveOut(path);
                leaveOut(path.replaceFirst("\\.[^.]*$", "") + ".prj");
            }
        }
        String name = "terrain/" + terrain.getName() + "-area.tif";
        for (int number = 2; Files.exists(assets.resolve(name))
            && !instead.containsKey(ProjectFolder.ASSETS + "/" + name); number++) {
            name = "terrain/" + terrain.getName() + "-area-" + number + ".tif";
        }
        instead.put(ProjectFolder.ASSETS + "/" + name, Files.write(temporary.resolve("map.tif"), map));
        ParameterTable table = ParameterTable.of(Terrain.class);
        table.find("path").set(terrain, name);
        table.find("tile").set(terrain, new ArrayList<>());
        instead.put(ProjectFolder.ENVIRONMENT + "/" + terrain.getFileName() + ProjectFolder.XML,
            Files.writeString(temporary.resolve("terrain.xml"), Xml.write(terrain)));
    }

    private void leaveOut(String path) {
        if (Files.isRegularFile(project.getAssets().getFolder().resolve(path))) {
            instead.put(ProjectFolder.ASSETS + "/" + plain(path), null);
        }
    }

    private static String plain(String path) {
        return path.replaceFirst("^(\\./)+", "");
    }

    /** Returns the assets that are also used as pictures, for example that of the terrain. */
    private Set<String> pictures() {
        List<SearObject> all = new ArrayList<>(project.getEnvironment());
        for (SEARrobot robot : project.getRobots()) {
            all.addAll(robot.getComponents());
            all.addAll(robot.getWheels());
        }
        Set<String> pictures = new HashSet<>();
        all.stream().filter(object -> object instanceof Shape && ((Shape) object).getImage() != null)
            .forEach(object -> pictures.add(plain(((Shape) object).getImage())));
        return pictures;
    }
}
