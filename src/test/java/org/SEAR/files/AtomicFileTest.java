// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.Assume;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A file is the old one or the new one. */
public class AtomicFileTest {
    private static final byte[] OLD = "old".getBytes(StandardCharsets.US_ASCII);
    private static final byte[] NEW = "new and longer".getBytes(StandardCharsets.US_ASCII);

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private Path folder;
    private Path file;

    @Before
    public void makeOld() throws IOException {
        folder = temporary.getRoot().toPath();
        file = Files.write(folder.resolve("result.csv"), OLD);
    }

    private Set<String> names() {
        return new TreeSet<>(Set.of(folder.toFile().list()));
    }

    @Test
    public void aFailureInTheMiddleLeavesTheOldFileAndNoOther() throws IOException {
        IOException full = assertThrows(IOException.class, () -> AtomicFile.write(file, place -> {
            Files.write(place, NEW);
            throw new IOException("No space left on device");
        }));
        assertEquals("No space left on device", full.getMessage());
        assertThrows(IllegalStateException.class, () -> AtomicFile.write(file, place -> {
            throw new IllegalStateException();
        }));
        assertArrayEquals(OLD, Files.readAllBytes(file));
        assertEquals(Set.of("result.csv"), names());
    }

    @Test
    public void aSuccessReplacesTheFile() throws IOException {
        AtomicFile.write(file, NEW);
        AtomicFile.write(folder.resolve("other.csv"), NEW);
        assertArrayEquals(NEW, Files.readAllBytes(file));
        assertArrayEquals(NEW, Files.readAllBytes(folder.resolve("other.csv")));
        assertEquals(Set.of("result.csv", "other.csv"), names());
    }

    @Test
    public void aReaderNeverSeesAPart() throws Exception {
        List<Integer> sizes = Collections.synchronizedList(new ArrayList<>());
        for (int i = 0; i < 20; i++) {
            AtomicFile.write(file, place -> {
                Files.write(place, NEW);
                sizes.add(Files.readAllBytes(file).length);
            });
        }
        assertEquals(OLD.length, (int) sizes.get(0));
        assertTrue(sizes.toString(), sizes.subList(1, sizes.size()).stream().allMatch(size -> size == NEW.length));
    }

    @Test
    public void errorsNameTheFile() {
        Path nowhere = folder.resolve("nowhere/result.csv");
        NoSuchFileException e = assertThrows(NoSuchFileException.class, () -> AtomicFile.write(nowhere, NEW));
        assertEquals(nowhere.toString(), e.getFile());
        Path directory = temporary.getRoot().toPath();
        assertThrows(IOException.class, () -> AtomicFile.write(directory, NEW));
    }

    @Test
    public void permissionsStay() throws IOException {
        Assume.assumeTrue("POSIX", folder.getFileSystem().supportedFileAttributeViews().contains("posix"));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
        AtomicFile.write(file, NEW);
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    }

    @Test
    public void aLinkIsReplacedAndADeviceIsWritten() throws IOException {
        Path link = folder.resolve("link");
        Assume.assumeTrue("links and devices", Files.exists(Paths.get("/dev/null")));
        Files.createSymbolicLink(link, file);
        AtomicFile.write(link, NEW);
        assertFalse(Files.isSymbolicLink(link));
        assertArrayEquals(OLD, Files.readAllBytes(file));
        AtomicFile.write(Paths.get("/dev/null"), NEW);
        assertFalse(Files.isRegularFile(Paths.get("/dev/null")));
    }
}
