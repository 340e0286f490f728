// SPDX-License-Identifier: Apache-2.0
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
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The secret that callers need when the user asks for it with {@code --token}: 192 random bits, new at each start, or
 * the content of a user's file. Any thread.
 */
public final class Token {
    /** Minimum length of a given token, characters. */
    public static final int SHORTEST = 16;
    private static final int LONGEST = 200;
    /** Length from which guessing is hopeless, characters. */
    private static final int LONG = 32;
    private static final int BYTES = 24;
    private static final String MAC = "HmacSHA256";
    private static final String OWNER_READS = "rw-------";
    private static final SecureRandom RANDOM = new SecureRandom();
    private static volatile Token current = new Token(null);

    private final String text;
    /** Key of the cookies; random for a short token, so that cookies don't help to guess it. */
    private final byte[] key;

    private Token(String text) {
        this.text = text;
        this.key = text != null && text.length() >= LONG ? text.getBytes(StandardCharsets.UTF_8) : random();
    }

    private static byte[] random() {
        byte[] bytes = new byte[BYTES];
        RANDOM.nextBytes(bytes);
        return bytes;
    }

    /** Returns a new token: letters, digits, - and _. */
    public static String make() {
        return Base64.getUrlEncoder().withoutPadding().encodeToString(random());
    }

    /** Returns the token of servers that start now. */
    public static Token current() {
        return current;
    }

    /**
     * Makes servers that start from now on require a new token.
     *
     * @return the token
     */
    public static Token require() {
        current = new Token(make());
        return current;
    }

    /**
     * Makes servers that start from now on require the token in a file.
     *
     * @return the token
     * @throws IOException if the file can't be read, or other users may read it
     * @throws IllegalArgumentException if the file does not contain a legal token
     */
    public static Token require(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix != null && posix.readAttributes().permissions().stream()
            .anyMatch(one -> !one.name().startsWith("OWNER"))) {
            throw new IOException("other users can read " + file + ": run chmod 600 " + file);
        }
        String text = Files.readString(file).trim();
        if (!text.matches("[\\w.~-]{" + SHORTEST + "," + LONGEST + "}")) {
            throw new IllegalArgumentException(file + " contains no token, legal: " + SHORTEST + " to " + LONGEST
                + " characters of A to Z, a to z, 0 to 9, . _ ~ -");
        }
        current = new Token(text);
        return current;
    }

    /** Makes servers that start from now on require no token. */
    public static void dismiss() {
        current = new Token(null);
    }

    /** Returns whether a caller with this token may call; always true if none is required. Takes constant time. */
    boolean fits(String given) {
        return text == null || isSame(text, given);
    }

    /** Returns whether two texts are equal, in a time that does not depend on where they differ. */
    static boolean isSame(String right, String given) {
        return MessageDigest.isEqual(right.getBytes(StandardCharsets.UTF_8), given.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns whether a token is required. */
    public boolean isAskedFor() {
        return text != null;
    }

    /** Returns whether the token is too long to be guessed. */
    boolean isLong() {
        return text.length() >= LONG;
    }

    /**
     * Returns a cookie for a caller who has shown the token; it does not reveal the token.
     *
     * @param goodFor what the cookie is valid for, such as an address
     */
    String cookie(String goodFor) {
        try {
            Mac mac = Mac.getInstance(MAC);
            mac.init(new SecretKeySpec(key, MAC));
            return Base64.getUrlEncoder().withoutPadding()
                .encodeToString(mac.doFinal(goodFor.getBytes(StandardCharsets.UTF_8)));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns the token; null if none is required. */
    public String text() {
        return text;
    }

    /**
     * Writes the token to the file {@code .sear/token-PORT} in the user's home folder, readable by that user only.
     *
     * @return the file
     */
    public Path write(int port) throws IOException {
        Path folder = Files.createDirectories(Paths.get(System.getProperty("user.home"), ".sear"));
        Path file = folder.resolve("token-" + port);
        return writePrivate(file, text + "\n");
    }

    /**
     * Writes a file that only its user can read.
     *
     * @return the file
     */
    public static Path writePrivate(Path file, String content) throws IOException {
        Path part = Files.createTempFile(file.toAbsolutePath().getParent(), "token", null);
        makePrivate(part);
        Files.writeString(part, content);
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
            throw new IOException(file + " can't be protected from other users on this disk, so the token "
                + "was not written");
        }
        acl.setAcl(List.of(AclEntry.newBuilder().setType(AclEntryType.ALLOW).setPrincipal(Files.getOwner(file))
            .setPermissions(EnumSet.allOf(AclEntryPermission.class)).build()));
    }
}
