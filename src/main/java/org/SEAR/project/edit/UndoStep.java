// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.xml.Xml;

/** A step of undo and redo: file changes and their description. Immutable, any thread. */
final class UndoStep {
    private static final String FORMAT = "SEAR edit 1";
    private static final int NONE = -1;
    /** Enough for a robot and all of its parts. */
    private static final int MAX_FILES = 20000;
    private static final Pattern FOLDERS = Pattern.compile(ProjectFolder.ENVIRONMENT + "/[^/]+|" + ProjectFolder.ROBOT
        + "/([^/]+/)?[^/]+");

    /** Description, as in "undo: move crate". */
    final String words;
    final List<FileChange> changes;

    UndoStep(String words, List<FileChange> changes) {
        this.words = words;
        this.changes = List.copyOf(changes);
    }

    /** Returns the bytes in memory. */
    long size() {
        return changes.stream().mapToLong(FileChange::size).sum();
    }

    byte[] toBytes() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeUTF(FORMAT);
        out.writeUTF(words);
        out.writeInt(changes.size());
        for (FileChange change : changes) {
            out.writeUTF(change.path);
            write(out, change.before());
            write(out, change.after());
        }
        out.flush();
        return bytes.toByteArray();
    }

    private static void write(DataOutputStream out, byte[] content) throws IOException {
        out.writeInt(content == null ? NONE : content.length);
        if (content != null) {
            out.write(content);
        }
    }

    /**
     * Reads the bytes of {@link #toBytes}. Projects are untrusted, so a step may only contain files of objects.
     *
     * @throws IOException if the bytes are no valid step
     */
    static UndoStep of(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        if (!in.readUTF().equals(FORMAT)) {
            throw new IOException("it is no step of this version of SEAR");
        }
        String words = in.readUTF();
        int count = in.readInt();
        if (count < 0 || count > MAX_FILES) {
            throw new IOException("it has " + count + " files, legal: 0 to " + MAX_FILES);
        }
        List<FileChange> changes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            String path = in.readUTF();
            if (!isObjectFile(path)) {
                throw new IOException("it names \"" + path + "\", legal: the file of an object");
            }
            changes.add(new FileChange(path, read(in), read(in)));
        }
        return new UndoStep(words, changes);
    }

    private static byte[] read(DataInputStream in) throws IOException {
        int length = in.readInt();
        if (length == NONE) {
            return null;
        }
        if (length < 0 || length > Xml.MAX_BYTES) {
            throw new IOException("it has a file of " + length + " bytes, legal: at most " + Xml.MAX_BYTES);
        }
        byte[] content = in.readNBytes(length);
        if (content.length < length) {
            throw new IOException("it ends in the middle");
        }
        return content;
    }

    private static boolean isObjectFile(String path) {
        boolean legal = FOLDERS.matcher(path).matches() && path.endsWith(ProjectFolder.XML);
        for (String part : path.split("/")) {
            legal &= TextRule.NAME.isLegal(part.endsWith(ProjectFolder.XML)
                ? part.substring(0, part.length() - ProjectFolder.XML.length()) : part);
        }
        return legal;
    }
}
