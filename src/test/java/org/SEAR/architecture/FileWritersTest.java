// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** Files that outlive a call are written by AtomicFile, whole or not at all. */
public class FileWritersTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."), "src");
    private static final Pattern WRITES =
        Pattern.compile("Files\\.(write|writeString|newOutputStream|newBufferedWriter|copy)\\("
        + "|new (FileOutputStream|FileWriter)\\(|new PrintWriter\\((new File|file|path)|ImageIO\\.write\\("
        + "|StandardOpenOption\\.(CREATE|WRITE)|\"rw\"");
    private static final Pattern ATOMIC = Pattern.compile("AtomicFile\\.write\\(");
    /** Files with other writers, and the reason. */
    private static final Map<String, String> OTHERS = new TreeMap<>(Map.ofEntries(
        Map.entry("AtomicFile.java", "the helper itself"),
        Map.entry("BundleReader.java", "unpacks into a folder that becomes the project as a whole"),
        Map.entry("BundleTransfers.java", "an upload's temporary file"),
        Map.entry("BundleWriter.java", "writes the place that AtomicFile gives it"),
        Map.entry("ExampleBundles.java", "a temporary file"),
        Map.entry("FolderOwner.java", "a lock file with the owner's process id"),
        Map.entry("Gateway.java", "a token, written aside with private permissions"),
        Map.entry("Import.java", "changes a copy that becomes the project as a whole"),
        Map.entry("InstallPlan.java", "installs aside, with a receipt and the owner of MyRobotLab's folder"),
        Map.entry("LogBuffer.java", "a record grows and can be read up to its last event"),
        Map.entry("MadePictures.java", "a picture in memory"),
        Map.entry("Marking.java", "a folder for one run of a pupil's script"),
        Map.entry("ModemLines.java", "a temporary folder"),
        Map.entry("MrlFolder.java", "opens MyRobotLab's jar to see whether it runs"),
        Map.entry("OutputLog.java", "a log that grows"),
        Map.entry("Png.java", "a picture in memory"),
        Map.entry("PngCanvas.java", "a picture in memory"),
        Map.entry("ProjectSwap.java", "a lock, and copies that become the project as a whole"),
        Map.entry("RasterFile.java", "a temporary file"),
        Map.entry("SearCommand.java", "a temporary file"),
        Map.entry("TerrainCut.java", "a temporary folder"),
        Map.entry("UrdfMeshes.java", "copies new files into assets before the objects that name them"),
        Map.entry("WindowProcess.java", "standard output")));

    @Test
    public void everyOtherWriterIsListedWithItsReason() throws IOException {
        Set<String> found = new TreeSet<>();
        for (String sources : List.of("main/java", "cli/java")) {
            try (Stream<Path> files = Files.walk(ROOT.resolve(sources))) {
                for (Path file : files.filter(each -> each.toString().endsWith(".java")).collect(Collectors.toList())) {
                    boolean writes = Stream.of(Files.readString(file).split("[;{}]"))
                        .anyMatch(part -> WRITES.matcher(part).find() && !ATOMIC.matcher(part).find());
                    if (writes) {
                        found.add(file.getFileName().toString());
                    }
                }
            }
        }
        assertEquals(OTHERS.keySet(), found);
    }
}
