package org.myrobotlab.embedded.web;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.AclEntry;
import java.nio.file.attribute.AclEntryPermission;
import java.nio.file.attribute.AclEntryType;
import java.nio.file.attribute.AclFileAttributeView;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;

/** What callers must know when the user asked for it with {@code --token}: 192 random bits, new with each start. Any thread. */
public final class Token {
    private static final int BYTES = 24;
    private static final String OWNER_READS = "rw-------";
    private static final SecureRandom RANDOM = new SecureRandom();
    private static volatile Token current = new Token(null);

    private final String text;

    private Token(String text) {
        this.text = text;
    }

    /** What servers that start now ask for. */
    static Token current() {
        return current;
    }

    /**
     * From now on servers that start ask for a token.
     *
     * @return that
     */
    public static Token require() {
        byte[] bytes = new byte[BYTES];
        RANDOM.nextBytes(bytes);
        current = new Token(Base64.getUrlEncoder().withoutPadding().encodeToString(bytes));
        return current;
    }

    /** From now on servers that start ask for none. */
    public static void dismiss() {
        current = new Token(null);
    }

    /** Whether a caller who gave this may call; always if no token is asked for. Takes as long for a wrong one as for the right one. */
    boolean fits(String given) {
        return text == null || MessageDigest.isEqual(text.getBytes(StandardCharsets.UTF_8), given.getBytes(StandardCharsets.UTF_8));
    }

    /** The token; letters, digits, - and _. */
    public String text() {
        return text;
    }

    /**
     * Writes the token into the file {@code .sear/token-PORT} of the user's home folder, which only that user can read.
     *
     * @return the file
     */
    public Path write(int port) throws IOException {
        Path folder = Files.createDirectories(Paths.get(System.getProperty("user.home"), ".sear"));
        Path file = folder.resolve("token-" + port);
        Path part = Files.createTempFile(folder, "token", null);
        makePrivate(part);
        Files.writeString(part, text + "\n");
        return Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void makePrivate(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix != null) {
            posix.setPermissions(PosixFilePermissions.fromString(OWNER_READS));
            return;
        }
        AclFileAttributeView acl = Files.getFileAttributeView(file, AclFileAttributeView.class);
        if (acl == null) {
            throw new IOException(file + " can't be kept from other users on this disk: the token is not written");
        }
        acl.setAcl(List.of(AclEntry.newBuilder().setType(AclEntryType.ALLOW).setPrincipal(Files.getOwner(file))
            .setPermissions(EnumSet.allOf(AclEntryPermission.class)).build()));
    }
}
