// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assume.assumeTrue;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Deletion of folders that hostile scripts have filled. */
public class ScratchFolderTest {
    private static final int DEPTH = 400;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private void deleted(Path folder) {
        assertNull(ScratchFolder.delete(folder));
        assertFalse(Files.exists(folder, LinkOption.NOFOLLOW_LINKS));
    }

    @Test
    public void nestedFoldersWhosePathIsTooLongForTheSystemAreDeleted() throws Exception {
        Path folder = temporary.newFolder("deep").toPath();
        Path inner = Files.createDirectory(folder.resolve("first"));
        for (int i = 0; i < DEPTH; i++) {
            Files.writeString(inner.resolve("file"), "text");
            Path outer = Files.createDirectory(folder.resolve("level-" + i));
            Files.move(inner, outer.resolve("x".repeat(200)));
            inner = outer;
        }
        deleted(folder);
    }

    @Test
    public void lockedFoldersAreDeletedAndTargetsOfLinksAreKept() throws Exception {
        assumeTrue(temporary.getRoot().toPath().getFileSystem().supportedFileAttributeViews().contains("posix"));
        Path folder = temporary.newFolder("locked").toPath();
        Path own = temporary.newFile("own").toPath();
        Path outside = temporary.newFolder("outside").toPath();
        Files.writeString(outside.resolve("kept"), "text");
        Path inner = Files.createDirectories(folder.resolve("a/b/c"));
        Files.createSymbolicLink(inner.resolve("link"), outside);
        Files.createSymbolicLink(folder.resolve("link"), own);
        for (Path one : new Path[] {inner, folder.resolve("a/b"), folder}) {
            Files.setPosixFilePermissions(one, PosixFilePermissions.fromString("---------"));
        }
        deleted(folder);
        assertTrue(Files.exists(own));
        assertEquals("text", Files.readString(outside.resolve("kept")));
    }

    @Test
    public void aMissingFolderIsNoProblem() {
        deleted(temporary.getRoot().toPath().resolve("missing"));
    }
}
